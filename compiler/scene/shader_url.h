#pragma once
// Shader code behind a url field or in CDATA, with the author's places kept byte for byte.

#include <optional>

#include "scene/code_file.h"

namespace plugc {

struct ShaderCode {
  MappedText text;
  Span span;  ///< The url string or the CDATA section.
};

/// The code of an EffectPart or ShaderPart: the first url that can be read (`data:text/plain,...` plain, percent-encoded or
/// base64; `data:,`; a local file), else CDATA. Reports and returns nullopt when there is none.
std::optional<ShaderCode> read_shader_code(const NodeGraph& graph, NodeId part, CodeFiles& files, Diagnostics& diagnostics);

}  // namespace plugc
