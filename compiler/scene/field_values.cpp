// A value goes through four questions: is it of the right kind (numbers for numbers), does it have the right count (one
// element, or a multiple of an element's components), is every number whole where it must be, and is it in the field's range
// or one of its words (value_limits.h). Values in a document are viewed where they are; the text of an XML attribute is read
// by the field's type and kept in the store. What a reader has already called damaged is not reported again.

#include "scene/field_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "document/number_places.h"
#include "document/read_lexical.h"
#include "scene/value_limits.h"

namespace plugc {
namespace {

struct Reading {
  const ValueSyntax& syntax;
  const Document& document;
  const ValueContract& contract;
  ValueStore& store;
  Diagnostics& diagnostics;
  bool damaged = false;  // of the value something was reported

  bool wrong_type(const Span& span, std::string_view what) const {
    if (damaged) return false;
    diagnostics.report(
        DiagnosticId::field_type, span,
        fmt::format("`{}` of `{}` takes {}, but {}", contract.field, contract.node, to_text(contract.type), what));
    return false;
  }
  bool wrong_type(std::string_view what) const { return wrong_type(syntax.span, what); }
  Span place_of(std::size_t number) const { return number_span(syntax, document, diagnostics.sources(), number); }
  bool wrong_number(std::size_t index, std::string_view what) const { return wrong_type(place_of(index), what); }
};

bool is_boolean(FieldType type) {
  return type == FieldType::SFBool || type == FieldType::MFBool;
}
bool is_integer(FieldType type) {
  return type == FieldType::SFInt32 || type == FieldType::MFInt32;
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// "a number stands", "3 numbers stand".
std::string standing(std::size_t count, std::string_view thing) {
  if (count == 0) return "nothing stands";
  return count == 1 ? fmt::format("a {} stands", thing) : fmt::format("{} stand", counted(count, thing));
}

std::span<const double> lexical_numbers(Reading& reading) {
  const std::span<const MappedText> text = reading.document.of(reading.syntax.strings());
  if (text.empty()) return {};
  const LexicalKind kind = is_boolean(reading.contract.type) ? LexicalKind::booleans : LexicalKind::numbers;
  Diagnostics unheard(reading.diagnostics.sources());  // what a damaged text says is no mistake of its own
  NumberBudget& budget = reading.store.budget;
  LexicalNumbers read = read_lexical_numbers(text[0], kind, reading.damaged ? unheard : reading.diagnostics, budget.left);
  reading.damaged |= read.damaged || read.cut;
  budget.left -= read.numbers.size();
  if (read.cut && !std::exchange(budget.is_spent, true)) {
    reading.diagnostics.report(
        DiagnosticId::scene_limit, reading.syntax.span,
        fmt::format("the attributes of this scene hold more than {} numbers; the rest is left out", kMaxDocumentNumbers));
  }
  return reading.store.keep(std::move(read.numbers));
}

/// The numbers written, when numbers may stand here.
std::optional<std::span<const double>> numbers_of(Reading& reading) {
  const ValueKind kind = reading.syntax.kind;
  if (kind == ValueKind::lexical) return lexical_numbers(reading);
  if (kind == ValueKind::empty) return std::span<const double>();
  const bool fits = is_boolean(reading.contract.type) ? kind == ValueKind::booleans : kind == ValueKind::numbers;
  if (fits) return reading.document.of(reading.syntax.numbers());
  reading.wrong_type(what_stands(reading.syntax) + " here");
  return std::nullopt;
}

/// The size of one image, `width height components` and a number a pixel; 0 when it is none (reported).
std::size_t image_size(const Reading& reading, std::span<const double> numbers, std::size_t at) {
  constexpr double kMaxSide = 65536;
  constexpr double kMaxComponents = 4;
  const auto wrong = [&](std::size_t index, std::string_view what) {
    reading.wrong_number(at + index, what);
    return std::size_t{0};
  };
  const std::span<const double> image = numbers.subspan(at);
  if (image.size() < 3) {
    reading.wrong_type("an image starts with its width, height and number of components");
    return 0;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (image[i] >= 0 && image[i] <= kMaxSide && image[i] == std::trunc(image[i])) continue;
    return wrong(i, fmt::format("an image cannot be {} pixels {}", image[i], i == 0 ? "wide" : "high"));
  }
  if (image[2] < 0 || image[2] > kMaxComponents || image[2] != std::trunc(image[2])) {
    return wrong(2, fmt::format("an image has 0 to 4 components, not {}", image[2]));
  }
  const auto pixels = static_cast<std::size_t>(image[0] * image[1]);
  if (pixels <= image.size() - 3) return 3 + pixels;
  reading.wrong_type(fmt::format("an image of {} x {} needs {}, and {} here", image[0], image[1], counted(pixels, "pixel"),
                                 standing(image.size() - 3, "pixel")));
  return 0;
}

/// For MFImage any number of images.
bool check_images(const Reading& reading, std::span<const double> numbers) {
  const bool single = reading.contract.type == FieldType::SFImage;
  std::size_t at = 0;
  do {
    if (!single && numbers.empty()) return true;
    const std::size_t size = image_size(reading, numbers, at);
    if (size == 0) return false;
    at += size;
  } while (!single && at < numbers.size());
  if (at == numbers.size()) return true;
  return reading.wrong_number(at, fmt::format("{} behind the last pixel", standing(numbers.size() - at, "number")));
}

bool check_count(const Reading& reading, std::span<const double>& numbers) {
  const FieldType type = reading.contract.type;
  const std::size_t components = component_count(type);
  if (components == 0) return check_images(reading, numbers);
  if (!is_multiple(type)) {
    if (numbers.size() == components) return true;
    const std::string_view thing = is_boolean(type) ? "boolean" : "number";
    return reading.wrong_type(fmt::format("{} here instead of {}", standing(numbers.size(), thing), components));
  }
  const std::size_t rest = numbers.size() % components;
  if (rest == 0) return true;
  reading.wrong_type(fmt::format("{} are no multiple of {}", counted(numbers.size(), "number"), components));
  numbers = numbers.first(numbers.size() - rest);
  return true;
}

/// Whether a number is whole and has 32 bits. Of those from 2^31 on, hexadecimal ones are meant as bits.
bool check_integer(const Reading& reading, double number, std::size_t index) {
  if (number != std::trunc(number)) return reading.wrong_number(index, fmt::format("{} is no whole number", number));
  constexpr double kLeast = std::numeric_limits<std::int32_t>::min();
  const bool as_bits = number > std::numeric_limits<std::int32_t>::max() && number <= std::numeric_limits<std::uint32_t>::max();
  if (number >= kLeast && as_bits) {
    const std::string_view written = reading.diagnostics.sources().text(reading.place_of(index));
    if (written.starts_with("0x") || written.starts_with("0X")) return true;
  } else if (number >= kLeast && number <= std::numeric_limits<std::int32_t>::max()) {
    return true;
  }
  return reading.wrong_number(index, fmt::format("{:.0f} does not fit into 32 bits", number));
}

/// `0xFFFFFFFF` as an integer is -1; nearly always there is no such number, and the numbers stay where they are.
bool check_integers(const Reading& reading, std::span<const double>& numbers) {
  bool any_bits = false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double number = numbers[i];
    const bool plain =
        number == static_cast<double>(static_cast<std::int32_t>(std::clamp(number, -2147483648.0, 2147483647.0)));
    if (plain) continue;
    if (!check_integer(reading, number, i)) return false;
    any_bits = true;
  }
  if (!any_bits) return true;
  std::vector<double>& copy = reading.store.numbers.emplace_back(numbers.begin(), numbers.end());
  for (double& number : copy) number = static_cast<std::int32_t>(static_cast<std::int64_t>(number));
  numbers = copy;
  return true;
}

/// In the classic encodings a list has brackets unless it is one element, and a single value has none. (JSON has them around
/// the components of one value.)
void check_brackets(const Reading& reading, std::size_t elements) {
  const Encoding encoding = reading.document.encoding;
  if (encoding != Encoding::classic && encoding != Encoding::vrml2) return;
  const bool multiple = is_multiple(reading.contract.type);
  if (multiple && !reading.syntax.bracketed && elements > 1) {
    reading.wrong_type(fmt::format("{} need `[` and `]` around them", counted(elements, "value")));
  } else if (!multiple && reading.syntax.bracketed) {
    reading.wrong_type("`[` stands here; a single value has no brackets");
  }
}

bool read_numbers(Reading& reading, FieldValue& value) {
  std::optional<std::span<const double>> numbers = numbers_of(reading);
  if (!numbers || !check_count(reading, *numbers)) return false;
  if (is_integer(reading.contract.type) && !check_integers(reading, *numbers)) return false;
  if (const std::size_t components = component_count(reading.contract.type); components > 0) {
    check_brackets(reading, numbers->size() / components);
  }
  if (const auto out = find_out_of_range(reading.contract, *numbers); out && !reading.damaged) {
    reading.diagnostics.report(DiagnosticId::field_range, reading.place_of(out->index), out->message);
  }
  value.numbers = *numbers;
  return true;
}

/// Several strings, or one, from the text of an attribute.
std::span<const MappedText> lexical_strings(const Reading& reading) {
  const std::span<const MappedText> written = reading.document.of(reading.syntax.strings());
  if (!is_multiple(reading.contract.type) || written.empty()) return written;  // an SFString attribute is the string itself
  return reading.store.strings.emplace_back(read_lexical_strings(written[0], reading.diagnostics));
}

bool read_strings(Reading& reading, FieldValue& value) {
  switch (reading.syntax.kind) {
    case ValueKind::lexical: value.strings = lexical_strings(reading); break;
    case ValueKind::strings: value.strings = reading.document.of(reading.syntax.strings()); break;
    case ValueKind::empty: break;
    default: return reading.wrong_type(what_stands(reading.syntax) + " here");
  }
  const bool fits = is_multiple(reading.contract.type) || value.strings.size() == 1;
  if (!fits) return reading.wrong_type(fmt::format("{} here", standing(value.strings.size(), "string")));
  check_brackets(reading, value.strings.size());
  if (!reading.damaged) check_words(reading.contract, reading.syntax.span, value.strings, reading.diagnostics);
  return true;
}

}  // namespace

std::span<const double> ValueStore::keep(std::vector<double> list) {
  constexpr std::size_t kBlock = 4096;
  if (list.size() >= kBlock) return numbers.emplace_front(std::move(list));
  if (numbers.empty() || numbers.back().capacity() - numbers.back().size() < list.size())
    numbers.emplace_back().reserve(kBlock);
  std::vector<double>& block = numbers.back();
  const std::size_t first = block.size();
  block.insert(block.end(), list.begin(), list.end());
  return std::span<const double>(block).subspan(first);
}

std::string what_stands(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::none: return "nothing stands";
    case ValueKind::numbers: return standing(value.count, "number");
    case ValueKind::booleans: return standing(value.count, "boolean");
    case ValueKind::strings: return standing(value.count, "string");
    case ValueKind::nodes: return value.count == 0 ? "`NULL` stands" : standing(value.count, "node");
    case ValueKind::empty: return "an empty list stands";
    case ValueKind::lexical: return "text stands";
    case ValueKind::is: return "an `IS` stands";
  }
  return "";
}

bool read_value(const ValueSyntax& syntax, const Document& document, const ValueContract& contract, ValueStore& store,
                Diagnostics& diagnostics, FieldValue& value) {
  if (syntax.kind == ValueKind::none) return false;  // the reader reported that nothing stands here
  Reading reading{syntax, document, contract, store, diagnostics, syntax.damaged};
  value.type = contract.type;
  value.span = syntax.span;
  if (is_numeric(contract.type)) return read_numbers(reading, value);
  if (is_string(contract.type)) return read_strings(reading, value);
  return reading.wrong_type(what_stands(syntax) + " here");
}

}  // namespace plugc
