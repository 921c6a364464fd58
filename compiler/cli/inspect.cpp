// plugc inspect: any phase of the pipeline as text, and composed programs line by line with their origins.

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/effect_orders.h"
#include "cli/print_program.h"

namespace plugc {
namespace {

struct InspectOptions {
  CommonOptions common;
  std::string input;
  std::string dump;
  std::string as;  // the encoding that the document is written in
  std::optional<std::size_t> program;
  std::string format = "text";
  bool orders = false;
};

int print_program(const Package& package, std::size_t index, const InspectOptions& options, const ProgramCosts* costs) {
  if (index >= package.programs()->size()) {
    fmt::print(stderr, "plugc: there is no program {}; the package has {}\n", index, package.programs()->size());
    return kBrokenUse;
  }
  fmt::print("{}", options.format == "json" ? program_json(package, index, costs) : program_text(package, index, costs));
  return kFine;
}

/// A package with what can be said of its programs beside it.
struct Inspected {
  std::vector<std::uint8_t> bytes;
  std::vector<ProgramCosts> costs;  ///< By program; empty when they were not asked for or cannot be known.
};

/// The input: read when it is a package, else compiled.
Inspected read_input(const InspectOptions& options, Validator& validator, SourceSet& sources, Diagnostics& diagnostics) {
  if (is_package_file(options.input)) {
    std::ifstream stream(options.input, std::ios::binary);
    return {{std::istreambuf_iterator<char>(stream), {}}, {}};
  }
  CompileOptions compile_with = compile_options(options.common);
  compile_with.measure = options.program.has_value();
  compile_with.library = true;
  Compilation made = compile({options.input}, compile_with, validator, sources, diagnostics);
  return {write_package(made.package), std::move(made.costs)};
}

std::string joined(const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>& names) {
  std::string text;
  for (const auto* name : names) text += (text.empty() ? "" : ", ") + name->str();
  return text.empty() ? "nothing" : text;
}

std::string default_of(const PackedScene& scene, std::uint32_t slot) {
  const PackedSlot& packed = *scene.slots()->Get(slot);
  const double* first = scene.slot_values()->data() + packed.first();
  return fmt::format("{}", fmt::join(first, first + std::size_t{packed.count()} * component_count(packed.type()), " "));
}

/// What a host that puts the effect on a shape of its own must know of it.
void print_effect(const Package& package, const PackedEffect& effect) {
  fmt::print("{} ({})\n", effect.name()->string_view(), origin_text(package, *effect.origin()));
  fmt::print("  needs {}; offers {}\n", joined(*effect.needs()), joined(*effect.offers()));
  const PackedScene& scene = *package.scenes()->Get(effect.scene());
  for (const auto* field : *effect.fields())
    fmt::print("  field {} = {}\n", field->name()->string_view(), default_of(scene, field->slot()));
  for (const auto* kind : *effect.kinds()) fmt::print("  program {} on {}\n", kind->program(), kind->name()->string_view());
}

int print_list(const Package& package) {
  for (const PackedEffect* effect : *package.effects()) print_effect(package, *effect);
  fmt::print("{} programs\n", package.programs()->size());
  for (std::size_t i = 0; i < package.programs()->size(); ++i) {
    fmt::print("{:4} {}\n", i, package.programs()->Get(static_cast<flatbuffers::uoffset_t>(i))->recipe()->string_view());
  }
  fmt::print("`--program N` shows one of them\n");
  return kFine;
}

Encoding encoding_named(std::string_view name) {
  if (name == "xml") return Encoding::xml;
  return name == "json" ? Encoding::json : Encoding::classic;
}

int print_document(const InspectOptions& options) {
  if (options.dump != "document") {
    fmt::print(stderr, "plugc: `--as` writes a document; add `--dump document`\n");
    return kBrokenUse;
  }
  SourceSet sources;
  Diagnostics diagnostics(sources);
  fmt::print("{}",
             write_scene(options.input, encoding_named(options.as), compile_options(options.common), sources, diagnostics));
  return report(diagnostics);
}

int print_orders(const InspectOptions& options, Validator& validator) {
  if (is_package_file(options.input)) {
    fmt::print(stderr, "plugc: `--orders` composes anew, so it needs the scene, not a package\n");
    return kBrokenUse;
  }
  CompileOptions compile_with = compile_options(options.common);
  compile_with.stage = "teapot";
  return print_effect_orders(options.input, compile_with, validator);
}

int inspect(const InspectOptions& options) {
  if (!options.as.empty()) return print_document(options);
  if (!options.common.shadows.empty() && is_package_file(options.input)) return refuse_shadows_of_package();
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const bool early = options.dump == "document" || options.dump == "scene" || options.dump == "recipes";
  if (early) {
    fmt::print("{}", dump_stage(options.input, options.dump, compile_options(options.common), sources, diagnostics));
    return report(diagnostics);
  }
  Validator validator = make_validator(options.common);
  if (options.orders) return print_orders(options, validator);
  const Inspected input = read_input(options, validator, sources, diagnostics);
  const int status = report(diagnostics);
  const PackageView view = open_package(input.bytes);
  if (view.package == nullptr) {
    fmt::print(stderr, "plugc: {}: {}\n", options.input, view.error);
    return kInputErrors;
  }
  int printed = kFine;
  if (options.program) {
    const std::size_t index = *options.program;
    printed = print_program(*view.package, index, options, index < input.costs.size() ? &input.costs[index] : nullptr);
  } else if (options.dump == "package") {
    fmt::print("{}", dump_package(*view.package));
  } else if (options.dump == "programs" && options.format == "json") {
    fmt::print("{}", programs_json(*view.package));
  } else if (options.dump == "programs") {
    for (std::size_t i = 0; i < view.package->programs()->size(); ++i) print_program(*view.package, i, options, nullptr);
  } else {
    print_list(*view.package);
  }
  return std::max(status, printed);
}

}  // namespace

void add_inspect_command(CLI::App& app, int& status) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* verb = app.add_subcommand("inspect", "Show what plugc makes of a scene, phase by phase");
  verb->add_option("SCENE|PACKAGE", options->input, "An X3D scene or a glTF model, or a package that `plugc build` wrote")
      ->required()
      ->check(CLI::ExistingFile);
  verb->add_option("--dump", options->dump, "A phase as text: document, scene, recipes, programs, package")
      ->check(CLI::IsMember({"document", "scene", "recipes", "programs", "package"}));
  verb->add_option("--as", options->as, "With `--dump document`: the scene written again, as classic, xml or json")
      ->check(CLI::IsMember({"classic", "xml", "json"}));
  verb->add_option("--program", options->program,
                   "One composed program: what feeds it, what each effect costs, and its text with the origin of every line");
  verb->add_flag("--orders", options->orders,
                 "Of effects that meet at a plug, which may be written in either order: draws both orders");
  verb->add_option("--format", options->format, "How to print programs: text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb->add_option("--target", options->common.targets, "Dialects to compose for, separated by commas (default: glsl330)")
      ->delimiter(',')
      ->check(CLI::IsMember({"glsl330", "essl300", "spirv"}));
  add_dynamic_option(*verb, options->common);
  add_optimize_option(*verb, options->common);
  add_shadows_option(*verb, options->common);
  add_common_options(*verb, options->common);
  verb->footer("Without an option the programs are listed.\n\nExample: plugc inspect scene.x3dv --program 0");
  verb->callback([options, &status] { status = inspect(*options); });
}

}  // namespace plugc
