// What an owner only declares is sought elsewhere: a function without a body in the shape's other effects (the thesis's
// library parts), an input that no part of its own effect writes in an earlier stage among the varyings of the others, a
// uniform among the fields of its effect and then of the ComposedShader. What is found gets the name that it has there.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "compose/borrow_functions.h"
#include "compose/castle_names.h"
#include "compose/placed_unit.h"
#include "compose/uniform_defaults.h"

namespace plugc {
namespace {

/// A definition of a function, and whose it is.
struct Definition {
  std::size_t owner = 0;
  const FunctionOutline* function = nullptr;
};

/// How declarations in two stages are one variable: as a uniform, or as what a stage hands to the next.
enum class Link : std::uint8_t { none, uniform, into_geometry, into_fragment };

/// The first declaration of a variable that stages share.
struct Linked {
  const PlacedUnit* unit = nullptr;
  const GlobalOutline* global = nullptr;
};

/// Outputs of one name, by owner: several where an owner contradicts itself.
using Writers = std::multimap<std::size_t, const GlobalOutline*>;

class NameBinder {
 public:
  explicit NameBinder(Composition& composition) : c_(composition) {}
  void run();

 private:
  void index_unit(const PlacedUnit& unit);
  Link link(const PlacedUnit& unit, const GlobalOutline& global) const;
  void compare_stages(const PlacedUnit& unit);
  void bind_unit(const PlacedUnit& unit);
  void step_aside(const PlacedUnit& unit, std::string_view name);
  std::vector<RelatedPlace> undefined_causes(const PlacedUnit& unit, const FunctionOutline& prototype) const;
  void bind_function(const PlacedUnit& unit, const FunctionOutline& prototype);
  Writers writers(ShaderStage reader, std::string_view name) const;
  std::string unwritten_message(const PlacedUnit& unit, const GlobalOutline& input) const;
  std::vector<RelatedPlace> unwritten_causes(const PlacedUnit& unit, std::string_view name) const;
  void note_geometry(const PlacedUnit& unit, std::string_view name, const Writers& all);
  void bind_input(const PlacedUnit& unit, const GlobalOutline& input);
  void check_castle_inputs(const PlacedUnit& unit);
  std::set<std::size_t> one_for_each_author(const std::set<std::size_t>& owners) const;
  void report(DiagnosticId id, const PlacedUnit& unit, std::string_view name, std::uint32_t begin, std::string message,
              std::vector<RelatedPlace> related = {});
  void list_fields(const PlacedUnit& unit);
  std::vector<double> initial_of(const PlacedUnit& unit, const GlobalOutline& uniform);
  FieldUniform field_uniform(const PlacedUnit& unit, const GlobalOutline& uniform);

  Composition& c_;
  std::map<std::pair<ShaderStage, std::string_view>, std::vector<Definition>> functions_;
  std::array<std::map<std::string_view, Writers>, kStageCount> outputs_;  // of each stage: by name
  std::map<std::tuple<Link, std::size_t, std::string_view>, Linked> linked_;
  std::vector<Borrowing> borrowings_;
  std::vector<std::pair<const PlacedUnit*, std::string_view>> idle_;  // functions that are declared, and no more
  std::set<std::string_view> written_;                                // castle_ names that the vertex stage uses
  std::set<std::string> listed_;
};

bool directive_names(const CodeUnit& code, const Token& directive, std::string_view name) {
  if (code.at(directive).find(name) == std::string_view::npos) return false;
  const std::vector<Token> words = directive_tokens(code.text.text(), directive);
  return std::any_of(words.begin(), words.end(), [&](const Token& word) { return code.at(word) == name; });
}

/// Whether the name stands anywhere in the unit but at `declared_at`.
bool is_used(const CodeUnit& code, std::string_view name, const std::set<std::uint32_t>& declared_at) {
  return std::any_of(code.tokens.tokens.begin(), code.tokens.tokens.end(), [&](const Token& token) {
    if (token.kind == TokenKind::directive) return directive_names(code, token, name);
    return token.kind == TokenKind::identifier && code.at(token) == name && !declared_at.contains(token.begin);
  });
}

/// Whether a macro of the unit may define functions that no outline shows: one that opens a body does.
bool macros_define_functions(const CodeUnit& code) {
  const auto& macros = code.outline.macros;
  return std::any_of(macros.begin(), macros.end(), [&](const MacroOutline& macro) {
    return std::string_view(code.text.text()).substr(macro.body_begin, macro.end - macro.body_begin).find('{') !=
           std::string_view::npos;
  });
}

void NameBinder::index_unit(const PlacedUnit& unit) {
  for (const FunctionOutline& function : unit.code->outline.functions) {
    if (function.is_definition()) functions_[{unit.stage, function.name}].push_back({unit.owner, &function});
  }
  for (const GlobalOutline& global : unit.code->outline.globals) {
    const bool written = global.storage == Storage::out && is_used(*unit.code, global.name, {global.name_begin});
    if (written) outputs_[static_cast<std::size_t>(unit.stage)][global.name].emplace(unit.owner, &global);
  }
  if (unit.stage == ShaderStage::vertex) written_.insert(unit.code->castle_names.begin(), unit.code->castle_names.end());
}

void NameBinder::report(DiagnosticId id, const PlacedUnit& unit, std::string_view name, std::uint32_t begin,
                        std::string message, std::vector<RelatedPlace> related) {
  c_.diagnostics.report(id, name_span(*unit.code, name, begin), std::move(message), std::move(related));
  c_.mark_faulty(unit);
}

/// An effect that acts in several places, on two lights or in two lists, is an owner in each, and one candidate.
std::set<std::size_t> NameBinder::one_for_each_author(const std::set<std::size_t>& owners) const {
  std::set<std::pair<OwnerKind, int>> known;
  std::set<std::size_t> kept;
  for (const std::size_t owner : owners) {
    if (known.insert({c_.owners[owner].kind, c_.owners[owner].index}).second) kept.insert(owner);
  }
  return kept;
}

/// What the vertex stage writes goes to the fragment stage where nothing stands between or plugc passes it on.
Link NameBinder::link(const PlacedUnit& unit, const GlobalOutline& global) const {
  if (global.storage == Storage::uniform) return Link::uniform;
  if (unit.stage == ShaderStage::vertex) {
    if (global.storage != Storage::out) return Link::none;
    return !c_.has_geometry || c_.passed.contains(c_.name_of(unit.owner, global.name)) ? Link::into_fragment
                                                                                       : Link::into_geometry;
  }
  if (global.storage == Storage::in) return unit.stage == ShaderStage::geometry ? Link::into_geometry : Link::into_fragment;
  return unit.stage == ShaderStage::geometry && global.storage == Storage::out ? Link::into_fragment : Link::none;
}

/// Within a stage, unequal declarations are found where they are written. A uniform of several stages, and what one stage
/// hands to another, are compared here: else only the linker would see them, without a place.
void NameBinder::compare_stages(const PlacedUnit& unit) {
  for (const GlobalOutline& global : unit.code->outline.globals) {
    const Link as = link(unit, global);
    if (as == Link::none || global.name.starts_with("castle_")) continue;
    const std::string_view name = as == Link::into_fragment ? unit.code->macro_word(global.name) : global.name;
    const Linked& first = linked_.try_emplace({as, unit.owner, name}, Linked{&unit, &global}).first->second;
    // a geometry stage reads an array of what one vertex has
    const bool equal = first.global->type == global.type && (as == Link::into_geometry || first.global->array == global.array);
    if (equal || first.unit->stage == unit.stage) continue;
    report(DiagnosticId::unequal_declarations, unit, global.name, global.name_begin,
           fmt::format("`{}` is declared here as `{}{}`, and differently in the {} stage", global.name, global.type,
                       global.array, to_text(first.unit->stage)),
           {{name_span(*first.unit->code, first.global->name, first.global->name_begin), "the other declaration"}});
  }
}

/// A function that nobody defines and nobody calls must not meet another owner's name either, unless an overload of it has
/// been found there.
void NameBinder::step_aside(const PlacedUnit& unit, std::string_view name) {
  auto& borrowed = c_.owners[unit.owner].borrowed[static_cast<std::size_t>(unit.stage)];
  if (borrowed.contains(name) || c_.taken.is_free(c_.final_name(unit, name), in_stage(unit.stage), unit.owner)) return;
  borrowed.insert_or_assign(std::string(name), c_.taken.new_name(std::string(name), unit.owner, c_.units));
}

/// Another effect's function of that name with other parameters, else code that is not understood.
std::vector<RelatedPlace> NameBinder::undefined_causes(const PlacedUnit& unit, const FunctionOutline& prototype) const {
  for (const PlacedUnit& other : c_.units) {
    for (const FunctionOutline& function : other.code->outline.functions) {
      const bool same_name = other.stage == unit.stage && function.is_definition() && function.name == prototype.name;
      if (same_name) return {{name_span(*other.code, function.name, function.name_begin), "it has other parameters here"}};
    }
  }
  return doubtful_places(c_.input, unit.stage, prototype.name);
}

void NameBinder::bind_function(const PlacedUnit& unit, const FunctionOutline& prototype) {
  std::set<std::size_t> candidates;
  for (const Definition& definition : functions_[{unit.stage, prototype.name}]) {
    if (same_parameters(*definition.function, prototype)) candidates.insert(definition.owner);
  }
  if (candidates.contains(unit.owner)) return;
  candidates = one_for_each_author(candidates);
  if (candidates.size() > 1) {
    return report(DiagnosticId::ambiguous_function, unit, prototype.name, prototype.name_begin,
                  fmt::format("`{}` is declared here and defined by {} other effects; define it in one, or in this one",
                              prototype.name, candidates.size()));
  }
  if (candidates.size() == 1) {
    if (is_used(*unit.code, prototype.name, {prototype.name_begin}))
      c_.note_need(unit, *candidates.begin(), NeedKind::function, prototype.name);
    borrowings_.push_back({static_cast<std::size_t>(&unit - c_.units.data()), &prototype, *candidates.begin()});
    return;
  }
  if (macros_define_functions(*unit.code)) return;
  if (!is_used(*unit.code, prototype.name, {prototype.name_begin})) {
    idle_.emplace_back(&unit, prototype.name);
    return;
  }
  report(DiagnosticId::shader_invalid, unit, prototype.name, prototype.name_begin,
         fmt::format("`{}` is declared and called, but nothing defines it in the {} stage of this shape", prototype.name,
                     to_text(unit.stage)),
         undefined_causes(unit, prototype));
}

/// Who writes the name for a stage to read. Fragment code behind a geometry stage reads what that writes, and what passes it.
Writers NameBinder::writers(ShaderStage reader, std::string_view name) const {
  const auto written_in = [&](ShaderStage stage) {
    const auto& outputs = outputs_[static_cast<std::size_t>(stage)];
    const auto found = outputs.find(name);
    return found == outputs.end() ? Writers() : found->second;
  };
  Writers all = written_in(ShaderStage::vertex);
  if (reader == ShaderStage::geometry || !c_.has_geometry) return all;
  std::erase_if(all, [&](const auto& writer) { return !c_.passed.contains(c_.name_of(writer.first, name)); });
  all.merge(written_in(ShaderStage::geometry));
  return all;
}

/// Those whose output is what the input asks for; a geometry stage reads an array of it.
std::set<std::size_t> owners_that_fit(const Writers& writers, const GlobalOutline& input, ShaderStage reader) {
  std::set<std::size_t> owners;
  for (const auto& [owner, output] : writers) {
    const bool sizes_fit = reader == ShaderStage::geometry ? !input.array.empty() : output->array == input.array;
    if (sizes_fit && output->type == input.type) owners.insert(owner);
  }
  return owners;
}

std::string NameBinder::unwritten_message(const PlacedUnit& unit, const GlobalOutline& input) const {
  const Writers in_vertex = writers(ShaderStage::geometry, input.name);
  if (unit.stage == ShaderStage::fragment && c_.has_geometry && !owners_that_fit(in_vertex, input, unit.stage).empty()) {
    return fmt::format(
        "`{}` is written in the vertex stage and does not get through the geometry shader of this shape; write "
        "`/* VARYING-PASSTHROUGH-GEOMETRY-SHADERS */` in front of `varying {} {};` in the `VERTEX` part",
        input.name, input.type, input.name);
  }
  return fmt::format("nothing writes `{}`; declare it as `varying {} {};` in a `VERTEX` part too and write it there",
                     input.name, input.type, input.name);
}

/// What geometry code writes is there as long as some effect brings the `main` of that stage.
void NameBinder::note_geometry(const PlacedUnit& unit, std::string_view name, const Writers& all) {
  const auto& outputs = outputs_[static_cast<std::size_t>(ShaderStage::geometry)];
  const auto written = outputs.find(name);
  if (!c_.has_geometry || unit.stage != ShaderStage::fragment || written == outputs.end()) return;
  const bool reads = std::any_of(written->second.begin(), written->second.end(),
                                 [&](const auto& writer) { return all.contains(writer.first); });
  if (reads) c_.note_need(unit, c_.geometry.owner, NeedKind::geometry_shader, "");
}

void NameBinder::bind_input(const PlacedUnit& unit, const GlobalOutline& input) {
  const std::string_view read = unit.code->macro_word(input.name);
  const Writers all = writers(unit.stage, read);
  note_geometry(unit, read, all);
  if (all.contains(unit.owner) || !is_used(*unit.code, input.name, {input.name_begin})) return;
  const std::set<std::size_t> candidates = one_for_each_author(owners_that_fit(all, input, unit.stage));
  if (candidates.size() == 1) {
    c_.note_need(unit, *candidates.begin(), NeedKind::varying, read);
    return borrow_name(c_, unit, read, *candidates.begin());
  }
  const std::string message = candidates.empty()
                                  ? unwritten_message(unit, input)
                                  : fmt::format("`{}` is read here and written by {} other effects; write it in this one",
                                                input.name, candidates.size());
  report(DiagnosticId::varying_unwritten, unit, input.name, input.name_begin, message,
         candidates.empty() ? unwritten_causes(unit, read) : std::vector<RelatedPlace>());
}

/// Where it is declared and not written; else code that is not understood and may have been meant to write it, or to bring the
/// geometry stage in which it is written.
std::vector<RelatedPlace> NameBinder::unwritten_causes(const PlacedUnit& unit, std::string_view name) const {
  for (const PlacedUnit& other : c_.units) {
    for (const GlobalOutline& global : other.code->outline.globals) {
      if (global.storage == Storage::out && global.name == name && other.stage != ShaderStage::fragment)
        return {{name_span(*other.code, global.name, global.name_begin), "it is declared here"}};
    }
  }
  std::vector<RelatedPlace> causes = doubtful_places(c_.input, ShaderStage::vertex, name);
  const bool by_geometry = outputs_[static_cast<std::size_t>(ShaderStage::geometry)].contains(name) || !c_.has_geometry;
  if (causes.empty() && unit.stage == ShaderStage::fragment && by_geometry)
    causes = doubtful_places(c_.input, ShaderStage::geometry, "");
  return causes;
}

/// castle_ varyings that this shape's vertex stage does not have: `castle_Color` under Phong shading, say.
void NameBinder::check_castle_inputs(const PlacedUnit& unit) {
  if (c_.owners[unit.owner].kind != OwnerKind::effect || c_.recipe.depth_only) return;
  for (const std::string& name : unit.code->castle_names) {
    const auto meaning = find_castle_name(name);
    if (!meaning || meaning->kind != CastleKind::varying || written_.contains(name)) continue;
    const auto& tokens = unit.code->tokens.tokens;
    const auto token = std::find_if(tokens.begin(), tokens.end(), [&](const Token& t) {
      return t.kind == TokenKind::identifier && unit.code->at(t) == name;
    });
    report(DiagnosticId::varying_unwritten, unit, name, token == tokens.end() ? 0 : token->begin,
           fmt::format("nothing writes `{}` in the vertex stage of this shape{}", name,
                       name == "castle_Color" ? "; it is there under `GOURAUD` shading only" : ""));
  }
}

void NameBinder::bind_unit(const PlacedUnit& unit) {
  for (const FunctionOutline& function : unit.code->outline.functions) {
    if (!function.is_definition()) bind_function(unit, function);
  }
  if (unit.stage == ShaderStage::vertex) return;
  for (const GlobalOutline& global : unit.code->outline.globals) {
    if (global.storage == Storage::in && !global.name.starts_with("castle_")) bind_input(unit, global);
  }
  check_castle_inputs(unit);
}

int find_field(const SceneEffect& effect, std::string_view name) {
  const auto found =
      std::find_if(effect.fields.begin(), effect.fields.end(), [&](const ShaderField& field) { return field.name == name; });
  return found == effect.fields.end() ? -1 : static_cast<int>(found - effect.fields.begin());
}

/// GLSL ES 3.00 has no initialisers of uniforms, so what cannot be computed here is lost there.
std::vector<double> NameBinder::initial_of(const PlacedUnit& unit, const GlobalOutline& uniform) {
  if (auto value = initial_value(*unit.code, uniform)) return std::move(*value);
  if (uniform.initializer_end > uniform.initializer_begin && c_.target == Target::essl300) {
    report(DiagnosticId::uniform_without_field, unit, uniform.name, uniform.name_begin,
           fmt::format(
               "plugc cannot compute what `{}` starts with, and `essl300` has no initialised uniforms: there it starts as 0; "
               "give it a field",
               uniform.name));
  }
  return {};
}

/// The effect's own field, else the ComposedShader's of that name.
FieldUniform NameBinder::field_uniform(const PlacedUnit& unit, const GlobalOutline& uniform) {
  const Owner& owner = c_.owners[unit.owner];
  FieldUniform found;
  found.name = c_.final_name(unit, uniform.name);
  found.type = uniform.type;
  found.owner = owner.index;
  found.of_shader = owner.kind == OwnerKind::shader;
  const std::string_view written = unit.code->written_name(uniform.name);
  found.field = find_field(c_.author(owner), written);
  found.span = name_span(*unit.code, uniform.name, uniform.name_begin);
  found.initial = initial_of(unit, uniform);
  if (found.field >= 0 || c_.recipe.shader < 0) return found;
  const int shader_field = find_field(c_.input.scene.shaders[static_cast<std::size_t>(c_.recipe.shader)], written);
  if (shader_field >= 0) {
    found.owner = c_.recipe.shader;
    found.of_shader = true;
    found.field = shader_field;
  }
  return found;
}

void NameBinder::list_fields(const PlacedUnit& unit) {
  for (const GlobalOutline& global : unit.code->outline.globals) {
    const bool by_renderer = find_castle_name(global.name) || !number_own_light(global.name, 0).empty();
    if (global.storage != Storage::uniform || by_renderer) continue;
    FieldUniform uniform = field_uniform(unit, global);
    if (listed_.insert(uniform.name).second) c_.result.fields.push_back(std::move(uniform));
  }
}

void NameBinder::run() {
  const auto each_unit = [&](bool by_author, auto member) {
    for (const PlacedUnit& unit : c_.units) {
      if (!unit.dropped && (!by_author || c_.by_author(unit))) (this->*member)(unit);
    }
  };
  if (c_.owners.size() == 1) return;
  each_unit(false, &NameBinder::index_unit);
  each_unit(true, &NameBinder::compare_stages);
  each_unit(true, &NameBinder::bind_unit);
  borrow_functions(c_, borrowings_);
  for (const auto& [unit, name] : idle_) step_aside(*unit, name);
  each_unit(true, &NameBinder::list_fields);
}

}  // namespace

void bind_names(Composition& composition) {
  NameBinder(composition).run();
}

}  // namespace plugc
