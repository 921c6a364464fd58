#include "shadows/compile_scene.h"

#include "base/file_access.h"
#include "compile.h"
#include "package/package_file.h"

namespace plugc {

std::vector<std::uint8_t> compile_scene(const std::filesystem::path& scene, const std::string& method, Validator& validator,
                                        std::string& error) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  CompileOptions options;
  if (!method.empty()) {
    const auto named = shadow_method_named(method);
    if (!named) error = "there is no method " + method;
    if (!named) return {};
    options.shadows.method = *named;
  }
  const Compilation made = compile({scene}, options, validator, sources, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic_kind(diagnostic.id).severity != Severity::error) continue;
    error = scene.string() + ": " + diagnostic.message;
    return {};
  }
  return write_package(made.package);
}

}  // namespace plugc
