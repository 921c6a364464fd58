#include "document/xml_output.h"

#include <algorithm>

#include <fmt/format.h>

#include "document/layout.h"

namespace plugc {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

}  // namespace

/// Line ends and tabs are written by number: parsers make blanks of others.
std::string xml_attribute_text(std::string_view value) {
  const char quote = value.find('"') != std::string_view::npos ? '\'' : '"';
  std::string text(1, quote);
  for (const char c : value) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == quote) {
      text += "&apos;";
    } else if (c == '\n' || c == '\r' || c == '\t') {
      text += fmt::format("&#{};", static_cast<int>(c));
    } else if (is_control(c)) {
      text += kReplacement;
    } else {
      text += c;
    }
  }
  return text + quote;
}

void XmlOutput::end_tag() {
  if (std::exchange(tag_is_open_, false)) text_ += ">\n";
}

void XmlOutput::open(std::string_view element) {
  end_tag();
  line_begin_ = text_.size();
  text_ += indentation(level_++);
  text_ += '<';
  text_ += element;
  tag_is_open_ = true;
}

void XmlOutput::raw_attribute(std::string_view name, std::string_view quoted) {
  const std::size_t end = text_.size() - line_begin_ + name.size() + std::min(quoted.find('\n'), quoted.size()) + 2;
  if (end > kLineWidth) {
    text_ += '\n';
    line_begin_ = text_.size();
    text_ += indentation(level_ + 1);
  } else {
    text_ += ' ';
  }
  text_.append(name).append("=").append(quoted);
  if (quoted.find('\n') != std::string_view::npos) line_begin_ = text_.rfind('\n') + 1;
}

void XmlOutput::close(std::string_view element) {
  --level_;
  if (std::exchange(tag_is_open_, false)) {
    text_ += "/>\n";
    return;
  }
  if (!std::exchange(code_ends_here_, false)) text_ += indentation(level_);
  text_.append("</").append(element).append(">\n");
}

/// Ends where the code ends: white space behind it would belong to it, were it no CDATA.
void XmlOutput::code(std::string_view code) {
  if (std::exchange(tag_is_open_, false)) text_ += '>';
  code_ends_here_ = true;
  const bool plain = code.find("]]>") == std::string_view::npos && code.find('\r') == std::string_view::npos &&
                     std::none_of(code.begin(), code.end(), is_control);
  if (plain) {
    text_.append("<![CDATA[").append(code).append("]]>");
    return;
  }
  if (text_.back() == '\n') text_.pop_back();
  for (const char c : code) {
    if (c == '&') {
      text_ += "&amp;";
    } else if (c == '<') {
      text_ += "&lt;";
    } else if (c == '>') {
      text_ += "&gt;";
    } else if (c == '\r') {
      text_ += "&#13;";
    } else if (is_control(c)) {
      text_ += kReplacement;
    } else {
      text_ += c;
    }
  }
}

}  // namespace plugc
