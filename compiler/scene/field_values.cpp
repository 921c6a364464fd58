// A value goes through three questions: is it of the right kind (numbers for numbers), does it have the right count (one
// element, or a multiple of an element's components), and is every number in the field's range. Values in a document are
// viewed where they are; the text of an XML attribute is read by the field's type and kept in the store.

#include "scene/field_values.h"

#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "document/read_lexical.h"

namespace plugc {
namespace {

struct Reading {
  const ValueSyntax& syntax;
  const Document& document;
  const ValueContract& contract;
  ValueStore& store;
  Diagnostics& diagnostics;

  std::string subject() const { return fmt::format("`{}` of `{}`", contract.field, contract.node); }

  bool wrong_type(std::string_view what) const {
    diagnostics.report(DiagnosticId::field_type, syntax.span,
                       fmt::format("{} takes {}, but {}", subject(), to_text(contract.type), what));
    return false;
  }
};

bool is_boolean(FieldType type) {
  return type == FieldType::SFBool || type == FieldType::MFBool;
}
bool is_integer(FieldType type) {
  return type == FieldType::SFInt32 || type == FieldType::MFInt32;
}

std::span<const double> lexical_numbers(const Reading& reading) {
  const std::span<const MappedText> text = reading.document.of(reading.syntax.strings());
  if (text.empty()) return {};
  return reading.store.numbers.emplace_back(read_lexical_numbers(text[0], reading.diagnostics));
}

/// The numbers written, when numbers may stand here.
std::optional<std::span<const double>> numbers_of(const Reading& reading) {
  const ValueKind kind = reading.syntax.kind;
  if (kind == ValueKind::lexical) return lexical_numbers(reading);
  if (kind == ValueKind::empty) return std::span<const double>();
  const bool fits = is_boolean(reading.contract.type) ? kind == ValueKind::booleans : kind == ValueKind::numbers;
  if (fits) return reading.document.of(reading.syntax.numbers());
  reading.wrong_type(fmt::format("{} stand here", describe(kind)));
  return std::nullopt;
}

/// width height components, then width * height pixels; for MFImage any number of such.
bool check_images(const Reading& reading, std::span<const double> numbers) {
  constexpr double kMaxSide = 65536;
  std::size_t at = 0;
  std::size_t images = 0;
  while (at < numbers.size()) {
    if (numbers.size() - at < 3) return reading.wrong_type("an image starts with its width, height and components");
    const double width = numbers[at], height = numbers[at + 1];
    const bool sized = width >= 0 && width <= kMaxSide && height >= 0 && height <= kMaxSide;
    const double left = static_cast<double>(numbers.size() - at - 3);
    if (!sized || std::floor(width) * std::floor(height) > left) {
      return reading.wrong_type(fmt::format("an image of {} x {} has {} pixels here", width, height, left));
    }
    at += 3 + static_cast<std::size_t>(std::floor(width) * std::floor(height));
    ++images;
  }
  if (reading.contract.type == FieldType::SFImage && images != 1) {
    return reading.wrong_type(fmt::format("{} images stand here", images));
  }
  return true;
}

bool check_count(const Reading& reading, std::span<const double>& numbers) {
  const FieldType type = reading.contract.type;
  const std::size_t components = component_count(type);
  if (components == 0) return check_images(reading, numbers);
  if (!is_multiple(type)) {
    if (numbers.size() == components) return true;
    return reading.wrong_type(fmt::format("{} numbers stand here instead of {}", numbers.size(), components));
  }
  const std::size_t rest = numbers.size() % components;
  if (rest == 0) return true;
  reading.wrong_type(fmt::format("{} numbers are no multiple of {}", numbers.size(), components));
  numbers = numbers.first(numbers.size() - rest);
  return true;
}

bool check_whole(const Reading& reading, std::span<const double> numbers) {
  for (const double number : numbers) {
    if (number != std::trunc(number)) return reading.wrong_type(fmt::format("{} is no whole number", number));
  }
  return true;
}

/// A bound like `>=0`, `>0`, `<=1`; an empty one holds for every number. Angles are often written rounded (1.5708 for a
/// right angle), so an inclusive bound takes a little more.
struct Bound {
  bool exists = false;
  bool above = false;
  bool inclusive = false;
  double value = 0;

  explicit Bound(std::string_view text) {
    if (text.empty()) return;
    exists = true;
    above = text[0] == '>';
    inclusive = text.size() > 1 && text[1] == '=';
    value = std::strtod(std::string(text.substr(inclusive ? 2 : 1)).c_str(), nullptr);
  }
  bool holds(double number) const {
    constexpr double kTolerance = 1e-4;
    if (!exists || (inclusive && std::abs(number - value) <= kTolerance * std::abs(value))) return true;
    return above ? number > value : number < value;
  }
};

void check_range(const Reading& reading, std::span<const double> numbers) {
  const Bound minimum(reading.contract.minimum), maximum(reading.contract.maximum);
  if (!minimum.exists && !maximum.exists) return;
  for (const double number : numbers) {
    const bool low = !minimum.holds(number);
    if (!low && maximum.holds(number)) continue;
    const std::string_view bound = low ? reading.contract.minimum : reading.contract.maximum;
    reading.diagnostics.report(DiagnosticId::field_range, reading.syntax.span,
                               fmt::format("{} is {}, but should be {}", reading.subject(), number, bound));
    return;
  }
}

bool read_numbers(const Reading& reading, FieldValue& value) {
  std::optional<std::span<const double>> numbers = numbers_of(reading);
  if (!numbers || !check_count(reading, *numbers)) return false;
  if (is_integer(reading.contract.type) && !check_whole(reading, *numbers)) return false;
  check_range(reading, *numbers);
  value.numbers = *numbers;
  return true;
}

bool read_strings(const Reading& reading, FieldValue& value) {
  const bool multiple = is_multiple(reading.contract.type);
  const std::span<const MappedText> written = reading.document.of(reading.syntax.strings());
  switch (reading.syntax.kind) {
    case ValueKind::lexical:
      value.strings = written;  // an SFString attribute is the string itself
      if (multiple && !written.empty()) {
        value.strings = reading.store.strings.emplace_back(read_lexical_strings(written[0], reading.diagnostics));
      }
      break;
    case ValueKind::strings: value.strings = written; break;
    case ValueKind::empty: break;
    default: return reading.wrong_type(fmt::format("{} stand here", describe(reading.syntax.kind)));
  }
  if (multiple || value.strings.size() == 1) return true;
  return reading.wrong_type(fmt::format("{} strings stand here", value.strings.size()));
}

}  // namespace

std::string_view describe(ValueKind kind) {
  switch (kind) {
    case ValueKind::none: return "no values";
    case ValueKind::numbers: return "numbers";
    case ValueKind::booleans: return "booleans";
    case ValueKind::strings: return "strings";
    case ValueKind::nodes: return "nodes";
    case ValueKind::empty: return "empty brackets";
    case ValueKind::lexical: return "attribute texts";
    case ValueKind::is: return "`IS` statements";
  }
  return "";
}

bool read_value(const ValueSyntax& syntax, const Document& document, const ValueContract& contract, ValueStore& store,
                Diagnostics& diagnostics, FieldValue& value) {
  const Reading reading{syntax, document, contract, store, diagnostics};
  value.type = contract.type;
  value.span = syntax.span;
  if (is_numeric(contract.type)) return read_numbers(reading, value);
  if (is_string(contract.type)) return read_strings(reading, value);
  return reading.wrong_type(fmt::format("{} stand here", describe(syntax.kind)));
}

}  // namespace plugc
