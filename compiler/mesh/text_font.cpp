// FreeType gives a glyph as closed contours of lines and curves. Curves are flattened, contours sorted into outlines and holes
// by how many others they lie in (even: outline; odd: hole of the smallest outline around it), and each outline is triangulated
// with its holes. Winding is not asked for: fonts disagree about it.

#include "mesh/text_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "mesh/triangulate.h"

namespace plugc {

namespace {

constexpr int kCurveSegments = 4;
constexpr float kUnitsPerPixel = 64;  // FreeType's 26.6 numbers

constexpr std::array<std::string_view, 2> kFontFolders = {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/TTF/"};

using Contour = std::vector<glm::dvec2>;

glm::dvec2 point_of(const FT_Vector* v) {
  return glm::dvec2(v->x, v->y) / double{kUnitsPerPixel};
}

std::vector<Contour>& contours_of(void* user) {
  return *static_cast<std::vector<Contour>*>(user);
}

int move_to(const FT_Vector* to, void* user) {
  contours_of(user).push_back({point_of(to)});
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  contours_of(user).back().push_back(point_of(to));
  return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  Contour& contour = contours_of(user).back();
  const glm::dvec2 a = contour.back(), b = point_of(control), c = point_of(to);
  for (int i = 1; i <= kCurveSegments; ++i) {
    const double t = double(i) / kCurveSegments, s = 1 - t;
    contour.push_back(a * (s * s) + b * (2 * s * t) + c * (t * t));
  }
  return 0;
}

int cubic_to(const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* to, void* user) {
  Contour& contour = contours_of(user).back();
  const glm::dvec2 a = contour.back(), b = point_of(control1), c = point_of(control2), d = point_of(to);
  for (int i = 1; i <= kCurveSegments; ++i) {
    const double t = double(i) / kCurveSegments, s = 1 - t;
    contour.push_back(a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t));
  }
  return 0;
}

// Without repeated points, which make no edge.
void clean(Contour& contour) {
  contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
  while (contour.size() > 1 && contour.front() == contour.back()) contour.pop_back();
}

std::vector<Contour> flatten(FT_Outline& outline) {
  std::vector<Contour> contours;
  FT_Outline_Funcs callbacks{};
  callbacks.move_to = move_to;
  callbacks.line_to = line_to;
  callbacks.conic_to = conic_to;
  callbacks.cubic_to = cubic_to;
  if (FT_Outline_Decompose(&outline, &callbacks, &contours) != 0) return {};
  for (Contour& contour : contours) clean(contour);
  std::erase_if(contours, [](const Contour& contour) { return contour.size() < 3; });
  return contours;
}

bool contains(const Contour& contour, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
    const glm::dvec2 &a = contour[i], &b = contour[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

// For each contour the outline whose triangles it bounds (itself, for an outline), by nesting.
std::vector<std::size_t> outlines_of(const std::vector<Contour>& contours) {
  std::vector<std::size_t> result(contours.size());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    std::size_t depth = 0;
    std::optional<std::size_t> nearest;
    for (std::size_t j = 0; j < contours.size(); ++j) {
      if (i == j || !contains(contours[j], contours[i][0])) continue;
      ++depth;
      if (!nearest || std::abs(signed_area(contours[j])) < std::abs(signed_area(contours[*nearest]))) nearest = j;
    }
    result[i] = depth % 2 == 0 ? i : *nearest;
  }
  return result;
}

void add_outline(Glyph& glyph, const std::vector<Contour>& contours, const std::vector<std::size_t>& outlines,
                 std::size_t outline) {
  std::vector<glm::dvec2> points = contours[outline];
  std::vector<std::uint32_t> ring_ends = {static_cast<std::uint32_t>(points.size())};
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (i == outline || outlines[i] != outline) continue;
    points.insert(points.end(), contours[i].begin(), contours[i].end());
    ring_ends.push_back(static_cast<std::uint32_t>(points.size()));
  }
  const auto first = static_cast<std::uint32_t>(glyph.points.size());
  for (const std::uint32_t index : triangulate(points, ring_ends)) glyph.triangles.push_back(first + index);
  glyph.points.insert(glyph.points.end(), points.begin(), points.end());
}

struct FontFamily {
  std::string_view name, file, italic;  // the fonts without serifs have an oblique instead of an italic
};

constexpr std::array<FontFamily, 3> kFamilies = {{
    {"SERIF", "DejaVuSerif", "Italic"},
    {"SANS", "DejaVuSans", "Oblique"},
    {"TYPEWRITER", "DejaVuSansMono", "Oblique"},
}};

std::string file_name(const FontFamily& family, std::string_view style) {
  std::string suffix;
  if (style.find("BOLD") != std::string_view::npos) suffix += "Bold";
  if (style.find("ITALIC") != std::string_view::npos) suffix += family.italic;
  return std::string(family.file) + (suffix.empty() ? "" : "-") + suffix + ".ttf";
}

}  // namespace

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  bool open(const std::string& file) {
    for (const std::string_view folder : kFontFolders)
      if (FT_New_Face(library, (std::string(folder) + file).c_str(), 0, &face) == 0)
        return FT_Set_Pixel_Sizes(face, 0, kFontPixels) == 0;
    return false;
  }
};

void Font::CloseFace::operator()(Face* face) const {
  if (face->face != nullptr) FT_Done_Face(face->face);
  if (face->library != nullptr) FT_Done_FreeType(face->library);
  delete face;
}

std::optional<Font> Font::open(std::string_view family_name, std::string_view style) {
  const auto* found = std::ranges::find(kFamilies, family_name, &FontFamily::name);
  const FontFamily& family = found == kFamilies.end() ? kFamilies[0] : *found;
  std::unique_ptr<Face, CloseFace> face(new Face);
  if (FT_Init_FreeType(&face->library) != 0) return std::nullopt;
  if (!face->open(file_name(family, style)) && !face->open(file_name(family, "PLAIN"))) return std::nullopt;
  return Font(std::move(face));
}

Font::Font(std::unique_ptr<Face, CloseFace> face) : face_(std::move(face)) {
  for (const char letter : {'W', 'y'}) {
    for (const glm::vec2& point : glyph(static_cast<std::uint32_t>(letter)).points) {
      ascent_ = std::max(ascent_, point.y);
      descent_ = std::max(descent_, -point.y);
    }
  }
  ascent_ = std::ceil(ascent_);
  descent_ = std::ceil(descent_);
}

const Glyph& Font::glyph(std::uint32_t code_point) {
  const auto [place, is_new] = glyphs_.try_emplace(code_point);
  Glyph& glyph = place->second;
  if (!is_new || FT_Load_Char(face_->face, code_point, FT_LOAD_NO_BITMAP) != 0) return glyph;
  glyph.advance = static_cast<float>(face_->face->glyph->advance.x) / kUnitsPerPixel;
  const std::vector<Contour> contours = flatten(face_->face->glyph->outline);
  const std::vector<std::size_t> outlines = outlines_of(contours);
  for (std::size_t i = 0; i < contours.size(); ++i)
    if (outlines[i] == i) add_outline(glyph, contours, outlines, i);
  return glyph;
}

}  // namespace plugc
