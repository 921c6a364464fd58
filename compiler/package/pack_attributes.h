#pragma once
// Vertex inputs: what programs read, and the numbers of authors that meshes hold for them (FloatVertexAttribute and its like).

#include <memory>
#include <vector>

#include "mesh/mesh.h"
#include "package/package_file.h"
#include "validate/validate.h"

namespace plugc {

/// A place in SPIR-V; -1 for what has none.
std::int32_t pack_number(std::uint32_t number);

/// A program's vertex inputs. Those that only an author's mesh feeds get the places that nothing else of the program takes; one
/// that finds none has unit 255 and is not fed. `over_screen`: what covers the picture has corners and texture coordinates,
/// which go by the reference engine's names, too.
std::vector<std::unique_ptr<PackedAttributeT>> pack_attributes(const std::vector<ReflectedVariable>& variables,
                                                               bool over_screen);

/// Adds them behind what a vertex has; offsets only, see write_mesh_attributes().
void add_mesh_attributes(const Mesh& mesh, PackedMeshT& packed);
/// Writes their numbers into the vertices, which have their final size.
void write_mesh_attributes(const Mesh& mesh, PackedMeshT& packed);

bool are_equal(const std::vector<std::unique_ptr<PackedMeshAttributeT>>& a,
               const std::vector<std::unique_ptr<PackedMeshAttributeT>>& b);

}  // namespace plugc
