#pragma once
// Shader text to a linked program, and values to its uniforms.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "package/package_file.h"
#include "runtime/gl/objects.h"

namespace plugc::gl {

inline constexpr unsigned kTexCoordUnits = 8;  ///< Texture coordinates that a program can take.
inline constexpr unsigned kLastCustom = 14;    ///< The location of an author's first attribute, if it has one column.

/// The location of an attribute, the same in every program so that one vertex array serves them all:
/// position 0, normal 1, color 2, tangent 3, texture coordinates 4 to 11, fog 15, custom 14 - unit. -1: none left.
GLint attribute_location(PackedSemantic semantic, unsigned unit);

using Attributes = flatbuffers::Vector<flatbuffers::Offset<PackedAttribute>>;

/// Either a program, or what the driver said and about which stage (none: about linking).
struct BuiltProgram {
  Program program;
  std::optional<std::uint32_t> failed_stage;  ///< Index into the stages.
  std::string log;
};
BuiltProgram build_program(const Functions& gl, const PackedTargetProgram& target, const Attributes& attributes);

/// Lets the driver set its compiler up, which it does at the first shader: Mesa's table of built-in functions takes 9 ms.
void warm_up_compiler(const Functions& gl);

void use_program(const Functions& gl, const Program& program);

/// -1 where the program has no such uniform (the driver dropped it).
GLint uniform_location(const Functions& gl, const Program& program, const char* name);

bool is_sampler(PackedUniformType type);

/// Sets a uniform of the program in use. `values` holds all numbers of all elements.
void set_uniform(const Functions& gl, GLint location, PackedUniformType type, GLsizei count, std::span<const float> values);
/// Points the elements of a sampler uniform at texture units from `unit` on.
void set_sampler(const Functions& gl, GLint location, GLsizei count, GLint unit);

}  // namespace plugc::gl
