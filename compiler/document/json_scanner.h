#pragma once
// JSON as brackets, keys, strings and literals. The scanner always stands at the next token; white space behind a token is
// skipped with it, and so are comments, which JSON does not have. What breaks the grammar is reported, each place once, and
// passed over: the reader only asks for the next item. Source: RFC 8259.

#include <algorithm>
#include <string>
#include <string_view>

#include "document/document_builder.h"

namespace plugc {

/// An object or a list that is being read.
struct JsonBracket {
  Span place;  ///< Its opening bracket.
  char close = '}';
  bool first = true;  ///< No item was asked for yet.
};

inline bool is_json_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

class JsonScanner {
 public:
  explicit JsonScanner(DocumentBuilder& builder);

  bool at_end() const { return at_ == end_; }
  /// The next character; NUL at the end (and where the text holds one, which begins nothing either).
  char next() const { return at_ == end_ ? '\0' : *at_; }
  /// Whether what is next would be a number, well written or not.
  bool next_is_number() const;
  std::uint32_t offset() const { return place(at_); }

  /// From `begin` to the end of the last token that was read; empty when none was read since.
  Span span_from(std::uint32_t begin) const { return {source_, begin, std::max(begin, place(last_end_))}; }
  Span next_span() const { return {source_, offset(), place(token_end())}; }
  /// The next token in words: "`}`", "a string", "the end of the file".
  std::string describe_next() const;

  /// Enters the object or list that is next.
  JsonBracket open();
  /// Whether another item follows; it is next then. Behind the last one the bracket is left.
  bool next_item(JsonBracket& bracket);
  /// The same for an object: the key of its next member; the member's value is next then.
  bool next_member(JsonBracket& object, Name& key);

  double take_number();
  /// Appends the string that is next, without its quotes and escapes.
  void take_string(MappedText& text);
  /// The string that is next as a name; any other scalar is taken as it is written.
  Name take_name();
  /// `true`, `null` or another word; "" when none is next.
  std::string_view peek_word() const;
  void take_word() { take_token(); }
  /// Passes whatever token is next.
  void take_token() { finish_token(token_end()); }
  /// Skips what is next, a bracket with all that it holds.
  void skip_value();

  /// Reports a mistake, unless one was reported just there: the second would only follow from the first.
  void mistake(const Span& span, std::string message);

 private:
  struct StringExtent {
    const char* end;  // the closing quote, or where the text ends without one
    bool closed;
    const char* line_break;  // the first one inside a string that is closed behind it, or null
  };
  bool begins_value() const;
  bool take(char c);
  void take_comma(const JsonBracket& bracket);
  bool leave(const JsonBracket& bracket);
  int& open_count(char close) { return close == '}' ? open_objects_ : open_lists_; }
  double take_odd_number();
  StringExtent find_string(const char* quote) const;
  const char* take_escape(const char* at, const char* end, MappedText& text);
  const char* take_code_unit(const char* at, const char* end, MappedText& text);
  const char* token_end() const;
  void finish_token(const char* token_end);
  void skip_space();
  void skip_comments();
  std::uint32_t place(const char* c) const { return static_cast<std::uint32_t>(c - begin_); }
  Span span(const char* first, const char* end) const { return {source_, place(first), place(end)}; }

  DocumentBuilder& build_;
  SourceId source_;
  const char* begin_;
  const char* end_;
  const char* at_;
  const char* last_begin_;  // the last token that was read
  const char* last_end_;
  int open_objects_ = 0;
  int open_lists_ = 0;
  std::uint32_t reported_at_ = UINT32_MAX;
  bool comment_was_reported_ = false;
  bool end_was_reported_ = false;
};

}  // namespace plugc
