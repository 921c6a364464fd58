// Programs: their stages for each target, uniforms and attributes.

#include <set>

#include "base/limits.h"
#include "package/package_file_check.h"

namespace plugc {
namespace {

constexpr std::uint32_t kSpirvMagic = 0x07230203;

bool check_stage(PackageCheck& check, const PackedStage& stage, PackedTarget target, const Place& place) {
  if (!is_enumerator(stage.kind())) return check.fail(place, "its kind is unknown");
  if (stage.text()->size() == 0 || stage.text()->size() > kMaxStageBytes)
    return check.fail(place, "its text is empty or too long");
  const bool has_spirv = stage.spirv()->size() != 0 && stage.spirv()->Get(0) == kSpirvMagic;
  if (target == PackedTarget::spirv && !has_spirv) return check.fail(place, "its SPIR-V does not start with the magic number");
  return check.charge(place, *stage.text()) && check.charge(place, *stage.spirv()) &&
         (stage.columns() == nullptr || check.charge(place, *stage.columns())) &&
         check.each(&place, "origin", *stage.origins(),
                    [&](const PackedLineOrigin* origin, const Place& at) { return check_origin(check, *origin, at); });
}

bool check_target_program(PackageCheck& check, const PackedTargetProgram& program, const Place& place) {
  if (!is_enumerator(program.target())) return check.fail(place, "its target is unknown");
  int last_kind = -1;
  const auto check_in_order = [&](const PackedStage* stage, const Place& at) {
    const int kind = static_cast<int>(stage->kind());
    if (kind <= last_kind) return check.fail(at, "stages are out of pipeline order");
    last_kind = kind;
    return check_stage(check, *stage, program.target(), at);
  };
  if (!check.each(&place, "stage", *program.stages(), check_in_order)) return false;
  const bool has_vertex = program.stages()->size() != 0 && program.stages()->Get(0)->kind() == PackedStageKind::vertex;
  return has_vertex || check.fail(place, "it has no vertex stage");
}

bool check_uniform(PackageCheck& check, const PackedUniform& uniform, const Place& place) {
  if (uniform.name()->size() == 0) return check.fail(place, "it has no name");
  if (!is_enumerator(uniform.type())) return check.fail(place, "its type is unknown");
  if (uniform.targets() == 0) return check.fail(place, "no target reads it");
  if (uniform.count() == 0 || uniform.count() > kMaxUniformElements)
    return check.fail(place, fmt::format("its array has {} elements", uniform.count()));
  if (!check.charge(place, *uniform.name()) || !check.charge(place, *uniform.initial())) return false;
  const std::uint64_t numbers = std::uint64_t{uniform.count()} * component_count(uniform.type());
  return uniform.initial()->size() == 0 || uniform.initial()->size() == numbers ||
         check.fail(place, fmt::format("it starts with {} numbers, not {}", uniform.initial()->size(), numbers));
}

bool check_attribute(PackageCheck& check, const PackedAttribute& attribute, const Place& place) {
  if (attribute.name()->size() == 0) return check.fail(place, "it has no name");
  if (!check.charge(place, *attribute.name())) return false;
  return is_enumerator(attribute.semantic()) || check.fail(place, "its semantic is unknown");
}

}  // namespace

bool check_origin(PackageCheck& check, const PackedLineOrigin& origin, const Place& place) {
  return origin.line() == 0 || check.require_index(place, "source", origin.source(), check.package.sources()->size());
}

bool check_program(PackageCheck& check, const PackedProgram& program, const Place& place) {
  std::set<PackedTarget> seen;
  const auto check_target = [&](const PackedTargetProgram* target, const Place& at) {
    if (!seen.insert(target->target()).second) return check.fail(at, "its target is there twice");
    return check_target_program(check, *target, at);
  };
  if (program.targets()->size() == 0) return check.fail(place, "it has no target");
  if (!check.charge(place, *program.name()) || !check.charge(place, *program.recipe())) return false;
  return check.each(&place, "target", *program.targets(), check_target) &&
         check.each(&place, "uniform", *program.uniforms(),
                    [&](const PackedUniform* uniform, const Place& at) { return check_uniform(check, *uniform, at); }) &&
         check.each(&place, "attribute", *program.attributes(),
                    [&](const PackedAttribute* attribute, const Place& at) { return check_attribute(check, *attribute, at); });
}

}  // namespace plugc
