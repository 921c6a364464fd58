#pragma once
// Caps that keep any input from exhausting time, memory or stack. Reaching one is reported, never silent.

#include <cstddef>
#include <cstdint>

namespace plugc {

inline constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;  ///< One file, read whole.
inline constexpr std::size_t kMaxTotalBytes = std::size_t{2} << 30;   ///< All files of one scene together, unpacked.
inline constexpr std::size_t kMaxNameBytes = 1024;                    ///< One name of a node, a field, a type.
inline constexpr std::size_t kMaxMessageBytes = 2000;                 ///< One message.
inline constexpr std::size_t kMaxSyntaxMistakes = 100;                ///< Reported in one file; then reading it stops.
inline constexpr std::size_t kMaxDocumentItems = 8'000'000;           ///< Nodes, fields, strings, statements of one file.
inline constexpr std::size_t kMaxDocumentNumbers = 64'000'000;        ///< Numbers of one file; a file may be full of them.
inline constexpr std::size_t kMaxGltfValues = 4'000'000;              ///< Numbers, strings, lists, objects of glTF's JSON.
inline constexpr std::size_t kMaxDiagnostics = 10'000;                ///< Different things said in one run.
inline constexpr std::uint32_t kMaxNesting = 512;                     ///< Nodes inside nodes, as written.
inline constexpr std::uint32_t kMaxLightNesting = 256;                ///< Where lights of VRML 1.0 open no more groups.
inline constexpr std::uint32_t kMaxInlineDepth = 32;                  ///< Inline inside Inline.
inline constexpr std::uint32_t kMaxProtoDepth = 64;                   ///< Prototype inside prototype, expanded.
inline constexpr std::uint32_t kMaxSceneNodes = 2'000'000;            ///< Nodes after expansion.
inline constexpr std::uint32_t kMaxSceneDepth = 2'000;                ///< Nodes inside nodes, after expansion.
inline constexpr std::uint32_t kMaxShapeInstances = 200'000;          ///< Shapes after USE is multiplied out.
inline constexpr std::size_t kMaxShaderTokens = 200'000;              ///< Tokens of one shader part.
inline constexpr std::size_t kMaxStageBytes = std::size_t{4} << 20;   ///< Text of one composed stage.
inline constexpr std::uint32_t kMaxExpressionNesting = 200;           ///< Brackets inside brackets in a shader or script.
inline constexpr std::uint32_t kMaxUniformElements = 4'096;    ///< Of one array; OpenGL promises a stage 1024 numbers in all.
inline constexpr std::uint32_t kMaxImageSide = 16'384;         ///< Pixels along one side of an image.
inline constexpr std::size_t kMaxJoinedTexels = 1 << 27;       ///< Of a volume or cube map made of pictures.
inline constexpr std::uint32_t kMaxSolidVertices = 1'000'000;  ///< Of one sphere, cone or cylinder.
inline constexpr std::size_t kMaxMeshVertices = 50'000'000;    ///< Vertices, and corners of faces, of one mesh.
inline constexpr std::size_t kMaxSceneVertices = 64'000'000;   ///< Vertices of all different meshes of a scene.
inline constexpr std::size_t kMaxTexCoordSets = 32;            ///< Of one geometry; programs read the first 8 of a shape.
inline constexpr std::size_t kMaxAttributeColumns = 11;  ///< Of authors' vertex attributes: all that OpenGL's 16 places leave.
inline constexpr std::uint64_t kMaxPolygonWork = 1'000'000'000;  ///< Corners times reflex corners, summed over a mesh's faces.
inline constexpr std::uint32_t kMaxShadowMapSide = 8'192;        ///< Texels along one side of a shadow map.
inline constexpr std::uint32_t kMaxMomentMapSide = 4'096;  ///< The same of one that holds moments: 16 bytes a texel, twice.

inline constexpr std::uint64_t kMaxShadowMapBytes = std::uint64_t{2} << 30U;  ///< All shadow maps of a scene together.
inline constexpr std::uint64_t kMaxTextureBytes = std::uint64_t{4} << 30U;    ///< All its textures: many may show one image.

}  // namespace plugc
