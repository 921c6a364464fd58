#pragma once
// A random scene with effects, as plain data: what the generator makes, what is written down as X3D and GLSL, and what the
// second composer reads. It never sees the text, so that nothing of plugc's reading of GLSL can reach it.
//
// Whatever an author declares carries a tag, a number of its own that stands in the text as a literal; in composed text the
// tag tells which of several `noise` a call has reached.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plugc::oracle {

enum class PartType { vertex, fragment, light };

/// `const in vec4`: qualifiers as an author writes them, in one of "", "in", "const", "const in", "out", "inout".
struct ParameterModel {
  std::string qualifier;
  std::string type;
  friend bool operator==(const ParameterModel&, const ParameterModel&) = default;
};

enum class GlobalKind { uniform, varying, constant, macro, structure };
struct GlobalModel {
  GlobalKind kind = GlobalKind::uniform;
  std::string type;  ///< Of uniforms and varyings.
  std::string name;
  int tag = 0;               ///< The value of constants and macros, the member of structures.
  bool initialised = false;  ///< A uniform with a default.
  int line = 0;              ///< In the scene file, as all lines here; set when it is written.
};

enum class StatementKind {
  read,     ///< Uses the global `name`.
  write,    ///< Assigns the varying `name`.
  call,     ///< Calls the helper `name` with an argument of `type`.
  marker,   ///< Offers the plug `name` with `count` arguments of `type`.
  renderer  ///< Uses the renderer's uniform `name`, of `type`, without declaring it.
};
struct StatementModel {
  StatementKind kind = StatementKind::read;
  std::string name;
  std::string type;
  int count = 1;
};

/// A plug function, a helper, or a helper's prototype.
struct FunctionModel {
  int tag = 0;
  bool is_plug = false;
  std::string name;  ///< Of the plug, or of the helper.
  std::string returned = "void";
  std::vector<ParameterModel> parameters;
  bool defined = true;
  std::vector<StatementModel> statements;
  int line = 0;
};

struct PartModel {
  PartType type = PartType::fragment;
  std::vector<GlobalModel> globals;
  std::vector<FunctionModel> functions;
};

struct FieldModel {
  std::string type, name;
  int line = 0;
};

struct EffectModel {
  bool enabled = true;
  std::string language = "GLSL";
  bool ignore_missing = false;  ///< uniformMissing "IGNORE".
  std::vector<FieldModel> fields;
  std::vector<int> parts;  ///< Into EffectSet::parts; one may stand there twice (USE).
  int language_line = 0;
};

struct LightModel {
  std::string node;  ///< DirectionalLight, PointLight or SpotLight.
  bool on = true;
  std::vector<int> effects;
};

struct TextureModel {
  std::string sampler = "sampler2D";  ///< That reads it; "" for a ShaderTexture.
  std::vector<int> effects;
};

struct ShapeModel {
  bool lit = true;
  bool gouraud = false;
  std::vector<TextureModel> textures;
  std::vector<int> effects;  ///< Of the Appearance.
  int group = 0;
};

/// Group 0 is the top level of the scene; a group stands behind the group that it is in.
struct GroupModel {
  int parent = -1;
  std::vector<int> effects;
};

struct EffectSet {
  bool headlight = true;
  std::vector<PartModel> parts;
  std::vector<EffectModel> effects;
  std::vector<LightModel> lights;  ///< In document order, at the top level.
  std::vector<GroupModel> groups;
  std::vector<ShapeModel> shapes;  ///< In document order.
};

/// The same seed gives the same set, anywhere. `mistakes` also makes sets that have some.
EffectSet generate_effect_set(std::uint64_t seed, bool mistakes);

/// The set as a scene in Classic encoding; fills in every line. Textures read `white.png`.
std::string write_scene(EffectSet& set);

/// A function's local variable that has this type: `t` (float), `v` (vec3) or `w` (vec4).
std::string_view local_of_type(std::string_view type);

}  // namespace plugc::oracle
