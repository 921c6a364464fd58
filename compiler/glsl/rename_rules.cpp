// Three reasons to rename: a word became a keyword, or is one in some target, and the text uses it as a name; a global or a
// function is named like a function that became built-in (and would hide it from the code it is joined with); a variable named
// `texture` stands beside a call that becomes `texture(...)`. The first holds for texts that are older than the word, the
// second for those older than version 130. What a word is used as is told from its neighbours: no expression is parsed.

#include "glsl/rename_rules.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "glsl/dialect_words.h"
#include "glsl/qualifiers.h"

namespace plugc {
namespace {

constexpr int kFirstNewVersion = 130;
constexpr int kEsslWords = 420;  // ESSL 3.00 has the words of GLSL up to here

int version_of(const VersionDirective& version) {
  return version.profile == "es" ? kEsslWords : version.number;
}

// One token among its neighbours.
struct Neighbours {
  std::string_view text;
  const TokenStream& stream;
  std::size_t i;

  bool is_behind(char symbol) const { return i > 0 && text[stream[i - 1].begin] == symbol; }
  bool is_before(char symbol) const { return i + 1 < stream.size() && text[stream[i + 1].begin] == symbol; }
  bool is_last() const { return i + 1 == stream.size(); }
  std::string_view previous() const { return i > 0 ? token_text(text, stream[i - 1]) : std::string_view{}; }
  bool before_identifier() const { return i + 1 < stream.size() && stream[i + 1].kind == TokenKind::identifier; }
  bool behind_type() const {
    constexpr std::array<std::string_view, 5> kNoTypes = {"return", "else", "do", "case", "precision"};
    if (i == 0 || stream[i - 1].kind != TokenKind::identifier) return false;
    return qualifier_kind(previous()) == QualifierKind::none && std::ranges::find(kNoTypes, previous()) == kNoTypes.end();
  }
};

// Whether this token shows that the text takes the word for a name.
bool is_used_as_name(NewWord word, const Neighbours& token) {
  if (word == NewWord::reserved) return true;
  if (token.is_behind('.') || token.is_last() || token.before_identifier()) return false;
  if (token.behind_type()) return true;
  return word == NewWord::qualifier && !token.is_before('(');
}

bool is_texture_variable(const Neighbours& token) {
  return !token.is_behind('.') && !token.is_last() && !token.is_before('(');
}

bool is_inside_struct(const Outline& outline, const Token& token) {
  const auto next = std::ranges::upper_bound(outline.structs, token.begin, {}, &StructOutline::begin);
  return next != outline.structs.begin() && token.end <= (next - 1)->end;
}

class RuleFinder {
 public:
  RuleFinder(std::string_view text, const Outline& outline, const std::vector<TokenStream>& streams)
      : text_(text), outline_(outline), streams_(streams) {}

  RenameRules run(bool has_old_texture_call) {
    for (const MacroOutline& macro : outline_.macros) macros_.insert(macro.name);
    const int version = version_of(outline_.version);
    if (version < kFirstNewVersion) find_new_builtins();
    for (const TokenStream& stream : streams_) {
      for (std::size_t i = 0; i < stream.size(); ++i) {
        if (stream[i].kind == TokenKind::identifier) look_at({text_, stream, i}, version, has_old_texture_call);
      }
    }
    if (!rules_.empty()) choose_names();
    return std::move(rules_);
  }

 private:
  void find_new_builtins() {
    for (const GlobalOutline& global : outline_.globals) {
      if (is_new_builtin_function(global.name)) rules_[global.name];
    }
    for (const FunctionOutline& function : outline_.functions) {
      if (is_new_builtin_function(function.name)) rules_[function.name].is_function = true;
    }
  }

  void look_at(const Neighbours& token, int version, bool has_old_texture_call) {
    const std::string_view word = token_text(text_, token.stream[token.i]);
    if (has_old_texture_call && word == "texture" && !macros_.contains(word) && is_texture_variable(token)) rules_[word];
    const NewWord kind = new_word(word);
    if (kind == NewWord::none || version >= new_word_version(word) || macros_.contains(word) || !is_used_as_name(kind, token))
      return;
    RenameRule& rule = rules_[word];
    rule.is_function = rule.is_keyword = true;
    rule.is_qualifier = kind == NewWord::qualifier;
  }

  // `texture_`, or `texture_2` where the author has taken that.
  void choose_names() {
    for (auto& [written, rule] : rules_) {
      const std::string first_choice = std::string(written) + "_";
      const auto taken = names_starting_with(first_choice);
      rule.renamed = first_choice;
      for (int n = 2; taken.contains(rule.renamed); ++n) rule.renamed = first_choice + std::to_string(n);
    }
  }

  std::unordered_set<std::string_view> names_starting_with(std::string_view prefix) const {
    std::unordered_set<std::string_view> names;
    for (const std::string_view macro : macros_) {
      if (macro.starts_with(prefix)) names.insert(macro);
    }
    for (const TokenStream& stream : streams_) {
      for (const Token& token : stream) {
        if (token_text(text_, token).starts_with(prefix)) names.insert(token_text(text_, token));
      }
    }
    return names;
  }

  std::string_view text_;
  const Outline& outline_;
  const std::vector<TokenStream>& streams_;
  std::unordered_set<std::string_view> macros_;
  RenameRules rules_;
};

}  // namespace

RenameRules find_rename_rules(std::string_view text, const Outline& outline, const std::vector<TokenStream>& streams,
                              bool has_old_texture_call) {
  return RuleFinder(text, outline, streams).run(has_old_texture_call);
}

bool applies(const RenameRule& rule, std::string_view text, const TokenStream& stream, std::size_t i, const Outline& outline) {
  const Neighbours token{text, stream, i};
  if (rule.is_keyword) return !(rule.is_qualifier && token.before_identifier());
  if (token.is_behind('.') || is_inside_struct(outline, stream[i])) return false;
  return rule.is_function || !token.is_before('(');
}

}  // namespace plugc
