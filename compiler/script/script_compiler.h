#pragma once
// The one pass over a script: it reads, checks and makes steps at once. Every expression leaves one value on the stack, that of
// a loop an empty one. Internal to the script room: compile_script.cpp reads functions and names, compile_expressions.cpp and
// compile_calls.cpp what stands in them.

#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "script/script_functions.h"
#include "script/script_steps.h"
#include "script/script_tokens.h"

namespace plugc {

inline constexpr ScriptType kNothing{};
inline constexpr ScriptType kBoolean{ScriptKind::boolean, false};
inline constexpr ScriptType kInteger{ScriptKind::integer, false};
inline constexpr ScriptType kNumber{ScriptKind::number, false};
inline constexpr ScriptType kText{ScriptKind::text, false};

/// What a name stands for that is no function.
struct Variable {
  std::string name;  ///< In lower case.
  ScriptType type;
  std::uint32_t index = 0;
  int field = -1;
};

class ScriptCompiler {
 public:
  ScriptCompiler(const MappedText& code, std::span<const ScriptField> fields, Diagnostics& diagnostics)
      : code_(code),
        fields_(fields),
        diagnostics_(diagnostics),
        steps_(program_),
        tokens_(read_script_tokens(code, diagnostics)) {}

  ScriptProgram run();

 private:
  // Functions
  void add_fields();
  void function();
  void begin_function(const ScriptToken& name, ScriptFunction& made);
  std::vector<std::string> parameters();
  void add_parameters(const ScriptToken& name, const std::vector<std::string>& names, ScriptFunction& made);

  // Expressions; each returns the type of what it leaves on the stack.
  ScriptType sequence();
  ScriptType assignment();
  ScriptType binary(std::size_t level);
  ScriptType factor();
  ScriptType named(const ScriptToken& name);
  ScriptType constant(const ScriptToken& token);
  ScriptType load(const ScriptToken& name, const Variable& variable);
  ScriptType store(const ScriptToken& name, const Variable& variable, ScriptType value);
  ScriptType apply(const ScriptToken& name, const std::vector<ScriptType>& arguments);

  // Calls: the name is read, the bracket is next.
  ScriptType call(const ScriptToken& name);
  ScriptType call_plain(const ScriptToken& name);
  ScriptType call_folded(const ScriptToken& name);
  ScriptType call_setter(const ScriptToken& name);
  ScriptType call_joined(const ScriptToken& name);
  ScriptType call_control(const ScriptToken& name);
  ScriptType call_if(const ScriptToken& name);
  ScriptType call_while(const ScriptToken& name);
  ScriptType call_for(const ScriptToken& name);
  std::uint32_t keep(const ScriptToken& name);
  std::vector<ScriptType> arguments();
  void condition();
  ScriptType nothing(const ScriptToken& name);  ///< The value of what has none.

  // Tokens
  const ScriptToken& next() const { return failed_ ? tokens_.back() : tokens_[at_]; }
  bool next_is(std::string_view symbol) const { return next().kind == ScriptTokenKind::symbol && next().text == symbol; }
  static bool ends(const ScriptToken& token) {
    return token.kind == ScriptTokenKind::end || token.kind == ScriptTokenKind::lost || token.kind == ScriptTokenKind::function;
  }
  bool take(std::string_view symbol);
  void expect(std::string_view symbol);
  void enter(const ScriptToken& at);  ///< One level deeper; too deep is a mistake.
  ScriptToken take_name(std::string_view what);
  Span span(const ScriptToken& token) const { return code_.locate(token.begin, token.end); }
  std::string written(const ScriptToken& token) const;

  // Names
  const Variable* find_variable(std::string_view lower) const;
  const Variable* expect_variable(const ScriptToken& name);
  void fail(const ScriptToken& at, std::string message, DiagnosticId id = DiagnosticId::script_invalid);
  void fail_unknown(const ScriptToken& name);

  const MappedText& code_;
  std::span<const ScriptField> fields_;
  Diagnostics& diagnostics_;
  ScriptProgram program_;
  ScriptSteps steps_;
  std::vector<ScriptToken> tokens_;
  std::size_t at_ = 0;
  bool failed_ = false;  // in this function; then the end is next
  std::uint32_t depth_ = 0;
  std::vector<Variable> variables_;                                 // parameters last: they hide fields
  std::size_t field_variables_ = 0;                                 // how many of them are fields
  std::unordered_map<std::string, std::size_t> variable_of_field_;  // by lower-case name, as is the next
  std::unordered_map<std::string, int> heard_;                      // fields that receive events
  int proposals_left_ = 10;                                         // each is looked for among all names
  std::set<int> stored_;                                            // fields
};

}  // namespace plugc
