// A token is as long as it can be. A text has two apostrophes where it means one.

#include "script/script_tokens.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/script_limits.h"

namespace plugc {
namespace {

constexpr std::string_view kBlank = " \t\r\n";
constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_";
constexpr std::string_view kNameCharacters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";
/// A longer one stands before the one that it begins with.
constexpr std::array<std::string_view, 17> kSymbols = {":=", "<=", ">=", "<>", "<", ">", "=", "+", "-",
                                                       "*",  "/",  "%",  "^",  "(", ")", ",", ";"};

bool is_in(std::string_view set, char c) {
  return set.find(c) != std::string_view::npos;
}

class TokenReader {
 public:
  TokenReader(const MappedText& code, Diagnostics& diagnostics) : code_(code), text_(code.text()), diagnostics_(diagnostics) {}

  std::vector<ScriptToken> run() {
    while (skip_blank() && read_token()) {
    }
    tokens_.push_back({failed_ ? ScriptTokenKind::lost : ScriptTokenKind::end, "", code_.size(), code_.size()});
    return std::move(tokens_);
  }

 private:
  /// False at the end, and where a comment has none.
  bool skip_blank() {
    for (at_ = text_.find_first_not_of(kBlank, at_); at_ < text_.size() && text_[at_] == '{';
         at_ = text_.find_first_not_of(kBlank, at_ + 1)) {
      const std::size_t close = text_.find('}', at_);
      if (close == std::string_view::npos) return fail(at_, 1, "this comment has no `}`");
      at_ = close;
    }
    return at_ < text_.size();
  }

  bool read_token() {
    if (tokens_.size() == kMaxScriptTokens) return fail(at_, 1, fmt::format("a script has at most {} words", kMaxScriptTokens));
    const char first = text_[at_];
    if (is_in(kLetters, first)) return take(ScriptTokenKind::name, text_.find_first_not_of(kNameCharacters, at_));
    if (is_in(kDigits, first)) return read_number();
    if (first == '\'') return read_text();
    for (const std::string_view symbol : kSymbols) {
      if (text_.substr(at_).starts_with(symbol)) return take(ScriptTokenKind::symbol, at_ + symbol.size());
    }
    return fail(at_, 1, "this character means nothing in a script");
  }

  bool read_number() {
    const std::size_t dot = std::min(text_.find_first_not_of(kDigits, at_), text_.size());
    const bool has_fraction = dot + 1 < text_.size() && text_[dot] == '.' && is_in(kDigits, text_[dot + 1]);
    if (!has_fraction) return take(ScriptTokenKind::whole_number, dot);
    return take(ScriptTokenKind::number, text_.find_first_not_of(kDigits, dot + 1));
  }

  bool read_text() {
    std::string text;
    for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
      if (text_[i] == '\'' && !text_.substr(i).starts_with("''")) {
        add(ScriptTokenKind::text, std::move(text), i + 1);
        return true;
      }
      text += text_[i];
      if (text_[i] == '\'') ++i;
    }
    return fail(at_, 1, "this text has no closing apostrophe");
  }

  bool take(ScriptTokenKind kind, std::size_t end) {
    end = std::min(end, text_.size());
    std::string text = lower_case(text_.substr(at_, end - at_));
    if (kind == ScriptTokenKind::name && text == "function") kind = ScriptTokenKind::function;
    add(kind, std::move(text), end);
    return true;
  }

  void add(ScriptTokenKind kind, std::string text, std::size_t end) {
    tokens_.push_back({kind, std::move(text), static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(end)});
    at_ = end;
  }

  bool fail(std::size_t begin, std::size_t size, std::string message) {
    const auto first = static_cast<std::uint32_t>(begin);
    diagnostics_.report(DiagnosticId::script_invalid, code_.locate(first, first + static_cast<std::uint32_t>(size)),
                        std::move(message));
    failed_ = true;
    return false;
  }

  const MappedText& code_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  bool failed_ = false;
  std::vector<ScriptToken> tokens_;
};

}  // namespace

std::string lower_case(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::vector<ScriptToken> read_script_tokens(const MappedText& code, Diagnostics& diagnostics) {
  return TokenReader(code, diagnostics).run();
}

}  // namespace plugc
