#include "mesh/mesh_cache.h"

#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace plugc {
namespace {

template <typename T>
std::size_t hash_of(const std::vector<T>& list) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

void report_full(MeshCache& cache, const Span& geometry, Diagnostics& diagnostics) {
  if (std::exchange(cache.is_full, true)) return;
  diagnostics.report(
      DiagnosticId::geometry_limit, geometry,
      fmt::format("the meshes of this scene have more than {} vertices; this one and new ones behind it are left out",
                  kMaxSceneVertices));
}

}  // namespace

std::shared_ptr<const Mesh> share_mesh(MeshCache& cache, Mesh mesh, const Span& geometry, Diagnostics& diagnostics) {
  const bool own = mesh.live != nullptr;  // what is equal now will not stay so
  const std::size_t hash = own ? 0 : hash_of(mesh.positions) ^ hash_of(mesh.indices);
  const auto [first, last] = cache.by_content.equal_range(hash);
  for (auto known = first; !own && known != last; ++known) {
    if (*known->second == mesh) return known->second;
  }
  if (cache.is_full || mesh.positions.size() > cache.vertices_left) {
    report_full(cache, geometry, diagnostics);
    return nullptr;
  }
  cache.vertices_left -= mesh.positions.size();
  auto shared = std::make_shared<const Mesh>(std::move(mesh));
  if (!own) cache.by_content.emplace(hash, shared);
  return shared;
}

}  // namespace plugc
