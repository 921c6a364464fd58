// The words in front of a declaration's type. A macro of the text may stand for some of them.

#include "glsl/declaration_reader.h"

namespace plugc {
namespace {

constexpr std::size_t kMaxQualifierMacro = 200;  // bytes; such a macro is read anew at each use

}  // namespace

void DeclarationReader::read_qualifiers(DeclarationStart& start) {
  std::size_t run_end = 0;
  while (is_identifier(at_)) {
    const QualifierKind kind = qualifier_kind(word(at_));
    if (kind == QualifierKind::none) {
      if (!read_macro_qualifier(start)) return;
    } else {
      read_qualifier(kind, run_end, start);
    }
  }
}

// `run_end` is the index behind the latest `flat`, `centroid`, ...: neighbours are kept as one text.
void DeclarationReader::read_qualifier(QualifierKind kind, std::size_t& run_end, DeclarationStart& start) {
  const std::size_t here = at_++;
  if (kind == QualifierKind::storage) apply_storage(word(here), start);
  if (kind == QualifierKind::layout && is(at_, '(')) {
    const std::size_t next = behind(at_);
    start.layout = text_of(range_of(here, next - 1));
    at_ = next;
  }
  if (kind == QualifierKind::interpolation) {
    if (start.qualifiers.end == 0) start.qualifiers.begin = token(here).begin;
    if (start.qualifiers.end == 0 || run_end == here) start.qualifiers.end = token(here).end;
    run_end = at_;
  }
}

// `#define PRECISION highp` or `#define VARYING varying`: an object-like macro that stands for qualifiers, or for nothing.
bool DeclarationReader::read_macro_qualifier(DeclarationStart& start) {
  const auto found = macros_.find(word(at_));
  if (found == macros_.end()) return false;
  const MacroOutline& macro = *found->second;
  if (macro.end - macro.begin > kMaxQualifierMacro) return false;
  const Token directive{TokenKind::directive, macro.begin, macro.end};
  std::vector<Token> words = directive_tokens(text_, directive);
  std::erase_if(words, [&](const Token& each) { return each.begin < macro.body_begin; });
  const bool only_qualifiers = std::ranges::all_of(
      words, [&](const Token& each) { return qualifier_kind(token_text(text_, each)) != QualifierKind::none; });
  if (!only_qualifiers) return false;
  for (const Token& each : words) apply_storage(token_text(text_, each), start);
  ++at_;
  return true;
}

void DeclarationReader::apply_storage(std::string_view word, DeclarationStart& start) const {
  if (word == "const") start.storage = Storage::constant;
  if (word == "uniform") start.storage = Storage::uniform;
  if (word == "in" || word == "attribute") start.storage = Storage::in;
  if (word == "out") start.storage = Storage::out;
  if (word == "varying") start.storage = varying_;
  if (word == "buffer") start.storage = Storage::buffer;
  if (word == "shared") start.storage = Storage::shared;
}

}  // namespace plugc
