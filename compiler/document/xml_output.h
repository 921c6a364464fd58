#pragma once
// XML as text: tags with their attributes, an element a line, lines of about kLineWidth.

#include <string>
#include <string_view>
#include <utility>

#include "document/document.h"

namespace plugc {

/// The text of an attribute in quotes. Control characters but tab, line feed and carriage return become U+FFFD.
std::string xml_attribute_text(std::string_view value);

class XmlOutput {
 public:
  void open(std::string_view element);
  /// Of the element that was opened last, before anything stands in it.
  void attribute(std::string_view name, std::string_view value) { raw_attribute(name, xml_attribute_text(value)); }
  void optional_attribute(std::string_view name, const Name& value) {
    if (!value.empty()) attribute(name, value.text);
  }
  /// The value with its quotes, as it is.
  void raw_attribute(std::string_view name, std::string_view quoted);
  /// Text inside an element, as CDATA where that can hold it. It is the last thing there.
  void code(std::string_view code);
  void close(std::string_view element);
  std::size_t level() const { return level_; }
  std::string take_text() { return std::move(text_); }

 private:
  void end_tag();

  std::string text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  std::size_t level_ = 0;
  std::size_t line_begin_ = 0;
  bool tag_is_open_ = false;  // `<Box size="1 1 1"`: attributes may follow, and `/>` or `>` is not written
  bool code_ends_here_ = false;
};

}  // namespace plugc
