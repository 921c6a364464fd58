#pragma once
// Programs for the tests of the validator, and how they are given to it.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "validate/validate.h"

namespace plugc {

inline constexpr std::string_view kVertex = R"(#version 330 core
uniform mat4 projection;
uniform mat4 unused;
in vec3 position;
in vec2 tex_coord[2];
in vec4 unread;
out vec3 normal;
void main() {
  normal = vec3(tex_coord[1], float(gl_VertexID));
  gl_Position = projection * vec4(position, 1.0);
}
)";

inline constexpr std::string_view kFragment = R"(#version 330 core
uniform sampler2DShadow shadow_map;
uniform float weights[4];
uniform struct Light { vec3 color; ivec2 cell; } lights[2];
uniform mat3x2 shear;
uniform bool on;
in vec3 normal;
out vec4 color;
void main() {
  color = vec4(weights[2] * lights[1].color + vec3(lights[0].cell, shear[1].x), on ? texture(shadow_map, normal) : 0.5);
}
)";

inline ProgramText program_of(std::vector<std::pair<ShaderStage, std::string>> stages, Target target = Target::glsl330) {
  ProgramText program{target, false, {}};
  for (auto& [stage, text] : stages) {
    program.stages.push_back({stage, {}});
    program.stages.back().text.append_generated(text);
  }
  return program;
}

inline ProgramText program_of(std::string_view vertex, std::string_view fragment, Target target = Target::glsl330) {
  return program_of({{ShaderStage::vertex, std::string(vertex)}, {ShaderStage::fragment, std::string(fragment)}}, target);
}

/// A fragment stage with these lines in main(); the first of them is line 4.
inline std::string fragment_with(std::string_view lines) {
  return "#version 330 core\nout vec4 color;\nvoid main() {\n" + std::string(lines) + "\ncolor = vec4(1.0);\n}\n";
}

inline constexpr std::string_view kPlainVertex = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";

inline ProgramText good_program() {
  return program_of(kVertex, kFragment);
}
inline ProgramText plain_program(std::string_view lines = "") {
  return program_of(kPlainVertex, fragment_with(lines));
}

/// An expression so deep that glslang's recursion overflows the stack.
inline ProgramText crashing_program() {
  std::string sum = "float x = 1.0";
  for (int i = 0; i < 60'000; ++i) sum += "+color.x";
  return plain_program(sum + ";");
}

/// Macros that expand to nothing, 2 to the 40 times.
inline ProgramText endless_program() {
  std::string text = "#version 330 core\n#define A0\n";
  for (int i = 1; i <= 40; ++i) {
    text += fmt::format("#define A{} A{} A{}\n", i, i - 1, i - 1);
  }
  return program_of(kPlainVertex, text + "out vec4 color;\nvoid main() { A40 color = vec4(1.0); }\n");
}

/// Macros that expand to 2 to the 40 terms, and so fill memory before they take time.
inline ProgramText memory_bomb() {
  std::string text = "#version 330 core\n#define A0 +1.0\n";
  for (int i = 1; i <= 40; ++i) {
    text += fmt::format("#define A{} A{} A{}\n", i, i - 1, i - 1);
  }
  return program_of(kPlainVertex, text + "out vec4 color;\nvoid main() { color = vec4(0.0 A40); }\n");
}

inline std::vector<ProgramText> list_of(ProgramText program) {
  std::vector<ProgramText> programs;
  programs.push_back(std::move(program));
  return programs;
}

inline ValidationResult validate_one(Validator& validator, ProgramText program) {
  return std::move(validator.validate(list_of(std::move(program))).front());
}

/// `vec3 position`, `float weights[4]`.
inline std::vector<std::string> shown(const std::vector<ReflectedVariable>& variables) {
  std::vector<std::string> lines;
  for (const ReflectedVariable& variable : variables) {
    lines.push_back(variable.type + " " + variable.name);
    if (variable.count != 1) lines.back().append("[").append(std::to_string(variable.count)).append("]");
  }
  return lines;
}

/// `fragment 4 <foo>: text`: stage, line, the bytes meant, and what is said.
inline std::vector<std::string> shown(const ValidationResult& result, const ProgramText& program) {
  std::vector<std::string> lines;
  for (const ShaderMessage& message : result.messages) {
    std::string meant;
    for (const StageText& stage : program.stages) {
      if (stage.stage == message.stage) meant = stage.text.text().substr(message.begin, message.end - message.begin);
    }
    lines.push_back(fmt::format("{} {} <{}>: {}", to_text(message.stage), message.line, meant, message.text));
  }
  return lines;
}

inline std::vector<std::string> messages_of(Validator& validator, const ProgramText& program) {
  return shown(validate_one(validator, program), program);
}

}  // namespace plugc
