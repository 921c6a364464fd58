// What glTF becomes: nodes, geometry, materials, textures, lights, cameras.

#include <cmath>

#include <gtest/gtest.h>

#include "gltf_reading.h"

namespace plugc {
namespace {

constexpr const char* kTriangle = R"({"attributes":{"POSITION":0},"indices":1})";

/// A file with nodes only.
std::string nodes_of(const std::string& nodes, const std::string& more = "") {
  return R"({"asset":{"version":"2.0"},"nodes":[)" + nodes + "]" + more + "}";
}

TEST(Gltf, BecomesTransformsGroupsAndShapes) {
  const GltfReading reading(gltf_of(kTriangle));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_EQ(reading.document.encoding, Encoding::gltf);
  EXPECT_EQ(reading.dump(),
            "Transform\n"
            "  field children\n"
            "    DEF mesh_0 Group\n"
            "      field children\n"
            "        Shape\n"
            "          field appearance\n"
            "            DEF material Appearance\n"
            "              field alphaMode \"OPAQUE\"\n"
            "              field material\n"
            "                PhysicalMaterial\n"
            "                  field baseColor 1 1 1\n"
            "                  field metallic 1\n"
            "                  field roughness 1\n"
            "                  field emissiveColor 0 0 0\n"
            "          field geometry\n"
            "            IndexedTriangleSet\n"
            "              field index 0 1 2\n"
            "              field normalPerVertex FALSE\n"
            "              field coord\n"
            "                DEF Coordinate_0 Coordinate\n"
            "                  field point 0 0 0 1 0 0 0 1 0\n");
}

TEST(Gltf, ReadsBinaryFilesWithPlacesInTheirJson) {
  std::string json = gltf_of(R"({"attributes":{"POSITION":9},"indices":1})");
  const std::size_t uri = json.find(",\"uri\""), end = json.find("\"}]", uri);
  json.erase(uri, end + 1 - uri);
  const GltfReading reading(glb_of(json, triangle_bytes()));
  EXPECT_EQ(reading.messages(), "2:52 `meshes[0].primitives[0].attributes.POSITION`: there is no 9; `accessors` holds 2\n");
  const std::string sound = json.replace(json.find("\"POSITION\":9"), 12, "\"POSITION\":0");
  EXPECT_EQ(GltfReading(glb_of(sound, triangle_bytes())).dump(), GltfReading(gltf_of(kTriangle)).dump());
}

TEST(Gltf, ReadsBuffersInFilesBesideIt) {
  std::string json = gltf_of(kTriangle);
  const std::size_t uri = json.find("data:"), end = json.find('"', uri);
  json.replace(uri, end - uri, "a%20b.bin");
  const GltfReading reading(json, {{"a b.bin", triangle_bytes() + "a longer file is no mistake"}});
  EXPECT_EQ(reading.messages(), "");
  EXPECT_EQ(reading.dump(), GltfReading(gltf_of(kTriangle)).dump());
}

TEST(Gltf, ReadsTheTreeOfNodes) {
  const GltfReading reading(nodes_of(
      R"({"name":"Arm","translation":[1,2,3],"rotation":[0,0,1,0],"scale":[2,2,2],"children":[1,2]},{"name":"Arm"},{"name":"2 b"})"));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_EQ(reading.dump(),
            "DEF Arm Transform\n"
            "  field translation 1 2 3\n"
            "  field rotation 0 0 1 3.141592653589793\n"
            "  field scale 2 2 2\n"
            "  field children\n"
            "    DEF Arm_2 Transform\n"
            "    DEF _2_b Transform\n");
}

TEST(Gltf, ReadsTheSceneThatTheFileShows) {
  EXPECT_EQ(
      GltfReading(nodes_of(R"({"name":"A"},{"name":"B"})", R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])")).dump(),
      "DEF B Transform\n");
  EXPECT_EQ(GltfReading(nodes_of(R"({"name":"A"},{"name":"B"})", R"(,"scenes":[{"nodes":[0]},{"nodes":[1]}])")).dump(),
            "DEF A Transform\n");
}

TEST(Gltf, TakesAMatrixApart) {
  const GltfReading turned(nodes_of(R"({"matrix":[0,2,0,0, -3,0,0,0, 0,0,4,0, 5,6,7,1]})"));
  EXPECT_EQ(turned.messages(), "");
  EXPECT_EQ(turned.dump(),
            "Transform\n"
            "  field translation 5 6 7\n"
            "  field rotation 0 0 1 1.5707963267948966\n"
            "  field scale 2 3 4\n");
  const GltfReading mirrored(nodes_of(R"({"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})"));
  EXPECT_TRUE(mirrored.holds("field scale -1 1 1")) << mirrored.dump();
  EXPECT_TRUE(mirrored.holds("field rotation 0 0 1 0")) << mirrored.dump();
  EXPECT_EQ(gltf_messages(nodes_of(R"({"matrix":[1,0,0,0, 1,1,0,0, 0,0,1,0, 0,0,0,1]})")),
            "1:47 `nodes[0].matrix`: this matrix is no product of a translation, a rotation and a scale; it is drawn as the "
            "nearest one\n");
}

TEST(Gltf, SharesWhatSeveralPlacesUse) {
  std::string json = gltf_of(std::string(kTriangle) + "," + kTriangle);
  json.replace(json.find(R"("nodes":[0])"), 11, R"("nodes":[0,1])");
  json.replace(json.find(R"([{"mesh":0}])"), 12, R"([{"mesh":0},{"mesh":0}])");
  const GltfReading reading(json);
  EXPECT_EQ(reading.messages(), "");
  EXPECT_TRUE(reading.holds("    USE mesh_0\n"));
  EXPECT_TRUE(reading.holds("            USE material\n"));
  EXPECT_TRUE(reading.holds("                USE Coordinate_0\n"));
}

/// The geometry of a primitive with this mode.
std::string geometry_of(const std::string& primitive) {
  const GltfReading reading(gltf_of(primitive));
  const std::string dump = reading.dump();
  const std::size_t geometry = dump.find("field geometry\n");
  const std::size_t begin = geometry == std::string::npos ? dump.size() : geometry + 15;
  std::string text = reading.messages();
  for (std::size_t at = begin; at < dump.size();) {
    const std::size_t end = dump.find('\n', at);
    const std::string line = dump.substr(dump.find_first_not_of(' ', at), end - dump.find_first_not_of(' ', at));
    if (!line.starts_with("DEF") && line.find("point") == std::string::npos) text += line + "\n";
    at = end + 1;
  }
  return text;
}

TEST(Gltf, EveryModeHasItsGeometry) {
  const auto with = [](const std::string& rest) { return geometry_of(R"({"attributes":{"POSITION":0})" + rest + "}"); };
  const std::string flat = "field normalPerVertex FALSE\nfield coord\n";
  EXPECT_EQ(with(""), "TriangleSet\n" + flat);
  EXPECT_EQ(with(R"(,"mode":5)"), "TriangleStripSet\nfield stripCount 3\n" + flat);
  EXPECT_EQ(with(R"(,"mode":6)"), "TriangleFanSet\nfield fanCount 3\n" + flat);
  EXPECT_EQ(with(R"(,"indices":1,"mode":5)"), "IndexedTriangleStripSet\nfield index 0 1 2\n" + flat);
  EXPECT_EQ(with(R"(,"indices":1,"mode":6)"), "IndexedTriangleFanSet\nfield index 0 1 2\n" + flat);
  EXPECT_EQ(with(R"(,"mode":0)"), "PointSet\nfield coord\nCoordinate\n");
  EXPECT_EQ(with(R"(,"mode":1)"), "IndexedLineSet\nfield coordIndex 0 1 -1 2\nfield coord\nCoordinate\n");
  EXPECT_EQ(with(R"(,"indices":1,"mode":2)"), "IndexedLineSet\nfield coordIndex 0 1 2 0\nfield coord\nCoordinate\n");
  EXPECT_EQ(with(R"(,"mode":3)"), "IndexedLineSet\nfield coordIndex 0 1 2\nfield coord\nCoordinate\n");
  EXPECT_EQ(with(R"(,"mode":7)"), "2:62 `meshes[0].primitives[0].mode`: there is no mode 7; 0 to 6 are\n");
}

TEST(Gltf, IndexedPointsAreTakenOut) {
  const std::string bytes = triangle_bytes().substr(0, 36) + bytes_of<std::uint16_t>({2, 1, 2});
  EXPECT_TRUE(GltfReading(gltf_of(R"({"attributes":{"POSITION":0},"indices":1,"mode":0})", "", "", bytes))
                  .holds("point 0 1 0 1 0 0 0 1 0"));
}

TEST(Gltf, LinesAndPointsAreNotLit) {
  EXPECT_TRUE(GltfReading(gltf_of(R"({"attributes":{"POSITION":0},"mode":1})")).holds("UnlitMaterial"));
}

TEST(Gltf, ReadsVertexData) {
  const std::string floats = bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0.25, 0.5, 1, 1, 0});
  const std::string bytes =
      triangle_bytes() + std::string(2, '\0') + floats + bytes_of<std::uint8_t>({255, 0, 51, 102, 0, 0, 0, 0, 0, 0, 0, 0});
  const GltfReading reading(
      gltf_of(R"({"attributes":{"POSITION":0,"NORMAL":2,"TEXCOORD_0":3,"COLOR_0":4,"TANGENT":5},"material":0})",
              R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,0.5]},"doubleSided":true}])",
              R"(,{"bufferView":0,"byteOffset":44,"componentType":5126,"count":3,"type":"VEC3"})"
              R"(,{"bufferView":0,"byteOffset":80,"componentType":5126,"count":3,"type":"VEC2"})"
              R"(,{"bufferView":0,"byteOffset":104,"componentType":5121,"count":3,"type":"VEC4","normalized":true})"
              R"(,{"bufferView":0,"byteOffset":44,"componentType":5126,"count":2,"type":"VEC4"})",
              bytes));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_TRUE(reading.holds("DEF Normal_2 Normal\n"));
  EXPECT_TRUE(reading.holds("field vector 0 0 1 0 0 1 0 0 1\n"));
  EXPECT_TRUE(reading.holds("field color 0.5 0 0.2 0.2 0 0 0 0 0 0 0 0\n")) << "times the base colour";
  EXPECT_TRUE(reading.holds("field point 0 0.75 0.5 0 1 1\n")) << "v runs down\n" << reading.dump();
  EXPECT_TRUE(reading.holds("field mapping \"TEXCOORD_0\"\n"));
  EXPECT_TRUE(reading.holds("DEF Tangent_5 Tangent\n"));
  EXPECT_TRUE(reading.holds("field solid FALSE\n"));
  EXPECT_FALSE(reading.holds("normalPerVertex"));
}

TEST(Gltf, SeveralSetsOfTextureCoordinatesStartWithTheMainOne) {
  const GltfReading reading(gltf_of(
      R"({"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2},"material":0})",
      R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}}],"textures":[{"source":0}],"images":[{"uri":"a.png"}])",
      R"(,{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})"));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_TRUE(reading.holds("field baseTextureMapping \"TEXCOORD_1\"\n"));
  const std::string dump = reading.dump();
  EXPECT_LT(dump.find("MultiTextureCoordinate"), dump.find("field mapping \"TEXCOORD_1\""));
}

TEST(Gltf, ReadsPhysicalMaterials) {
  const GltfReading reading(
      gltf_of(R"({"attributes":{"POSITION":0},"material":0})",
              R"(,"materials":[{"name":"Brass","alphaMode":"MASK","alphaCutoff":0.25,"emissiveFactor":[0.1,0.2,0.3],)"
              R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0,0.75],"metallicFactor":0.9,"roughnessFactor":0.4,)"
              R"("metallicRoughnessTexture":{"index":0}},"normalTexture":{"index":0,"scale":2},)"
              R"("occlusionTexture":{"index":0,"strength":0.5},"emissiveTexture":{"index":0}}],)"
              R"("textures":[{"source":0,"sampler":0,"name":"Wood"}],"images":[{"uri":"a.png"}],)"
              R"("samplers":[{"wrapS":33071,"wrapT":33648,"minFilter":9987,"magFilter":9728}])"));
  EXPECT_EQ(reading.messages(), "");
  const std::string dump = reading.dump();
  const std::size_t begin = dump.find("DEF Brass Appearance");
  EXPECT_EQ(dump.substr(begin, dump.find("          field geometry") - begin),
            "DEF Brass Appearance\n"
            "              field alphaMode \"MASK\"\n"
            "              field alphaCutoff 0.25\n"
            "              field material\n"
            "                PhysicalMaterial\n"
            "                  field baseColor 0.5 0.25 0\n"
            "                  field transparency 0.25\n"
            "                  field metallic 0.9\n"
            "                  field roughness 0.4\n"
            "                  field emissiveColor 0.1 0.2 0.3\n"
            "                  field metallicRoughnessTexture\n"
            "                    DEF Wood ImageTexture\n"
            "                      field url \"a.png\"\n"
            "                      field repeatS FALSE\n"
            "                      field repeatT TRUE\n"
            "                      field textureProperties\n"
            "                        TextureProperties\n"
            "                          field boundaryModeS \"CLAMP_TO_EDGE\"\n"
            "                          field boundaryModeT \"MIRRORED_REPEAT\"\n"
            "                          field minificationFilter \"AVG_PIXEL_AVG_MIPMAP\"\n"
            "                          field generateMipMaps TRUE\n"
            "                          field magnificationFilter \"NEAREST_PIXEL\"\n"
            "                  field metallicRoughnessTextureMapping \"TEXCOORD_0\"\n"
            "                  field emissiveTexture\n"
            "                    USE Wood\n"
            "                  field emissiveTextureMapping \"TEXCOORD_0\"\n"
            "                  field normalScale 2\n"
            "                  field normalTexture\n"
            "                    USE Wood\n"
            "                  field normalTextureMapping \"TEXCOORD_0\"\n"
            "                  field occlusionStrength 0.5\n"
            "                  field occlusionTexture\n"
            "                    USE Wood\n"
            "                  field occlusionTextureMapping \"TEXCOORD_0\"\n");
}

TEST(Gltf, ReadsUnlitMaterials) {
  const GltfReading reading(gltf_of(
      R"({"attributes":{"POSITION":0},"material":0})",
      R"(,"materials":[{"extensions":{"KHR_materials_unlit":{}},"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0,1]}}])"));
  EXPECT_TRUE(reading.holds("UnlitMaterial\n                  field emissiveColor 0.5 0.25 0\n")) << reading.dump();
}

TEST(Gltf, ImagesInBuffersBecomeDataUrls) {
  const GltfReading reading(
      gltf_of(R"({"attributes":{"POSITION":0},"material":0})",
              R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],)"
              R"("images":[{"bufferView":0,"mimeType":"image/png"}])"));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_TRUE(reading.holds("field url \"data:image/png;base64," + base64_encode(triangle_bytes()) + "\"\n"));
}

/// Where a TextureTransform with these fields takes (s, t), as X3D says (4.1, 18.4.8).
std::pair<double, double> moved(const GltfReading& reading, double s, double t) {
  std::map<std::string_view, std::vector<double>> fields;
  for (const NodeSyntax& node : reading.document.nodes) {
    if (node.type.text != "TextureTransform") continue;
    for (const FieldSyntax& field : reading.document.of(node.fields)) {
      const auto numbers = reading.document.of(field.value.numbers());
      fields[field.name.text].assign(numbers.begin(), numbers.end());
    }
  }
  const auto& move = fields.at("translation");
  const auto& scale = fields.at("scale");
  const double angle = fields.at("rotation")[0];
  const double x = s + move[0], y = t + move[1];
  return {scale[0] * (std::cos(angle) * x - std::sin(angle) * y), scale[1] * (std::sin(angle) * x + std::cos(angle) * y)};
}

std::string with_transform(const std::string& transform) {
  return gltf_of(
      R"({"attributes":{"POSITION":0},"material":0})",
      R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":)" +
          transform + R"(}}}}],"textures":[{"source":0}],"images":[{"uri":"a.png"}])");
}

TEST(Gltf, TextureTransformsMeanTheSame) {
  const GltfReading uneven(with_transform(R"({"offset":[0.5,0.25],"scale":[2,4]})"));
  EXPECT_EQ(uneven.messages(), "");
  {
    const auto [s, t] = moved(uneven, 0.125, 1 - 0.5);  // (u, v) = (0.125, 0.5) -> (0.75, 2.25)
    EXPECT_NEAR(s, 0.75, 1e-12);
    EXPECT_NEAR(t, 1 - 2.25, 1e-12);
  }
  const double angle = 0.5;
  const GltfReading turned(with_transform(R"({"offset":[0.5,0.25],"scale":[2,2],"rotation":0.5})"));
  const double u = 0.125, v = 0.5;
  {
    // KHR_texture_transform: translation * rotation * scale, rotation = [cos sin; -sin cos]
    const double moved_u = 0.5 + std::cos(angle) * 2 * u + std::sin(angle) * 2 * v;
    const double moved_v = 0.25 - std::sin(angle) * 2 * u + std::cos(angle) * 2 * v;
    const auto [s, t] = moved(turned, u, 1 - v);
    EXPECT_NEAR(s, moved_u, 1e-12);
    EXPECT_NEAR(t, 1 - moved_v, 1e-12);
  }
  EXPECT_NE(gltf_messages(with_transform(R"({"scale":[2,4],"rotation":0.5})")).find("turns and then scales unevenly"),
            std::string::npos);
}

TEST(Gltf, ReadsLightsAndCameras) {
  const GltfReading reading(nodes_of(
      R"({"camera":0},{"camera":1},{"extensions":{"KHR_lights_punctual":{"light":0}}},{"extensions":{"KHR_lights_punctual":{"light":1}}})",
      R"(,"cameras":[{"name":"Front","type":"perspective","perspective":{"yfov":0.5,"znear":0.1}},)"
      R"({"type":"orthographic","orthographic":{"xmag":2,"ymag":3,"znear":0,"zfar":9}}],)"
      R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","color":[1,0.5,0],"intensity":2},)"
      R"({"type":"spot","range":7,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.2}}]}})"));
  EXPECT_EQ(reading.messages(), "");
  EXPECT_EQ(reading.dump(),
            "Transform\n"
            "  field children\n"
            "    DEF Front Viewpoint\n"
            "      field position 0 0 0\n"
            "      field description \"Front\"\n"
            "      field fieldOfView 0.5\n"
            "      field fieldOfViewForceVertical TRUE\n"
            "Transform\n"
            "  field children\n"
            "    OrthoViewpoint\n"
            "      field position 0 0 0\n"
            "      field fieldOfView -2 -3 2 3\n"
            "Transform\n"
            "  field children\n"
            "    DirectionalLight\n"
            "      field color 1 0.5 0\n"
            "      field intensity 2\n"
            "      field global TRUE\n"
            "Transform\n"
            "  field children\n"
            "    SpotLight\n"
            "      field intensity 1\n"
            "      field global TRUE\n"
            "      field attenuation 0 0 1\n"
            "      field radius 7\n"
            "      field beamWidth 0.1\n"
            "      field cutOffAngle 0.2\n");
}

TEST(Gltf, ReadsAccessorsWithStridesAndSparseElements) {
  const std::string bytes =
      bytes_of<float>({0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9}) + bytes_of<std::uint32_t>({1}) + bytes_of<float>({5, 6, 7});
  std::string json = gltf_of(
      R"({"attributes":{"POSITION":2}})", "",
      R"(,{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":0,"byteOffset":48,"componentType":5125},"values":{"bufferView":0,"byteOffset":52}}})",
      bytes);
  json.replace(json.find(R"("bufferViews":[)"), 15, R"("bufferViews":[)");
  json.replace(json.find("}],\"buffers\""), 12, "},{\"buffer\":0,\"byteLength\":48,\"byteStride\":16}],\"buffers\"");
  const GltfReading reading(json);
  EXPECT_EQ(reading.messages(), "");
  EXPECT_TRUE(reading.holds("point 0 0 0 5 6 7 0 1 0")) << reading.dump();
  const GltfReading zeros(
      gltf_of(R"({"attributes":{"POSITION":2}})", "", R"(,{"componentType":5126,"count":2,"type":"VEC3"})"));
  EXPECT_EQ(zeros.messages(), "");
  EXPECT_TRUE(zeros.holds("point 0 0 0 0 0 0\n"));
}

TEST(Gltf, SaysWhatItDoesNotRead) {
  const std::string json = gltf_of(R"({"attributes":{"POSITION":0},"targets":[{"POSITION":0}]})",
                                   R"(,"animations":[{"channels":[],"samplers":[]}],"skins":[{"joints":[0]}])");
  EXPECT_EQ(GltfReading(json).messages(), "4:" + std::to_string(json.find("[{\"channels\"") - json.rfind('\n')) +
                                              " animations of glTF are not read; the model stands still\n"
                                              "4:" +
                                              std::to_string(json.find("[{\"joints\"") - json.rfind('\n')) +
                                              " skins of glTF are not read; the meshes stand as they were modelled\n"
                                              "2:65 morph targets of glTF are not read; meshes keep their first form\n");
  EXPECT_EQ(gltf_messages(nodes_of("{}", R"(,"extensionsRequired":["KHR_draco_mesh_compression","KHR_mesh_quantization"])")),
            "1:63 this file needs the extension `KHR_draco_mesh_compression`, which plugc does not read; export it without\n");
}

}  // namespace
}  // namespace plugc
