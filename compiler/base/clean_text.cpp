// One pass; runs of ASCII, which most text is, go by eight bytes.

#include "base/clean_text.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace plugc {
namespace {

unsigned byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

bool is_continuation(unsigned byte, unsigned low = 0x80, unsigned high = 0xBF) {
  return byte >= low && byte <= high;
}

/// Whether the eight bytes are ASCII and none is NUL.
bool is_plain(const char* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  constexpr std::uint64_t kOnes = 0x0101010101010101, kHighBits = 0x8080808080808080;
  return (((word - kOnes) | word) & kHighBits) == 0;
}

bool says_it_is_no_utf8(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") || text.starts_with("\x1F\x8B") ||
         text.starts_with("glTF");
}

std::size_t behind_plain(std::string_view text, std::size_t at) {
  while (at + 8 <= text.size() && is_plain(text.data() + at)) at += 8;
  return at;
}

/// The first byte that is no part of a character.
struct Damage {
  std::size_t at = std::string::npos;
  unsigned byte = 0;
};

/// Replaces what is no character.
Damage clean(std::string& text) {
  Damage first;
  for (std::size_t at = behind_plain(text, 0); at < text.size(); at = behind_plain(text, at)) {
    const std::size_t length = character_length(text, at);
    if (length != 0) {
      at += length;
      continue;
    }
    if (first.at == std::string::npos) first = {at, byte_at(text, at)};
    text[at] = text[at] == '\0' ? ' ' : '?';
    ++at;
  }
  return first;
}

}  // namespace

std::size_t character_length(std::string_view text, std::size_t at) {
  const unsigned first = byte_at(text, at), second = byte_at(text, at + 1);
  if (first < 0x80) return first != 0 ? 1 : 0;
  if (first >= 0xC2 && first <= 0xDF) return is_continuation(second) ? 2 : 0;
  const bool third = is_continuation(byte_at(text, at + 2));
  if (first == 0xE0) return third && is_continuation(second, 0xA0, 0xBF) ? 3 : 0;
  if (first == 0xED) return third && is_continuation(second, 0x80, 0x9F) ? 3 : 0;  // no surrogates
  if (first >= 0xE1 && first <= 0xEF) return third && is_continuation(second) ? 3 : 0;
  const bool fourth = third && is_continuation(byte_at(text, at + 3));
  if (first == 0xF0) return fourth && is_continuation(second, 0x90, 0xBF) ? 4 : 0;
  if (first == 0xF4) return fourth && is_continuation(second, 0x80, 0x8F) ? 4 : 0;
  if (first >= 0xF1 && first <= 0xF3) return fourth && is_continuation(second) ? 4 : 0;
  return 0;
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const unsigned byte = byte_at(text, at);
    const bool second_row = byte == 0xC2 && byte_at(text, at + 1) < 0xA0;  // U+0080 to U+009F
    const bool shown = length != 0 && byte >= 0x20 && byte != 0x7F && !second_row;
    for (const std::size_t end = at + std::max<std::size_t>(length, 1); at < end; ++at)
      result += shown ? std::string(1, text[at]) : fmt::format("\\x{:02x}", byte_at(text, at));
  }
  return result;
}

SourceId add_clean_text(SourceSet& sources, std::string name, std::string text, Diagnostics& diagnostics) {
  if (says_it_is_no_utf8(text)) return sources.add(std::move(name), std::move(text));
  const Damage first = clean(text);
  const SourceId source = sources.add(std::move(name), std::move(text));
  if (first.at == std::string::npos) return source;
  const auto at = static_cast<std::uint32_t>(first.at);
  diagnostics.report(
      DiagnosticId::text_damaged, {source, at, at + 1},
      first.byte == 0
          ? std::string("a NUL byte stands in this text; each is read as a space")
          : fmt::format("the byte 0x{:02x} belongs to no character of UTF-8; each such byte is read as `?`", first.byte));
  return source;
}

}  // namespace plugc
