// The text's live code, its macros and the arguments of its markers are read as streams of tokens. A first look finds which
// of the author's names must change (rename_rules.h); then each stream is walked once, each identifier that has a newer form
// yields an edit, and all edits are applied together, so that every byte keeps its place of origin.

#include "glsl/dialect.h"

#include <algorithm>
#include <map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "glsl/dialect_words.h"
#include "glsl/edit.h"
#include "glsl/outline.h"
#include "glsl/rename_rules.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

// GLSL 3.30 has no line continuation (4.20 and ESSL 3.00 have): `\` and line end become a blank.
MappedText join_continued_lines(const MappedText& text) {
  std::vector<Edit> edits;
  const std::string_view bytes = text.text();
  for (std::size_t at = bytes.find('\\'); at != std::string_view::npos; at = bytes.find('\\', at + 1)) {
    const auto begin = static_cast<std::uint32_t>(at);
    const std::uint32_t length = continuation_length(bytes, begin);
    if (length != 0) edits.push_back({begin, begin + length, " "});
  }
  return edits.empty() ? text : apply_edits(text, std::move(edits));
}

// A directive or a comment inside the declaration would go with it: then it is left for the compiler to reject.
bool is_plain_gl_array(const GlobalOutline& global, std::string_view text) {
  if (global.declarator_count != 1 || global.type != "vec4" || global.name != "gl_TexCoord") return false;
  return text.substr(global.begin, global.end - global.begin).find_first_of("#/") == std::string_view::npos;
}

bool is_direction(std::string_view word) {
  return word == "in" || word == "out" || word == "inout";
}

class Upgrader {
 public:
  Upgrader(const MappedText& text, ShaderStage stage, std::span<const MacroDefinition> predefined)
      : mapped_(text), text_(mapped_.text()), stage_(stage), tokens_(tokenize(text_, predefined)) {
    outline_ = outline(text_, tokens_, Storage::none);
    for (const FunctionOutline& function : outline_.functions) own_names_.insert(function.name);
    for (const MacroOutline& macro : outline_.macros) own_names_.insert(macro.name);
  }

  UpgradedText run() {
    drop_gl_arrays();
    collect_streams();
    rules_ = find_rename_rules(text_, outline_, streams_, has_old_texture_call());
    for (stream_index_ = 0; stream_index_ < streams_.size(); ++stream_index_) walk_stream();
    for (const auto& [written, renamed] : renamed_) result_.renamed_names.push_back({std::string(written), renamed});
    result_.text = apply_edits(mapped_, std::move(edits_));
    return std::move(result_);
  }

 private:
  const TokenStream& stream() const { return streams_[stream_index_]; }
  bool is(std::size_t i, char symbol) const { return i < stream().size() && text_[stream()[i].begin] == symbol; }
  std::string_view word(std::size_t i) const {
    return i < stream().size() ? token_text(text_, stream()[i]) : std::string_view{};
  }

  void drop_gl_arrays();
  void collect_streams();
  bool has_old_texture_call();
  std::optional<TextureCall> texture_call_at(std::size_t i) const;

  void walk_stream();
  std::size_t upgrade_identifier(std::size_t i);
  std::size_t upgrade_gl_word(std::size_t i);
  std::size_t upgrade_indexed(std::size_t i);
  std::size_t upgrade_ftransform(std::size_t i);
  std::size_t upgrade_texture_call(std::size_t i);
  std::size_t upgrade_storage(std::size_t i);
  std::size_t merge_directions(std::size_t i);
  bool rename(std::size_t i);
  std::size_t replace(std::size_t first, std::size_t last, std::string replacement);
  std::string use(std::string_view castle_word);

  const MappedText& mapped_;
  std::string_view text_;
  ShaderStage stage_;
  TokenList tokens_;
  Outline outline_;
  std::unordered_set<std::string_view> own_names_;
  std::vector<TextRange> dropped_;
  std::vector<TokenStream> streams_;  // the code first
  RenameRules rules_;
  std::size_t stream_index_ = 0;
  std::vector<bool> open_brackets_;  // whether each open `(` is that of a call in `vec4(...)`
  bool next_bracket_is_wrapped_ = false;
  std::unordered_set<std::string> used_;
  std::map<std::string_view, std::string> renamed_;
  std::vector<Edit> edits_;
  UpgradedText result_;
};

// `varying vec4 gl_TexCoord[4];` only gave the array a size; its elements are single variables now.
void Upgrader::drop_gl_arrays() {
  for (const GlobalOutline& global : outline_.globals) {
    if (!is_plain_gl_array(global, text_)) continue;
    dropped_.push_back({global.begin, global.end});
    edits_.push_back({global.begin, global.end, ""});
  }
}

void Upgrader::collect_streams() {
  TokenStream& code = streams_.emplace_back();
  std::size_t drop = 0;
  for (const Token& token : tokens_.tokens) {
    while (drop < dropped_.size() && dropped_[drop].end <= token.begin) ++drop;
    const bool dropped = drop < dropped_.size() && dropped_[drop].begin <= token.begin;
    const bool is_code = token.kind != TokenKind::directive && token.kind != TokenKind::marker;
    if (is_code && !dropped) code.push_back(token);
  }
  for (const MacroOutline& macro : outline_.macros) {
    const auto name_end = macro.name_begin + static_cast<std::uint32_t>(macro.name.size());
    streams_.push_back(scan_range(text_, name_end, macro.end));
  }
  for (const MarkerOutline& marker : outline_.markers) {
    if (marker.arguments.empty()) continue;
    const auto begin = static_cast<std::uint32_t>(marker.arguments.data() - text_.data());
    streams_.push_back(scan_range(text_, begin, begin + static_cast<std::uint32_t>(marker.arguments.size())));
  }
}

// A call, or a macro that stands for the function (`#define sample texture2D`).
std::optional<TextureCall> Upgrader::texture_call_at(std::size_t i) const {
  const char initial = text_[stream()[i].begin];
  if (initial != 't' && initial != 's') return std::nullopt;
  const bool is_call = is(i + 1, '(');
  const bool is_whole_macro = stream_index_ > 0 && i + 1 == stream().size();
  if (!is_call && !is_whole_macro) return std::nullopt;
  auto call = upgraded_texture_call(word(i));
  if (!call || own_names_.contains(word(i))) return std::nullopt;
  return call->returned_vec4 && !is_call ? std::nullopt : call;
}

bool Upgrader::has_old_texture_call() {
  for (stream_index_ = 0; stream_index_ < streams_.size(); ++stream_index_) {
    for (std::size_t i = 0; i < stream().size(); ++i) {
      if (stream()[i].kind == TokenKind::identifier && texture_call_at(i)) return true;
    }
  }
  return false;
}

void Upgrader::walk_stream() {
  open_brackets_.clear();
  for (std::size_t i = 0; i < stream().size();) {
    const Token& token = stream()[i];
    if (token.kind == TokenKind::identifier) {
      i = upgrade_identifier(i);
      continue;
    }
    if (text_[token.begin] == '(') {
      open_brackets_.push_back(std::exchange(next_bracket_is_wrapped_, false));
    } else if (text_[token.begin] == ')' && !open_brackets_.empty()) {
      if (open_brackets_.back()) edits_.push_back({token.end, token.end, ")"});
      open_brackets_.pop_back();
    }
    ++i;
  }
}

// Returns the index behind what was read. A token gets one edit at most.
std::size_t Upgrader::upgrade_identifier(std::size_t i) {
  if (rename(i)) return i + 1;
  if (i > 0 && is(i - 1, '.')) return i + 1;
  switch (text_[stream()[i].begin]) {
    case 'g': return upgrade_gl_word(i);
    case 'f': return upgrade_ftransform(i);
    case 't':
    case 's': return upgrade_texture_call(i);
    case 'a':
    case 'v': return upgrade_storage(i);
    case 'i':
    case 'o': return merge_directions(i);
    case 'c':
      if (word(i).starts_with("castle_")) use(word(i));
      return i + 1;
    default: return i + 1;
  }
}

std::size_t Upgrader::upgrade_ftransform(std::size_t i) {
  const bool is_call = word(i) == "ftransform" && is(i + 1, '(') && is(i + 2, ')');
  if (!is_call || own_names_.contains(word(i))) return i + 1;
  const std::string projection = use("castle_ProjectionMatrix");
  const std::string model_view = use("castle_ModelViewMatrix");
  return replace(i, i + 2, fmt::format("({} * ({} * {}))", projection, model_view, use("castle_Vertex")));
}

std::size_t Upgrader::upgrade_gl_word(std::size_t i) {
  const std::string_view name = word(i);
  if (!name.starts_with("gl_")) return i + 1;
  if (const std::string_view castle = castle_name(name, stage_); !castle.empty()) return replace(i, i, use(castle));
  if (name == "gl_ModelViewProjectionMatrix") {
    const std::string projection = use("castle_ProjectionMatrix");
    return replace(i, i, fmt::format("({} * {})", projection, use("castle_ModelViewMatrix")));
  }
  return is(i + 1, '[') && is(i + 3, ']') ? upgrade_indexed(i) : i + 1;
}

// `gl_TexCoord[0]`. An index that is no plain number is left for the compiler to reject.
std::size_t Upgrader::upgrade_indexed(std::size_t i) {
  constexpr std::size_t kMaxDigits = 2;
  const std::string_view index = word(i + 2);
  if (index.size() > kMaxDigits || !std::ranges::all_of(index, is_digit)) return i + 1;
  if (word(i) == "gl_FragData" && index == "0") return replace(i, i + 3, use("castle_FragColor"));
  const std::string_view castle = indexed_castle_name(word(i));
  return castle.empty() ? i + 1 : replace(i, i + 3, use(fmt::format("{}{}", castle, index)));
}

std::size_t Upgrader::upgrade_texture_call(std::size_t i) {
  const auto call = texture_call_at(i);
  if (!call) return i + 1;
  next_bracket_is_wrapped_ = call->returned_vec4;
  return replace(i, i, call->returned_vec4 ? "vec4(" + call->name : call->name);
}

std::size_t Upgrader::upgrade_storage(std::size_t i) {
  if (word(i) == "attribute" && stage_ == ShaderStage::vertex) return replace(i, i, "in");
  if (word(i) != "varying" || stage_ == ShaderStage::geometry) return i + 1;
  return replace(i, i, stage_ == ShaderStage::vertex ? "out" : "in");
}

// `inout in vec3 normal`, which some drivers take: what is read and written is `inout`.
std::size_t Upgrader::merge_directions(std::size_t i) {
  if (open_brackets_.empty() || !is_direction(word(i))) return i + 1;
  std::size_t last = i;
  while (is_direction(word(last + 1))) ++last;
  if (last == i) return i + 1;
  const auto is_as_first = [&](const Token& token) { return token_text(text_, token) == word(i); };
  const bool all_equal = std::all_of(stream().begin() + static_cast<std::ptrdiff_t>(i),
                                     stream().begin() + static_cast<std::ptrdiff_t>(last) + 1, is_as_first);
  result_.merged_directions.push_back(mapped_.locate(stream()[i].begin, stream()[last].end));
  return replace(i, last, all_equal ? std::string(word(i)) : "inout");
}

bool Upgrader::rename(std::size_t i) {
  if (rules_.empty()) return false;
  const auto rule = rules_.find(word(i));
  if (rule == rules_.end() || !applies(rule->second, text_, stream(), i, outline_)) return false;
  renamed_.emplace(rule->first, rule->second.renamed);
  replace(i, i, rule->second.renamed);
  return true;
}

std::size_t Upgrader::replace(std::size_t first, std::size_t last, std::string replacement) {
  edits_.push_back({stream()[first].begin, stream()[last].end, std::move(replacement)});
  return last + 1;
}

std::string Upgrader::use(std::string_view castle_word) {
  std::string name(castle_word);
  if (used_.insert(name).second) result_.used_names.push_back(name);
  return name;
}

}  // namespace

UpgradedText upgrade(const MappedText& text, ShaderStage stage, std::span<const MacroDefinition> predefined) {
  const MappedText joined = join_continued_lines(text);
  return Upgrader(joined, stage, predefined).run();
}

}  // namespace plugc
