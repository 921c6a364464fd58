// Fields as they are written. Those that X3D has under another name, or as one value of a list, keep their place in the
// document's pools.

#include <algorithm>

#include "document/vrml1_scene.h"

namespace plugc {

/// Null where it is not written, or not well; the last one where it is written twice.
const Vrml1Field* Vrml1Scene::find(std::uint32_t node, std::string_view name) const {
  if (node == kNoVrml1Node) return nullptr;
  const Vrml1Field* found = nullptr;
  for (const Vrml1Field& field : tree_.of(tree_.nodes[node].fields)) {
    if (field.info->name == name && field.value.kind != ValueKind::none) found = &field;
  }
  return found;
}

std::span<const double> Vrml1Scene::numbers(std::uint32_t node, std::string_view name) const {
  const Vrml1Field* field = find(node, name);
  return field == nullptr ? std::span<const double>() : build_.document.of(field->value.numbers());
}

double Vrml1Scene::number(std::uint32_t node, std::string_view name, double otherwise) const {
  const auto written = numbers(node, name);
  return written.empty() ? otherwise : written[0];
}

glm::dvec3 Vrml1Scene::vector(std::uint32_t node, std::string_view name, const glm::dvec3& otherwise) const {
  const auto written = numbers(node, name);
  return written.size() < 3 ? otherwise : glm::dvec3(written[0], written[1], written[2]);
}

glm::dvec4 Vrml1Scene::rotation(std::uint32_t node, std::string_view name) const {
  const auto written = numbers(node, name);
  return written.size() < 4 ? glm::dvec4(0, 0, 1, 0) : glm::dvec4(written[0], written[1], written[2], written[3]);
}

std::span<const MappedText> Vrml1Scene::strings(std::uint32_t node, std::string_view name) const {
  const Vrml1Field* field = find(node, name);
  return field == nullptr ? std::span<const MappedText>() : build_.document.of(field->value.strings());
}

std::string_view Vrml1Scene::word(std::uint32_t node, std::string_view name) const {
  const auto written = strings(node, name);
  return written.empty() ? "" : written[0].text();
}

bool Vrml1Scene::has_word(std::uint32_t node, std::string_view name, std::string_view word) const {
  return std::ranges::any_of(strings(node, name), [&](const MappedText& one) { return one.text() == word; });
}

/// Empty also where they are `-1`, which is what they are when nothing is written.
std::span<const double> Vrml1Scene::indices(std::uint32_t node, std::string_view name) const {
  const auto written = numbers(node, name);
  return written.size() == 1 && written[0] < 0 ? std::span<const double>() : written;
}

Span Vrml1Scene::place_of(std::uint32_t node) const {
  return tree_.nodes[node].type.span;
}

/// Writes the field under the name that X3D has for it.
void Vrml1Scene::pass(std::uint32_t node, std::string_view name, std::string_view as) {
  if (const Vrml1Field* field = find(node, name)) write_.value(as, field->value, field->name.span);
}

void Vrml1Scene::pass(std::uint32_t node, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) pass(node, name, name);
}

/// One element of a list, for a field of X3D that takes one: the last, where there are fewer.
void Vrml1Scene::pass_element(std::uint32_t node, std::string_view name, std::size_t number, std::string_view as) {
  const Vrml1Field* field = find(node, name);
  if (field == nullptr || field->value.count == 0) return;
  ValueSyntax element = field->value;
  element.count = static_cast<std::uint32_t>(component_count(field->info->type));
  element.first +=
      element.count * static_cast<std::uint32_t>(std::min<std::size_t>(number, field->value.count / element.count - 1));
  write_.value(as, element, field->name.span);
}

}  // namespace plugc
