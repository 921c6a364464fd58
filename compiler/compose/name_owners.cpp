// Every owner (the renderer, each effect, the ComposedShader) has a name space of its own; the composed text has one a
// stage. Owners are taken in order, and a name that an earlier owner has is changed to `name_2`, `name_3`, ... everywhere in
// its owner's code. castle_ names belong to the renderer whoever declares them, and so do vertex inputs, which the geometry
// feeds by name; in a light's own effect, `castle_LightSourceColor` is the name of that light's. Uniforms and varyings live in
// all stages at once, other names in theirs. Structs that are equal token for token are one type and need no second name.

#include <fmt/format.h>

#include "compose/placed_unit.h"
#include "compose/struct_text.h"
#include "glsl/dialect_words.h"
#include "glsl/scan.h"
#include "glsl/tokens.h"

namespace plugc {
namespace {

struct DeclaredName {
  std::string_view name;
  StageMask stages = 0;
  const CodeUnit* struct_code = nullptr;  ///< For a struct, with `type`.
  const StructOutline* type = nullptr;
};

bool is_castle(std::string_view name) {
  return name.starts_with("castle_");
}
bool is_attribute(const PlacedUnit& unit, const GlobalOutline& global) {
  return unit.stage == ShaderStage::vertex && global.storage == Storage::in;
}

class OwnerNamer {
 public:
  explicit OwnerNamer(Composition& composition) : c_(composition), units_by_owner_(composition.owners.size()) {
    for (const PlacedUnit& unit : c_.units) {
      if (!unit.dropped) units_by_owner_[unit.owner].push_back(&unit);
    }
  }
  void run();

 private:
  void take_attributes();
  void take_builtins();
  std::vector<DeclaredName> declared_names(std::size_t owner) const;
  void name_owner(std::size_t owner);
  void name_struct(const DeclaredName& declared, std::size_t owner);
  std::string_view choose_name(const DeclaredName& declared, std::size_t owner);
  void name_own_light(std::size_t owner);

  Composition& c_;
  std::vector<std::vector<const PlacedUnit*>> units_by_owner_;
  std::map<std::pair<StageMask, std::string>, std::string_view> structs_;  // final names by the structs' texts
};

/// Before all else, so that no function or variable of a renderer-fed name comes between.
void OwnerNamer::take_attributes() {
  for (const PlacedUnit& unit : c_.units) {
    for (const GlobalOutline& global : unit.code->outline.globals) {
      const bool fed = !unit.dropped && is_attribute(unit, global) && !is_castle(global.name);
      if (fed) c_.taken.take(global.name, in_stage(unit.stage), 0);
    }
  }
}

std::vector<DeclaredName> OwnerNamer::declared_names(std::size_t owner) const {
  std::vector<DeclaredName> names;
  for (const PlacedUnit* unit : units_by_owner_[owner]) {
    const Outline& outline = unit->code->outline;
    const StageMask here = in_stage(unit->stage);
    for (const FunctionOutline& function : outline.functions) {
      const bool own = function.is_definition() && plug_name(function.name).empty() && function.name != "main";
      if (own) names.push_back({function.name, here, nullptr, nullptr});
    }
    for (const GlobalOutline& global : outline.globals) {
      const std::string_view name = unit->code->declared_name(global);
      if (is_castle(name) || is_attribute(*unit, global)) continue;
      const bool shared = global.storage == Storage::uniform || global.storage == Storage::in || global.storage == Storage::out;
      names.push_back({name, shared ? kAllStages : here, nullptr, nullptr});
    }
    for (const StructOutline& type : outline.structs) {
      if (!type.name.empty()) names.push_back({type.name, here, unit->code.get(), &type});
      if (!type.instance.empty()) names.push_back({type.instance, here, nullptr, nullptr});
    }
  }
  return names;
}

/// The name that the owner's code gets; taken from here on.
std::string_view OwnerNamer::choose_name(const DeclaredName& declared, std::size_t owner) {
  std::string_view name = c_.name_of(owner, declared.name);
  if (!c_.taken.is_free(name, declared.stages, owner)) {
    name = c_.taken.new_name(declared.name, owner, c_.units);
    c_.owners[owner].renames.insert_or_assign(declared.name, name);
  }
  c_.taken.take(name, declared.stages, owner);
  return name;
}

void OwnerNamer::name_struct(const DeclaredName& declared, std::size_t owner) {
  const auto [known, added] = structs_.try_emplace({declared.stages, struct_text(*declared.struct_code, *declared.type)});
  if (added) {
    known->second = choose_name(declared, owner);
  } else if (known->second != declared.name) {
    c_.owners[owner].renames.insert_or_assign(declared.name, known->second);
  }
}

void OwnerNamer::name_own_light(std::size_t owner) {
  for (const PlacedUnit* unit : units_by_owner_[owner]) {
    if (unit->scope.kind != ScopeKind::light || c_.owners[owner].kind != OwnerKind::effect) return;
    for (const std::string& name : unit->code->castle_names) {
      std::string numbered = number_own_light(name, unit->scope.number);
      if (!numbered.empty()) c_.owners[owner].renames.try_emplace(name, c_.taken.keep(std::move(numbered)));
    }
  }
}

void OwnerNamer::name_owner(std::size_t owner) {
  name_own_light(owner);
  for (const DeclaredName& declared : declared_names(owner)) {
    if (declared.type != nullptr) {
      name_struct(declared, owner);
    } else {
      choose_name(declared, owner);
    }
  }
}

/// ESSL 3.00 (6.1) lets nobody define or overload what is built in: an author's function of such a name gets another.
void OwnerNamer::take_builtins() {
  if (c_.target != Target::essl300) return;
  constexpr std::size_t kBuiltin = SIZE_MAX - 1;  // no owner has this number
  for (const PlacedUnit& unit : c_.units) {
    for (const FunctionOutline& function : unit.code->outline.functions) {
      if (is_builtin_function(function.name)) c_.taken.take(function.name, kAllStages, kBuiltin);
    }
  }
}

void OwnerNamer::run() {
  for (const SwitchUniform& one : c_.result.switches) c_.taken.take(one.name, kAllStages, 0);
  take_attributes();
  take_builtins();
  for (std::size_t owner = 0; owner < c_.owners.size(); ++owner) name_owner(owner);
}

}  // namespace

void name_owners(Composition& composition) {
  OwnerNamer(composition).run();
}

namespace {

constexpr std::size_t kNobody = SIZE_MAX;

}  // namespace

bool TakenNames::is_free(std::string_view name, StageMask stages, std::size_t owner) const {
  const auto found = owners_.find(name);
  if (found == owners_.end()) return true;
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    const std::size_t holder = found->second[stage];
    if ((stages & (1U << stage)) != 0 && holder != kNobody && holder != owner) return false;
  }
  return true;
}

void TakenNames::take(std::string_view name, StageMask stages, std::size_t owner) {
  const auto [found, added] = owners_.try_emplace(name);
  if (added) found->second.fill(kNobody);
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    std::size_t& holder = found->second[stage];
    if ((stages & (1U << stage)) != 0 && holder == kNobody) holder = owner;
  }
}

std::string_view TakenNames::new_name(std::string_view name, std::size_t owner, const std::vector<PlacedUnit>& units) {
  for (int& number = next_number_.try_emplace(name, 2).first->second;; ++number) {
    std::string candidate = fmt::format("{}_{}", name, number);
    // templates hold no such words
    const bool is_word = owner != 0 && words_of(owner, units).contains(candidate);
    if (is_free(candidate, kAllStages, kNobody) && !is_word) return keep(std::move(candidate));
  }
}

/// The words of the owner's code that end in a digit, as new names do, those in macros included: a new name must not meet a
/// local variable either.
const std::unordered_set<std::string_view>& TakenNames::words_of(std::size_t owner, const std::vector<PlacedUnit>& units) {
  const auto [found, added] = words_.try_emplace(owner);
  for (std::size_t u = 0; added && u < units.size(); ++u) {
    if (units[u].owner != owner) continue;
    const CodeUnit& code = *units[u].code;
    const auto add = [&](std::string_view word) {
      if (is_digit(word.back())) found->second.insert(word);
    };
    for (const Token& token : code.tokens.tokens) {
      if (token.kind == TokenKind::identifier) add(code.at(token));
      if (token.kind != TokenKind::directive) continue;
      for (const Token& word : directive_tokens(code.text.text(), token)) add(code.at(word));
    }
  }
  return found->second;
}

}  // namespace plugc
