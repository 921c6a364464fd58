// The GLSL 3.30 text of a program goes to the driver once. Samplers get texture units in the order of the package, so that
// a unit belongs to a uniform for good and a draw only binds textures.
// A driver's error names a line of the composed text; the stage's origins lead from there to the author's file. A linker's
// error names no line, but often a variable or function: the last stage that has it declares it where it first stands.

#include "runtime/program_pool.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

#include "runtime/gl/texture.h"

namespace plugc {
namespace {

const PackedTargetProgram* find_target(const PackedProgram& program) {
  for (const PackedTargetProgram* target : *program.targets()) {
    if (target->target() == PackedTarget::glsl330) return target;
  }
  return nullptr;
}

bool is_read_by_glsl330(const PackedUniform& uniform) {
  return (uniform.targets() >> static_cast<unsigned>(PackedTarget::glsl330) & 1U) != 0;
}

std::string title(const PackedProgram& program) {
  return "program `" + program.name()->str() + "`";
}

const char* stage_name(PackedStageKind kind) {
  switch (kind) {
    case PackedStageKind::vertex: return "vertex";
    case PackedStageKind::geometry: return "geometry";
    case PackedStageKind::fragment: return "fragment";
  }
  return "unknown";
}

/// The author's column; 0 stays 0.
std::uint32_t author_column(const PackedStage& stage, std::uint32_t line, std::uint32_t column) {
  if (column == 0 || stage.columns() == nullptr) return column;
  std::uint32_t found = column;
  for (const PackedColumnOrigin* entry : *stage.columns()) {
    if (entry->line() == line && entry->column() <= column) found = entry->origin_column() + (column - entry->column());
  }
  return found;
}

/// `file:line:column: ` of the author, or "" for text that plugc wrote.
std::string author_place(const Package& package, const PackedStage& stage, std::uint32_t line, std::uint32_t column) {
  if (line == 0 || line > stage.origins()->size()) return "";
  const PackedLineOrigin& origin = *stage.origins()->Get(line - 1);
  if (origin.line() == 0) return "";
  std::string place = package.sources()->Get(origin.source())->str() + ":" + std::to_string(origin.line()) + ":";
  const std::uint32_t found = author_column(stage, line, column);
  if (found != 0) place += std::to_string(found) + ":";
  return place + " ";
}

void report_stage(const Package& package, const PackedProgram& program, const PackedStage& stage, std::string_view log,
                  Messages& messages) {
  for (const DriverError& error : parse_driver_log(log)) {
    const std::string place = author_place(package, stage, error.line, error.column);
    std::string where = title(program) + ", " + stage_name(stage.kind()) + " stage";
    if (place.empty() && error.line != 0) where += ", line " + std::to_string(error.line);
    messages.add(place + "the driver rejects " + where + ": " + error.text);
  }
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

struct TextPlace {
  std::uint32_t line = 0, column = 0;
};

/// Where a word first stands, from 1; 0 when it does not.
TextPlace place_of(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end]))) continue;
    const std::string_view before = text.substr(0, at);
    const std::size_t line_begin = before.find_last_of('\n') + 1;  // 0 on the first line
    return {1 + static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n')),
            1 + static_cast<std::uint32_t>(at - line_begin)};
  }
  return {};
}

/// Mesa quotes what it speaks of as `name' or as "name".
std::string_view quoted_name(std::string_view message) {
  const std::size_t begin = message.find_first_of("`\"");
  if (begin == std::string_view::npos) return "";
  const std::string_view rest = message.substr(begin + 1);
  return rest.substr(0, rest.find_first_of("'\"([ "));
}

std::string place_of_name(const Package& package, const PackedTargetProgram& target, std::string_view name) {
  for (std::uint32_t i = target.stages()->size(); i > 0 && !name.empty(); --i) {
    const PackedStage& stage = *target.stages()->Get(i - 1);
    const TextPlace found = place_of(stage.text()->string_view(), name);
    std::string place = author_place(package, stage, found.line, found.column);
    if (!place.empty()) return place;
  }
  return "";
}

void report(const Package& package, const PackedProgram& program, const gl::BuiltProgram& built,
            const PackedTargetProgram& target, Messages& messages) {
  if (built.failed_stage) {
    report_stage(package, program, *target.stages()->Get(*built.failed_stage), built.log, messages);
    return;
  }
  for (const DriverError& error : parse_driver_log(built.log)) {
    const std::string place = place_of_name(package, target, quoted_name(error.text));
    messages.add(place + "the driver cannot link " + title(program) + ": " + error.text);
  }
}

LoadedProgram load(const gl::Functions& gl, const Package& package, const PackedProgram& packed, Messages& messages) {
  LoadedProgram loaded;
  const PackedTargetProgram* const target = find_target(packed);
  if (target == nullptr) {
    messages.add(title(packed) + " holds no GLSL 3.30 text: build the package with `--target glsl330`");
    return loaded;
  }
  gl::BuiltProgram built = gl::build_program(gl, *target, *packed.attributes());
  if (!built.program) {
    report(package, packed, built, *target, messages);
    return loaded;
  }
  loaded.program = std::move(built.program);
  return loaded;
}

void find_uniforms(const gl::Functions& gl, const PackedProgram& packed, LoadedProgram& loaded, Messages& messages) {
  GLint units_left = gl::kUploadUnit;
  GLint next_unit = 0;
  gl::use_program(gl, loaded.program);
  for (const PackedUniform* uniform : *packed.uniforms()) {
    LoadedUniform found{uniform->name()->str(), uniform->type(), uniform->count()};
    found.initial.assign(uniform->initial()->begin(), uniform->initial()->end());
    if (is_read_by_glsl330(*uniform)) found.location = gl::uniform_location(gl, loaded.program, found.name.c_str());
    if (gl::is_sampler(found.type) && found.location >= 0) {
      if (found.count > static_cast<std::uint32_t>(units_left)) {
        messages.add(title(packed) + " has more textures than the driver has units: `" + found.name + "` stays unset");
        found.location = -1;
      } else {
        found.unit = next_unit;
        next_unit += static_cast<GLint>(found.count);
        units_left -= static_cast<GLint>(found.count);
        gl::set_sampler(gl, found.location, static_cast<GLsizei>(found.count), found.unit);
      }
    }
    loaded.uniforms.push_back(std::move(found));
  }
}

bool read_number(std::string_view& text, std::uint32_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool skip(std::string_view& text, char expected) {
  if (text.empty() || text.front() != expected) return false;
  text.remove_prefix(1);
  return true;
}

std::string_view trim(std::string_view text) {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

DriverError parse_line(std::string_view whole) {
  std::string_view rest = whole;
  DriverError error;
  std::uint32_t string = 0;
  std::uint32_t column = 0;
  const bool mesa = read_number(rest, string) && skip(rest, ':') && read_number(rest, error.line) && skip(rest, '(') &&
                    read_number(rest, column) && skip(rest, ')') && skip(rest, ':');
  if (mesa) return {error.line, column, std::string(trim(rest))};
  rest = whole;
  const bool other = read_number(rest, string) && skip(rest, '(') && read_number(rest, error.line) && skip(rest, ')');
  if (!other) return {0, 0, std::string(whole)};
  rest = trim(rest);
  skip(rest, ':');
  return {error.line, 0, std::string(trim(rest))};
}

}  // namespace

std::vector<DriverError> parse_driver_log(std::string_view log) {
  std::vector<DriverError> errors;
  while (!log.empty()) {
    const std::size_t length = std::min(log.find('\n'), log.size());
    const std::string_view line = trim(log.substr(0, length));
    log.remove_prefix(std::min(length + 1, log.size()));
    if (!line.empty()) errors.push_back(parse_line(line));
  }
  if (errors.empty()) errors.push_back({0, 0, "it gives no reason"});
  return errors;
}

ProgramPool::ProgramPool(const gl::Functions& functions, const Package& package)
    : gl_(&functions), package_(&package), programs_(package.programs()->size()) {}

const LoadedProgram& ProgramPool::get(std::uint32_t index, Messages& messages) {
  std::optional<LoadedProgram>& slot = programs_[index];
  if (slot) return *slot;
  const PackedProgram& packed = *package_->programs()->Get(index);
  slot = load(*gl_, *package_, packed, messages);
  if (slot->program) find_uniforms(*gl_, packed, *slot, messages);
  return *slot;
}

}  // namespace plugc
