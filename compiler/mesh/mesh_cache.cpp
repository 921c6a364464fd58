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

}  // namespace

bool take_vertices(VertexBudget& budget, std::size_t count, const Span& geometry, Diagnostics& diagnostics) {
  if (!budget.spent && count <= budget.left) {
    budget.left -= count;
    return true;
  }
  if (!std::exchange(budget.spent, true))
    diagnostics.report(
        DiagnosticId::geometry_limit, geometry,
        fmt::format("the meshes of this scene have more than {} vertices; what is more is left out, from here on",
                    kMaxSceneVertices));
  return false;
}

std::shared_ptr<const Mesh> share_mesh(MeshCache& cache, Mesh mesh, const Span& geometry, Diagnostics& diagnostics) {
  const bool own = mesh.live != nullptr;  // what is equal now will not stay so
  const std::size_t hash = own ? 0 : hash_of(mesh.positions) ^ hash_of(mesh.indices);
  const auto [first, last] = cache.by_content.equal_range(hash);
  for (auto known = first; !own && known != last; ++known) {
    if (*known->second == mesh) return known->second;
  }
  if (!take_vertices(cache.budget, mesh.positions.size(), geometry, diagnostics)) return nullptr;
  auto shared = std::make_shared<const Mesh>(std::move(mesh));
  if (!own) cache.by_content.emplace(hash, shared);
  return shared;
}

}  // namespace plugc
