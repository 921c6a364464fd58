// Text (X3D 4.1, 15.4.2): lines of glyphs in the plane z = 0, seen from +z. A line's height of one unit of `size` runs from the
// foot of a y to the head of a W, and the baseline lies one font pixel above the origin; so the reference viewer lays out its
// bitmaps. justify moves every line along itself by its own length, and the block as a whole down or up:
//
//     minor axis    FIRST: first baseline at 0    BEGIN: block below 0    MIDDLE: half of it above    END: block above 0
//
// Lines that go up (topToBottom FALSE) turn that around, and characters from right to left (leftToRight FALSE) begin at the
// right end. With `horizontal FALSE` lines are columns: a glyph stands in the middle of a square of one `size`, squares below
// (or, topToBottom FALSE, above) each other, columns from left to right (or right to left); the minor axis is x.
//
// S and T start at the origin of the first line and count units of `size`. Two vertices that no triangle uses stretch the
// mesh's box to the full height and length of the lines, blanks included.

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/limits.h"
#include "mesh/geometry.h"
#include "mesh/text_font.h"

namespace plugc {

namespace {

struct Style {
  std::string family = "SERIF", style = "PLAIN";
  std::string major = "BEGIN", minor = "FIRST";
  float size = 1, spacing = 1;
  bool horizontal = true, left_to_right = true, top_to_bottom = true;
};

std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string string_at(std::span<const MappedText> strings, std::size_t index, std::string otherwise) {
  return index < strings.size() && !strings[index].empty() ? upper_case(std::string(strings[index].text())) : otherwise;
}

Style style_of(const GeometrySource& source) {
  Style style;
  const NodeGraph& graph = source.graph;
  const NodeId node = graph.child(source.node, "fontStyle");
  if (!graph.is(node, "FontStyle")) return style;
  style.family = string_at(graph.field(node, "family").strings, 0, style.family);
  style.style = string_at(graph.field(node, "style").strings, 0, style.style);
  style.major = string_at(graph.field(node, "justify").strings, 0, style.major);
  style.minor = string_at(graph.field(node, "justify").strings, 1, style.minor);
  style.size = static_cast<float>(graph.number(node, "size"));
  style.spacing = static_cast<float>(graph.number(node, "spacing"));
  style.horizontal = graph.boolean(node, "horizontal");
  style.left_to_right = graph.boolean(node, "leftToRight");
  style.top_to_bottom = graph.boolean(node, "topToBottom");
  return style;
}

// The next code point of UTF-8 text; a byte that starts none gives U+FFFD and is passed over.
std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  if (lead < 0x80) return lead;
  const std::size_t rest = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
  if (rest == 0 || lead > 0xf4 || at + rest > text.size()) return 0xfffd;
  std::uint32_t code_point = lead & (0x3fu >> rest);
  for (std::size_t i = 0; i < rest; ++i) {
    const auto byte = static_cast<unsigned char>(text[at + i]);
    if ((byte & 0xc0) != 0x80) return 0xfffd;
    code_point = code_point << 6 | (byte & 0x3f);
  }
  at += rest;
  return code_point;
}

std::vector<std::uint32_t> code_points(std::string_view text) {
  std::vector<std::uint32_t> result;
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t code_point = next_code_point(text, at);
    if (code_point >= ' ') result.push_back(code_point);
  }
  return result;
}

// One line of text in units of the scene: its characters, its length, and how far it is stretched along itself.
struct Line {
  std::vector<std::uint32_t> characters;
  float length = 0;
  float stretch = 1;
};

float shift_share(std::string_view justify) {
  return justify == "END" ? 1.0f : justify == "MIDDLE" ? 0.5f : 0.0f;
}

class TextSetter {
 public:
  TextSetter(const GeometrySource& source, const Style& style, Font& font)
      : source_(source), style_(style), font_(font), scale_(style.size / (font.ascent() + font.descent())) {
    mesh.tex_coords.resize(1);
    mesh.solid = source.graph.boolean(source.node, "solid");
  }

  void set_all() {
    const std::vector<Line> lines = read_lines();
    if (lines.empty()) return;
    origin_ = start_of(lines[0], 0, lines.size());
    low_ = high_ = origin_;
    for (std::size_t i = 0; i < lines.size() && mesh.positions.size() <= kMaxMeshVertices; ++i) {
      const glm::vec2 start = start_of(lines[i], i, lines.size());
      if (style_.horizontal)
        set_line(lines[i], start);
      else
        set_column(lines[i], start);
    }
    if (mesh.indices.empty()) return;
    add_vertex(low_);
    add_vertex(high_);
  }

  Mesh mesh;

 private:
  std::vector<Line> read_lines() {
    std::vector<Line> lines;
    float longest = 0;
    const std::span<const double> lengths = source_.graph.field(source_.node, "length").numbers;
    std::size_t left = most_characters();
    for (const MappedText& text : source_.graph.field(source_.node, "string").strings) {
      Line& line = lines.emplace_back(Line{code_points(text.text())});
      line.characters.resize(std::min(line.characters.size(), left));
      left -= line.characters.size();
      for (const std::uint32_t character : line.characters)
        line.length += style_.horizontal ? font_.glyph(character).advance * scale_ : style_.size;
      if (style_.horizontal ? !style_.left_to_right : !style_.top_to_bottom) std::ranges::reverse(line.characters);
      const std::size_t index = lines.size() - 1;
      if (index < lengths.size() && lengths[index] > 0) stretch(line, static_cast<float>(lengths[index]));
      longest = std::max(longest, line.length);
    }
    const auto max_extent = static_cast<float>(source_.graph.number(source_.node, "maxExtent"));
    if (max_extent > 0 && longest > max_extent)
      for (Line& line : lines) stretch(line, line.length * max_extent / longest);
    return lines;
  }

  /// Of all lines together: the reference engine's `maxDisplayChars`; -1: all of them.
  std::size_t most_characters() const {
    const int most = source_.graph.integer(source_.node, "maxDisplayChars");
    return most < 0 ? SIZE_MAX : static_cast<std::size_t>(most);
  }

  static void stretch(Line& line, float length) {
    if (line.length <= 0) return;
    line.stretch *= length / line.length;
    line.length = length;
  }

  /// From the foot of a y to the head of a W: what of it lies above the baseline.
  float head_share() const { return (font_.ascent() + 1) / (font_.ascent() + font_.descent()); }

  float first_baseline(std::size_t lines) const {
    if (style_.minor == "FIRST") return 0;
    const float share = static_cast<float>(lines) * shift_share(style_.minor);
    const float shift = style_.top_to_bottom ? share - head_share() : 1 - head_share() - share;
    return shift * style_.spacing * style_.size;
  }

  /// The left end of a line's baseline, or the upper left corner of a column.
  glm::vec2 start_of(const Line& line, std::size_t index, std::size_t count) const {
    const float step = style_.spacing * style_.size, share = shift_share(style_.major);
    const auto place = static_cast<float>(index);
    if (style_.horizontal)
      return {-line.length * (style_.left_to_right ? share : 1 - share),
              first_baseline(count) + (style_.top_to_bottom ? -place : place) * step};
    const float shift = static_cast<float>(count) * shift_share(style_.minor);
    return {(style_.left_to_right ? place - shift : shift - place - 1) * step,
            line.length * (style_.top_to_bottom ? share : 1 - share)};
  }

  void cover(const glm::vec2& low, const glm::vec2& high) {
    low_ = glm::min(low_, low);
    high_ = glm::max(high_, high);
  }

  void set_line(const Line& line, glm::vec2 pen) {
    cover(pen - glm::vec2(0, (font_.descent() - 1) * scale_), pen + glm::vec2(line.length, (font_.ascent() + 1) * scale_));
    const glm::vec2 scale{scale_ * line.stretch, scale_};
    for (const std::uint32_t character : line.characters) {
      const Glyph& glyph = font_.glyph(character);
      set_glyph(glyph, pen, scale);
      pen.x += glyph.advance * scale.x;
    }
  }

  void set_column(const Line& line, glm::vec2 corner) {
    cover(corner - glm::vec2(0, line.length), corner + glm::vec2(style_.size, 0));
    const glm::vec2 scale{scale_, scale_ * line.stretch};
    const float cell = style_.size * line.stretch;
    for (const std::uint32_t character : line.characters) {
      const Glyph& glyph = font_.glyph(character);
      const glm::vec2 baseline{(style_.size - glyph.advance * scale.x) / 2, -head_share() * cell};
      set_glyph(glyph, corner + baseline, scale);
      corner.y -= cell;
    }
  }

  void set_glyph(const Glyph& glyph, const glm::vec2& pen, const glm::vec2& scale) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    if (first > kMaxMeshVertices) return;  // reported for the whole mesh
    for (const glm::vec2& point : glyph.points) add_vertex(pen + (point + glm::vec2(0, 1)) * scale);
    for (const std::uint32_t index : glyph.triangles) mesh.indices.push_back(first + index);
  }

  void add_vertex(const glm::vec2& position) {
    const glm::vec2 texture = style_.size > 0 ? (position - origin_) / style_.size : glm::vec2(0);
    mesh.positions.emplace_back(position, 0.0f);
    mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    mesh.tex_coords[0].emplace_back(texture, 0.0f, 1.0f);
  }

  const GeometrySource& source_;
  const Style& style_;
  Font& font_;
  float scale_;  // from font pixels to units
  glm::vec2 origin_{0}, low_{0}, high_{0};
};

}  // namespace

std::optional<Mesh> make_text(const GeometrySource& source) {
  if (source.type() == "Text3D" && source.graph.number(source.node, "depth") > 0)
    source.report(DiagnosticId::not_drawn, "depth", "a `Text3D` is drawn flat, as a `Text`; its `depth` is passed over");
  const Style style = style_of(source);
  std::optional<Font> font = Font::open(style.family, style.style);
  if (!font) {
    source.diagnostics.report(DiagnosticId::file_unreadable, {},
                              "no DejaVu font is installed, so no text is drawn; install the package fonts-dejavu-core");
    return std::nullopt;
  }
  TextSetter setter(source, style, *font);
  setter.set_all();
  return std::move(setter.mesh);
}

}  // namespace plugc
