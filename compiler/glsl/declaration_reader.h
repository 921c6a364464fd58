#pragma once
// Reads the declarations of a text one behind the other: qualifiers, a type, and behind it either a function's brackets or a
// list of declarators. Internal to the glsl room.

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>

#include "glsl/brackets.h"
#include "glsl/outline.h"
#include "glsl/qualifiers.h"

namespace plugc {

// What stands before the names of one declaration. `first` and the like are indices of tokens.
struct DeclarationStart {
  std::size_t first = 0;
  Storage storage = Storage::none;
  TextRange qualifiers;
  std::string_view layout;
  TextRange type;
  std::string_view array;
};

class DeclarationReader {
 public:
  DeclarationReader(std::string_view text, const BracketedCode& code, Storage varying, Outline& outline)
      : text_(text), code_(code), varying_(varying), outline_(outline) {
    for (const MacroOutline& macro : outline.macros) macros_.emplace(macro.name, &macro);
  }

  void run() {
    while (at_ < size()) read_statement();
  }

 private:
  std::size_t size() const { return code_.tokens.size(); }
  const Token& token(std::size_t i) const { return code_.tokens[i]; }
  std::string_view word(std::size_t i) const { return i < size() ? token_text(text_, token(i)) : std::string_view{}; }
  bool is(std::size_t i, char symbol) const { return i < size() && text_[token(i).begin] == symbol; }
  bool is_identifier(std::size_t i) const { return i < size() && token(i).kind == TokenKind::identifier; }
  TextRange range_of(std::size_t first, std::size_t last) const { return {token(first).begin, token(last).end}; }
  std::string_view text_of(const TextRange& range) const { return text_.substr(range.begin, range.end - range.begin); }
  // Behind a bracket's partner; behind any other token the next one.
  std::size_t behind(std::size_t i) const { return std::max<std::size_t>(i, code_.closing[i]) + 1; }

  void read_statement();
  void read_declaration();
  void read_qualifiers(DeclarationStart& start);
  void read_qualifier(QualifierKind kind, std::size_t& run_end, DeclarationStart& start);
  bool read_macro_qualifier(DeclarationStart& start);
  void apply_storage(std::string_view word, DeclarationStart& start) const;
  std::string_view read_array();
  void read_struct(DeclarationStart& start);
  void read_block(const DeclarationStart& start);
  void read_function(const DeclarationStart& start);
  void read_globals(const DeclarationStart& start);
  void read_declarator(GlobalOutline& global);
  void skip_statement();
  void report(std::size_t i, std::string message);
  void report_unexpected();
  bool take_semicolon();

  std::string_view text_;
  const BracketedCode& code_;
  Storage varying_;
  Outline& outline_;
  std::unordered_map<std::string_view, const MacroOutline*> macros_;
  std::size_t at_ = 0;
};

}  // namespace plugc
