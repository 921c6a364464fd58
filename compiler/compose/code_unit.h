#pragma once
// One piece of shader code on its way into a stage: upgraded, cut into tokens, outlined. Made once for each effect part
// and for each form of a template; composing only reads it.

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostics.h"
#include "glsl/dialect.h"
#include "glsl/outline.h"
#include "glsl/stage.h"
#include "scene/scene.h"

namespace plugc {

/// A definition of a plug function.
struct PlugFunction {
  std::size_t function = 0;  ///< Into Outline::functions.
  std::string_view plug;     ///< Its name without `PLUG_`.
  bool overloaded = false;   ///< The unit defines several of the name.
};

struct CodeUnit {
  MappedText text;
  std::vector<std::string> castle_names;   ///< castle_ names that the text uses, declared or not.
  std::vector<RenamedName> renamed_names;  ///< Names that upgrading had to change.
  std::vector<Span> merged_directions;     ///< Of parameters that had several (UpgradedText).
  TokenList tokens;
  Outline outline;                           ///< Points into `text`, so a unit is never moved once made.
  std::vector<PlugFunction> plug_functions;  ///< In text order.
  std::vector<Token> plug_words;             ///< Where `PLUG_` names stand in the code.
  bool names_precision = false;              ///< `lowp`, `mediump` or `highp` stands somewhere in it.
  std::unordered_map<std::string_view, std::string_view> macro_words;  ///< Macros that stand for one word.

  CodeUnit() = default;
  CodeUnit(const CodeUnit&) = delete;
  CodeUnit& operator=(const CodeUnit&) = delete;

  std::string_view at(const Token& token) const { return token_text(text.text(), token); }
  Span span(std::uint32_t begin, std::uint32_t end) const { return text.locate(begin, end); }
  /// A name as its author wrote it.
  std::string_view written_name(std::string_view name) const;
  /// What a name stands for: the word that a macro of that name is, else the name itself.
  std::string_view macro_word(std::string_view name) const;
  /// The name that a declaration gives: behind `#define scale factor`, `uniform float scale;` declares `factor`.
  std::string_view declared_name(const GlobalOutline& global) const;
};

/// Whether `lowp`, `mediump` or `highp` stands in the text.
bool names_precision(std::string_view text);

/// `PLUG_name` -> `name`; "" for other names.
std::string_view plug_name(std::string_view function_name);

/// Notes where the unit has plug functions; it must be outlined.
void note_plugs(CodeUnit& unit);

/// The unit's own `main`; null where it has none.
const FunctionOutline* find_main(const CodeUnit& unit);

/// Upgrades and outlines a text for a stage. The target decides what `GL_ES` and `__VERSION__` make of its `#if`s, and
/// `behind_geometry` what `HAS_GEOMETRY_SHADER` does.
std::shared_ptr<const CodeUnit> make_code_unit(const MappedText& text, ShaderStage stage, Target target = Target::glsl330,
                                               bool behind_geometry = false);

/// What is not understood of an author's code.
struct CodeDoubt {
  Span span;
  std::string message;
};

/// An effect's or ComposedShader's parts. A LIGHT part has two forms, one for each stage that may light.
struct EffectCode {
  struct Part {
    PartStage stage = PartStage::vertex;
    std::shared_ptr<const CodeUnit> in_vertex;        ///< Set for VERTEX and LIGHT.
    std::shared_ptr<const CodeUnit> in_fragment;      ///< Set for FRAGMENT and LIGHT.
    std::shared_ptr<const CodeUnit> in_geometry;      ///< Set for GEOMETRY.
    std::shared_ptr<const CodeUnit> behind_geometry;  ///< `in_fragment` where there is a geometry stage, when it asks for that.
    std::shared_ptr<const Part> for_essl;             ///< The part as ESSL reads it, when it asks for `GL_ES` or `__VERSION__`.

    const Part& form(Target target) const { return target == Target::essl300 && for_essl ? *for_essl : *this; }
  };
  std::vector<Part> parts;                ///< Each EffectPart node once, however often it is USEd.
  std::vector<std::string> plugs;         ///< That some part fills: sorted, each once.
  std::vector<std::string> castle_names;  ///< That some part uses: sorted, each once.
  bool has_problems = false;              ///< Some part cannot be taken apart, which has been reported at its place.
  bool moves_vertices = false;            ///< Some part does, in a plug of the vertex stage.
  bool discards = false;                  ///< Some fragment part drops fragments.
  bool has_geometry_main = false;         ///< Some GEOMETRY part has a `main`.
  bool broken = false;                    ///< Some part can never be valid, and that is reported.
  std::vector<CodeDoubt> doubts;          ///< To be reported as `shader_syntax` where a compiler refuses the code.

  bool fills(std::string_view plug) const;        ///< Some part defines PLUG_plug.
  bool uses(std::string_view castle_name) const;  ///< Some part names it.
};

/// Outlines the parts of an effect. What can never be valid is reported at the author's place.
EffectCode make_effect_code(const SceneEffect& effect, Diagnostics& diagnostics);

}  // namespace plugc
