#include "mesh/mesh_cache.h"

#include <functional>
#include <string_view>

namespace plugc {
namespace {

template <typename T>
std::size_t hash_of(const std::vector<T>& list) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

}  // namespace

std::shared_ptr<const Mesh> share_mesh(MeshCache& cache, Mesh mesh) {
  if (mesh.live != nullptr) return std::make_shared<const Mesh>(std::move(mesh));  // what is equal now will not stay so
  const std::size_t hash = hash_of(mesh.positions) ^ hash_of(mesh.indices);
  const auto [first, last] = cache.by_content.equal_range(hash);
  for (auto known = first; known != last; ++known) {
    if (*known->second == mesh) return known->second;
  }
  return cache.by_content.emplace(hash, std::make_shared<const Mesh>(std::move(mesh)))->second;
}

}  // namespace plugc
