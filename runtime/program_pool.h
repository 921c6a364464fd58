#pragma once
// The programs of a package on the driver: each linked once, its uniforms found once.

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/gl/program.h"
#include "runtime/messages.h"

namespace plugc {

struct LoadedUniform {
  std::string name;
  PackedUniformType type = PackedUniformType::float_;
  std::uint32_t count = 1;
  GLint location = -1;
  GLint unit = -1;                  ///< Samplers: the first texture unit.
  std::vector<float> initial = {};  ///< For shapes without a binding; empty: it keeps what it has.
};

struct LoadedProgram {
  gl::Program program;                  ///< None when the driver rejected it.
  std::vector<LoadedUniform> uniforms;  ///< As in the package.
};

class ProgramPool {
 public:
  ProgramPool() = default;
  ProgramPool(const gl::Functions& functions, const Package& package);

  /// Builds it on first use. What the driver rejects is said in `messages`, at the author's line where there is one.
  const LoadedProgram& get(std::uint32_t index, Messages& messages);

 private:
  const gl::Functions* gl_ = nullptr;
  const Package* package_ = nullptr;
  std::vector<std::optional<LoadedProgram>> programs_;
};

/// A line of a driver's log, as `0:12(3): error: text` (Mesa) or `0(12) : error C0000: text` say it.
struct DriverError {
  std::uint32_t line = 0;    ///< From 1; 0 when the log names none.
  std::uint32_t column = 0;  ///< From 1; 0 when the log names none.
  std::string text;
};
std::vector<DriverError> parse_driver_log(std::string_view log);

}  // namespace plugc
