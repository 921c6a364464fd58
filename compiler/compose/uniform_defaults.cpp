// Recursive descent over the initialiser's tokens. A name is replaced by the initialiser of the constant, or by the body of
// the macro, that it stands for; the depth of all nesting together is limited.

#include "compose/uniform_defaults.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "glsl/scan.h"

namespace plugc {
namespace {

constexpr int kMaxDepth = 40;
constexpr std::size_t kMaxNumbers = 4096;

struct Value {
  std::vector<double> numbers;
  bool is_integer = false;
};
using MaybeValue = std::optional<Value>;

bool is_matrix(const Value& value) {
  return value.numbers.size() > 4;
}

MaybeValue calculate(char operation, const Value& a, const Value& b) {
  const bool both_scalars_fit = a.numbers.size() == 1 || b.numbers.size() == 1 || a.numbers.size() == b.numbers.size();
  const bool of_matrices = is_matrix(a) && is_matrix(b) && (operation == '*' || operation == '/');
  if (!both_scalars_fit || of_matrices) return std::nullopt;
  Value result{std::vector<double>(std::max(a.numbers.size(), b.numbers.size())), a.is_integer && b.is_integer};
  for (std::size_t i = 0; i < result.numbers.size(); ++i) {
    const double x = a.numbers[a.numbers.size() == 1 ? 0 : i];
    const double y = b.numbers[b.numbers.size() == 1 ? 0 : i];
    if (operation == '/' && y == 0) return std::nullopt;
    const double quotient = operation == '/' ? (result.is_integer ? std::trunc(x / y) : x / y) : 0;
    result.numbers[i] = operation == '+' ? x + y : operation == '-' ? x - y : operation == '*' ? x * y : quotient;
  }
  return result;
}

MaybeValue read_number(std::string_view word) {
  const bool hexadecimal = word.starts_with("0x") || word.starts_with("0X");
  while (!hexadecimal && !word.empty() && std::string_view("fFlLuU").find(word.back()) != std::string_view::npos)
    word.remove_suffix(1);
  const bool integer = word.find_first_of(".eE") == std::string_view::npos;
  if (hexadecimal || (integer && word.size() > 1 && word.front() == '0')) return std::nullopt;
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return Value{{number}, integer};
}

/// What a constructor makes of its arguments.
struct Shape {
  std::size_t size = 1;
  std::size_t columns = 1;  ///< More than 1 for matrices.
  bool is_integer = false, is_boolean = false;
};

std::optional<Shape> find_shape(std::string_view type) {
  static const std::map<std::string_view, Shape> kShapes = {
      {"float", {1, 1, false, false}}, {"int", {1, 1, true, false}},   {"uint", {1, 1, true, false}},
      {"bool", {1, 1, true, true}},    {"vec2", {2, 1, false, false}}, {"vec3", {3, 1, false, false}},
      {"vec4", {4, 1, false, false}},  {"ivec2", {2, 1, true, false}}, {"ivec3", {3, 1, true, false}},
      {"ivec4", {4, 1, true, false}},  {"mat3", {9, 3, false, false}}, {"mat4", {16, 4, false, false}}};
  const auto found = kShapes.find(type);
  return found == kShapes.end() ? std::nullopt : std::optional(found->second);
}

MaybeValue construct(const Shape& shape, const std::vector<Value>& arguments) {
  Value all{{}, shape.is_integer};
  for (const Value& argument : arguments)
    all.numbers.insert(all.numbers.end(), argument.numbers.begin(), argument.numbers.end());
  if (all.numbers.empty()) return std::nullopt;
  if (arguments.size() == 1 && all.numbers.size() == 1 && shape.size > 1) {
    const double only = all.numbers.front();
    all.numbers.assign(shape.size, shape.columns > 1 ? 0 : only);
    for (std::size_t i = 0; i < shape.size && shape.columns > 1; i += shape.columns + 1) all.numbers[i] = only;
  }
  const bool from_matrix = std::ranges::any_of(arguments, is_matrix) && all.numbers.size() != shape.size;
  if (all.numbers.size() < shape.size || from_matrix) return std::nullopt;
  all.numbers.resize(shape.size);
  for (double& number : all.numbers) {
    if (shape.is_boolean) number = number != 0 ? 1 : 0;
    if (shape.is_integer) number = std::trunc(number);
  }
  return all;
}

class InitializerReader {
 public:
  InitializerReader(const CodeUnit& code, std::uint32_t begin, std::uint32_t end, int depth)
      : code_(code), tokens_(scan_range(code.text.text(), begin, end)), depth_(depth) {}

  MaybeValue read() {
    MaybeValue value = read_sum();
    return at_ == tokens_.size() ? value : std::nullopt;
  }

 private:
  std::string_view word() const { return at_ < tokens_.size() ? code_.at(tokens_[at_]) : std::string_view(); }
  bool take(std::string_view symbol) {
    if (word() != symbol) return false;
    ++at_;
    return true;
  }
  MaybeValue read_sum();
  MaybeValue read_product();
  MaybeValue read_unary();
  MaybeValue read_primary();
  MaybeValue read_constructor(std::string_view type);
  MaybeValue read_name(std::string_view name) const;

  const CodeUnit& code_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_;
};

MaybeValue InitializerReader::read_sum() {
  MaybeValue left = read_product();
  while (left && (word() == "+" || word() == "-")) {
    const char operation = code_.at(tokens_[at_++]).front();
    const MaybeValue right = read_product();
    left = right ? calculate(operation, *left, *right) : std::nullopt;
  }
  return left;
}

MaybeValue InitializerReader::read_product() {
  MaybeValue left = read_unary();
  while (left && (word() == "*" || word() == "/")) {
    const char operation = code_.at(tokens_[at_++]).front();
    const MaybeValue right = read_unary();
    left = right ? calculate(operation, *left, *right) : std::nullopt;
  }
  return left;
}

MaybeValue InitializerReader::read_unary() {
  bool negative = false;
  while (word() == "-" || word() == "+") negative = (code_.at(tokens_[at_++]) == "-") != negative;
  MaybeValue value = read_primary();
  if (!value || !negative) return value;
  for (double& number : value->numbers) number = -number;
  return value;
}

MaybeValue InitializerReader::read_primary() {
  if (at_ >= tokens_.size() || depth_ >= kMaxDepth) return std::nullopt;
  if (take("(")) {
    ++depth_;
    MaybeValue inner = read_sum();
    --depth_;
    return take(")") ? inner : std::nullopt;
  }
  const Token token = tokens_[at_];
  const std::string_view text = code_.at(token);
  ++at_;
  if (token.kind != TokenKind::identifier) return read_number(text);
  if (text == "true" || text == "false") return Value{{text == "true" ? 1.0 : 0.0}, true};
  if (word() == "(" || word() == "[") return read_constructor(text);
  return read_name(text);
}

/// `vec3(1.0, 0.5, 0.25)`; `float[2](0.25, 0.75)`, whose elements stand one behind the other.
MaybeValue InitializerReader::read_constructor(std::string_view type) {
  const bool array = take("[");
  while (array && at_ < tokens_.size() && !take("]")) ++at_;
  const auto shape = find_shape(type);
  if (!shape || !take("(")) return std::nullopt;
  ++depth_;
  std::vector<Value> arguments;
  Value elements{{}, shape->is_integer};
  do {
    MaybeValue argument = read_sum();
    if (!argument || elements.numbers.size() > kMaxNumbers) return std::nullopt;
    if (array && argument->numbers.size() != shape->size) return std::nullopt;
    elements.numbers.insert(elements.numbers.end(), argument->numbers.begin(), argument->numbers.end());
    arguments.push_back(std::move(*argument));
  } while (take(","));
  --depth_;
  if (!take(")")) return std::nullopt;
  return array ? MaybeValue(std::move(elements)) : construct(*shape, arguments);
}

MaybeValue InitializerReader::read_name(std::string_view name) const {
  const auto range = [&]() -> std::optional<TextRange> {
    for (const MacroOutline& macro : code_.outline.macros) {
      if (macro.name == name) return TextRange{macro.body_begin, macro.end};
    }
    for (const GlobalOutline& global : code_.outline.globals) {
      const bool constant = global.storage == Storage::constant && global.initializer_end > global.initializer_begin;
      if (constant && global.name == name) return TextRange{global.initializer_begin, global.initializer_end};
    }
    return std::nullopt;
  }();
  return range ? InitializerReader(code_, range->begin, range->end, depth_ + 1).read() : std::nullopt;
}

}  // namespace

std::optional<std::vector<double>> initial_value(const CodeUnit& code, const GlobalOutline& global) {
  if (global.initializer_end <= global.initializer_begin) return std::nullopt;
  const MaybeValue value = InitializerReader(code, global.initializer_begin, global.initializer_end, 0).read();
  return value ? std::optional(value->numbers) : std::nullopt;
}

}  // namespace plugc
