#pragma once
// Whether the fields of effects and shaders and the uniforms of their code belong together.

#include "base/diagnostics.h"
#include "compose/code_unit.h"
#include "compose/compose.h"
#include "scene/scene.h"

namespace plugc {

/// The GLSL type that a field feeds (`vec3` for SFColor), or "" when it feeds none. Arrays have the element's type.
std::string_view uniform_type(FieldType type);

/// Whether the field may feed a uniform of this GLSL type: a texture, its own kind of sampler.
bool feeds(const Scene& scene, const ShaderField& field, std::string_view glsl_type);

/// Reports uniforms that no field feeds, fields that feed no uniform, and pairs of different types, for one effect or
/// ComposedShader.
void check_fields(const Scene& scene, const SceneEffect& effect, const EffectCode& code, Diagnostics& diagnostics);

/// The name of the field that would feed an author's uniform: its own, or, where a macro stands for it and no field bears that
/// word, the macro's.
std::string_view field_name(const SceneEffect& effect, const CodeUnit& code, const GlobalOutline& uniform);

}  // namespace plugc
