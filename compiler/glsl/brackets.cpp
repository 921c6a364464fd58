// A stack of open brackets. What is left open is given up where the text stops being legal, so a missing bracket costs its own
// block, not the whole text:
//
//     f(a, b;          `(` at the `;`, unless a `for` opened it
//     f(a, b }         `(` at the `}`
//     void f() { a;    `{` where the next function is defined, when braces are missing at all, else at the end
//     void g() {}
//
// A bracket that does not fit the innermost open one is dropped. Macros may hold brackets that are not seen here: where the
// text defines one whose own brackets do not match, nothing is certain; and what a macro's call holds may be anything.

#include "glsl/brackets.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

bool is_code(const Token& token) {
  return token.kind == TokenKind::identifier || token.kind == TokenKind::number || token.kind == TokenKind::symbol;
}

char partner(char opening) {
  return opening == '(' ? ')' : opening == '[' ? ']' : '}';
}

/// Words that stand in front of `(...) {` without defining a function.
bool is_statement_word(std::string_view word) {
  constexpr std::string_view kWords[] = {"else", "return", "do", "case", "default"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

class BracketMatcher {
 public:
  BracketMatcher(std::string_view text, Outline& outline) : text_(text), outline_(outline) {
    for (const MacroOutline& macro : outline.macros) note_macro(macro);
  }

  BracketedCode run(const std::vector<Token>& tokens) {
    code_.tokens.reserve(tokens.size());
    count_braces(tokens);
    for (const Token& token : tokens) {
      if (is_code(token) && !take(token)) break;
    }
    while (!open_.empty() && !code_.tokens.empty()) give_up_at_end();
    return std::move(code_);
  }

 private:
  std::string_view word(std::size_t index) const { return token_text(text_, code_.tokens[index]); }
  char text_of(std::uint32_t index) const { return text_[code_.tokens[index].begin]; }
  bool is_innermost(char opening) const { return !open_.empty() && text_of(open_.back()) == opening; }

  void note_macro(const MacroOutline& macro);
  void count_braces(const std::vector<Token>& tokens);
  void report(const Token& token, std::string message, ProblemKind kind);
  bool take(const Token& token);
  bool open(const Token& token);
  bool close(const Token& token, char c);
  void keep(const Token& token);
  bool is_in_macro_call() const;
  bool is_for(std::uint32_t opening) const;
  std::size_t function_header() const;
  std::size_t open_braces() const;
  void give_up_before(const Token& token);
  void give_up_at_end();
  void give_up(const Token& place, std::string_view where, std::size_t end);

  std::string_view text_;
  Outline& outline_;
  BracketedCode code_;
  std::vector<std::uint32_t> open_;
  std::vector<std::string_view> macros_;
  bool macros_match_ = true;  // each macro's own brackets do
  std::int64_t missing_braces_ = 0;
  std::size_t given_up_ = 0;  // `(` and `[` whose partner may still come
  bool cut_ = false;          // nested too deep: what is open stays open, and that has been said
};

void BracketMatcher::note_macro(const MacroOutline& macro) {
  macros_.push_back(macro.name);
  std::string open;
  for (const Token& token : scan_range(text_, macro.body_begin, macro.end)) {
    const char c = text_[token.begin];
    if (c == '(' || c == '[' || c == '{') open += partner(c);
    if (c != ')' && c != ']' && c != '}') continue;
    macros_match_ = macros_match_ && !open.empty() && open.back() == c;
    if (!open.empty()) open.pop_back();
  }
  macros_match_ = macros_match_ && open.empty();
}

void BracketMatcher::count_braces(const std::vector<Token>& tokens) {
  for (const Token& token : tokens) {
    if (token.kind != TokenKind::symbol) continue;
    missing_braces_ += text_[token.begin] == '{' ? 1 : text_[token.begin] == '}' ? -1 : 0;
  }
}

void BracketMatcher::report(const Token& token, std::string message, ProblemKind kind) {
  if (!macros_match_ && kind == ProblemKind::fatal) kind = ProblemKind::doubtful;
  outline_.problems.push_back({token.begin, token.end, std::move(message), kind});
}

bool BracketMatcher::take(const Token& token) {
  const char c = text_[token.begin];
  const bool is_symbol = token.kind == TokenKind::symbol;
  if (is_symbol && (c == ')' || c == ']' || c == '}')) return close(token, c);
  if (is_symbol && (c == ';' || c == '{')) give_up_before(token);
  if (is_symbol && (c == '(' || c == '[' || c == '{')) return open(token);
  keep(token);
  return true;
}

bool BracketMatcher::open(const Token& token) {
  if (open_.size() == kMaxExpressionNesting) {
    report(token, fmt::format("brackets are nested deeper than {}", kMaxExpressionNesting), ProblemKind::fatal);
    cut_ = true;
    return false;
  }
  open_.push_back(static_cast<std::uint32_t>(code_.tokens.size()));
  keep(token);
  return true;
}

void BracketMatcher::keep(const Token& token) {
  code_.tokens.push_back(token);
  code_.closing.push_back(0);
}

bool BracketMatcher::close(const Token& token, char c) {
  const char opening = c == ')' ? '(' : c == ']' ? '[' : '{';
  if (c == '}' && open_braces() > 0) {
    while (!is_innermost('{')) give_up(token, "in front of `}`", code_.tokens.size());
    given_up_ = 0;
  }
  if (!is_innermost(opening)) {
    if (c != '}' && given_up_ > 0) {
      --given_up_;
    } else {
      report(token, fmt::format("`{}` closes nothing", c), ProblemKind::fatal);
    }
    return true;
  }
  code_.closing[open_.back()] = static_cast<std::uint32_t>(code_.tokens.size());
  open_.pop_back();
  keep(token);
  return true;
}

/// Whether one of the innermost `(` and `[` belongs to a call of a macro. At most kMaxExpressionNesting steps.
bool BracketMatcher::is_in_macro_call() const {
  for (auto opening = open_.rbegin(); opening != open_.rend() && text_of(*opening) != '{'; ++opening) {
    if (*opening > 0 && std::find(macros_.begin(), macros_.end(), word(*opening - 1)) != macros_.end()) return true;
  }
  return false;
}

bool BracketMatcher::is_for(std::uint32_t opening) const {
  return opening > 0 && word(opening - 1) == "for";
}

/// Where the `void f(...)` begins that the tokens so far end in: a `{` behind it defines a function. 0: they do not.
std::size_t BracketMatcher::function_header() const {
  const std::size_t end = code_.tokens.size() - 1;
  if (code_.tokens.empty() || word(end) != ")") return 0;
  std::size_t opening = end;
  while (opening > 0 && code_.closing[opening] != end) --opening;
  const bool named = opening >= 2 && code_.tokens[opening - 1].kind == TokenKind::identifier &&
                     code_.tokens[opening - 2].kind == TokenKind::identifier && !is_statement_word(word(opening - 2));
  return named ? opening - 2 : 0;
}

// At most kMaxExpressionNesting steps.
std::size_t BracketMatcher::open_braces() const {
  return static_cast<std::size_t>(
      std::count_if(open_.begin(), open_.end(), [&](std::uint32_t index) { return text_of(index) == '{'; }));
}

/// In front of a `;` or `{`: neither may stand inside of `(` or `[`, nor the body of a function inside of another one's.
void BracketMatcher::give_up_before(const Token& token) {
  const bool semicolon = text_[token.begin] == ';';
  if (is_in_macro_call()) return;
  while (!open_.empty() && !is_innermost('{') && !(semicolon && is_for(open_.back()))) {
    give_up(token, fmt::format("in front of `{}`", token_text(text_, token)), code_.tokens.size());
  }
  const std::size_t header = semicolon || missing_braces_ <= 0 ? 0 : function_header();
  for (; header > 0 && !open_.empty() && missing_braces_ > 0; --missing_braces_) {
    give_up(code_.tokens[header], "in front of this function", header);
  }
}

void BracketMatcher::give_up_at_end() {
  const auto end = static_cast<std::uint32_t>(text_.size());
  give_up({TokenKind::invalid, end, end}, "at the end of the text", code_.tokens.size());
}

/// The innermost bracket ends in front of the token of index `end`.
void BracketMatcher::give_up(const Token& place, std::string_view where, std::size_t end) {
  const std::uint32_t index = open_.back();
  const char opening = text_of(index);
  if (!cut_) {
    report(place, fmt::format("`{}` is missing {}", partner(opening), where), ProblemKind::fatal);
    outline_.problems.back().cause = {code_.tokens[index].begin, code_.tokens[index].end};
    outline_.problems.back().cause_message = fmt::format("this `{}` is never closed", opening);
  }
  if (opening != '{') ++given_up_;
  code_.closing[index] = static_cast<std::uint32_t>(end - 1);
  open_.pop_back();
}

}  // namespace

BracketedCode match_brackets(std::string_view text, const std::vector<Token>& tokens, Outline& outline) {
  return BracketMatcher(text, outline).run(tokens);
}

}  // namespace plugc
