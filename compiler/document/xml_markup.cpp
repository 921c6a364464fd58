// What a scene has no use for, and CDATA. Where the end of such a thing is missing, it would swallow the rest of the file;
// then it ends where the author will have meant it to:
//
//     a comment                      in front of the next `<`
//     a processing instruction       behind the next `>`
//     a document type                likewise
//     CDATA                          in front of the next end tag

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "document/xml_scanner.h"

namespace plugc {
namespace {

constexpr auto kNowhere = std::string_view::npos;

bool equal_letters(std::string_view text, std::string_view lower) {
  const auto same = [](char any, char small) { return any == small || (any >= 'A' && any <= 'Z' && any + 0x20 == small); };
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(), same);
}

/// The text between the quotes behind `name=`, as in `encoding="UTF-8"`; "" when there is none.
std::string_view pseudo_attribute(std::string_view text, std::string_view name) {
  const std::size_t found = text.find(name);
  if (found == kNowhere) return "";
  const std::size_t first = text.find_first_of("\"'", found);
  if (first == kNowhere) return "";
  const std::size_t close = text.find(text[first], first + 1);
  return close == kNowhere ? "" : text.substr(first + 1, close - first - 1);
}

}  // namespace

/// Where `closing` stands behind the next `from` bytes. A search that came to the end of the file is not made again.
std::size_t XmlScanner::find_closing(std::string_view closing, std::size_t from) {
  if (std::find(missing_.begin(), missing_.end(), closing) != missing_.end()) return kNowhere;
  const std::size_t found = rest().find(closing, from);
  if (found == kNowhere) missing_.push_back(closing);
  return found;
}

/// Goes on at `at`, behind something whose missing end was reported.
void XmlScanner::resume(const char* at) {
  at_ = at;
  if (at_ == end_) end_was_reported_ = true;
}

/// XML 1.0, 2.5: nothing but the end of a comment has two hyphens in a row.
void XmlScanner::skip_comment() {
  const std::string_view comment = rest();
  constexpr std::size_t kOpening = 4;
  const std::size_t close = find_closing("-->", kOpening);
  if (close == kNowhere) {
    build_.mistake(span(at_, at_ + kOpening), "a comment is not closed by `-->`");
    return resume(find('<', at_ + kOpening, end_));
  }
  const std::size_t hyphens = comment.find("--", kOpening);
  if (hyphens != close) {
    build_.mistake(span(at_ + hyphens, at_ + hyphens + 2), "a comment of XML cannot hold `--`; it stands for its end alone");
  }
  at_ += close + 3;
}

/// One that is closed by the end of another one is not closed.
void XmlScanner::skip_instruction() {
  const std::string_view instruction = rest();
  const std::size_t close = find_closing("?>", 2);
  if (close == kNowhere || instruction.substr(0, close).find("<?", 2) != kNowhere) {
    build_.mistake(span(at_, at_ + 2), "a processing instruction is not closed by `?>`");
    const char* const behind = find('>', at_, end_);
    return resume(behind == end_ ? end_ : behind + 1);
  }
  if (instruction.starts_with("<?xml") && is_a(instruction[5], kXmlBlank)) {
    report_declared_encoding(instruction.substr(0, close));
  }
  at_ += close + 2;
}

void XmlScanner::report_declared_encoding(std::string_view declaration) {
  const std::string_view encoding = pseudo_attribute(declaration, "encoding");
  const auto is = [&](std::string_view lower) { return equal_letters(encoding, lower); };
  if (encoding.empty() || is("utf-8") || is("utf8") || is("us-ascii")) return;  // ASCII is UTF-8, too
  build_.diagnostics.report(
      DiagnosticId::header_odd, span(encoding.data(), encoding.data() + encoding.size()),
      fmt::format("this file declares the encoding `{}`, but is read as UTF-8; save it as UTF-8", shown(encoding)));
}

/// A scene needs no entities of its own; what others do with those (expand them without end, read files by them) is never done.
void XmlScanner::skip_document_type() {
  constexpr std::string_view kOpening = "<!DOCTYPE";
  const bool searched = std::find(missing_.begin(), missing_.end(), kOpening) != missing_.end();  // a file has but one
  const char* const behind = searched ? nullptr : document_type_end();
  if (behind == nullptr) {
    missing_.push_back(kOpening);
    build_.mistake(span(at_, at_ + kOpening.size()), "a document type declaration is not closed");
    return resume(find('<', at_ + 1, end_));
  }
  const char* const bracket = std::find_if(at_, behind, [](char c) { return c == '[' || c == '>'; });
  if (bracket != behind && *bracket == '[') {
    build_.diagnostics.report(DiagnosticId::doctype_subset, span(bracket, bracket + 1),
                              "declarations of a document type are passed over; plugc knows the five entities of XML alone");
  }
  at_ = behind;
}

/// Behind the `>` outside of quotes, comments and declarations inside; null when there is none. Outside of `[ ]` a `<` begins
/// what follows (XML 1.0, 2.8).
const char* XmlScanner::document_type_end() const {
  int brackets = 0;
  for (const char* at = at_ + 1; at != end_; ++at) {
    const std::string_view here(at, static_cast<std::size_t>(end_ - at));
    std::string_view closing;
    if (*at == '"') closing = "\"";
    if (*at == '\'') closing = "'";
    if (here.starts_with("<!--")) closing = "-->";
    if (here.starts_with("<?")) closing = "?>";
    if (!closing.empty()) {
      const std::size_t close = here.find(closing, 1);
      if (close == kNowhere) return nullptr;
      at += close + closing.size() - 1;
    } else if (*at == '[') {
      ++brackets;
    } else if (*at == ']') {
      --brackets;
    } else if (brackets <= 0 && *at == '>') {
      return at + 1;
    } else if (brackets <= 0 && *at == '<') {
      return nullptr;
    }
  }
  return nullptr;
}

/// A section that ends with the end of another one lacks its own, if an end tag stands between their beginnings.
XmlItem XmlScanner::take_cdata() {
  constexpr std::string_view kOpening = "<![CDATA[";
  const char* const first = at_ + kOpening.size();
  const std::size_t close = find_closing("]]>", kOpening.size());
  const std::size_t another = rest().substr(0, close).find(kOpening, kOpening.size());
  const bool may_lack_end = close == kNowhere || another != kNowhere;
  const std::size_t end_tag = may_lack_end ? rest().substr(0, another).find("</", kOpening.size()) : kNowhere;
  text_was_reported_ = false;
  if (close == kNowhere || end_tag != kNowhere) {
    build_.mistake(span(at_, first), "a CDATA section is not closed by `]]>`");
    resume(at_ + std::min(end_tag, rest().size()));
    text_ = span(first, at_);
  } else {
    text_ = span(first, at_ + close);
    at_ += close + 3;
  }
  return XmlItem::cdata;
}

}  // namespace plugc
