// A stack of open brackets. A `}` closes the nearest `{` and gives up on what is still open inside it; a `)` or `]` that
// does not fit the innermost open bracket is dropped. So a missing bracket costs its own block, not the whole text.

#include "glsl/brackets.h"

#include <fmt/format.h>

#include "base/limits.h"

namespace plugc {
namespace {

class BracketMatcher {
 public:
  BracketMatcher(std::string_view text, std::vector<OutlineProblem>& problems) : text_(text), problems_(problems) {}

  BracketedCode run(const std::vector<Token>& tokens) {
    code_.tokens.reserve(tokens.size());
    for (const Token& token : tokens) {
      if (token.kind != TokenKind::identifier && token.kind != TokenKind::number && token.kind != TokenKind::symbol) continue;
      if (!take(token)) break;
    }
    while (!open_.empty()) give_up_innermost();
    return std::move(code_);
  }

 private:
  char text_of(std::uint32_t index) const { return text_[code_.tokens[index].begin]; }

  void report(const Token& token, std::string message) { problems_.push_back({token.begin, token.end, std::move(message)}); }

  bool take(const Token& token) {
    const char c = text_[token.begin];
    if (c == ')' || c == ']' || c == '}') return close(token, c);
    if (c == '(' || c == '[' || c == '{') {
      if (open_.size() == kMaxExpressionNesting) {
        report(token, fmt::format("brackets are nested deeper than {}", kMaxExpressionNesting));
        cut_ = true;
        return false;
      }
      open_.push_back(static_cast<std::uint32_t>(code_.tokens.size()));
    }
    keep(token);
    return true;
  }

  void keep(const Token& token) {
    code_.tokens.push_back(token);
    code_.closing.push_back(0);
  }

  bool close(const Token& token, char c) {
    const char opening = c == ')' ? '(' : c == ']' ? '[' : '{';
    if (c == '}' && open_braces() > 0) {
      while (text_of(open_.back()) != '{') give_up_innermost();
    }
    if (open_.empty() || text_of(open_.back()) != opening) {
      report(token, fmt::format("`{}` closes nothing", c));
      return true;
    }
    code_.closing[open_.back()] = static_cast<std::uint32_t>(code_.tokens.size());
    open_.pop_back();
    keep(token);
    return true;
  }

  // At most kMaxExpressionNesting steps.
  std::size_t open_braces() const {
    std::size_t count = 0;
    for (const std::uint32_t index : open_) count += text_of(index) == '{' ? 1 : 0;
    return count;
  }

  void give_up_innermost() {
    const std::uint32_t index = open_.back();
    if (!cut_) report(code_.tokens[index], fmt::format("`{}` is never closed", text_of(index)));
    code_.closing[index] = static_cast<std::uint32_t>(code_.tokens.size() - 1);
    open_.pop_back();
  }

  std::string_view text_;
  std::vector<OutlineProblem>& problems_;
  BracketedCode code_;
  std::vector<std::uint32_t> open_;
  bool cut_ = false;  // nested too deep: what is open stays open, and that has been said
};

}  // namespace

BracketedCode match_brackets(std::string_view text, const std::vector<Token>& tokens, std::vector<OutlineProblem>& problems) {
  return BracketMatcher(text, problems).run(tokens);
}

}  // namespace plugc
