#pragma once
// Meshes and images in packed form.

#include <cstdint>
#include <memory>

#include "image/image.h"
#include "mesh/mesh.h"
#include "package/package_file.h"

namespace plugc {

/// Interleaved floats in one layout: position 3, normal 3, then tex_coord 2 (4 where r or q are used) a unit, then colour 4.
/// `units` is how many texture coordinate units programs read; units that the mesh lacks repeat its last one (X3D 4.1, 18.4.5).
std::unique_ptr<PackedMeshT> pack_mesh(const Mesh& mesh, std::uint32_t units);
std::unique_ptr<PackedImageT> pack_image(const Image& image);

}  // namespace plugc
