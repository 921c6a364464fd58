#pragma once
// Fogs that lie in layers.

#include <optional>

#include "compose/castle_names.h"
#include "package/pack_bindings.h"

namespace plugc {

/// The binding of a uniform that says how deep something lies in a fog in layers; nullopt for other names, and where the shape
/// stands in no such fog.
std::optional<PackedBinding> bind_fog_plane(std::uint32_t uniform, const CastleName& name, const BindingContext& context);

/// Packs the planes of the scene's fogs that lie in layers. Which each fog has; UINT32_MAX for one that has none.
std::vector<std::uint32_t> pack_fog_planes(const Scene& scene, PackedSceneT& packed);

}  // namespace plugc
