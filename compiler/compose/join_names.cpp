// Every owner (the renderer, each effect, the ComposedShader) has a name space of its own; the composed text has one a
// stage. Owners are taken in order, and a name that an earlier owner has is changed to `name_2`, `name_3`, ... everywhere in
// its owner's code. castle_ names belong to the renderer whoever declares them. Uniforms and varyings live in all
// stages at once, other names in theirs. A function that an owner only declares, and an input that it only reads, are
// sought in the other owners (the thesis's library parts).

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compose/castle_names.h"
#include "compose/placed_unit.h"

namespace plugc {
namespace {

bool is_castle(std::string_view name) { return name.starts_with("castle_"); }
bool is_interface(Storage storage) { return storage == Storage::uniform || storage == Storage::in || storage == Storage::out; }

struct DeclaredName {
  std::string name;
  ShaderStage stage = ShaderStage::vertex;
  bool everywhere = false;  ///< In all stages at once.
};

class NameJoiner {
 public:
  explicit NameJoiner(Composition& composition) : c_(composition) {}
  void join();

 private:
  std::vector<DeclaredName> declared_names(std::size_t owner) const;
  void name_owner(std::size_t owner);
  bool is_free(const std::string& name, const DeclaredName& declared, std::size_t owner) const;
  void take(const std::string& name, const DeclaredName& declared, std::size_t owner);
  bool shares_struct(std::size_t owner, const DeclaredName& declared) const;
  void bind_foreign(std::size_t unit);
  void bind_function(const PlacedUnit& unit, const FunctionOutline& prototype);
  void bind_input(const PlacedUnit& unit, const GlobalOutline& input);
  std::vector<std::size_t> owners_where(const PlacedUnit& asking, auto predicate) const;
  void list_fields(const PlacedUnit& unit);
  int find_field(const SceneEffect& effect, std::string_view name) const;
  FieldUniform field_uniform(const PlacedUnit& unit, const GlobalOutline& uniform) const;

  Composition& c_;
};

std::vector<DeclaredName> NameJoiner::declared_names(std::size_t owner) const {
  std::vector<DeclaredName> names;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.owner != owner || unit.dropped) continue;
    const Outline& outline = unit.code->outline;
    for (const FunctionOutline& function : outline.functions) {
      if (function.is_definition() && plug_name(function.name).empty() && function.name != "main") {
        names.push_back({std::string(function.name), unit.stage, false});
      }
    }
    for (const GlobalOutline& global : outline.globals) {
      if (!is_castle(global.name)) names.push_back({std::string(global.name), unit.stage, is_interface(global.storage)});
    }
    for (const StructOutline& type : outline.structs) names.push_back({std::string(type.name), unit.stage, false});
  }
  return names;
}

bool NameJoiner::is_free(const std::string& name, const DeclaredName& declared, std::size_t owner) const {
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    if (!declared.everywhere && stage != static_cast<std::size_t>(declared.stage)) continue;
    const auto found = c_.taken[stage].find(name);
    if (found != c_.taken[stage].end() && found->second != owner) return false;
  }
  return true;
}

void NameJoiner::take(const std::string& name, const DeclaredName& declared, std::size_t owner) {
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    if (declared.everywhere || stage == static_cast<std::size_t>(declared.stage)) c_.taken[stage].emplace(name, owner);
  }
}

std::vector<std::string_view> struct_tokens(const CodeUnit& code, const StructOutline& type) {
  std::vector<std::string_view> tokens;
  for (const Token& token : code.tokens.tokens) {
    if (token.begin >= type.begin && token.end <= type.end) tokens.push_back(code.at(token));
  }
  return tokens;
}

const StructOutline* find_struct(const CodeUnit& code, std::string_view name) {
  const auto& structs = code.outline.structs;
  const auto found = std::find_if(structs.begin(), structs.end(), [&](const StructOutline& type) { return type.name == name; });
  return found == structs.end() ? nullptr : &*found;
}

/// Struct definitions that are equal token for token are one type, whoever wrote them.
bool NameJoiner::shares_struct(std::size_t owner, const DeclaredName& declared) const {
  const StructOutline* mine = nullptr;
  const CodeUnit* my_code = nullptr;
  for (const PlacedUnit& unit : c_.units) {
    if (unit.stage != declared.stage || unit.dropped) continue;
    const StructOutline* type = find_struct(*unit.code, declared.name);
    if (type == nullptr) continue;
    if (unit.owner == owner) {
      mine = type;
      my_code = unit.code.get();
    }
  }
  if (mine == nullptr) return false;
  return std::any_of(c_.units.begin(), c_.units.end(), [&](const PlacedUnit& unit) {
    const StructOutline* other = find_struct(*unit.code, declared.name);
    return !unit.dropped && unit.owner < owner && unit.stage == declared.stage && other != nullptr &&
           struct_tokens(*unit.code, *other) == struct_tokens(*my_code, *mine);
  });
}

void NameJoiner::name_owner(std::size_t owner) {
  auto& renames = c_.owners[owner].renames;
  for (const DeclaredName& declared : declared_names(owner)) {
    if (const auto renamed = renames.find(declared.name); renamed != renames.end()) {
      take(renamed->second, declared, owner);
    } else if (is_free(declared.name, declared, owner)) {
      take(declared.name, declared, owner);
    } else if (!shares_struct(owner, declared)) {
      std::string name;
      for (int i = 2; name.empty() || !is_free(name, declared, owner); ++i) name = fmt::format("{}_{}", declared.name, i);
      renames.emplace(declared.name, name);
      take(name, declared, owner);
    }
  }
}

/// Other owners with a unit in some stage that the predicate accepts.
std::vector<std::size_t> NameJoiner::owners_where(const PlacedUnit& asking, auto predicate) const {
  std::set<std::size_t> found;
  for (const PlacedUnit& unit : c_.units) {
    if (!unit.dropped && unit.owner != asking.owner && predicate(unit)) found.insert(unit.owner);
  }
  return {found.begin(), found.end()};
}

std::string final_name(const Owner& owner, std::string_view name) {
  const auto renamed = owner.renames.find(name);
  return renamed == owner.renames.end() ? std::string(name) : renamed->second;
}

bool defines(const CodeUnit& code, std::string_view name) {
  return std::any_of(code.outline.functions.begin(), code.outline.functions.end(),
                     [&](const FunctionOutline& function) { return function.name == name && function.is_definition(); });
}

void NameJoiner::bind_function(const PlacedUnit& unit, const FunctionOutline& prototype) {
  const bool own = std::any_of(c_.units.begin(), c_.units.end(), [&](const PlacedUnit& other) {
    return other.owner == unit.owner && other.stage == unit.stage && defines(*other.code, prototype.name);
  });
  if (own) return;
  const auto candidates = owners_where(unit, [&](const PlacedUnit& other) {
    return other.stage == unit.stage && defines(*other.code, prototype.name);
  });
  const Span span = unit.code->span(prototype.name_begin, prototype.name_begin + static_cast<std::uint32_t>(prototype.name.size()));
  if (candidates.size() > 1) {
    c_.diagnostics.report(DiagnosticId::ambiguous_function, span,
                          fmt::format("`{}` is declared here and defined by {} other effects; define it in one, or in this one",
                                      prototype.name, candidates.size()));
    return c_.mark_faulty(unit);
  }
  if (candidates.empty()) return;  // glslang says that it has no body
  const std::string name = final_name(c_.owners[candidates.front()], prototype.name);
  if (name != prototype.name) c_.owners[unit.owner].renames.insert_or_assign(std::string(prototype.name), name);
}

bool writes(const PlacedUnit& unit, std::string_view name) {
  const auto& globals = unit.code->outline.globals;
  return unit.stage == ShaderStage::vertex && std::any_of(globals.begin(), globals.end(), [&](const GlobalOutline& global) {
           return global.storage == Storage::out && global.name == name;
         });
}

void NameJoiner::bind_input(const PlacedUnit& unit, const GlobalOutline& input) {
  const bool own = std::any_of(c_.units.begin(), c_.units.end(), [&](const PlacedUnit& other) {
    return other.owner == unit.owner && writes(other, input.name);
  });
  if (own || is_castle(input.name)) return;
  const auto candidates = owners_where(unit, [&](const PlacedUnit& other) { return writes(other, input.name); });
  if (candidates.size() == 1) {
    c_.owners[unit.owner].renames.insert_or_assign(std::string(input.name), final_name(c_.owners[candidates.front()], input.name));
    return;
  }
  const Span span = unit.code->span(input.name_begin, input.name_begin + static_cast<std::uint32_t>(input.name.size()));
  c_.diagnostics.report(DiagnosticId::varying_unwritten, span,
                        fmt::format("nothing writes `{}`; declare it as `varying {} {};` in a `VERTEX` part too and write it there",
                                    input.name, input.type, input.name));
  c_.mark_faulty(unit);
}

void NameJoiner::bind_foreign(std::size_t index) {
  const PlacedUnit& unit = c_.units[index];
  if (unit.dropped || c_.owners[unit.owner].kind == OwnerKind::renderer) return;
  for (const FunctionOutline& function : unit.code->outline.functions) {
    if (!function.is_definition()) bind_function(unit, function);
  }
  if (unit.stage != ShaderStage::fragment) return;
  for (const GlobalOutline& global : unit.code->outline.globals) {
    if (global.storage == Storage::in) bind_input(unit, global);
  }
}

int NameJoiner::find_field(const SceneEffect& effect, std::string_view name) const {
  const auto found = std::find_if(effect.fields.begin(), effect.fields.end(), [&](const ShaderField& field) { return field.name == name; });
  return found == effect.fields.end() ? -1 : static_cast<int>(found - effect.fields.begin());
}

/// The effect's own field, else the ComposedShader's of that name.
FieldUniform NameJoiner::field_uniform(const PlacedUnit& unit, const GlobalOutline& uniform) const {
  const Owner& owner = c_.owners[unit.owner];
  FieldUniform found;
  found.name = final_name(owner, uniform.name);
  found.type = uniform.type;
  found.owner = owner.index;
  found.of_shader = owner.kind == OwnerKind::shader;
  const std::string_view written = unit.code->written_name(uniform.name);
  found.field = find_field(c_.author(owner), written);
  found.span = unit.code->span(uniform.name_begin, uniform.name_begin + static_cast<std::uint32_t>(uniform.name.size()));
  if (found.field >= 0 || c_.recipe.shader < 0) return found;
  const int shader_field = find_field(c_.input.scene.shaders[static_cast<std::size_t>(c_.recipe.shader)], written);
  if (shader_field >= 0) {
    found.owner = c_.recipe.shader;
    found.of_shader = true;
    found.field = shader_field;
  }
  return found;
}

void NameJoiner::list_fields(const PlacedUnit& unit) {
  if (unit.dropped || c_.owners[unit.owner].kind == OwnerKind::renderer) return;
  for (const GlobalOutline& global : unit.code->outline.globals) {
    if (global.storage != Storage::uniform || find_castle_name(global.name) ||
        !number_own_light(global.name, 0).empty()) {
      continue;
    }
    FieldUniform uniform = field_uniform(unit, global);
    const bool listed = std::any_of(c_.result.fields.begin(), c_.result.fields.end(),
                                    [&](const FieldUniform& known) { return known.name == uniform.name; });
    if (!listed) c_.result.fields.push_back(std::move(uniform));
  }
}

void NameJoiner::join() {
  for (std::size_t owner = 0; owner < c_.owners.size(); ++owner) name_owner(owner);
  for (std::size_t unit = 0; unit < c_.units.size(); ++unit) bind_foreign(unit);
  for (const PlacedUnit& unit : c_.units) list_fields(unit);
}

}  // namespace

void join_names(Composition& composition) { NameJoiner(composition).join(); }

}  // namespace plugc
