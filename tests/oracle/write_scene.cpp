// Writes line by line, counting lines. A node is written in full where it comes first, and by USE from then on. Every author's
// function begins with its tag, in a float `t` beside which stand locals of the other types:
//
//     void PLUG_fragment_modify(inout vec4 p0)
//     {
//       float t = 17.0; vec3 v = vec3(t); vec4 w = vec4(t);
//       t += level;
//       /* PLUG: dim (t) */
//     }

#include <fmt/format.h>

#include <set>

#include "oracle/effect_set.h"

namespace plugc::oracle {
namespace {

class SceneWriter {
 public:
  explicit SceneWriter(EffectSet& set) : set_(set) {}

  std::string write() {
    line("#X3D V4.0 utf8");
    line(fmt::format("NavigationInfo {{ headlight {} }}", set_.headlight ? "TRUE" : "FALSE"));
    for (const LightModel& light : set_.lights) {
      line(fmt::format("{} {{ on {}", light.node, light.on ? "TRUE" : "FALSE"));
      write_effects("effects", light.effects);
      line("}");
    }
    write_group(0);
    return std::move(text_);
  }

 private:
  int line(std::string_view text) {
    text_ += text;
    text_ += '\n';
    return line_++;
  }

  void write_group(int group) {
    write_children(set_.groups[static_cast<std::size_t>(group)].effects);
    for (const ShapeModel& shape : set_.shapes) {
      if (shape.group == group) write_shape(shape);
    }
    for (std::size_t inner = 0; inner < set_.groups.size(); ++inner) {
      if (set_.groups[inner].parent != group) continue;
      line("Group { children [");
      write_group(static_cast<int>(inner));
      line("] }");
    }
  }

  /// A texture that this sampler reads, without its end.
  static std::string texture_text(const std::string& sampler) {
    if (sampler == "sampler2D") return "ImageTexture { url \"white.png\"";
    if (sampler == "sampler3D") return "PixelTexture3D { image [ 1 1 1 1 255 ]";
    if (sampler.empty()) return "ShaderTexture {";
    std::string text = "ComposedCubeMapTexture {";
    for (const std::string_view side : {"front", "back", "left", "right", "top", "bottom"})
      text += fmt::format(" {}Texture PixelTexture {{ image 1 1 1 255 }}", side);
    return text;
  }

  void write_shape(const ShapeModel& shape) {
    line(fmt::format("Shape {{ {} geometry Box {{ }} appearance Appearance {{", shape.gouraud ? "shading \"GOURAUD\"" : ""));
    line(shape.lit ? "material Material { specularColor 1 1 1 }" : "material UnlitMaterial { emissiveColor 1 1 1 }");
    if (shape.textures.size() > 1) line("texture MultiTexture { mode [ \"MODULATE\" \"MODULATE\" ] texture [");
    for (const TextureModel& texture : shape.textures) {
      line(fmt::format("{}{}", shape.textures.size() > 1 ? "" : "texture ", texture_text(texture.sampler)));
      write_effects("effects", texture.effects);
      line("}");
    }
    if (shape.textures.size() > 1) line("] }");
    write_effects("effects", shape.effects);
    line("} }");
  }

  void write_effects(std::string_view field, const std::vector<int>& effects) {
    line(fmt::format("{} [", field));
    write_children(effects);
    line("]");
  }

  void write_children(const std::vector<int>& effects) {
    for (const int effect : effects) write_effect(effect);
  }

  void write_effect(int index) {
    if (!written_effects_.insert(index).second) {
      line(fmt::format("USE E{}", index));
      return;
    }
    EffectModel& effect = set_.effects[static_cast<std::size_t>(index)];
    line(fmt::format("DEF E{} Effect {{ enabled {}", index, effect.enabled ? "TRUE" : "FALSE"));
    effect.language_line = line(fmt::format("language \"{}\"", effect.language));
    if (effect.ignore_missing) line("uniformMissing \"IGNORE\"");
    for (FieldModel& field : effect.fields) {
      field.line = line(fmt::format("inputOutput {} {} {}", field.type, field.name, value_of(field.type)));
    }
    line("parts [");
    for (const int part : effect.parts) write_part(part);
    line("] }");
  }

  static std::string_view value_of(std::string_view field_type) {
    if (field_type == "SFFloat" || field_type == "SFInt32") return "1";
    if (field_type == "SFVec2f") return "1 1";
    return field_type == "SFRotation" ? "0 1 0 1" : "1 1 1";
  }

  void write_part(int index) {
    if (!written_parts_.insert(index).second) {
      line(fmt::format("USE P{}", index));
      return;
    }
    PartModel& part = set_.parts[static_cast<std::size_t>(index)];
    constexpr std::string_view kTypes[] = {"VERTEX", "FRAGMENT", "LIGHT"};
    line(fmt::format("DEF P{} EffectPart {{ type \"{}\" url \"data:text/plain,", index, kTypes[static_cast<int>(part.type)]));
    for (GlobalModel& global : part.globals) global.line = line(text_of(global));
    for (FunctionModel& function : part.functions) write_function(part, function);
    line("\" }");
  }

  static std::string text_of(const GlobalModel& global) {
    switch (global.kind) {
      case GlobalKind::uniform:
        return fmt::format("uniform {} {}{};", global.type, global.name, global.initialised ? " = 1.0" : "");
      case GlobalKind::varying: return fmt::format("varying {} {};", global.type, global.name);
      case GlobalKind::constant: return fmt::format("const float {} = {}.0;", global.name, global.tag);
      case GlobalKind::macro: return fmt::format("#define {} {}.0", global.name, global.tag);
      case GlobalKind::structure: return fmt::format("struct {} {{ float member_{}; }};", global.name, global.tag);
    }
    return "";
  }

  void write_function(const PartModel& part, FunctionModel& function) {
    std::string parameters;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
      const auto& [qualifier, type] = function.parameters[i];
      parameters += fmt::format("{}{}{}{} p{}", i > 0 ? ", " : "", qualifier, qualifier.empty() ? "" : " ", type, i);
    }
    function.line = line(fmt::format("{} {}{}({}){}", function.returned, function.is_plug ? "PLUG_" : "", function.name,
                                     parameters, function.defined ? "" : ";"));
    if (!function.defined) return;
    line("{");
    line(fmt::format("  float t = {}.0; vec3 v = vec3(t); vec4 w = vec4(t);", function.tag));
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
      if (function.parameters[i].qualifier == "out") line(fmt::format("  p{} = {}(t);", i, function.parameters[i].type));
    }
    for (std::size_t i = 0; i < function.statements.size(); ++i) line("  " + text_of(part, function.statements[i], i));
    if (function.returned != "void") line(fmt::format("  return {}(t);", function.returned));
    line("}");
  }

  static std::string text_of(const PartModel& part, const StatementModel& statement, std::size_t number) {
    switch (statement.kind) {
      case StatementKind::read: return read_text(part, statement.name, number);
      case StatementKind::write: return fmt::format("{} = {};", statement.name, local_of_type(statement.type));
      case StatementKind::call: return fmt::format("t += {}({});", statement.name, local_of_type(statement.type));
      case StatementKind::renderer: return fmt::format("t += {}{};", statement.name, statement.type == "float" ? "" : ".x");
      case StatementKind::marker: break;
    }
    std::string arguments;
    for (int i = 0; i < statement.count; ++i)
      arguments += fmt::format("{}{}", i > 0 ? ", " : "", local_of_type(statement.type));
    return fmt::format("/* PLUG: {} ({}) */", statement.name, arguments);
  }

  static std::string read_text(const PartModel& part, const std::string& name, std::size_t number) {
    for (const GlobalModel& global : part.globals) {
      if (global.name != name) continue;
      if (global.kind == GlobalKind::structure) return fmt::format("{} s{} = {}(t);", name, number, name);
      const bool is_vector = global.type.starts_with("vec");
      return fmt::format("t += {}{};", global.type == "int" ? "float(" + name + ")" : name, is_vector ? ".x" : "");
    }
    return "";
  }

  EffectSet& set_;
  std::string text_;
  int line_ = 1;
  std::set<int> written_effects_, written_parts_;
};

}  // namespace

std::string_view local_of_type(std::string_view type) {
  return type == "vec3" ? "v" : type == "vec4" ? "w" : "t";
}

std::string write_scene(EffectSet& set) {
  return SceneWriter(set).write();
}

}  // namespace plugc::oracle
