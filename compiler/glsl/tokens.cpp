// One pass over the bytes. White space and comments are skipped; a `#` that is the first thing on its line starts a
// directive, which is obeyed (conditions, definitions) and kept as one token; anything else is scanned as a token. Dead
// branches are scanned the same way, as comments in them must be seen, but yield nothing. A stack holds one entry for
// each open `#if`; nothing recurses.

#include "glsl/tokens.h"

#include <algorithm>

#include "base/limits.h"
#include "glsl/condition.h"
#include "glsl/marker.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

// One `#if` ... `#endif`.
struct Branch {
  bool parent_live = true;
  bool live = true;
  bool taken = true;  // some branch of this `#if` has been live
};

// A directive's words: `#define A(x) 1` has the name `define` and the rest ` A(x) 1`.
struct DirectiveWords {
  std::string_view name;
  std::string_view rest;
};

class Tokenizer {
 public:
  Tokenizer(std::string_view text, std::span<const MacroDefinition> predefined) : text_(text), macros_(predefined) {}

  TokenList run() {
    list_.tokens.reserve(std::min(text_.size() / 4, kMaxShaderTokens));
    while (at_ < text_.size() && !list_.too_many) step();
    return std::move(list_);
  }

 private:
  bool live() const { return branches_.empty() || branches_.back().live; }

  void emit(const Token& token) {
    if (list_.tokens.size() == kMaxShaderTokens) {
      list_.too_many = true;
    } else {
      list_.tokens.push_back(token);
    }
  }

  void step();
  void pass_block_comment();
  void pass_directive();
  std::uint32_t directive_end() const;
  DirectiveWords directive_words(std::uint32_t end) const;
  void obey(const DirectiveWords& words);
  void open_branch(const DirectiveWords& words);
  void next_branch(const DirectiveWords& words);
  bool condition_holds(const DirectiveWords& words);
  void define(std::string_view rest);

  std::string_view text_;
  MacroTable macros_;
  TokenList list_;
  std::vector<Branch> branches_;
  std::uint32_t at_ = 0;
  bool line_start_ = true;  // nothing but white space and comments since the line began
};

void Tokenizer::step() {
  const char c = text_[at_];
  if (is_line_end(c)) {
    line_start_ = true;
    ++at_;
  } else if (is_blank(c)) {
    ++at_;
  } else if (const std::uint32_t continued = continuation_length(text_, at_); continued != 0) {
    at_ += continued;
  } else if (const CommentKind comment = comment_at(text_, at_); comment == CommentKind::line) {
    at_ = line_comment_end(text_, at_);
  } else if (comment == CommentKind::block) {
    pass_block_comment();
  } else if (c == '#' && line_start_) {
    pass_directive();
  } else {
    const Token token = scan_token(text_, at_);
    if (live()) emit(token);
    at_ = token.end;
    line_start_ = false;
  }
}

void Tokenizer::pass_block_comment() {
  const auto text_end = static_cast<std::uint32_t>(text_.size());
  const std::uint32_t end = block_comment_end(text_, at_);
  if (end == UINT32_MAX) {
    emit({TokenKind::invalid, at_, text_end});  // in a dead branch too: the `#endif` is lost in it
  } else if (live() && is_marker(text_.substr(at_, end - at_))) {
    emit({TokenKind::marker, at_, end});
  }
  at_ = std::min(end, text_end);
}

// The line end that ends the directive; comments may carry it over several lines, and an unclosed one is left behind it.
std::uint32_t Tokenizer::directive_end() const {
  std::uint32_t at = at_;
  while (at < text_.size() && !is_line_end(text_[at])) {
    const CommentKind comment = comment_at(text_, at);
    if (comment == CommentKind::line) return line_comment_end(text_, at);
    if (comment == CommentKind::block) {
      const std::uint32_t end = block_comment_end(text_, at);
      if (end == UINT32_MAX) return at;
      at = end;
    } else {
      at += std::max(1U, continuation_length(text_, at));
    }
  }
  return at;
}

DirectiveWords Tokenizer::directive_words(std::uint32_t end) const {
  const std::string_view line = text_.substr(0, end);
  for (std::uint32_t at = at_ + 1; at < end;) {
    if (is_blank(line[at])) {
      ++at;
    } else if (comment_at(line, at) == CommentKind::block) {
      at = block_comment_end(line, at);
    } else if (const std::uint32_t continued = continuation_length(line, at); continued != 0) {
      at += continued;
    } else if (is_identifier_start(line[at])) {
      const Token name = scan_token(line, at);
      return {token_text(line, name), line.substr(name.end)};
    } else {
      break;
    }
  }
  return {};
}

void Tokenizer::pass_directive() {
  const std::uint32_t end = directive_end();
  const bool was_live = live();
  obey(directive_words(end));
  if (was_live || live()) emit({TokenKind::directive, at_, end});
  at_ = end;
  line_start_ = false;
}

void Tokenizer::obey(const DirectiveWords& words) {
  if (words.name == "if" || words.name == "ifdef" || words.name == "ifndef") return open_branch(words);
  if (words.name == "elif" || words.name == "else") return next_branch(words);
  if (words.name == "endif") {
    if (!branches_.empty()) branches_.pop_back();
    return;
  }
  if (!live()) return;
  if (words.name == "define") define(words.rest);
  if (words.name == "undef") {
    const auto tokens = scan_range(words.rest, 0, static_cast<std::uint32_t>(words.rest.size()));
    if (!tokens.empty()) macros_.undefine(token_text(words.rest, tokens.front()));
  }
}

void Tokenizer::open_branch(const DirectiveWords& words) {
  Branch branch;
  branch.parent_live = live();
  branch.live = branch.parent_live && condition_holds(words);
  branch.taken = branch.live;
  branches_.push_back(branch);
}

void Tokenizer::next_branch(const DirectiveWords& words) {
  if (branches_.empty()) return;
  Branch& branch = branches_.back();
  branch.live = branch.parent_live && !branch.taken && (words.name == "else" || condition_holds(words));
  branch.taken = branch.taken || branch.live;
}

// What cannot be evaluated counts as true: the compiler behind will judge the text itself.
bool Tokenizer::condition_holds(const DirectiveWords& words) {
  if (words.name == "if" || words.name == "elif") return macros_.evaluate(words.rest).value_or(1) != 0;
  const auto tokens = scan_range(words.rest, 0, static_cast<std::uint32_t>(words.rest.size()));
  if (tokens.empty()) return true;
  return macros_.is_defined(token_text(words.rest, tokens.front())) == (words.name == "ifdef");
}

void Tokenizer::define(std::string_view rest) {
  const auto tokens = scan_range(rest, 0, static_cast<std::uint32_t>(rest.size()));
  if (tokens.empty() || tokens.front().kind != TokenKind::identifier) return;
  const Token& name = tokens.front();
  const bool has_parameters = name.end < rest.size() && rest[name.end] == '(';
  macros_.define(token_text(rest, name), rest.substr(name.end), has_parameters);
}

}  // namespace

TokenList tokenize(std::string_view text, std::span<const MacroDefinition> predefined) {
  return Tokenizer(text, predefined).run();
}

std::vector<Token> directive_tokens(std::string_view text, const Token& directive) {
  std::vector<Token> tokens;
  tokens.push_back({TokenKind::symbol, directive.begin, directive.begin + 1});
  const std::vector<Token> words = scan_range(text, directive.begin + 1, directive.end);
  tokens.insert(tokens.end(), words.begin(), words.end());
  return tokens;
}

}  // namespace plugc
