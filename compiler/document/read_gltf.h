#pragma once
// glTF 2.0 as a Document of X3D nodes.

#include <filesystem>

#include "base/file_access.h"
#include "document/document.h"

namespace plugc {

/// Whether these are the bytes of a `.glb` file, or JSON that is not X3D and either has an `asset` or is named `.gltf`.
bool is_gltf(std::string_view bytes, const std::filesystem::path& path);

/// Reads `.gltf` and `.glb`; `path` is what the buffers and images that it names are relative to. The Document's places lie in
/// the JSON, which is a source of its own where it comes out of a .glb. What breaks a rule of glTF is reported there
/// (`gltf-invalid`), and the rest is read. Skins, morph targets and animations are not read, which is said (`not-drawn`).
/// Source: the glTF 2.0 specification of Khronos.
Document read_gltf(SourceId source, const std::filesystem::path& path, FileAccess& files, SourceSet& sources,
                   Diagnostics& diagnostics);

/// A file of any encoding: glTF by read_gltf(), all others by read_document() of their text.
Document read_document(SourceId source, const std::filesystem::path& path, FileAccess& files, SourceSet& sources,
                       Diagnostics& diagnostics);

}  // namespace plugc
