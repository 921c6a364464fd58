#pragma once
// What one shader text declares at global scope, and its markers. No expression is parsed: function bodies are skipped by
// their brackets. All positions are byte offsets into the text that was given; all string_views point into it.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/tokens.h"

namespace plugc {

enum class Direction : std::uint8_t { in, out, inout };

struct Parameter {
  bool is_const = false;
  Direction direction = Direction::in;
  std::string_view type;   ///< `vec4`, `sampler2D`, a struct's name; precision words left out.
  std::string_view name;   ///< May be empty.
  std::string_view array;  ///< `[4]` or empty.
  std::uint32_t begin = 0, end = 0;
};

/// A function's definition or prototype.
struct FunctionOutline {
  std::string_view return_type;
  std::string_view name;
  std::uint32_t name_begin = 0;
  std::vector<Parameter> parameters;                       ///< Empty for `(void)`.
  std::uint32_t parameters_begin = 0, parameters_end = 0;  ///< Between the brackets.
  std::uint32_t begin = 0, end = 0;                        ///< The whole declaration, `;` or body included.
  std::uint32_t body_begin = 0, body_end = 0;              ///< `{` to behind `}`; equal for a prototype.
  bool is_definition() const { return body_end > body_begin; }
};

enum class Storage : std::uint8_t { none, constant, uniform, in, out, buffer, shared };

/// One declared global variable. `uniform float a, b;` gives two with the same begin and end.
struct GlobalOutline {
  Storage storage = Storage::none;  ///< `attribute` is in; `varying` is out in a vertex text, in in a fragment text.
  std::string_view qualifiers;      ///< `flat`, `centroid`, ... as written; empty for most.
  std::string_view layout;          ///< `layout(...)` as written, or empty.
  std::string_view type;
  std::string_view name;
  std::string_view array;  ///< `[4]`, `[]` or empty; from the type or the name.
  std::uint32_t name_begin = 0;
  std::uint32_t declarator_begin = 0, declarator_end = 0;    ///< `b[2] = x` in `float a, b[2] = x;`
  std::uint32_t initializer_begin = 0, initializer_end = 0;  ///< Behind `=`; equal when there is none.
  std::uint32_t begin = 0, end = 0;                          ///< The whole declaration with `;`.
  std::uint32_t declarator_count = 1;                        ///< How many variables the declaration declares.
};

/// `struct Name {...};` A block (`uniform Name {...} instance;`) is kept as a struct with storage.
struct StructOutline {
  std::string_view name;  ///< Empty for an anonymous struct.
  std::uint32_t name_begin = 0;
  std::string_view instance;  ///< A block's instance name, or empty.
  std::uint32_t instance_begin = 0;
  Storage storage = Storage::none;
  std::uint32_t begin = 0, end = 0;  ///< `struct` to behind `}` (and behind `;` where nothing is declared with it).
};

struct MacroOutline {
  std::string_view name;
  std::uint32_t name_begin = 0;
  std::uint32_t begin = 0, end = 0;  ///< The whole directive.
  std::uint32_t body_begin = 0;      ///< Behind the name and the parameters.
};

enum class MarkerKind : std::uint8_t { plug, declarations, varying_passthrough };

struct MarkerOutline {
  MarkerKind kind = MarkerKind::plug;
  std::string_view name;                        ///< Of the plug.
  std::string_view arguments;                   ///< Between the brackets, as written.
  std::vector<std::string_view> argument_list;  ///< The same, cut at its commas.
  bool is_sole_statement = false;               ///< The whole body of an `if`, `else` or loop, which must stay one statement.
  std::uint32_t begin = 0, end = 0;             ///< The whole comment.
  std::uint32_t name_begin = 0;
  std::uint32_t enclosing_function = UINT32_MAX;  ///< Index into functions, or none at global scope.
};

/// Directives and statements that must be hoisted or honoured.
struct VersionDirective {
  int number = 0;            ///< 0 when the text has none.
  std::string_view profile;  ///< `es`, `core`, `compatibility` or empty.
  std::uint32_t begin = 0, end = 0;
};

struct TextRange {
  std::uint32_t begin = 0, end = 0;
};

enum class ProblemKind : std::uint8_t {
  fatal,     ///< No compiler takes the text, and what stands behind it may be read as a piece of it.
  doubtful,  ///< Not understood here; a macro may make it right, so the compiler has to judge it.
  harmless   ///< No mistake in the eyes of a compiler.
};

struct OutlineProblem {
  std::uint32_t begin = 0, end = 0;  ///< Where the text stops being legal.
  std::string message;               ///< "`}` is missing in front of `void`"
  ProblemKind kind = ProblemKind::doubtful;
  TextRange cause = {};  ///< An earlier place that it is about, or empty.
  std::string cause_message = {};
};

struct Outline {
  VersionDirective version;
  std::vector<TextRange> extensions;  ///< `#extension` lines.
  std::vector<TextRange> precisions;  ///< `precision mediump float;`
  std::vector<TextRange> empties;     ///< A `;` that ends nothing, which GLSL 3.30 does not know and everybody writes.
  std::vector<FunctionOutline> functions;
  std::vector<GlobalOutline> globals;
  std::vector<StructOutline> structs;
  std::vector<MacroOutline> macros;  ///< Live `#define`s.
  std::vector<TextRange> undefs;
  std::vector<TextRange> layouts;  ///< `layout(triangles) in;`
  std::vector<MarkerOutline> markers;
  std::vector<OutlineProblem> problems;  ///< In order; the outline goes on behind each.
};

/// The parameters of a signature that stands alone: `inout vec4 color, const in vec3 normal`. Offsets into `text`.
std::vector<Parameter> parse_parameters(std::string_view text);

/// `varying_storage` is what `varying` means in this stage.
Outline outline(std::string_view text, const TokenList& tokens, Storage varying_storage);

}  // namespace plugc
