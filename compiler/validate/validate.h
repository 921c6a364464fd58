#pragma once
// The only door into glslang and SPIRV-Tools. Texts go to a worker process that keeps glslang warm; a crash or a hang in
// there costs one program one message. Only this room makes a ValidatedProgram, and only that type enters a package.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/source.h"
#include "glsl/stage.h"

namespace plugc {

/// One stage as it is to be compiled: complete text, `#version` line included.
struct StageText {
  ShaderStage stage = ShaderStage::vertex;
  MappedText text;
};

/// The candidate: its stages, each at most once, in pipeline order.
struct ProgramText {
  Target target = Target::glsl330;
  bool optimize = false;  ///< Replace what is valid by an equivalent that does less (optimize.h).
  std::vector<StageText> stages;
};

/// GLSL meets by name and has no numbers.
inline constexpr std::uint32_t kNoInterfaceNumber = UINT32_MAX;

/// Type of a uniform or attribute, spelled as GLSL does (`vec3`, `sampler2DShadow`).
struct ReflectedVariable {
  std::string name;  ///< Without `[0]`.
  std::string type;
  std::uint32_t count = 1;                      ///< Array size.
  std::uint32_t location = kNoInterfaceNumber;  ///< In SPIR-V; docs/targets.md says how they are dealt out.
  std::uint32_t binding = kNoInterfaceNumber;   ///< Of a sampler in SPIR-V.
};

/// What an optimised program costs, counted in its SPIR-V.
struct ProgramCost {
  std::uint32_t vertex_instructions = 0;  ///< Inside functions.
  std::uint32_t geometry_instructions = 0;
  std::uint32_t fragment_instructions = 0;
  std::uint32_t texture_reads = 0;  ///< Instructions that read a texture, in all stages.
  std::uint32_t varyings = 0;       ///< Locations that the fragment stage reads.
};

/// A program that glslang has accepted. Cannot be made elsewhere.
class ValidatedProgram {
 public:
  Target target() const { return target_; }
  const std::vector<StageText>& stages() const { return stages_; }
  const std::vector<std::vector<std::uint32_t>>& spirv() const { return spirv_; }   ///< Per stage; for Target::spirv only.
  const std::vector<ReflectedVariable>& uniforms() const { return uniforms_; }      ///< Active ones, in name order.
  const std::vector<ReflectedVariable>& attributes() const { return attributes_; }  ///< Active vertex inputs, in name order.
  const std::optional<ProgramCost>& cost() const { return cost_; }                  ///< Of an optimised one.

 private:
  friend class Validator;
  ValidatedProgram() = default;
  Target target_ = Target::glsl330;
  std::vector<StageText> stages_;
  std::vector<std::vector<std::uint32_t>> spirv_;
  std::vector<ReflectedVariable> uniforms_;
  std::vector<ReflectedVariable> attributes_;
  std::optional<ProgramCost> cost_;
};

/// What glslang said of one place.
struct ShaderMessage {
  ShaderStage stage = ShaderStage::vertex;
  std::uint32_t line = 0;   ///< Of the composed text, from 1; 0 for the linker's.
  std::uint32_t begin = 0;  ///< The token meant, as bytes of the composed text (else the line, trimmed; empty when unknown).
  std::uint32_t end = 0;
  Span span;         ///< The author's place, through the text's map; not valid in generated text.
  std::string text;  ///< In glslang's words, without its place.
};

struct ValidationResult {
  std::optional<ValidatedProgram> program;  ///< Present when valid.
  std::vector<ShaderMessage> messages;      ///< Errors when not valid; else empty.
  bool died = false;                        ///< The worker crashed or overran on this program.
  std::string not_optimized;                ///< Why a valid program stays as it was though it was to be optimised; else "".
};

struct ValidatorOptions {
  std::filesystem::path cache_folder;                 ///< Verdicts by content hash; empty: no cache.
  std::chrono::milliseconds timeout{5000};            ///< For one program.
  std::vector<Target> warm_targets{Target::glsl330};  ///< What the worker prepares for when it starts (25 ms each).
  std::size_t workers = 1;                            ///< Programs of one call are judged by so many at a time.
};

/// Owns the workers. Make it before any thread is started: it forks. Threads may start afterwards, even if a worker has to
/// be replaced then; but only one at a time may call validate(). Results do not depend on the number of workers.
class Validator {
 public:
  explicit Validator(ValidatorOptions options);
  ~Validator();
  Validator(Validator&&) noexcept;
  Validator& operator=(Validator&&) noexcept;

  /// One result a program, in order. Equal texts are judged once.
  std::vector<ValidationResult> validate(std::vector<ProgramText> programs);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plugc
