#pragma once
// The characters of the classic encoding and of attribute values, those of XML's names, and the one way to write a character.
// Source: ISO/IEC 19776-2, A.2 and 14772-1, A.3 (names); `:` stays a name character, as in `COMPONENT Shaders:1`.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace plugc {

enum CharacterClass : std::uint8_t {
  kSpaceCharacter = 1,  ///< White space; the comma counts as such.
  kWordStart = 2,
  kWordRest = 4,
  kNumberStart = 8,
};

constexpr std::array<std::uint8_t, 256> make_character_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (std::size_t c = 0x21; c < classes.size(); ++c) {
    if (c != 0x7f) classes[c] = kWordStart | kWordRest;
  }
  for (const unsigned char c : std::string_view("\"#',.[\\]{}")) classes[c] = 0;
  for (const unsigned char c : std::string_view(" \t\r\n,")) classes[c] = kSpaceCharacter;
  for (const unsigned char c : std::string_view("0123456789+-")) classes[c] = kWordRest | kNumberStart;
  classes['.'] = kNumberStart;
  return classes;
}
inline constexpr std::array<std::uint8_t, 256> kCharacterClasses = make_character_classes();

constexpr bool is_a(char c, CharacterClass wanted) {
  return (kCharacterClasses[static_cast<unsigned char>(c)] & wanted) != 0;
}

/// Whether a number may not go on with this character, nor anything begin with it right behind a number.
constexpr bool runs_on_number(char c) {
  return is_a(c, kWordRest) || c == '.';
}

/// Behind the end of a line and eights of the blanks that the next one is indented by: most of the white space of a file.
inline const char* skip_indentation(const char* at, const char* end) {
  constexpr std::string_view kBlanks = "        ";
  if (at != end && *at == '\n') ++at;
  while (static_cast<std::size_t>(end - at) >= kBlanks.size() && kBlanks == std::string_view(at, kBlanks.size())) {
    at += kBlanks.size();
  }
  return at;
}

enum XmlCharacter : std::uint8_t { kXmlBlank = 1, kXmlNameStart = 2, kXmlNameRest = 4 };

/// XML 1.0, 2.3; every character beyond ASCII counts as a letter.
constexpr std::array<std::uint8_t, 256> make_xml_characters() {
  std::array<std::uint8_t, 256> kinds{};
  for (std::size_t c = 0x80; c < kinds.size(); ++c) kinds[c] = kXmlNameStart | kXmlNameRest;
  for (std::size_t c = 'a'; c <= 'z'; ++c) kinds[c] = kinds[c - 0x20] = kXmlNameStart | kXmlNameRest;
  for (const unsigned char c : std::string_view("_:")) kinds[c] = kXmlNameStart | kXmlNameRest;
  for (const unsigned char c : std::string_view("-.0123456789")) kinds[c] = kXmlNameRest;
  for (const unsigned char c : std::string_view(" \t\r\n")) kinds[c] = kXmlBlank;
  return kinds;
}
inline constexpr std::array<std::uint8_t, 256> kXmlCharacters = make_xml_characters();

constexpr bool is_a(char c, XmlCharacter wanted) {
  return (kXmlCharacters[static_cast<unsigned char>(c)] & wanted) != 0;
}

/// Appends the character of that code point (RFC 3629).
inline void append_utf8(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t bits) { text += static_cast<char>(bits); };
  const auto rest = [&](int shift) { byte(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | (code >> 6)), rest(0);
  } else if (code < 0x10000) {
    byte(0xE0 | (code >> 12)), rest(6), rest(0);
  } else {
    byte(0xF0 | (code >> 18)), rest(12), rest(6), rest(0);
  }
}

}  // namespace plugc
