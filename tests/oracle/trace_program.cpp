// Chapter 5: a run through the program. The base shader reaches its markers in order; at each, the functions that fill it are
// called one after another; a function runs its statements in text order, and a marker among them is a place of calls like
// any other. In a light's own effect `castle_LightSource...` without a number means this light.

#include <algorithm>

#include <fmt/format.h>

#include "oracle/program_model.h"

namespace plugc::oracle {
namespace {

class Tracer {
 public:
  explicit Tracer(const ProgramModel& program) : program_(program) {}

  ProgramTrace run() {
    for (const Marker& marker : program_.markers) {
      if (!marker.calls.empty()) result_.plugs_filled.insert(marker.plug);
      if (marker.piece >= 0) continue;
      trace_ = marker.stage == Stage::vertex ? &result_.vertex : &result_.fragment;
      for (const Call& call : marker.calls) run_function(call, place_text(marker));
    }
    return std::move(result_);
  }

 private:
  /// A call shows its light by where it stands, and its texture by its argument.
  static std::string place_text(const Marker& marker) {
    if (marker.scope.kind == ScopeKind::light) return fmt::format("@light {}", marker.scope.number);
    return marker.plug == "texture_color" ? fmt::format("@texture {}", marker.scope.number) : "";
  }

  void run_function(const Call& call, const std::string& place) {
    trace_->push_back(fmt::format("f{}{}", call.function->tag, place));
    for (const StatementModel& statement : call.function->statements) run_statement(call, statement);
  }

  void run_statement(const Call& call, const StatementModel& statement) {
    const Piece& piece = program_.pieces[call.piece];
    switch (statement.kind) {
      case StatementKind::write:
        trace_->push_back("w:" + tags_text(writing_functions(program_, piece.effect, statement.name)));
        break;
      case StatementKind::read: run_read(piece, statement); break;
      case StatementKind::renderer: trace_->push_back("c:" + renderer_name(piece, statement.name)); break;
      case StatementKind::call:
        for (const Call& helper : helper_candidates(program_, piece, statement.name, statement.type)) run_function(helper, "");
        break;
      case StatementKind::marker: run_marker(call.piece, statement); break;
    }
  }

  void run_marker(std::size_t piece, const StatementModel& statement) {
    for (const Marker& marker : program_.markers) {
      if (marker.statement != &statement || marker.piece != static_cast<int>(piece)) continue;
      for (const Call& call : marker.calls) run_function(call, "");
    }
  }

  void run_read(const Piece& piece, const StatementModel& statement) {
    const auto& globals = piece.part->globals;
    const auto global =
        std::find_if(globals.begin(), globals.end(), [&](const GlobalModel& g) { return g.name == statement.name; });
    switch (global->kind) {
      case GlobalKind::uniform: trace_->push_back("u:" + uniform_source(piece, *global)); break;
      case GlobalKind::varying: trace_->push_back("v:" + written_by(piece, *global)); break;
      case GlobalKind::constant: trace_->push_back(fmt::format("k{}", global->tag)); break;
      case GlobalKind::macro: trace_->push_back(fmt::format("m{}", global->tag)); break;
      case GlobalKind::structure: trace_->push_back(fmt::format("s{}", global->tag)); break;
    }
  }

  std::string uniform_source(const Piece& piece, const GlobalModel& uniform) const {
    const EffectModel& effect = program_.set.effects[static_cast<std::size_t>(piece.effect)];
    const bool has_field = std::any_of(effect.fields.begin(), effect.fields.end(),
                                       [&](const FieldModel& field) { return field.name == uniform.name; });
    return fmt::format("E{}.{}", piece.effect, has_field ? uniform.name : "-");
  }

  std::string written_by(const Piece& piece, const GlobalModel& varying) const {
    const std::vector<int> writers = varying_writers(program_, piece, varying.name, varying.type);
    return writers.size() == 1 ? tags_text(writing_functions(program_, writers[0], varying.name)) : "";
  }

  static std::string renderer_name(const Piece& piece, const std::string& name) {
    if (piece.scope.kind != ScopeKind::light || name != "castle_LightSourceColor") return name;
    return fmt::format("castle_LightSource{}Color", piece.scope.number);
  }

  static std::string tags_text(const std::set<int>& tags) { return fmt::format("{}", fmt::join(tags, ",")); }

  const ProgramModel& program_;
  ProgramTrace result_;
  Trace* trace_ = nullptr;
};

}  // namespace

ProgramTrace trace_program(const ProgramModel& program) {
  return Tracer(program).run();
}

}  // namespace plugc::oracle
