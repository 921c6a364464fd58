// A tag is found by its `<`; its `>` is the first one outside quotes. Comments, CDATA sections, processing instructions and
// declarations are jumped over whole. Decoding copies runs between `&` and `\r` and appends what stands for the rest.

#include "document/xml_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "document/characters.h"

namespace plugc {
namespace {

constexpr std::size_t kLongestEntity = 12;

std::size_t behind(std::string_view text, std::string_view mark, std::size_t from) {
  const std::size_t at = text.find(mark, from);
  return at == std::string_view::npos ? text.size() : at + mark.size();
}

std::size_t behind_tag(std::string_view text, std::size_t at) {
  for (char quote = 0; at < text.size(); ++at) {
    if (quote != 0) {
      if (text[at] == quote) quote = 0;
    } else if (text[at] == '"' || text[at] == '\'') {
      quote = text[at];
    } else if (text[at] == '>') {
      return at + 1;
    }
  }
  return text.size();
}

std::size_t behind_declaration(std::string_view text, std::size_t at) {
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '[' || text[at] == '<') ++depth;
    if (text[at] == ']' || text[at] == '>') --depth;
    if (depth == 0) return at + 1;
  }
  return text.size();
}

std::string_view tag_name(std::string_view text, std::size_t at) {
  return text.substr(at, std::min(text.find_first_of(" \t\r\n/>", at), text.size()) - at);
}

/// `#65` or `#x41` (XML 1.0, 4.1); nullopt when that is no character.
std::optional<std::string> character_reference(std::string_view digits) {
  const bool hex = digits.starts_with('x');
  if (hex) digits.remove_prefix(1);
  std::uint32_t code = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, hex ? 16 : 10);
  const bool valid = error == std::errc() && end == digits.data() + digits.size() && code != 0 && code <= 0x10FFFF &&
                     (code < 0xD800 || code > 0xDFFF);
  if (!valid) return std::nullopt;
  std::string text;
  append_utf8(text, code);
  return text;
}

/// What `&name;` stands for.
std::optional<std::string> entity(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> kNamed = {
      {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
  if (name.starts_with('#')) return character_reference(name.substr(1));
  for (const auto& [known, character] : kNamed) {
    if (known == name) return std::string(1, character);
  }
  return std::nullopt;
}

}  // namespace

XmlExtents find_xml_extents(std::string_view text, std::size_t end) {
  XmlExtents extents;
  std::vector<std::size_t> open;
  text = text.substr(0, end);
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const std::string_view tag = text.substr(at);
    if (tag.starts_with("<!--")) {
      at = behind(text, "-->", at + 4);
    } else if (tag.starts_with("<![CDATA[")) {
      at = behind(text, "]]>", at);
    } else if (tag.starts_with("<?")) {
      at = behind(text, "?>", at);
    } else if (tag.starts_with("<!")) {
      at = behind_declaration(text, at);
    } else if (tag.starts_with("</")) {
      at = behind_tag(text, at);
      if (open.empty()) continue;
      extents.elements[open.back()].end = static_cast<std::uint32_t>(at);
      open.pop_back();
    } else {
      const auto begin = static_cast<std::uint32_t>(at);
      at = behind_tag(text, at);
      const bool empty = text[at - 1] == '>' && text[at - 2] == '/';
      if (!empty) open.push_back(extents.elements.size());
      extents.elements.push_back({begin, static_cast<std::uint32_t>(empty ? at : text.size())});
    }
  }
  for (const std::size_t element : open) extents.open.push_back(tag_name(text, extents.elements[element].begin + 1));
  return extents;
}

MappedText decode_xml(const Span& span, DocumentBuilder& builder) {
  MappedText decoded;
  const std::string_view raw = builder.sources.text(span);
  std::size_t done = 0;
  const auto append_run = [&](std::size_t end) {
    append_with_line_feeds(
        decoded, builder.sources,
        {span.source, span.begin + static_cast<std::uint32_t>(done), span.begin + static_cast<std::uint32_t>(end)});
    done = end;
  };
  for (std::size_t at = raw.find('&'); at != std::string_view::npos; at = raw.find('&', at + 1)) {
    const std::string_view window = raw.substr(at, kLongestEntity);
    const std::size_t end = window.find_first_of("; \t\r\n&<", 1);
    const bool ended = end != std::string_view::npos && window[end] == ';' && end > 1;
    const std::string_view written = window.substr(0, ended ? end + 1 : 0);
    const Span place{span.source, span.begin + static_cast<std::uint32_t>(at),
                     span.begin + static_cast<std::uint32_t>(at + written.size())};
    const auto text = written.empty() ? std::nullopt : entity(written.substr(1, written.size() - 2));
    if (!text) {
      builder.mistake(written.empty() ? Span{place.source, place.begin, place.begin + 1} : place,
                      written.empty() ? "this `&` begins no entity of XML; write `&amp;`"
                      : written.starts_with("&#")
                          ? fmt::format("`{}` refers to no character", written)
                          : fmt::format("XML has no entity `{}`; write `&amp;` for the character `&`", written));
      continue;
    }
    append_run(at);
    decoded.append_generated(*text, place);
    done = at + written.size();
  }
  append_run(raw.size());
  return decoded;
}

}  // namespace plugc
