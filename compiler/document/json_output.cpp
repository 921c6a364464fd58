#include "document/json_output.h"

#include <utility>

#include <fmt/format.h>

#include "document/layout.h"

namespace plugc {

std::string json_quoted(std::string_view string) {
  std::string text(1, '"');
  for (const char c : string) {
    switch (c) {
      case '"': text += "\\\""; break;
      case '\\': text += "\\\\"; break;
      case '\n': text += "\\n"; break;
      case '\r': text += "\\r"; break;
      case '\t': text += "\\t"; break;
      case '\0': text += "\\ufffd"; break;
      default:
        text +=
            static_cast<unsigned char>(c) < 0x20 ? fmt::format("\\u{:04x}", static_cast<unsigned char>(c)) : std::string(1, c);
    }
  }
  return text + '"';
}

void JsonOutput::open(char bracket) {
  text_ += bracket;
  ++level_;
  is_first_ = true;
  open_at_.push_back(text_.size());
}

void JsonOutput::close(char bracket) {
  --level_;
  if (!std::exchange(is_first_, false)) text_ += '\n' + indentation(level_);
  text_ += bracket;
  join_lines(text_, open_at_.back());
  open_at_.pop_back();
}

void JsonOutput::item() {
  if (!std::exchange(is_first_, false)) text_ += ',';
  text_ += '\n' + indentation(level_);
}

void JsonOutput::key(std::string_view name) {
  item();
  text_ += json_quoted(name) + ": ";
}

void JsonOutput::open_object(std::string_view type) {
  text_ += "{ " + json_quoted(type) + ": ";
  open('{');
}

void JsonOutput::close_object() {
  close('}');
  text_ += " }";
}

}  // namespace plugc
