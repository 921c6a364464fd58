#pragma once
// The members of glTF's objects, as the specification lists them: as much of it as plugc reads. Nothing but data; what it
// means is in gltf_rules.cpp. Kinds of objects have names of our own where glTF has none.

#include <cstdint>
#include <string_view>

namespace plugc {

/// Vital: may be absent, but where it is wrong its object means something else.
enum class GltfNeed : std::uint8_t { optional, required, vital };

enum class GltfType : std::uint8_t {
  index,      // of an item of `target`
  indices,    // a list of such
  index_map,  // an object of such
  count,      // 0 or a positive whole number
  stride,     // of a buffer view
  component,  // of an accessor
  one_of,     // a string of `target`
  number,
  numbers,  // `length` of them
  string,
  boolean,
  object,  // of the kind `target`
  list,    // of objects of the kind `target`
};

struct GltfRule {
  std::string_view owner, member;
  GltfNeed need;
  GltfType type;
  std::string_view target = {};
  std::size_t length = 0;
};

// clang-format off

inline constexpr GltfRule kGltfRules[] = {
    {"file", "asset", GltfNeed::required, GltfType::object, "asset"},
    {"file", "buffers", GltfNeed::optional, GltfType::list, "buffer"},
    {"file", "bufferViews", GltfNeed::optional, GltfType::list, "bufferView"},
    {"file", "accessors", GltfNeed::optional, GltfType::list, "accessor"},
    {"file", "images", GltfNeed::optional, GltfType::list, "image"},
    {"file", "samplers", GltfNeed::optional, GltfType::list, "sampler"},
    {"file", "textures", GltfNeed::optional, GltfType::list, "texture"},
    {"file", "materials", GltfNeed::optional, GltfType::list, "material"},
    {"file", "meshes", GltfNeed::optional, GltfType::list, "mesh"},
    {"file", "cameras", GltfNeed::optional, GltfType::list, "camera"},
    {"file", "nodes", GltfNeed::optional, GltfType::list, "node"},
    {"file", "scenes", GltfNeed::optional, GltfType::list, "scene"},
    {"file", "scene", GltfNeed::optional, GltfType::index, "scenes"},
    {"file", "extensions", GltfNeed::optional, GltfType::object, "file extensions"},
    {"file extensions", "KHR_lights_punctual", GltfNeed::optional, GltfType::object, "lights"},
    {"lights", "lights", GltfNeed::optional, GltfType::list, "light"},
    {"asset", "version", GltfNeed::required, GltfType::string},

    {"buffer", "byteLength", GltfNeed::required, GltfType::count},
    {"buffer", "uri", GltfNeed::vital, GltfType::string},
    {"bufferView", "buffer", GltfNeed::required, GltfType::index, "buffers"},
    {"bufferView", "byteOffset", GltfNeed::vital, GltfType::count},
    {"bufferView", "byteLength", GltfNeed::required, GltfType::count},
    {"bufferView", "byteStride", GltfNeed::vital, GltfType::stride},
    {"accessor", "bufferView", GltfNeed::vital, GltfType::index, "bufferViews"},
    {"accessor", "byteOffset", GltfNeed::vital, GltfType::count},
    {"accessor", "componentType", GltfNeed::required, GltfType::component},
    {"accessor", "count", GltfNeed::required, GltfType::count},
    {"accessor", "type", GltfNeed::required, GltfType::one_of, "SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4"},
    {"accessor", "normalized", GltfNeed::vital, GltfType::boolean},
    {"accessor", "sparse", GltfNeed::vital, GltfType::object, "sparse"},
    {"sparse", "count", GltfNeed::required, GltfType::count},
    {"sparse", "indices", GltfNeed::required, GltfType::object, "sparse indices"},
    {"sparse", "values", GltfNeed::required, GltfType::object, "sparse values"},
    {"sparse indices", "bufferView", GltfNeed::required, GltfType::index, "bufferViews"},
    {"sparse indices", "byteOffset", GltfNeed::vital, GltfType::count},
    {"sparse indices", "componentType", GltfNeed::required, GltfType::component},
    {"sparse values", "bufferView", GltfNeed::required, GltfType::index, "bufferViews"},
    {"sparse values", "byteOffset", GltfNeed::vital, GltfType::count},

    {"image", "uri", GltfNeed::vital, GltfType::string},
    {"image", "bufferView", GltfNeed::vital, GltfType::index, "bufferViews"},
    {"image", "mimeType", GltfNeed::optional, GltfType::string},
    {"sampler", "magFilter", GltfNeed::optional, GltfType::count},
    {"sampler", "minFilter", GltfNeed::optional, GltfType::count},
    {"sampler", "wrapS", GltfNeed::optional, GltfType::count},
    {"sampler", "wrapT", GltfNeed::optional, GltfType::count},
    {"texture", "name", GltfNeed::optional, GltfType::string},
    {"texture", "sampler", GltfNeed::optional, GltfType::index, "samplers"},
    {"texture", "source", GltfNeed::vital, GltfType::index, "images"},

    {"material", "name", GltfNeed::optional, GltfType::string},
    {"material", "pbrMetallicRoughness", GltfNeed::optional, GltfType::object, "pbr"},
    {"material", "normalTexture", GltfNeed::optional, GltfType::object, "normalTexture"},
    {"material", "occlusionTexture", GltfNeed::optional, GltfType::object, "occlusionTexture"},
    {"material", "emissiveTexture", GltfNeed::optional, GltfType::object, "textureInfo"},
    {"material", "emissiveFactor", GltfNeed::optional, GltfType::numbers, "", 3},
    {"material", "alphaMode", GltfNeed::optional, GltfType::one_of, "OPAQUE MASK BLEND"},
    {"material", "alphaCutoff", GltfNeed::optional, GltfType::number},
    {"material", "doubleSided", GltfNeed::optional, GltfType::boolean},
    {"material", "extensions", GltfNeed::optional, GltfType::object, "material extensions"},
    {"material extensions", "KHR_materials_unlit", GltfNeed::optional, GltfType::object, "unlit"},
    {"pbr", "baseColorFactor", GltfNeed::optional, GltfType::numbers, "", 4},
    {"pbr", "baseColorTexture", GltfNeed::optional, GltfType::object, "textureInfo"},
    {"pbr", "metallicFactor", GltfNeed::optional, GltfType::number},
    {"pbr", "roughnessFactor", GltfNeed::optional, GltfType::number},
    {"pbr", "metallicRoughnessTexture", GltfNeed::optional, GltfType::object, "textureInfo"},
    {"normalTexture", "scale", GltfNeed::optional, GltfType::number},
    {"occlusionTexture", "strength", GltfNeed::optional, GltfType::number},
    {"textureInfo", "index", GltfNeed::required, GltfType::index, "textures"},
    {"textureInfo", "texCoord", GltfNeed::optional, GltfType::count},
    {"textureInfo", "extensions", GltfNeed::optional, GltfType::object, "texture extensions"},
    {"texture extensions", "KHR_texture_transform", GltfNeed::optional, GltfType::object, "texture transform"},
    {"texture transform", "offset", GltfNeed::optional, GltfType::numbers, "", 2},
    {"texture transform", "rotation", GltfNeed::optional, GltfType::number},
    {"texture transform", "scale", GltfNeed::optional, GltfType::numbers, "", 2},
    {"texture transform", "texCoord", GltfNeed::optional, GltfType::count},

    {"mesh", "name", GltfNeed::optional, GltfType::string},
    {"mesh", "primitives", GltfNeed::required, GltfType::list, "primitive"},
    {"primitive", "attributes", GltfNeed::required, GltfType::index_map, "accessors"},
    {"primitive", "indices", GltfNeed::vital, GltfType::index, "accessors"},
    {"primitive", "material", GltfNeed::optional, GltfType::index, "materials"},
    {"primitive", "mode", GltfNeed::vital, GltfType::count},

    {"camera", "name", GltfNeed::optional, GltfType::string},
    {"camera", "type", GltfNeed::required, GltfType::one_of, "perspective orthographic"},
    {"camera", "perspective", GltfNeed::vital, GltfType::object, "perspective"},
    {"camera", "orthographic", GltfNeed::vital, GltfType::object, "orthographic"},
    {"perspective", "yfov", GltfNeed::required, GltfType::number},
    {"perspective", "znear", GltfNeed::required, GltfType::number},
    {"perspective", "zfar", GltfNeed::optional, GltfType::number},
    {"perspective", "aspectRatio", GltfNeed::optional, GltfType::number},
    {"orthographic", "xmag", GltfNeed::required, GltfType::number},
    {"orthographic", "ymag", GltfNeed::required, GltfType::number},
    {"orthographic", "zfar", GltfNeed::required, GltfType::number},
    {"orthographic", "znear", GltfNeed::required, GltfType::number},
    {"light", "name", GltfNeed::optional, GltfType::string},
    {"light", "type", GltfNeed::required, GltfType::one_of, "directional point spot"},
    {"light", "color", GltfNeed::optional, GltfType::numbers, "", 3},
    {"light", "intensity", GltfNeed::optional, GltfType::number},
    {"light", "range", GltfNeed::optional, GltfType::number},
    {"light", "spot", GltfNeed::vital, GltfType::object, "spot"},
    {"spot", "innerConeAngle", GltfNeed::optional, GltfType::number},
    {"spot", "outerConeAngle", GltfNeed::optional, GltfType::number},

    {"node", "name", GltfNeed::optional, GltfType::string},
    {"node", "children", GltfNeed::optional, GltfType::indices, "nodes"},
    {"node", "mesh", GltfNeed::optional, GltfType::index, "meshes"},
    {"node", "camera", GltfNeed::optional, GltfType::index, "cameras"},
    {"node", "matrix", GltfNeed::optional, GltfType::numbers, "", 16},
    {"node", "translation", GltfNeed::optional, GltfType::numbers, "", 3},
    {"node", "rotation", GltfNeed::optional, GltfType::numbers, "", 4},
    {"node", "scale", GltfNeed::optional, GltfType::numbers, "", 3},
    {"node", "extensions", GltfNeed::optional, GltfType::object, "node extensions"},
    {"node extensions", "KHR_lights_punctual", GltfNeed::optional, GltfType::object, "node light"},
    {"node light", "light", GltfNeed::required, GltfType::index, "lights"},
    {"scene", "name", GltfNeed::optional, GltfType::string},
    {"scene", "nodes", GltfNeed::optional, GltfType::indices, "nodes"},
};

// clang-format on

/// The emptiest object of a kind that stands in lists which the library takes.
struct GltfEmptiest {
  std::string_view kind, text;
};

inline constexpr GltfEmptiest kEmptiestGltf[] = {
    {"buffer", "{}"},
    {"bufferView", R"({"buffer":0,"byteLength":0})"},
    {"accessor", R"({"componentType":5126,"count":0,"type":"SCALAR"})"},
    {"image", "{}"},
    {"sampler", "{}"},
    {"texture", "{}"},
    {"material", "{}"},
    {"mesh", R"({"primitives":[]})"},
    {"primitive", R"({"attributes":{}})"},
    {"camera", R"({"type":"perspective","perspective":{"yfov":1,"znear":1}})"},
    {"light", R"({"type":"point"})"},
    {"node", "{}"},
    {"scene", "{}"},
};

}  // namespace plugc
