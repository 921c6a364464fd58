// One table look-up a character; lists of numbers run in one loop of their own (scan_number.h).
// A string is copied in runs between its escapes. Skipping a bracket counts depth instead of recursing.

#include "document/classic_scanner.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "document/document_builder.h"
#include "document/skip_item.h"

namespace plugc {
namespace {

/// Behind the closing quote of the string at `at`, or the end of the text.
const char* string_end(const char* at, const char* end) {
  for (++at; at < end && *at != '"'; ++at) {
    if (*at == '\\') ++at;
  }
  return at < end ? at + 1 : end;
}

}  // namespace

ClassicScanner::ClassicScanner(SourceId source, const SourceSet& sources)
    : source_(source),
      sources_(&sources),
      begin_(sources.text(source).data()),
      at_(begin_),
      end_(begin_ + sources.text(source).size()),
      read_to_(begin_) {
  const std::string_view text = sources.text(source);
  if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
  skip_space();
}

void ClassicScanner::skip_comments() {
  while (at_ != end_ && *at_ == '#') {
    at_ = std::find_if(at_, end_, [](char c) { return c == '\n' || c == '\r'; });
    while (at_ != end_ && is_a(*at_, kSpaceCharacter)) ++at_;
  }
}

const char* ClassicScanner::token_end() const {
  if (at_ == end_) return end_;
  if (*at_ == '"') return string_end(at_, end_);
  if (next_is(kNumberStart)) return std::find_if_not(at_, end_, runs_on_number);
  return at_ + std::max<std::size_t>(peek_word().size(), 1);
}

Span ClassicScanner::next_span() const {
  return {source_, offset(), static_cast<std::uint32_t>(token_end() - begin_)};
}

std::string ClassicScanner::describe_next() const {
  if (at_end()) return "the end of the file";
  if (next() == '"') return "a string";
  return described({at_, static_cast<std::size_t>(token_end() - at_)});
}

Name ClassicScanner::take_word() {
  const std::uint32_t begin = offset();
  const std::string_view word = peek_word();
  if (!word.empty()) finish_token(word_end_);
  return {word, span_from(begin)};
}

Name ClassicScanner::take_bare() {
  constexpr std::string_view kEnds = " \t\r\n,\"[]{}";
  const std::uint32_t begin = offset();
  const char* const bare_end = std::find_if(at_, end_, [&](char c) { return kEnds.find(c) != std::string_view::npos; });
  const std::string_view bare(at_, static_cast<std::size_t>(bare_end - at_));
  if (!bare.empty()) finish_token(bare_end);
  return {bare, span_from(begin)};
}

bool ClassicScanner::brace_follows_word() const {
  ClassicScanner ahead = *this;
  return !ahead.take_word().empty() && ahead.next() == '{';
}

bool ClassicScanner::take_odd_number(double& value) {
  double read = 0;
  const auto [end, error] = scan_number(at_, end_, read);
  const std::string_view token(at_, static_cast<std::size_t>(token_end() - at_));
  if (error == std::errc()) value = read;
  // Too small to tell from zero is zero: exporters write `1e-400` and mean that.
  const bool tiny = error == std::errc::result_out_of_range && end == token_end() && token.find("e-") != std::string_view::npos;
  finish_token(token_end());
  return tiny;
}

bool ClassicScanner::take_string(MappedText& text) {
  const char* run = at_ + 1;
  const char* at = run;
  const auto place = [&](const char* c) { return static_cast<std::uint32_t>(c - begin_); };
  const auto append_run = [&](const char* run_end) {
    append_with_line_feeds(text, *sources_, {source_, place(run), place(run_end)});
  };
  for (; at != end_ && *at != '"'; ++at) {
    const bool escape = *at == '\\' && at + 1 != end_ && (at[1] == '"' || at[1] == '\\');
    if (!escape) continue;
    append_run(at);
    text.append_generated({at + 1, 1}, {source_, place(at), place(at) + 2});
    run = ++at + 1;
  }
  append_run(at);
  const bool closed = at != end_;
  finish_token(closed ? at + 1 : at);
  return closed;
}

void ClassicScanner::skip_item() {
  skip_item_of(*this);
}

}  // namespace plugc
