#pragma once
// The classic encoding as words, numbers, strings and brackets. The scanner always stands at the next one: white space,
// commas and comments behind a token are skipped with it. It reports nothing; the grammar does.

#include <algorithm>
#include <string>
#include <string_view>

#include "base/source.h"
#include "document/characters.h"
#include "document/document.h"
#include "document/scan_number.h"

namespace plugc {

class ClassicScanner {
 public:
  ClassicScanner(SourceId source, const SourceSet& sources);

  bool at_end() const { return at_ == end_; }
  /// The next character; NUL at the end (and where the text holds one, which begins nothing either).
  char next() const { return at_ == end_ ? '\0' : *at_; }
  bool next_is(CharacterClass wanted) const { return at_ != end_ && is_a(*at_, wanted); }
  std::uint32_t offset() const { return static_cast<std::uint32_t>(at_ - begin_); }

  /// From `begin` to the end of the last token that was read; empty when none was read since.
  Span span_from(std::uint32_t begin) const {
    return {source_, begin, std::max(begin, static_cast<std::uint32_t>(read_to_ - begin_))};
  }
  /// The next token, as far as a message should mark it.
  Span next_span() const;
  /// The next token in words: "`}`", "a string", "the end of the file".
  std::string describe_next() const;

  /// Takes the character when it is the next one.
  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    finish_token(at_ + 1);
    return true;
  }

  /// The word that is next, or "".
  std::string_view peek_word() const {
    if (word_ != at_) find_word();
    return {word_, static_cast<std::size_t>(word_end_ - word_)};
  }
  Name take_word();
  /// Whatever stands in front of white space, a comma, a quote or a bracket: names and strings as VRML 1.0 has them. It may be
  /// empty.
  Name take_bare();
  /// Whether `{` follows the word that is next.
  bool brace_follows_word() const;

  /// Appends the numbers that are next, up to an odd one or what is none.
  void take_numbers(std::vector<double>& numbers) {
    const auto [numbers_end, next] = scan_numbers(at_, end_, numbers);
    if (next == at_) return;
    read_to_ = numbers_end;
    at_ = next;
    skip_space();
  }

  /// Reads a number into `value`. False: the text there is no number or too large; all of it is taken, and `value` holds
  /// as much as was one.
  bool take_number(double& value) {
    value = 0;
    const auto [end, error] = scan_number(at_, end_, value);
    if (error == std::errc() && (end == end_ || !runs_on_number(*end))) [[likely]] {
      finish_token(end);
      return true;
    }
    return take_odd_number(value);
  }

  /// Reads a string without its quotes and escapes. False: it is not closed, and holds the rest of the text.
  bool take_string(MappedText& text);

  /// Passes whatever token is next.
  void take_token() { finish_token(token_end()); }
  /// Skips one token, or a bracket with all that it holds.
  void skip_item();
  void skip_to_end() { finish_token(end_); }

 private:
  void finish_token(const char* token_end) {
    read_to_ = at_ = token_end;
    skip_space();
  }
  void skip_space() {
    at_ = skip_indentation(at_, end_);
    while (at_ != end_ && is_a(*at_, kSpaceCharacter)) ++at_;
    if (at_ != end_ && *at_ == '#') skip_comments();
  }
  void skip_comments();
  void find_word() const {
    word_ = word_end_ = at_;
    if (!next_is(kWordStart)) return;
    while (word_end_ != end_ && is_a(*word_end_, kWordRest)) ++word_end_;
  }
  bool take_odd_number(double& value);
  const char* token_end() const;

  SourceId source_;
  const SourceSet* sources_;
  const char* begin_;
  const char* at_;
  const char* end_;
  const char* read_to_;
  mutable const char* word_ = nullptr;  // where peek_word() looked last, and what it found
  mutable const char* word_end_ = nullptr;
};

}  // namespace plugc
