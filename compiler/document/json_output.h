#pragma once
// JSON as text: brackets, keys and strings, each item in a line of its own unless a bracket fits into one.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document/document.h"

namespace plugc {

/// In quotes, with the escapes that JSON wants; NUL becomes U+FFFD.
std::string json_quoted(std::string_view string);

class JsonOutput {
 public:
  void open(char bracket);
  void close(char bracket);
  void item();
  void key(std::string_view name);
  void member(std::string_view name, std::string_view text) { key(name), text_ += text; }
  void optional_member(std::string_view name, const Name& value) {
    if (!value.empty()) member(name, json_quoted(value.text));
  }
  /// `{ "Box": {` on one line.
  void open_object(std::string_view type);
  void close_object();
  void write(std::string_view text) { text_ += text; }
  /// The lines of the innermost bracket stay lines, however short they are.
  void keep_lines() { open_at_.back() = 0; }
  std::size_t level() const { return level_; }
  std::string take_text() { return std::move(text_); }

 private:
  std::string text_;
  std::size_t level_ = 0;
  std::vector<std::size_t> open_at_;  // behind each open bracket
  bool is_first_ = true;              // of the innermost bracket nothing is written yet
};

}  // namespace plugc
