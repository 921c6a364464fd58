// Walks a stage's text from main(): every call of a function that the text defines is followed. A body that begins with a tag
// is an author's; what it names is looked up among the text's globals. No expression is understood: of an argument only its
// type is guessed, to tell overloads apart.

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "compose/compose.h"
#include "glsl/outline.h"
#include "oracle/observe.h"

namespace plugc::oracle {
namespace {

/// A composed stage, taken apart.
struct StageOutline {
  explicit StageOutline(const ComposedProgram& program, ShaderStage stage) {
    for (const ComposedStage& each : program.stages) {
      if (each.stage == stage) text = each.text.text();
    }
    tokens = tokenize(text, {});
    outlined = outline(text, tokens, Storage::none);
  }
  std::string_view at(std::size_t token) const { return token_text(text, tokens.tokens[token]); }

  std::string text;
  TokenList tokens;
  Outline outlined;
};

int number_in(std::string_view text) {
  int number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// The light or the texture whose function of the renderer is being walked.
struct Surroundings {
  std::string light, texture;
};

class TextTracer {
 public:
  TextTracer(const ComposedProgram& program, const Scene& scene, const StageOutline& stage, const StageOutline& vertex)
      : program_(program), scene_(scene), stage_(stage) {
    for (const FunctionOutline& function : stage.outlined.functions) {
      if (function.is_definition()) functions_.emplace(function.name, &function);
    }
    for (const GlobalOutline& global : stage.outlined.globals) globals_.emplace(global.name, &global);
    for (const StructOutline& type : stage.outlined.structs) structs_.emplace(type.name, &type);
    for (const FieldUniform& uniform : program.fields) fields_.emplace(uniform.name, &uniform);
    find_writers(vertex);
  }

  Trace run() {
    const auto main = functions_.find("main");
    if (main != functions_.end()) walk(*main->second, {});
    return std::move(trace_);
  }

 private:
  std::size_t token_at(std::uint32_t byte) const {
    const auto& tokens = stage_.tokens.tokens;
    const auto found =
        std::lower_bound(tokens.begin(), tokens.end(), byte, [](const Token& t, std::uint32_t b) { return t.begin < b; });
    return static_cast<std::size_t>(found - tokens.begin());
  }

  /// `{ float t = 17.0;` -> 17; 0 for the renderer's own functions.
  static int tag_of(const StageOutline& stage, std::size_t body) {
    if (body + 4 >= stage.tokens.tokens.size() || stage.at(body + 1) != "float" || stage.at(body + 2) != "t") return 0;
    return number_in(stage.at(body + 4));
  }

  /// Of each output, the tags of the functions that assign it.
  void find_writers(const StageOutline& vertex) {
    int tag = 0;
    std::uint32_t end = 0;
    std::map<std::uint32_t, std::uint32_t> bodies;
    for (const FunctionOutline& function : vertex.outlined.functions) {
      if (function.is_definition()) bodies[function.body_begin] = function.body_end;
    }
    for (std::size_t i = 0; i + 1 < vertex.tokens.tokens.size(); ++i) {
      const Token& token = vertex.tokens.tokens[i];
      if (const auto body = bodies.find(token.begin); body != bodies.end()) tag = tag_of(vertex, i), end = body->second;
      const bool assigned = token.kind == TokenKind::identifier && vertex.at(i + 1) == "=";
      if (assigned && tag != 0 && token.begin < end) writers_[std::string(vertex.at(i))].insert(tag);
    }
  }

  /// `for_author`: an author's code has called it, perhaps by way of a function that only calls on.
  void walk(const FunctionOutline& function, const Surroundings& around, bool for_author = false) {
    const std::size_t first = token_at(function.body_begin);
    const int tag = tag_of(stage_, first);
    const FunctionOutline* outer = std::exchange(walked_, &function);
    for (std::size_t i = first; i < stage_.tokens.tokens.size() && stage_.tokens.tokens[i].begin < function.body_end; ++i) {
      if (stage_.tokens.tokens[i].kind != TokenKind::identifier || stage_.at(i - 1) == ".") continue;
      if (stage_.at(i + 1) == "(" && functions_.contains(stage_.at(i))) {
        follow(i, tag != 0 || for_author, around);
      } else if (tag != 0) {
        note_use(i);
      }
    }
    walked_ = outer;
  }

  void follow(std::size_t call, bool by_author, const Surroundings& around) {
    const FunctionOutline* meant = overload(call);
    if (meant == nullptr) return;
    const int tag = tag_of(stage_, token_at(meant->body_begin));
    if (tag != 0) trace_.push_back(fmt::format("f{}{}", tag, by_author ? "" : place_of(call, around)));
    constexpr std::string_view kLight = "light_source_";
    Surroundings inside = around;
    if (meant->name.starts_with(kLight)) inside.light = meant->name.substr(kLight.size());
    if (const std::string texture = texture_of(*meant); tag == 0 && !texture.empty()) inside.texture = texture;
    walk(*meant, inside, by_author);
  }

  /// The number of the texture whose coordinates a function of the renderer reads; "" for other functions.
  std::string texture_of(const FunctionOutline& function) const {
    constexpr std::string_view kCoordinates = "castle_TexCoord";
    for (std::size_t i = token_at(function.body_begin);
         i < stage_.tokens.tokens.size() && stage_.tokens.tokens[i].begin < function.body_end; ++i) {
      if (stage_.at(i).starts_with(kCoordinates)) return std::string(stage_.at(i).substr(kCoordinates.size()));
    }
    return "";
  }

  /// Where the renderer calls an author: in which light's function, for which texture.
  std::string place_of(std::size_t call, const Surroundings& around) const {
    if (stage_.at(call).starts_with("PLUG_texture_color")) return "@texture " + around.texture;
    return around.light.empty() ? "" : "@light " + around.light;
  }

  const FunctionOutline* overload(std::size_t call) const {
    const std::vector<std::string_view> types = argument_types(call + 2);
    const auto [begin, end] = functions_.equal_range(stage_.at(call));
    const auto found = std::find_if(begin, end, [&](const auto& candidate) { return takes(*candidate.second, types); });
    return found == end ? nullptr : found->second;
  }

  static bool takes(const FunctionOutline& function, const std::vector<std::string_view>& types) {
    if (function.parameters.size() != types.size()) return false;
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (!types[i].empty() && types[i] != function.parameters[i].type) return false;
    }
    return true;
  }

  /// The types of the arguments that begin at a token, "" where unknown.
  std::vector<std::string_view> argument_types(std::size_t first) const {
    std::vector<std::string_view> types;
    int depth = 0;
    for (std::size_t i = first, begin = first; depth >= 0; ++i) {
      depth += stage_.at(i) == "(" ? 1 : stage_.at(i) == ")" ? -1 : 0;
      if (depth > 0 || (depth == 0 && stage_.at(i) != ",")) continue;
      if (i > begin) types.push_back(argument_type(begin, i));
      begin = i + 1;
    }
    return types;
  }

  std::string_view argument_type(std::size_t begin, std::size_t end) const {
    if (stage_.at(begin).starts_with("castle_texture_")) return globals_.at(stage_.at(begin))->type;
    if (stage_.at(end - 1) == "rgb") return "vec3";
    if (end - begin != 1) return "";
    for (const Parameter& parameter : walked_->parameters) {
      if (parameter.name == stage_.at(begin)) return parameter.type;
    }
    return stage_.at(begin) == "t" ? "float" : stage_.at(begin) == "v" ? "vec3" : stage_.at(begin) == "w" ? "vec4" : "";
  }

  /// What an author's function does with a name.
  void note_use(std::size_t token) {
    const std::string_view name = stage_.at(token);
    if (const int macro = macro_value(stage_.tokens.tokens[token]); macro != 0) {
      trace_.push_back(fmt::format("m{}", macro));
    } else if (structs_.contains(name)) {
      if (stage_.at(token + 1) == "(") trace_.push_back(fmt::format("s{}", member_of(*structs_.at(name))));
    } else if (globals_.contains(name)) {
      note_global(*globals_.at(name), stage_.at(token + 1) == "=");
    }
  }

  void note_global(const GlobalOutline& global, bool written) {
    const std::string name(global.name);
    if (global.storage == Storage::constant) {
      const std::string_view value = std::string_view(stage_.text).substr(global.initializer_begin);
      trace_.push_back(fmt::format("k{}", number_in(value.substr(value.find_first_not_of(' ')))));
    } else if (global.storage == Storage::uniform) {
      trace_.push_back(uniform_source(name));
    } else {
      const auto writers = writers_.find(name);
      trace_.push_back((written ? "w:" : "v:") +
                       (writers == writers_.end() ? "" : fmt::format("{}", fmt::join(writers->second, ","))));
    }
  }

  std::string uniform_source(const std::string& name) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) return "c:" + name;
    const SceneEffect& effect = scene_.effects[static_cast<std::size_t>(found->second->owner)];
    const int field = found->second->field;
    return fmt::format("u:{}.{}", effect.label, field < 0 ? "-" : effect.fields[static_cast<std::size_t>(field)].name);
  }

  int member_of(const StructOutline& type) const {
    constexpr std::string_view kMember = "member_";
    const std::string_view text = std::string_view(stage_.text).substr(type.begin, type.end - type.begin);
    const std::size_t at = text.find(kMember);
    return at == std::string_view::npos ? 0 : number_in(text.substr(at + kMember.size()));
  }

  /// The value that a macro of this name has at the token; 0 when there is none.
  int macro_value(const Token& token) const {
    const std::string_view name = token_text(stage_.text, token);
    int value = 0;
    for (const Token& directive : stage_.tokens.tokens) {
      if (directive.begin > token.begin) break;
      if (directive.kind != TokenKind::directive) continue;
      const std::vector<Token> words = directive_tokens(stage_.text, directive);
      if (words.size() < 3 || token_text(stage_.text, words[2]) != name) continue;
      value = words.size() > 3 ? number_in(token_text(stage_.text, words[3])) : 0;
    }
    return value;
  }

  const ComposedProgram& program_;
  const Scene& scene_;
  const StageOutline& stage_;
  std::multimap<std::string_view, const FunctionOutline*> functions_;
  std::map<std::string_view, const GlobalOutline*> globals_;
  std::map<std::string_view, const StructOutline*> structs_;
  std::map<std::string, const FieldUniform*> fields_;
  std::map<std::string, std::set<int>> writers_;
  const FunctionOutline* walked_ = nullptr;
  Trace trace_;
};

}  // namespace

ProgramTrace trace_of(const ComposedProgram& program, const Scene& scene) {
  const StageOutline vertex(program, ShaderStage::vertex), fragment(program, ShaderStage::fragment);
  ProgramTrace trace;
  trace.vertex = TextTracer(program, scene, vertex, vertex).run();
  trace.fragment = TextTracer(program, scene, fragment, vertex).run();
  trace.plugs_filled = {program.plugs_filled.begin(), program.plugs_filled.end()};
  return trace;
}

}  // namespace plugc::oracle
