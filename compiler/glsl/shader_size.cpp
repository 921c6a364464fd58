// Macros are not expanded, only measured: what a use of one comes to is the sum over its body, each parameter counting as its
// argument does. Uses with arguments of equal sizes come to the same, so each is measured once however often it stands; sums
// stop at the limit. A macro inside its own expansion stands for itself (GLSL 4.60, 3.3, which takes that from C++).
//
//     #define A(x) x x x x          A(1) comes to 4
//     #define B(x) A(A(x))          B(1) to 16; eight such lines reach the limit
//
// An expression's depth is about the number of its operators between two commas, semicolons or braces at one level of brackets.

#include "glsl/shader_size.h"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "base/limits.h"
#include "glsl/scan.h"

namespace plugc {
namespace {

constexpr std::size_t kMost = kMaxShaderTokens;
constexpr std::uint32_t kMaxDepth = 400;  // macros within macros and calls within arguments
constexpr std::size_t kMaxOperators = 2000;

using Words = std::vector<std::string_view>;

struct Macro {
  bool has_parameters = false;
  std::vector<std::string_view> parameters;
  Words body;
  bool expanding = false;
  std::map<std::vector<std::size_t>, std::size_t> sizes;  // by the sizes of the arguments
  std::size_t generation = 0;                             // of the table of macros that the sizes hold for
};

class MacroMeter {
 public:
  void define(const Words& words, bool has_parameters);
  void undefine(std::string_view name) { generation_ += macros_.erase(name); }
  bool knows_none() const { return macros_.empty(); }
  bool knows(std::string_view name) const { return macros_.contains(name); }
  /// How many tokens the words come to, up to kMost.
  std::size_t measure(const Words& words) { return sum(words, 0, words.size(), {}, {}, 0); }

 private:
  std::size_t sum(const Words& words, std::size_t begin, std::size_t end, const Words& parameters,
                  const std::vector<std::size_t>& sizes, std::uint32_t depth);
  std::size_t use(Macro& macro, const std::vector<std::size_t>& arguments, std::uint32_t depth);

  std::unordered_map<std::string_view, Macro> macros_;
  std::size_t generation_ = 0;
};

/// `words` are those behind `#define`.
void MacroMeter::define(const Words& words, bool has_parameters) {
  if (words.empty()) return;
  ++generation_;
  Macro macro;
  macro.has_parameters = has_parameters;
  std::size_t body = 1;
  if (has_parameters) {
    while (body < words.size() && words[body] != ")") {
      if (is_identifier_start(words[body].front())) macro.parameters.push_back(words[body]);
      ++body;
    }
    ++body;
  }
  if (body < words.size()) macro.body.assign(words.begin() + static_cast<std::ptrdiff_t>(body), words.end());
  macros_.insert_or_assign(words.front(), std::move(macro));
}

std::size_t MacroMeter::use(Macro& macro, const std::vector<std::size_t>& arguments, std::uint32_t depth) {
  if (macro.generation != generation_) macro.sizes.clear();
  macro.generation = generation_;
  if (const auto known = macro.sizes.find(arguments); known != macro.sizes.end()) return known->second;
  macro.expanding = true;
  const std::size_t size = sum(macro.body, 0, macro.body.size(), macro.parameters, arguments, depth + 1);
  macro.expanding = false;
  macro.sizes.emplace(arguments, size);
  return size;
}

/// Behind the `)` that belongs to the `(` at `open`, and the ends of the arguments between them.
std::size_t argument_ends(const Words& words, std::size_t open, std::size_t end, std::vector<std::size_t>& ends) {
  std::size_t level = 0;
  for (std::size_t i = open; i < end; ++i) {
    if (words[i] == "(") ++level;
    if (words[i] == "," && level == 1) ends.push_back(i);
    if (words[i] == ")" && --level == 0) {
      ends.push_back(i);
      return i + 1;
    }
  }
  ends.push_back(end);
  return end;
}

std::size_t MacroMeter::sum(const Words& words, std::size_t begin, std::size_t end, const Words& parameters,
                            const std::vector<std::size_t>& sizes, std::uint32_t depth) {
  if (depth > kMaxDepth) return kMost;
  std::size_t total = 0;
  for (std::size_t i = begin; i < end && total < kMost;) {
    const std::string_view word = words[i++];
    if (const auto parameter = std::find(parameters.begin(), parameters.end(), word); parameter != parameters.end()) {
      const auto number = static_cast<std::size_t>(parameter - parameters.begin());
      total += number < sizes.size() ? sizes[number] : 0;
      continue;
    }
    const auto macro = macros_.find(word);
    const bool used =
        macro != macros_.end() && !macro->second.expanding && (!macro->second.has_parameters || (i < end && words[i] == "("));
    if (!used) {
      ++total;
      continue;
    }
    std::vector<std::size_t> arguments;
    if (macro->second.has_parameters) {
      std::vector<std::size_t> ends;
      const std::size_t behind = argument_ends(words, i, end, ends);
      for (std::size_t from = i + 1; const std::size_t to : ends) {
        arguments.push_back(sum(words, std::min(from, to), to, parameters, sizes, depth + 1));
        from = to + 1;
      }
      i = behind;
    }
    total += use(macro->second, arguments, depth);
  }
  return std::min(total, kMost);
}

class SizeReader {
 public:
  explicit SizeReader(std::string_view text) : text_(text) {}
  std::optional<SizeProblem> run(const std::vector<Token>& tokens);

 private:
  std::optional<SizeProblem> read_directive(const Token& directive);
  std::optional<SizeProblem> add(const Token& first, const Words& words);
  std::optional<SizeProblem> count_operator(const Token& token);

  std::string_view text_;
  MacroMeter meter_;
  std::size_t total_ = 0;
  std::vector<std::size_t> operators_ = {0};  // in the expressions that are open, by level of brackets
};

std::optional<SizeProblem> SizeReader::add(const Token& first, const Words& words) {
  total_ += meter_.measure(words);
  if (total_ < kMost) return std::nullopt;
  return SizeProblem{first.begin, first.end, fmt::format("macros make more than {} tokens of this part", kMost)};
}

std::optional<SizeProblem> SizeReader::read_directive(const Token& directive) {
  const std::vector<Token> tokens = directive_tokens(text_, directive);
  Words words;
  for (std::size_t i = 2; i < tokens.size(); ++i) words.push_back(token_text(text_, tokens[i]));
  const std::string_view name = tokens.size() > 1 ? token_text(text_, tokens[1]) : "";
  if (name == "define") {
    meter_.define(words, tokens.size() > 3 && tokens[3].begin == tokens[2].end && words[1] == "(");
  } else if (name == "undef" && !words.empty()) {
    meter_.undefine(words.front());
  } else if (name == "if" || name == "elif") {
    return add(directive, words);
  }
  return std::nullopt;
}

std::optional<SizeProblem> SizeReader::count_operator(const Token& token) {
  if (token.kind != TokenKind::symbol) return std::nullopt;
  const char c = text_[token.begin];
  if (c == '(' || c == '[') {
    operators_.push_back(0);
  } else if (c == ')' || c == ']') {
    if (operators_.size() > 1) operators_.pop_back();
  } else if (c == '{' || c == '}' || c == ';') {
    operators_.assign(1, 0);
  } else if (c == ',') {
    operators_.back() = 0;
  } else if (++operators_.back() > kMaxOperators) {
    return SizeProblem{token.begin, token.end, fmt::format("an expression has more than {} operators here", kMaxOperators)};
  }
  return std::nullopt;
}

/// Code between two directives is measured as a whole, as a macro's arguments may stand on many lines.
std::optional<SizeProblem> SizeReader::run(const std::vector<Token>& tokens) {
  for (std::size_t i = 0; i < tokens.size();) {
    if (tokens[i].kind == TokenKind::directive) {
      if (auto problem = read_directive(tokens[i++])) return problem;
      continue;
    }
    const std::size_t first = i;
    std::size_t use = SIZE_MAX;
    Words words;
    for (; i < tokens.size() && tokens[i].kind != TokenKind::directive; ++i) {
      if (auto problem = count_operator(tokens[i])) return problem;
      if (meter_.knows_none()) continue;
      words.push_back(token_text(text_, tokens[i]));
      if (use == SIZE_MAX && meter_.knows(words.back())) use = i;
    }
    if (use == SIZE_MAX) continue;
    if (auto problem = add(tokens[std::max(first, use)], words)) return problem;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SizeProblem> find_size_problem(std::string_view text, const TokenList& tokens) {
  return SizeReader(text).run(tokens.tokens);
}

}  // namespace plugc
