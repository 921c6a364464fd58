#pragma once
// The XML encoding as elements, attributes and text. Comments, processing instructions and document types are passed over.
// The scanner knows which elements are open and hands out one end for each of them, whatever the end tags say, so a reader
// only asks for the next thing inside. What breaks the grammar is reported, each mistake once, and the nearest reading is
// taken. Source: Extensible Markup Language (XML) 1.0, fifth edition.

#include <string>
#include <string_view>
#include <vector>

#include "document/characters.h"
#include "document/document_builder.h"

namespace plugc {

/// What stands inside an element; `end` is the element's own end, or that of the file where none is open.
enum class XmlItem : std::uint8_t { element, text, cdata, end };

struct XmlAttribute {
  Name name;
  Span value;            ///< Between the quotes, as written (xml_text.h decodes it).
  bool damaged = false;  ///< Where the value ends was guessed.
};

class XmlScanner {
 public:
  explicit XmlScanner(DocumentBuilder& builder);

  /// What is next inside the innermost open element. An element is open from here on; attributes that nobody asked for
  /// are passed over by the call behind it. Text of blanks alone is none.
  XmlItem next();
  /// The name in the tag of the last `element`.
  const Name& tag() const { return tag_; }
  /// The attributes of that tag, one by one.
  bool next_attribute(XmlAttribute& attribute);
  /// Passes over what is left of the innermost open element.
  void skip_element();

  /// The characters of the last `text` or `cdata`, as written.
  const Span& text() const { return text_; }
  /// Whether a mistake was reported inside it.
  bool text_was_reported() const { return text_was_reported_; }

  /// From `begin` to behind what was last opened or closed.
  Span span_from(std::uint32_t begin) const { return {source_, begin, std::max(begin, place(last_end_))}; }

 private:
  struct OpenElement {
    Name name;
    bool excused = false;  ///< Something about its tags was reported: that it lacks its end is no second mistake.
  };

  // Elements and text (xml_scanner.cpp)
  bool begins_markup(const char* less) const;
  bool take_markup(XmlItem& item);
  XmlItem take_start_tag();
  void take_end_tag();
  std::size_t elements_closed_by(std::string_view name, const Span& tag);
  std::size_t close_up_to(std::size_t index, const Span& tag);
  std::size_t close_nothing(std::string_view name, const Span& tag);
  XmlItem take_text(const char* begin);
  XmlItem take_end_of_file();
  XmlItem close_innermost();
  void excuse_innermost() {
    if (deeper_ == 0) open_.back().excused = true;
  }
  std::size_t depth() const { return open_.size() + deeper_; }

  // Attributes (xml_attributes.cpp)
  bool take_attribute(XmlAttribute& attribute, const char* behind_last);
  void take_quoted(XmlAttribute& attribute);
  bool take_unquoted(XmlAttribute& attribute);
  void take_open_value(XmlAttribute& attribute, const char* limit);
  void pass_over_odd(const char* behind_last);
  void report_odd(const char* begin, const char* behind_last);
  void end_start_tag(const char* behind, bool empty);
  void end_broken_start_tag(const char* behind_last);
  const char* odd_token_end(const char* at) const;
  bool attribute_begins(const char* at) const;
  bool ends_tag(const char* at) const;

  // What is passed over, and code (xml_markup.cpp)
  void skip_comment();
  void skip_instruction();
  void report_declared_encoding(std::string_view declaration);
  void skip_document_type();
  const char* document_type_end() const;
  XmlItem take_cdata();
  std::size_t find_closing(std::string_view closing, std::size_t from);
  void resume(const char* at);

  // Characters
  char peek(std::ptrdiff_t ahead) const { return end_ - at_ > ahead ? at_[ahead] : '\0'; }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
  const char* find(char c, const char* from, const char* to) const;
  const char* name_end(const char* at) const;
  const char* skip_blanks(const char* at) const;
  std::uint32_t place(const char* c) const { return static_cast<std::uint32_t>(c - begin_); }
  Span span(const char* first, const char* end) const { return {source_, place(first), place(end)}; }
  Name name(const char* first, const char* end) const {
    return {{first, static_cast<std::size_t>(end - first)}, span(first, end)};
  }

  DocumentBuilder& build_;
  SourceId source_;
  const char* begin_;
  const char* end_;
  const char* at_;
  const char* last_end_;
  std::vector<OpenElement> open_;           // outermost first
  std::size_t deeper_ = 0;                  // elements that are open inside the last of these
  std::size_t ends_ = 0;                    // elements whose end comes next
  const char* end_tag_ = nullptr;           // what ended them
  std::vector<std::string_view> unclosed_;  // elements that the last such tag closed too early; their end tags may follow
  Name tag_;
  bool inside_tag_ = false;
  bool tag_was_reported_ = false;  // that it is not closed would be no second mistake
  const char* odd_end_ = nullptr;  // behind the last thing in a tag that is no attribute
  Span text_;
  bool text_was_reported_ = false;
  std::vector<std::string_view> missing_;  // what closes something and does not stand in the rest of the file
  bool end_was_reported_ = false;
};

inline const char* XmlScanner::name_end(const char* at) const {
  while (at != end_ && is_a(*at, kXmlNameRest)) ++at;
  return at;
}

inline const char* XmlScanner::skip_blanks(const char* at) const {
  while (at != end_ && is_a(*at, kXmlBlank)) ++at;
  return at;
}

}  // namespace plugc
