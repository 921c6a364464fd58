// Compile every stage, bind the fixed attribute locations and the one output, link. The first stage that fails ends it:
// a link error behind a compile error says nothing new.

#include "runtime/gl/program.h"

#include <numeric>

namespace plugc::gl {
namespace {

constexpr GLint kFirstTexCoord = 4, kFogCoord = 15;

GLenum shader_type(PackedStageKind kind) {
  switch (kind) {
    case PackedStageKind::vertex: return GL_VERTEX_SHADER;
    case PackedStageKind::geometry: return GL_GEOMETRY_SHADER;
    case PackedStageKind::fragment: return GL_FRAGMENT_SHADER;
  }
  return GL_VERTEX_SHADER;
}

template <typename GetValue, typename GetLog>
std::string info_log(GLuint id, GetValue get_value, GetLog get_log) {
  GLint length = 0;
  get_value(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  GLsizei written = 0;
  if (length > 0) get_log(id, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

Shader compile(const Functions& gl, const PackedStage& stage, std::string& log) {
  Shader shader(gl, gl.CreateShader(shader_type(stage.kind())));
  const char* const text = stage.text()->c_str();
  gl.ShaderSource(shader.id(), 1, &text, nullptr);
  gl.CompileShader(shader.id());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  log = info_log(shader.id(), gl.GetShaderiv, gl.GetShaderInfoLog);
  return {};
}

void bind_attributes(const Functions& gl, const Program& program, const Attributes& attributes) {
  for (const PackedAttribute* attribute : attributes) {
    const GLint location = attribute_location(attribute->semantic(), attribute->unit());
    if (location < 0) continue;
    gl.BindAttribLocation(program.id(), static_cast<GLuint>(location), attribute->name()->c_str());
  }
}

void set_integers(const Functions& gl, GLint location, PackedUniformType type, GLsizei count, std::span<const float> values) {
  std::vector<GLint> integers;
  for (const float value : values) {
    const bool fits = value >= -2147483648.0F && value < 2147483648.0F;
    integers.push_back(fits ? static_cast<GLint>(value) : 0);
  }
  switch (type) {
    case PackedUniformType::ivec2: gl.Uniform2iv(location, count, integers.data()); break;
    case PackedUniformType::ivec3: gl.Uniform3iv(location, count, integers.data()); break;
    case PackedUniformType::ivec4: gl.Uniform4iv(location, count, integers.data()); break;
    default: gl.Uniform1iv(location, count, integers.data()); break;
  }
}

}  // namespace

GLint attribute_location(PackedSemantic semantic, unsigned unit) {
  switch (semantic) {
    case PackedSemantic::position: return 0;
    case PackedSemantic::normal: return 1;
    case PackedSemantic::color: return 2;
    case PackedSemantic::tangent: return 3;
    case PackedSemantic::tex_coord: return unit < kTexCoordUnits ? kFirstTexCoord + static_cast<GLint>(unit) : -1;
    case PackedSemantic::fog_coord: return kFogCoord;
    case PackedSemantic::custom: return unit <= kLastCustom ? static_cast<GLint>(kLastCustom - unit) : -1;
  }
  return -1;
}

BuiltProgram build_program(const Functions& gl, const PackedTargetProgram& target, const Attributes& attributes) {
  BuiltProgram built;
  Program program(gl, gl.CreateProgram());
  const std::uint32_t stage_count = target.stages()->size();
  for (std::uint32_t i = 0; i < stage_count; ++i) {
    const Shader shader = compile(gl, *target.stages()->Get(i), built.log);
    if (!shader) {
      built.failed_stage = i;
      return built;
    }
    gl.AttachShader(program.id(), shader.id());
  }
  bind_attributes(gl, program, attributes);
  gl.BindFragDataLocation(program.id(), 0, "castle_FragColor");
  gl.LinkProgram(program.id());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) {
    built.program = std::move(program);
  } else {
    built.log = info_log(program.id(), gl.GetProgramiv, gl.GetProgramInfoLog);
  }
  return built;
}

void warm_up_compiler(const Functions& gl) {
  const Shader shader(gl, gl.CreateShader(GL_VERTEX_SHADER));
  const char* const text = "#version 330 core\nvoid main() {}\n";
  gl.ShaderSource(shader.id(), 1, &text, nullptr);
  gl.CompileShader(shader.id());
}

void use_program(const Functions& gl, const Program& program) {
  gl.UseProgram(program.id());
}

GLint uniform_location(const Functions& gl, const Program& program, const char* name) {
  return gl.GetUniformLocation(program.id(), name);
}

bool is_sampler(PackedUniformType type) {
  return type >= PackedUniformType::sampler2D;
}

void set_uniform(const Functions& gl, GLint location, PackedUniformType type, GLsizei count, std::span<const float> values) {
  switch (type) {
    case PackedUniformType::bool_:
    case PackedUniformType::float_: gl.Uniform1fv(location, count, values.data()); break;
    case PackedUniformType::vec2: gl.Uniform2fv(location, count, values.data()); break;
    case PackedUniformType::vec3: gl.Uniform3fv(location, count, values.data()); break;
    case PackedUniformType::vec4: gl.Uniform4fv(location, count, values.data()); break;
    case PackedUniformType::mat3: gl.UniformMatrix3fv(location, count, GL_FALSE, values.data()); break;
    case PackedUniformType::mat4: gl.UniformMatrix4fv(location, count, GL_FALSE, values.data()); break;
    case PackedUniformType::int_:
    case PackedUniformType::ivec2:
    case PackedUniformType::ivec3:
    case PackedUniformType::ivec4: set_integers(gl, location, type, count, values); break;
    default: break;  // samplers: set_sampler
  }
}

void set_sampler(const Functions& gl, GLint location, GLsizei count, GLint unit) {
  std::vector<GLint> units(static_cast<std::size_t>(count));
  std::iota(units.begin(), units.end(), unit);
  gl.Uniform1iv(location, count, units.data());
}

}  // namespace plugc::gl
