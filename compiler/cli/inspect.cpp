// plugc inspect: any phase of the pipeline as text, and composed programs line by line with their origins.

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"

namespace plugc {
namespace {

struct InspectOptions {
  CommonOptions common;
  std::string input;
  std::string dump;
  std::string as;  // the encoding that the document is written in
  std::optional<std::size_t> program;
};

std::string origin_text(const Package& package, const PackedLineOrigin& origin) {
  if (origin.line() == 0) return "";
  const std::string_view name = package.sources()->Get(origin.source())->string_view();
  return fmt::format("{}:{}", name.substr(name.find_last_of('/') + 1), origin.line());
}

void print_stage(const Package& package, const PackedStage& stage) {
  fmt::print("---- {} stage ----\n", EnumNamePackedStageKind(stage.kind()));
  const std::string_view text = stage.text()->string_view();
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const bool known = stage.origins() != nullptr && line < stage.origins()->size();
    const std::string origin =
        known ? origin_text(package, *stage.origins()->Get(static_cast<flatbuffers::uoffset_t>(line))) : "";
    fmt::print("{:>26} | {}\n", origin, text.substr(begin, end - begin));
    begin = end + 1;
  }
}

void print_names(std::string_view title, const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>* names) {
  if (names == nullptr || names->size() == 0) return;
  fmt::print("{}:", title);
  for (const auto* name : *names) fmt::print(" {}", name->string_view());
  fmt::print("\n");
}

/// The bindings of the first shape that has the program in some state; null when none has.
const flatbuffers::Vector<const PackedBinding*>* find_bindings(const Package& package, std::size_t program) {
  for (const PackedScene* scene : *package.scenes()) {
    for (const PackedShape* shape : *scene->shapes()) {
      for (std::uint32_t variant = 0; variant <= shape->variants()->size(); ++variant) {
        const ShapePrograms use = shape_programs(*shape, static_cast<std::uint8_t>(variant));
        if (use.program == program) return use.bindings;
        if (use.depth_program >= 0 && static_cast<std::size_t>(use.depth_program) == program) return use.depth_bindings;
      }
    }
  }
  return nullptr;
}

/// Which source feeds a uniform, as the first shape that uses the program has it.
void print_uniforms(const Package& package, const PackedProgram& program, std::size_t index) {
  const auto* bindings = find_bindings(package, index);
  for (std::size_t i = 0; i < program.uniforms()->size(); ++i) {
    const PackedUniform* uniform = program.uniforms()->Get(static_cast<flatbuffers::uoffset_t>(i));
    std::string fed = "nothing (keeps the value of its text, or 0)";
    if (bindings != nullptr) {
      for (const PackedBinding* binding : *bindings) {
        if (binding->uniform() == i) fed = fmt::format("{} {}", EnumNamePackedSource(binding->source()), binding->a());
      }
    }
    fmt::print("uniform {} {} <- {}\n", EnumNamePackedUniformType(uniform->type()), uniform->name()->string_view(), fed);
  }
}

int print_program(const Package& package, std::size_t index) {
  if (index >= package.programs()->size()) {
    fmt::print(stderr, "plugc: there is no program {}; the package has {}\n", index, package.programs()->size());
    return kBrokenUse;
  }
  const PackedProgram* program = package.programs()->Get(static_cast<flatbuffers::uoffset_t>(index));
  fmt::print("program {}: {}\n", index, program->recipe()->string_view());
  print_names("plugs filled", program->plugs_filled());
  print_names("plugs empty", program->plugs_empty());
  print_uniforms(package, *program, index);
  for (const PackedTargetProgram* target : *program->targets()) {
    fmt::print("==== {} ====\n", EnumNamePackedTarget(target->target()));
    for (const PackedStage* stage : *target->stages()) print_stage(package, *stage);
  }
  return kFine;
}

/// The input as package bytes: read when it is a package, else compiled.
std::vector<std::uint8_t> input_bytes(const InspectOptions& options, Validator& validator, SourceSet& sources,
                                      Diagnostics& diagnostics) {
  if (is_package_file(options.input)) {
    std::ifstream stream(options.input, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  CompileOptions compile_with = compile_options(options.common);
  compile_with.library = true;
  return write_package(compile({options.input}, compile_with, validator, sources, diagnostics).package);
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

int inspect(const InspectOptions& options) {
  if (!options.as.empty()) return print_document(options);
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const bool early = options.dump == "document" || options.dump == "scene" || options.dump == "recipes";
  if (early) {
    fmt::print("{}", dump_stage(options.input, options.dump, compile_options(options.common), sources, diagnostics));
    return report(diagnostics);
  }
  Validator validator = make_validator(options.common);
  const std::vector<std::uint8_t> bytes = input_bytes(options, validator, sources, diagnostics);
  const int status = report(diagnostics);
  const PackageView view = open_package(bytes);
  if (view.package == nullptr) {
    fmt::print(stderr, "plugc: {}: {}\n", options.input, view.error);
    return kInputErrors;
  }
  int printed = kFine;
  if (options.program) {
    printed = print_program(*view.package, *options.program);
  } else if (options.dump == "package") {
    fmt::print("{}", dump_package(*view.package));
  } else if (options.dump == "programs") {
    for (std::size_t i = 0; i < view.package->programs()->size(); ++i) print_program(*view.package, i);
  } else {
    print_list(*view.package);
  }
  return std::max(status, printed);
}

}  // namespace

void add_inspect_command(CLI::App& app, int& status) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* verb = app.add_subcommand("inspect", "Show what plugc makes of a scene, phase by phase");
  verb->add_option("SCENE|PACKAGE", options->input, "An X3D scene, or a package that `plugc build` wrote")
      ->required()
      ->check(CLI::ExistingFile);
  verb->add_option("--dump", options->dump, "A phase as text: document, scene, recipes, programs, package")
      ->check(CLI::IsMember({"document", "scene", "recipes", "programs", "package"}));
  verb->add_option("--as", options->as, "With `--dump document`: the scene written again, as classic, xml or json")
      ->check(CLI::IsMember({"classic", "xml", "json"}));
  verb->add_option("--program", options->program, "One composed program: its text with the origin of every line");
  verb->add_option("--target", options->common.targets, "Dialects to compose for: glsl330, essl300, spirv")
      ->delimiter(',')
      ->check(CLI::IsMember({"glsl330", "essl300", "spirv"}));
  add_dynamic_option(*verb, options->common);
  add_common_options(*verb, options->common);
  verb->footer("Without an option the programs are listed.\n\nExample: plugc inspect scene.x3dv --program 0");
  verb->callback([options, &status] { status = inspect(*options); });
}

}  // namespace plugc
