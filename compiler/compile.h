#pragma once
// The public API of libplugc: X3D scenes in, a package out.
//
//     plugc::SourceSet sources;
//     plugc::Diagnostics diagnostics(sources);
//     plugc::Validator validator({});                       // before any thread is started
//     plugc::Compilation made = plugc::compile({"scene.x3dv"}, {}, validator, sources, diagnostics);
//     auto bytes = plugc::write_package(made.package);      // diagnostics.all() says what was wrong

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compose/effect_pairs.h"
#include "document/document.h"
#include "image/load_images.h"
#include "package/assemble_package.h"
#include "validate/measure_costs.h"
#include "validate/validate.h"

namespace plugc {

/// Two effects of a scene, by index, and how they are called.
struct EffectArrangement {
  int first = -1, second = -1;
  PairOrder order = PairOrder::as_written;
};

struct CompileOptions {
  std::vector<Target> targets = {Target::glsl330};
  std::filesystem::path root;  ///< Folder that scenes may read; empty: default_root() of each.
  bool optimize = false;       ///< Programs that do less and draw the same, in place of readable ones.
  bool measure = false;        ///< Also find out what each effect costs (validate/measure_costs.h).
  bool for_lint = false;       ///< Every effect, also in branches that are not drawn, and the rules of lint.
  /// What a file with effects but no shapes is tried on: teapot, sphere, box, plane; empty: nothing is put under it.
  std::string stage;
  bool library = false;  ///< A file with effects and no shape becomes a library: each effect alone on built-in shapes.
  std::vector<std::string> dynamic;  ///< `DEF.field`: what a host may change while the scene is drawn.
  ShadowDefaults shadows = {};
  /// By scene file as it is given to compile(): what was chosen for its shadow maps.
  std::map<std::filesystem::path, std::vector<ShadowChoice>> shadow_choices = {};
  std::optional<EffectArrangement> arrangement = {};
  KnownImages* known_images = nullptr;  ///< For lint: what earlier calls have found out of images.
};

/// Where the time went, in milliseconds, and how much was made.
struct CompileStatistics {
  double read = 0;     ///< Documents and scene.
  double prepare = 0;  ///< Meshes, images, effect code.
  double compose = 0;
  double validate = 0;
  double assemble = 0;
  std::size_t compositions = 0;
  std::size_t rechecks = 0;
};

struct Compilation {
  PackageT package;
  CompileStatistics statistics;
  std::vector<ProgramCosts> costs;             ///< By program of the package, when they were asked for.
  std::set<std::filesystem::path> files_read;  ///< Scenes and all that they include: what the package depends on.
};

/// Compiles scene files into one package. Mistakes are reported; what could be made is in the package.
Compilation compile(const std::vector<std::filesystem::path>& scenes, const CompileOptions& options, Validator& validator,
                    SourceSet& sources, Diagnostics& diagnostics);

/// Says of a scene what compile() says with `for_lint`, and makes no package: of images and geometry only what is to be
/// checked, and what programs depend on.
void lint(const std::filesystem::path& scene, CompileOptions options, Validator& validator, SourceSet& sources,
          Diagnostics& diagnostics);

/// Two effects that meet at a plug: compose/effect_pairs.h.
struct SceneEffectPair {
  int first = -1, second = -1;
  std::string first_label, second_label;
  std::vector<std::string> plugs;
  std::vector<std::uint32_t> slots;  ///< Of the numbers that feed the two, in the package of this scene alone.
};
std::vector<SceneEffectPair> effect_pairs(const std::filesystem::path& scene, const CompileOptions& options, SourceSet& sources,
                                          Diagnostics& diagnostics);

/// What an early phase made of a scene, as text: `document`, `scene` or `recipes`; "" for another name.
std::string dump_stage(const std::filesystem::path& scene, std::string_view stage, const CompileOptions& options,
                       SourceSet& sources, Diagnostics& diagnostics);

/// The scene's own file written again: comments are lost, prototypes and names stay. Source: document/write_document.h.
std::string write_scene(const std::filesystem::path& scene, Encoding as, const CompileOptions& options, SourceSet& sources,
                        Diagnostics& diagnostics);

}  // namespace plugc
