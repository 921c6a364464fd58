// Runs between `&` and `\r` are copied, and what stands for the rest is put between them. A text without those is a view of
// the file.

#include "document/xml_text.h"

#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "document/characters.h"

namespace plugc {
namespace {

constexpr std::size_t kLongestEntity = 12;

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

MappedText decode_xml(const Span& span, DocumentBuilder& builder) {
  const std::string_view raw = builder.sources.text(span);
  if (raw.find('&') == std::string_view::npos && raw.find('\r') == std::string_view::npos)
    return MappedText(builder.sources, span);
  MappedText decoded;
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
