#pragma once
// Which of the author's names cannot stay as they are in GLSL 3.30, and what they become.

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "glsl/outline.h"

namespace plugc {

/// Tokens that are read as one run of code: the code itself, a macro's parameters and body, or a marker's arguments.
using TokenStream = std::vector<Token>;

struct RenameRule {
  std::string renamed;
  bool is_function = false;   ///< The name's calls are meant too.
  bool is_keyword = false;    ///< Not even a member of a struct may bear the name.
  bool is_qualifier = false;  ///< Before another word it is the keyword after all.
};

/// By the name as written. Keys point into `text`.
using RenameRules = std::unordered_map<std::string_view, RenameRule>;

/// `has_old_texture_call`: a call in the text is about to become `texture(...)`.
RenameRules find_rename_rules(std::string_view text, const Outline& outline, const std::vector<TokenStream>& streams,
                              bool has_old_texture_call);

/// Whether the rule is for stream[i], a token of its name.
bool applies(const RenameRule& rule, std::string_view text, const TokenStream& stream, std::size_t i, const Outline& outline);

}  // namespace plugc
