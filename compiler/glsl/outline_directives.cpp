// One pass over the tokens that are not code. Live `#if` ... `#endif` lines are counted against each other; those inside
// dead branches come in pairs that the tokenizer has swallowed.

#include "glsl/outline_directives.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "glsl/marker.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

class DirectiveReader {
 public:
  DirectiveReader(std::string_view text, Outline& outline) : text_(text), outline_(outline) {}

  void run(const std::vector<Token>& tokens) {
    for (const Token& token : tokens) {
      if (token.kind == TokenKind::directive) read_directive(token);
      if (token.kind == TokenKind::marker) read_marker_token(token);
      if (token.kind == TokenKind::invalid) read_invalid(token);
      if (token.kind != TokenKind::marker) before_ = token_text(text_, token);
    }
    for (const Token& condition : conditions_) report_open(condition);
  }

 private:
  using Words = std::vector<Token>;

  void report(const Token& token, std::string message, ProblemKind kind = ProblemKind::doubtful) {
    outline_.problems.push_back({token.begin, token.end, std::move(message), kind});
  }
  void report_open(const Token& condition) {
    const auto end = static_cast<std::uint32_t>(text_.size());
    report({TokenKind::invalid, end, end}, "`#endif` is missing at the end of the text", ProblemKind::fatal);
    outline_.problems.back().cause = {condition.begin, condition.end};
    outline_.problems.back().cause_message = fmt::format("this `{}` is never closed", first_line(condition));
  }
  std::string_view word(const Words& words, std::size_t i) const {
    return i < words.size() ? token_text(text_, words[i]) : std::string_view{};
  }
  std::string_view first_line(const Token& token) const {
    const std::string_view whole = token_text(text_, token);
    return whole.substr(0, std::min(whole.find_first_of("\\\r\n"), kShown));
  }

  void read_directive(const Token& directive) {
    const Words words = directive_tokens(text_, directive);
    const std::string_view name = word(words, 1);
    if (name == "version") read_version(directive, words);
    if (name == "extension") outline_.extensions.push_back({directive.begin, directive.end});
    if (name == "define") read_define(directive, words);
    if (name == "undef") outline_.undefs.push_back({directive.begin, directive.end});
    if (name == "if" || name == "ifdef" || name == "ifndef") conditions_.push_back(directive);
    if (name == "elif" || name == "else" || name == "endif") read_branch(directive, name);
  }

  void read_version(const Token& directive, const Words& words) {
    const std::string_view number = word(words, 2);
    VersionDirective version;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), version.number);
    if (error != std::errc() || end != number.data() + number.size()) {
      report(directive, "`#version` has no number that can be read", ProblemKind::fatal);
      version.number = 0;
    }
    version.profile = word(words, 3);
    version.begin = directive.begin;
    version.end = directive.end;
    outline_.version = version;
  }

  void read_define(const Token& directive, const Words& words) {
    if (words.size() < 3 || words[2].kind != TokenKind::identifier) {
      return report(directive, "`#define` names no macro", ProblemKind::fatal);
    }
    MacroOutline macro;
    macro.name = word(words, 2);
    macro.name_begin = words[2].begin;
    macro.begin = directive.begin;
    macro.end = directive.end;
    macro.body_begin = words[2].end;
    // Parameters start right behind the name: `A (x)` is a macro without any.
    if (words.size() > 3 && words[3].begin == words[2].end && word(words, 3) == "(") {
      std::size_t i = 4;
      while (i < words.size() && word(words, i) != ")") ++i;
      macro.body_begin = i < words.size() ? words[i].end : directive.end;
    }
    outline_.macros.push_back(macro);
  }

  void read_branch(const Token& directive, std::string_view name) {
    if (conditions_.empty()) return report(directive, fmt::format("`#{}` has no `#if`", name), ProblemKind::fatal);
    if (name == "endif") conditions_.pop_back();
  }

  void read_marker_token(const Token& token) {
    const MarkerWords words = read_marker(text_, token);
    if (!words.well_formed)
      return report(token, "a plug marker is written `/* PLUG: name (arguments) */`", ProblemKind::harmless);
    MarkerOutline marker;
    marker.kind = words.kind;
    marker.name = text_.substr(words.name_begin, words.name_end - words.name_begin);
    marker.arguments = text_.substr(words.arguments_begin, words.arguments_end - words.arguments_begin);
    marker.argument_list = split_arguments(marker.arguments);
    marker.is_sole_statement = before_ == ")" || before_ == "else" || before_ == "do";
    marker.begin = token.begin;
    marker.end = token.end;
    marker.name_begin = words.name_begin;
    outline_.markers.push_back(std::move(marker));
  }

  void read_invalid(const Token& token) {
    if (comment_at(text_, token.begin) == CommentKind::block) return report(token, "`/*` is never closed", ProblemKind::fatal);
    const auto first = static_cast<unsigned char>(text_[token.begin]);
    if (first == '"') return report(token, "GLSL has no strings");
    const bool printable = first > ' ' && first != 0x7F;
    report(token, printable ? fmt::format("stray `{}`", first_line(token)) : fmt::format("stray byte {:#04x}", first));
  }

  static constexpr std::size_t kShown = 60;  // bytes of the author's text in a message
  std::string_view text_;
  Outline& outline_;
  std::vector<Token> conditions_;
  std::string_view before_;  // the last token that is no marker
};

}  // namespace

void outline_directives(std::string_view text, const std::vector<Token>& tokens, Outline& outline) {
  DirectiveReader(text, outline).run(tokens);
}

}  // namespace plugc
