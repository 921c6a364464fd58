// A condition is first expanded into a flat list of numbers, operators and brackets: `defined X` becomes 1 or 0, an
// object-like macro its tokens (never inside itself, as in C), any other identifier 0. The list is then read by precedence
// climbing, so that the call depth grows with brackets and prefixes only, and these are capped.

#include "glsl/condition.h"

#include <array>
#include <charconv>

#include "base/limits.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

constexpr std::uint32_t kMaxExpansionDepth = 64;
constexpr std::size_t kExpansionBudget = kMaxStageBytes;

struct BinaryOperator {
  std::string_view symbol;
  int precedence;
};
constexpr std::array<BinaryOperator, 18> kOperators = {{{"||", 1},
                                                        {"&&", 2},
                                                        {"|", 3},
                                                        {"^", 4},
                                                        {"&", 5},
                                                        {"==", 6},
                                                        {"!=", 6},
                                                        {"<", 7},
                                                        {">", 7},
                                                        {"<=", 7},
                                                        {">=", 7},
                                                        {"<<", 8},
                                                        {">>", 8},
                                                        {"+", 9},
                                                        {"-", 9},
                                                        {"*", 10},
                                                        {"/", 10},
                                                        {"%", 10}}};

int precedence_of(std::string_view symbol) {
  for (const BinaryOperator& candidate : kOperators) {
    if (candidate.symbol == symbol) return candidate.precedence;
  }
  return 0;
}

// Wraps around on overflow instead of being undefined.
std::int64_t wrapped(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

std::optional<std::int64_t> apply_arithmetic(std::string_view symbol, std::int64_t left, std::int64_t right) {
  const auto a = static_cast<std::uint64_t>(left);
  const auto b = static_cast<std::uint64_t>(right);
  if (symbol == "+") return wrapped(a + b);
  if (symbol == "-") return wrapped(a - b);
  if (symbol == "*") return wrapped(a * b);
  if (symbol == "<<" || symbol == ">>") {
    if (right < 0 || right > 31) return std::nullopt;
    return symbol == "<<" ? wrapped(a << b) : left >> right;
  }
  if (right == 0 || (symbol != "/" && symbol != "%")) return std::nullopt;
  if (right == -1) return symbol == "/" ? wrapped(0 - a) : 0;
  return symbol == "/" ? left / right : left % right;
}

std::optional<std::int64_t> apply(std::string_view symbol, std::int64_t left, std::int64_t right) {
  if (symbol == "||") return left != 0 || right != 0;
  if (symbol == "&&") return left != 0 && right != 0;
  if (symbol == "|") return left | right;
  if (symbol == "^") return left ^ right;
  if (symbol == "&") return left & right;
  if (symbol == "==") return left == right;
  if (symbol == "!=") return left != right;
  if (symbol == "<") return left < right;
  if (symbol == ">") return left > right;
  if (symbol == "<=") return left <= right;
  if (symbol == ">=") return left >= right;
  return apply_arithmetic(symbol, left, right);
}

std::optional<std::int64_t> number_value(std::string_view digits) {
  if (digits.ends_with('u') || digits.ends_with('U')) digits.remove_suffix(1);
  int base = 10;
  if (digits.size() > 1 && digits[0] == '0') {
    const bool hex = (digits[1] | 0x20) == 'x';
    base = hex ? 16 : 8;
    digits.remove_prefix(hex ? 2 : 1);
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// Reads an expanded condition. Nothing is returned as soon as a rule does not fit.
class ConditionReader {
 public:
  explicit ConditionReader(std::span<const ConditionWord> words) : words_(words) {}

  std::optional<std::int64_t> read_all() {
    const auto value = read_binary(1);
    return at_ == words_.size() ? value : std::nullopt;
  }

 private:
  std::string_view peek() const { return at_ < words_.size() ? words_[at_].text : std::string_view{}; }

  std::optional<std::int64_t> read_binary(int least_precedence) {
    auto left = read_prefixed();
    for (int precedence = precedence_of(peek()); left && precedence >= least_precedence; precedence = precedence_of(peek())) {
      const std::string_view symbol = words_[at_++].text;
      const auto right = read_binary(precedence + 1);
      left = right ? apply(symbol, *left, *right) : std::nullopt;
    }
    return left;
  }

  std::optional<std::int64_t> read_prefixed() {
    if (at_ == words_.size() || depth_ == kMaxExpressionNesting) return std::nullopt;
    const ConditionWord word = words_[at_++];
    if (word.kind == TokenKind::number) return number_value(word.text);
    ++depth_;
    const auto value = word.text == "(" ? read_bracketed() : read_operand(word.text);
    --depth_;
    return value;
  }

  std::optional<std::int64_t> read_bracketed() {
    const auto value = read_binary(1);
    if (peek() != ")") return std::nullopt;
    ++at_;
    return value;
  }

  std::optional<std::int64_t> read_operand(std::string_view prefix) {
    if (prefix != "!" && prefix != "-" && prefix != "+" && prefix != "~") return std::nullopt;
    const auto operand = read_prefixed();
    if (!operand) return std::nullopt;
    if (prefix == "!") return *operand == 0;
    if (prefix == "~") return ~*operand;
    return prefix == "-" ? wrapped(0 - static_cast<std::uint64_t>(*operand)) : *operand;
  }

  std::span<const ConditionWord> words_;
  std::size_t at_ = 0;
  std::uint32_t depth_ = 0;
};

}  // namespace

MacroTable::MacroTable(std::span<const MacroDefinition> predefined) : budget_(kExpansionBudget) {
  define("__VERSION__", "330", false);
  for (const MacroDefinition& macro : predefined) define(macro.name, macro.value, false);
}

void MacroTable::define(std::string_view name, std::string_view value, bool has_parameters) {
  macros_[name] = {value, has_parameters, false};
}

std::optional<std::int64_t> MacroTable::evaluate(std::string_view expression) {
  words_.clear();
  if (!expand(expression, 0)) return std::nullopt;
  return ConditionReader(words_).read_all();
}

bool MacroTable::spend(std::size_t bytes) {
  budget_ = bytes > budget_ ? 0 : budget_ - bytes;
  return budget_ != 0;
}

// Appends the expanded tokens of `expression` to words_; false when it has no value.
bool MacroTable::expand(std::string_view expression, std::uint32_t depth) {
  if (depth == kMaxExpansionDepth || !spend(expression.size() + 1)) return false;
  const std::vector<Token> tokens = scan_range(expression, 0, static_cast<std::uint32_t>(expression.size()));
  const auto text_at = [&](std::size_t i) {
    return i < tokens.size() ? token_text(expression, tokens[i]) : std::string_view{};
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::identifier) {
      words_.push_back({tokens[i].kind, text_at(i)});
    } else if (text_at(i) == "defined") {
      const bool bracketed = text_at(i + 1) == "(";
      i += bracketed ? 2 : 1;
      if (i >= tokens.size() || tokens[i].kind != TokenKind::identifier) return false;
      words_.push_back({TokenKind::number, is_defined(text_at(i)) ? "1" : "0"});
      if (bracketed && text_at(++i) != ")") return false;
    } else if (!expand_identifier(text_at(i), depth)) {
      return false;
    }
  }
  return true;
}

bool MacroTable::expand_identifier(std::string_view name, std::uint32_t depth) {
  const auto found = macros_.find(name);
  if (found == macros_.end() || found->second.expanding) {
    words_.push_back({TokenKind::number, "0"});
    return true;
  }
  Macro& macro = found->second;
  if (macro.has_parameters) return false;
  macro.expanding = true;
  const bool expanded = expand(macro.value, depth + 1);
  macro.expanding = false;
  return expanded;
}

}  // namespace plugc
