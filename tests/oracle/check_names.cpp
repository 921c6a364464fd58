// Chapter 4: what a name means, and what feeds a uniform.
//
// Names are private to their effect. Within it the parts share them: equal declarations (of the same type) merge, unequal ones
// are an error. A function that a part only declares is resolved in its part, then its effect, then the shape's other effects;
// two candidates are an error. A fragment input that no part of its own effect writes is sought in the
// same way, by name and type.
// A uniform gets its own effect's field of its name; uniformMissing "IGNORE" or a default makes it do without. A field without
// a uniform and a pair of different types are mistakes that leave the effect in.

#include <algorithm>
#include <map>
#include <tuple>

#include "oracle/program_model.h"

namespace plugc::oracle {

std::vector<Call> helper_candidates(const ProgramModel& program, const Piece& piece, const std::string& name,
                                    const std::string& type) {
  std::vector<Call> own, others;
  std::set<std::pair<int, const FunctionModel*>> known;  // an effect that is there twice is one candidate
  for (std::size_t i = 0; i < program.pieces.size(); ++i) {
    const Piece& other = program.pieces[i];
    for (const FunctionModel& function : other.part->functions) {
      const bool is_meant =
          function.defined && !function.is_plug && function.name == name && function.parameters[0].type == type;
      if (!is_meant || other.stage != piece.stage) continue;
      if (other.placement == piece.placement) own.push_back({i, &function});
      if (known.insert({other.effect, &function}).second) others.push_back({i, &function});
    }
  }
  return own.empty() ? others : own;
}

std::set<int> writing_functions(const ProgramModel& program, int effect, const std::string& name) {
  std::set<int> tags;
  for (const Piece& piece : program.pieces) {
    if (piece.effect != effect || piece.stage != Stage::vertex) continue;
    for (const FunctionModel& function : piece.part->functions) {
      for (const StatementModel& statement : function.statements) {
        if (statement.kind == StatementKind::write && statement.name == name) tags.insert(function.tag);
      }
    }
  }
  return tags;
}

std::vector<int> varying_writers(const ProgramModel& program, const Piece& piece, const std::string& name,
                                 const std::string& type) {
  if (!writing_functions(program, piece.effect, name).empty()) return {piece.effect};
  std::set<int> writers;
  for (const Piece& other : program.pieces) {
    if (other.stage != Stage::vertex) continue;
    for (const FunctionModel& function : other.part->functions) {
      for (const StatementModel& statement : function.statements) {
        const bool writes = statement.kind == StatementKind::write && statement.name == name && statement.type == type;
        if (writes) writers.insert(other.effect);
      }
    }
  }
  return {writers.begin(), writers.end()};
}

namespace {

const GlobalModel* find_global(const PartModel& part, const std::string& name) {
  const auto found =
      std::find_if(part.globals.begin(), part.globals.end(), [&](const GlobalModel& g) { return g.name == name; });
  return found == part.globals.end() ? nullptr : &*found;
}

class NameChecker {
 public:
  NameChecker(ProgramModel& program, std::set<std::string>& said) : program_(program), said_(said) {}

  /// Unequal: to the effect's first declaration, or to the first in the same stage.
  void check_declarations() {
    std::map<std::pair<int, std::string>, const GlobalModel*> first;
    std::map<std::tuple<int, std::string, Stage>, const GlobalModel*> first_in_stage;
    for (const Piece& piece : program_.pieces) {
      for (const GlobalModel& global : piece.part->globals) {
        if (global.kind == GlobalKind::macro) continue;
        const GlobalModel* known = first.try_emplace({piece.effect, global.name}, &global).first->second;
        const GlobalModel* in_stage =
            first_in_stage.try_emplace({piece.effect, global.name, piece.stage}, &global).first->second;
        if (known->type != global.type || in_stage->type != global.type) complain(piece, global.line, "unequal-declarations");
      }
    }
  }

  void check_functions() {
    for (const Piece& piece : program_.pieces) {
      for (const FunctionModel& function : piece.part->functions) {
        if (!function.defined) check_prototype(piece, function);
      }
    }
  }

  void check_varyings() {
    for (const Piece& piece : program_.pieces) {
      if (piece.stage != Stage::fragment) continue;
      for (const FunctionModel& function : piece.part->functions) {
        for (const StatementModel& statement : function.statements) check_varying(piece, statement);
      }
    }
  }

 private:
  void complain(const Piece& piece, int line, std::string_view code) {
    say(said_, line, code);
    program_.faulty.insert(piece.effect);
  }

  void note_need(const Piece& piece, int provider) {
    if (provider != piece.effect) program_.needs.push_back({piece.effect, provider});
  }

  void check_prototype(const Piece& piece, const FunctionModel& prototype) {
    const auto found = helper_candidates(program_, piece, prototype.name, prototype.parameters[0].type);
    if (found.size() > 1) complain(piece, prototype.line, "ambiguous-function");
    if (found.empty() && is_called(piece, prototype)) complain(piece, prototype.line, "shader-invalid");
    if (found.size() == 1 && is_called(piece, prototype)) note_need(piece, program_.pieces[found[0].piece].effect);
  }

  bool is_called(const Piece& piece, const FunctionModel& prototype) const {
    for (const FunctionModel& function : piece.part->functions) {
      for (const StatementModel& statement : function.statements) {
        const bool calls = statement.kind == StatementKind::call && statement.name == prototype.name;
        if (calls && statement.type == prototype.parameters[0].type) return true;
      }
    }
    return false;
  }

  void check_varying(const Piece& piece, const StatementModel& statement) {
    const GlobalModel* global = find_global(*piece.part, statement.name);
    if (statement.kind != StatementKind::read || global == nullptr || global->kind != GlobalKind::varying) return;
    const std::vector<int> writers = varying_writers(program_, piece, statement.name, global->type);
    if (writers.size() != 1) return complain(piece, global->line, "varying-unwritten");
    note_need(piece, writers.front());
  }

  ProgramModel& program_;
  std::set<std::string>& said_;
};

bool feeds(const FieldModel& field, const GlobalModel& uniform) {
  if (field.type == "SFVec3f" || field.type == "SFColor") return uniform.type == "vec3";
  if (field.type == "SFRotation") return uniform.type == "vec4";
  if (field.type == "SFInt32") return uniform.type == "int";
  return field.type == "SFFloat" && uniform.type == "float";
}

}  // namespace

void check_names(ProgramModel& program, std::set<std::string>& said) {
  NameChecker checker(program, said);
  checker.check_declarations();
  checker.check_functions();
  checker.check_varyings();
}

void check_fields(const EffectModel& effect, const EffectSet& set, std::set<std::string>& said) {
  std::set<std::string> fed, unfed;
  for (const int part : effect.parts) {
    for (const GlobalModel& global : set.parts[static_cast<std::size_t>(part)].globals) {
      if (global.kind != GlobalKind::uniform) continue;
      const auto field =
          std::find_if(effect.fields.begin(), effect.fields.end(), [&](const FieldModel& f) { return f.name == global.name; });
      if (field == effect.fields.end()) {
        const bool missed = !effect.ignore_missing && !global.initialised && unfed.insert(global.name).second;
        if (missed) say(said, global.line, "uniform-without-field");
        continue;
      }
      if (fed.insert(field->name).second && !feeds(*field, global)) say(said, field->line, "uniform-type");
    }
  }
  for (const FieldModel& field : effect.fields) {
    if (!fed.contains(field.name)) say(said, field.line, "field-without-uniform");
  }
}

}  // namespace plugc::oracle
