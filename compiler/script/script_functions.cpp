// One row for each overload; the first row that fits counts. A letter stands for a type: b boolean, i integer, f number, s
// text, 3 and 4 vectors. Capitals stand for any of several: V vectors, X matrices, T numbers, vectors and matrices, L lists and
// texts; and behind them E and C for what such a list or matrix, the latest argument that was a capital, is made of.

#include "script/script_functions.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace plugc {
namespace {

using Kind = ScriptFunctionKind;
using Op = ScriptOp;

constexpr ScriptType kBoolean{ScriptKind::boolean, false};
constexpr ScriptType kInteger{ScriptKind::integer, false};
constexpr ScriptType kNumber{ScriptKind::number, false};
constexpr ScriptType kText{ScriptKind::text, false};

/// What a step's operand is: how many numbers an element of the first argument has, or 1 for arithmetic of whole numbers.
enum class Operand : std::uint8_t { none, element, whole };

struct Overload {
  std::string_view name, parameters;
  char result = 'n';
  std::optional<ScriptOp> op;
  Operand operand = Operand::none;
};

// clang-format off
constexpr std::array kOverloads = {
    Overload{"+", "ii", 'i', Op::add}, Overload{"+", "TT", 'T', Op::add},
    Overload{"-", "ii", 'i', Op::subtract}, Overload{"-", "TT", 'T', Op::subtract},
    Overload{"-", "i", 'i', Op::negate}, Overload{"-", "T", 'T', Op::negate},
    Overload{"*", "ii", 'i', Op::multiply}, Overload{"*", "fT", 'T', Op::multiply}, Overload{"*", "Tf", 'T', Op::multiply},
    Overload{"*", "XC", 'C', Op::multiply}, Overload{"*", "XX", 'X', Op::multiply},
    Overload{"/", "Tf", 'T', Op::divide},
    Overload{"%", "ii", 'i', Op::modulo, Operand::whole}, Overload{"%", "ff", 'f', Op::modulo},
    Overload{"^", "ii", 'i', Op::power, Operand::whole}, Overload{"^", "ff", 'f', Op::power},
    Overload{"power", "ii", 'i', Op::power, Operand::whole}, Overload{"power", "ff", 'f', Op::power},
    Overload{"=", "bb", 'b', Op::equal}, Overload{"=", "TT", 'b', Op::equal}, Overload{"=", "LL", 'b', Op::equal},
    Overload{"<>", "bb", 'b', Op::not_equal}, Overload{"<>", "TT", 'b', Op::not_equal},
    Overload{"<>", "LL", 'b', Op::not_equal},
    Overload{"<", "ff", 'b', Op::less}, Overload{"<", "ss", 'b', Op::less},
    Overload{"<=", "ff", 'b', Op::less_equal}, Overload{"<=", "ss", 'b', Op::less_equal},
    Overload{">", "ff", 'b', Op::greater}, Overload{">", "ss", 'b', Op::greater},
    Overload{">=", "ff", 'b', Op::greater_equal}, Overload{">=", "ss", 'b', Op::greater_equal},
    Overload{"max", "ii", 'i', Op::greatest}, Overload{"max", "TT", 'T', Op::greatest},
    Overload{"min", "ii", 'i', Op::least}, Overload{"min", "TT", 'T', Op::least},
    Overload{"or", "bb", 'b', Op::greatest}, Overload{"and", "bb", 'b', Op::least}, Overload{"not", "b", 'b', Op::not_},
    Overload{"lerp", "fTT", 'T', Op::lerp},

    Overload{"sin", "f", 'f', Op::sin}, Overload{"cos", "f", 'f', Op::cos}, Overload{"tan", "f", 'f', Op::tan},
    Overload{"cotan", "f", 'f', Op::cotan}, Overload{"arcsin", "f", 'f', Op::arcsin}, Overload{"arccos", "f", 'f', Op::arccos},
    Overload{"arctan", "f", 'f', Op::arctan}, Overload{"arccotan", "f", 'f', Op::arccotan},
    Overload{"sinh", "f", 'f', Op::sinh}, Overload{"cosh", "f", 'f', Op::cosh}, Overload{"tanh", "f", 'f', Op::tanh},
    Overload{"cotanh", "f", 'f', Op::cotanh}, Overload{"exp", "f", 'f', Op::exp}, Overload{"power2", "f", 'f', Op::exp2},
    Overload{"ln", "f", 'f', Op::ln}, Overload{"log2", "f", 'f', Op::log2}, Overload{"log", "ff", 'f', Op::log},
    Overload{"sqr", "i", 'i', Op::square}, Overload{"sqr", "f", 'f', Op::square}, Overload{"sqrt", "f", 'f', Op::sqrt},
    Overload{"sgn", "f", 'i', Op::sign},
    Overload{"abs", "i", 'i', Op::abs}, Overload{"abs", "f", 'f', Op::abs},
    Overload{"floor", "f", 'i', Op::floor}, Overload{"ceil", "f", 'i', Op::ceil}, Overload{"round", "f", 'i', Op::round},
    Overload{"random", "", 'f', Op::random}, Overload{"random", "i", 'i', Op::random_below},

    Overload{"int", "f", 'i', Op::truncate}, Overload{"int", "b", 'i', {}}, Overload{"float", "f", 'f', {}},
    Overload{"float", "b", 'f', {}}, Overload{"bool", "f", 'b', Op::not_zero}, Overload{"bool", "b", 'b', {}},
    Overload{"string", "f", 's', Op::text_of_number}, Overload{"string", "b", 's', Op::text_of_boolean},
    Overload{"string", "s", 's', {}}, Overload{"character_from_code", "i", 's', {}}, Overload{"writeln", "s", 'n', {}},

    Overload{"array_get_count", "L", 'i', Op::count, Operand::element},
    Overload{"array_set_count", "Li", 'L', Op::resize, Operand::element},
    Overload{"array_get", "Li", 'E', Op::element, Operand::element},
    Overload{"array_set", "LiE", 'L', Op::replace, Operand::element},
    Overload{"vector_get_count", "V", 'i', Op::count, Operand::element},
    Overload{"vector_get", "Vi", 'f', Op::element, Operand::element},
    Overload{"vector_set", "Vif", 'V', Op::replace, Operand::element},
    Overload{"matrix_get_count", "X", 'i', Op::count, Operand::element},
    Overload{"matrix_get", "Xi", 'C', Op::element, Operand::element},
    Overload{"matrix_set", "XiC", 'X', Op::replace, Operand::element},

    Overload{"vector_length", "V", 'f', Op::length}, Overload{"vector_sqr_length", "V", 'f', Op::square_length},
    Overload{"vector_dot", "VV", 'f', Op::dot}, Overload{"vector_cross", "33", '3', Op::cross},
    Overload{"grayscale", "3", 'f', Op::grayscale}, Overload{"rotate", "43", '3', Op::rotate},
    Overload{"orientation_to_direction", "4", '3', Op::direction}, Overload{"orientation_to_up", "4", '3', Op::up},
    Overload{"orientation_from_direction_up", "33", '4', Op::orientation}, Overload{"slerp", "f44", '4', Op::slerp},
};
// clang-format on

struct NamedKind {
  std::string_view name;
  Kind kind;
};

/// Those that are more than their rows say.
constexpr std::array kNamed = {
    NamedKind{"max", Kind::folded},
    NamedKind{"min", Kind::folded},
    NamedKind{"and", Kind::folded},
    NamedKind{"or", Kind::folded},
    NamedKind{"array_set", Kind::setter},
    NamedKind{"array_set_count", Kind::setter},
    NamedKind{"vector_set", Kind::setter},
    NamedKind{"matrix_set", Kind::setter},
    NamedKind{"array", Kind::joined},
    NamedKind{"array_d", Kind::joined},
    NamedKind{"vector", Kind::joined},
    NamedKind{"vector_d", Kind::joined},
    NamedKind{"matrix", Kind::joined},
    NamedKind{"if", Kind::control},
    NamedKind{"when", Kind::control},
    NamedKind{"while", Kind::control},
    NamedKind{"for", Kind::control},
    NamedKind{"shortcut", Kind::not_made},
    NamedKind{"catmull_rom_spline", Kind::not_made},
    NamedKind{"hermite_spline", Kind::not_made},
    NamedKind{"hermite_tense_spline", Kind::not_made},
};

bool is_vector(ScriptType type) {
  return !type.list && (type.kind == ScriptKind::vec2 || type.kind == ScriptKind::vec3 || type.kind == ScriptKind::vec4);
}

bool is_matrix(ScriptType type) {
  return !type.list && (type.kind == ScriptKind::mat3 || type.kind == ScriptKind::mat4);
}

/// The type that a capital stands for when `type` is given for it; nullopt when it cannot be.
std::optional<ScriptType> meant_by(char letter, ScriptType type) {
  const bool is_list = type.list || type == kText;
  switch (letter) {
    case 'V': return is_vector(type) ? std::optional(type) : std::nullopt;
    case 'X': return is_matrix(type) ? std::optional(type) : std::nullopt;
    case 'T': return fits(type, kNumber) ? kNumber : is_vector(type) || is_matrix(type) ? std::optional(type) : std::nullopt;
    case 'L': return is_list ? std::optional(type) : std::nullopt;
    default: return std::nullopt;
  }
}

/// What a letter stands for once it is known what the capital does.
ScriptType type_of(char letter, ScriptType bound) {
  switch (letter) {
    case 'b': return kBoolean;
    case 'i': return kInteger;
    case 'f': return kNumber;
    case 's': return kText;
    case '3': return {ScriptKind::vec3, false};
    case '4': return {ScriptKind::vec4, false};
    case 'E':
    case 'C': return element_type(bound);
    case 'n': return {};
    default: return bound;
  }
}

std::optional<ScriptCall> match(const Overload& overload, std::span<const ScriptType> arguments) {
  if (overload.parameters.size() != arguments.size()) return std::nullopt;
  ScriptType bound;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const char letter = overload.parameters[i];
    if (bound.kind == ScriptKind::nothing) {
      const auto meant = meant_by(letter, arguments[i]);
      if (meant) bound = *meant;
    }
    const ScriptType wanted = type_of(letter, bound);
    if (wanted.kind == ScriptKind::nothing || !fits(arguments[i], wanted)) return std::nullopt;
  }
  ScriptCall call{type_of(overload.result, bound), overload.op, 0};
  if (overload.operand == Operand::element) call.operand = width(element_type(arguments[0]).kind);
  if (overload.operand == Operand::whole) call.operand = 1;
  return call;
}

}  // namespace

std::uint32_t width(ScriptKind kind) {
  switch (kind) {
    case ScriptKind::vec2: return 2;
    case ScriptKind::vec3: return 3;
    case ScriptKind::vec4: return 4;
    case ScriptKind::mat3: return 9;
    case ScriptKind::mat4: return 16;
    default: return 1;
  }
}

ScriptType element_type(ScriptType type) {
  if (type.list || type.kind == ScriptKind::text) return {type.kind, false};
  if (type.kind == ScriptKind::mat3) return {ScriptKind::vec3, false};
  if (type.kind == ScriptKind::mat4) return {ScriptKind::vec4, false};
  return kNumber;
}

std::string to_text(ScriptType type) {
  struct Words {
    std::string_view one, many;
  };
  static constexpr std::array<Words, 11> kWords = {{{"nothing", "nothings"},
                                                    {"a boolean", "booleans"},
                                                    {"an integer", "integers"},
                                                    {"a number", "numbers"},
                                                    {"a text", "texts"},
                                                    {"a vector of 2 numbers", "vectors of 2 numbers"},
                                                    {"a vector of 3 numbers", "vectors of 3 numbers"},
                                                    {"a vector of 4 numbers", "vectors of 4 numbers"},
                                                    {"a matrix of 3 by 3 numbers", "matrices of 3 by 3 numbers"},
                                                    {"a matrix of 4 by 4 numbers", "matrices of 4 by 4 numbers"},
                                                    {"an image, a node or a list of texts", ""}}};
  const Words& words = kWords[static_cast<std::size_t>(type.kind)];
  return type.list ? fmt::format("a list of {}", words.many) : std::string(words.one);
}

std::string to_text(std::span<const ScriptType> types) {
  std::string words;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (i != 0) words += i + 1 == types.size() ? " and " : ", ";
    words += to_text(types[i]);
  }
  return words.empty() ? "nothing" : words;
}

bool fits(ScriptType value, ScriptType wanted) {
  const bool promoted = value.kind == ScriptKind::integer && wanted.kind == ScriptKind::number && value.list == wanted.list;
  return value == wanted || promoted;
}

std::optional<ScriptCall> find_script_call(std::string_view name, std::span<const ScriptType> arguments) {
  for (const Overload& overload : kOverloads) {
    if (overload.name != name) continue;
    if (auto call = match(overload, arguments)) return call;
  }
  const bool glued = name == "+" && arguments.size() == 2 && meant_by('L', arguments[0]) && arguments[0] == arguments[1];
  if (glued) return ScriptCall{arguments[0], ScriptOp::join, 2};
  return std::nullopt;
}

ScriptFunctionKind script_function_kind(std::string_view name) {
  const auto named = std::ranges::find(kNamed, name, &NamedKind::name);
  if (named != kNamed.end()) return named->kind;
  if (name.starts_with("image_") || name == "image") return Kind::not_made;
  const bool has_row = std::ranges::find(kOverloads, name, &Overload::name) != kOverloads.end();
  return has_row ? Kind::plain : Kind::unknown;
}

std::span<const std::string_view> script_function_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> found;
    for (const Overload& overload : kOverloads) {
      if (overload.name.size() > 1) found.push_back(overload.name);
    }
    for (const NamedKind& named : kNamed) found.push_back(named.name);
    return found;
  }();
  return names;
}

std::optional<ScriptType> joined_type(std::string_view name, std::span<const ScriptType> arguments) {
  const auto all_fit = [&](ScriptType wanted) {
    return std::ranges::all_of(arguments, [&](ScriptType one) { return fits(one, wanted); });
  };
  const std::size_t count = arguments.size();
  if (count == 0) return std::nullopt;
  if (name.starts_with("vector")) {
    if (count < 2 || count > 4 || !all_fit(kNumber)) return std::nullopt;
    return ScriptType{static_cast<ScriptKind>(static_cast<std::size_t>(ScriptKind::vec2) + count - 2), false};
  }
  if (name == "matrix") {
    if (count == 3 && all_fit({ScriptKind::vec3, false})) return ScriptType{ScriptKind::mat3, false};
    if (count == 4 && all_fit({ScriptKind::vec4, false})) return ScriptType{ScriptKind::mat4, false};
    return std::nullopt;
  }
  ScriptType element = arguments[0];
  if (element == kInteger && !all_fit(kInteger)) element = kNumber;
  if (element.list || element.kind == ScriptKind::nothing || element.kind == ScriptKind::other || !all_fit(element))
    return std::nullopt;
  if (element == kText) return ScriptType{ScriptKind::other, false};
  return ScriptType{element.kind, true};
}

}  // namespace plugc
