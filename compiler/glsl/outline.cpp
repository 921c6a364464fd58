// Directives and markers first, then brackets are matched, then declarations are read (declaration_reader.h).

#include "glsl/outline.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/limits.h"
#include "glsl/brackets.h"
#include "glsl/declaration_reader.h"
#include "glsl/outline_directives.h"

namespace plugc {
namespace {

constexpr std::size_t kMaxProblems = 20;

// Functions stand in text order, so the one whose body holds a marker is found by bisection.
void place_markers(Outline& outline) {
  for (MarkerOutline& marker : outline.markers) {
    const auto next = std::ranges::upper_bound(outline.functions, marker.begin, {}, &FunctionOutline::begin);
    if (next == outline.functions.begin()) continue;
    const FunctionOutline& function = *(next - 1);
    if (function.body_begin <= marker.begin && marker.end <= function.body_end) {
      marker.enclosing_function = static_cast<std::uint32_t>(next - outline.functions.begin() - 1);
    }
  }
}

void order_problems(std::vector<OutlineProblem>& problems) {
  std::ranges::stable_sort(problems, {}, &OutlineProblem::begin);
  if (problems.size() <= kMaxProblems) return;
  problems.resize(kMaxProblems);
  problems.back().message += "; further problems are not listed";
}

}  // namespace

Outline outline(std::string_view text, const TokenList& tokens, Storage varying_storage) {
  Outline result;
  outline_directives(text, tokens.tokens, result);
  const BracketedCode code = match_brackets(text, tokens.tokens, result);
  DeclarationReader(text, code, varying_storage, result).run();
  place_markers(result);
  if (tokens.too_many) {  // what else is found is only due to the cut
    const Token& last = tokens.tokens.back();
    result.problems = {
        {last.begin, last.end, fmt::format("the text has more than {} tokens", kMaxShaderTokens), ProblemKind::fatal}};
  }
  order_problems(result.problems);
  return result;
}

}  // namespace plugc
