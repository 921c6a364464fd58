// What is wrong in a glTF file is told at its place, and the rest is read.

#include <gtest/gtest.h>

#include "base/limits.h"
#include "gltf_reading.h"

namespace plugc {
namespace {

constexpr const char* kTriangle = R"({"attributes":{"POSITION":0},"indices":1})";

/// A file whose one line behind the first is what the test is about.
std::string file_with(const std::string& line) {
  return "{\"asset\":{\"version\":\"2.0\"},\n" + line + "}";
}

TEST(GltfMistakes, MembersOfTheWrongType) {
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":5)")), "2:9 `nodes`: expected a list of objects\n");
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":[5])")), "2:10 `nodes[0]`: expected an object, a node\n");
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":[{"mesh":1.5}])")),
            "2:18 `nodes[0].mesh`: expected the index of one of the `meshes`\n");
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":[{"translation":[1,2]}])")),
            "2:25 `nodes[0].translation`: expected a list of 3 numbers\n");
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":[{"translation":[1,2,"3"]}])")),
            "2:30 `nodes[0].translation[2]`: expected a number\n");
  EXPECT_EQ(gltf_messages(file_with(R"("materials":[{"alphaMode":"CUT","doubleSided":1}])")),
            "2:27 `materials[0].alphaMode`: expected `OPAQUE`, `MASK` or `BLEND`\n"
            "2:47 `materials[0].doubleSided`: expected `true` or `false`\n");
  EXPECT_EQ(gltf_messages(file_with(
                R"("bufferViews":[{"buffer":0,"byteLength":-4,"byteStride":6}],"buffers":[{"byteLength":4294967296}])")),
            "2:86 `buffers[0].byteLength`: expected a whole number from 0 on\n"
            "2:41 `bufferViews[0].byteLength`: expected a whole number from 0 on\n"
            "2:57 `bufferViews[0].byteStride`: expected a multiple of 4 from 4 to 252\n");
}

TEST(GltfMistakes, MembersThatAreMissing) {
  EXPECT_EQ(gltf_messages("{\"asset\":{}}"), "1:10 `asset`: `version` is missing\n");
  EXPECT_EQ(gltf_messages(file_with(R"("accessors":[{"count":3,"type":"VEC5"}])")),
            "2:14 `accessors[0]`: `componentType` is missing\n"
            "2:32 `accessors[0].type`: expected `SCALAR`, `VEC2`, `VEC3`, `VEC4`, `MAT2`, `MAT3` or `MAT4`\n");
  EXPECT_EQ(gltf_messages(file_with(R"("cameras":[{"type":"perspective"},{"type":"fish eye"}])")),
            "2:12 `cameras[0]`: `perspective` is missing\n"
            "2:43 `cameras[1].type`: expected `perspective` or `orthographic`\n");
}

TEST(GltfMistakes, IndicesOfWhatDoesNotExist) {
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":[{"mesh":2,"children":[0,7]}],"meshes":[])")),
            "2:34 `nodes[0].children[1]`: there is no 7; `nodes` holds 1\n"
            "2:18 `nodes[0].mesh`: there is no 2; `meshes` holds 0\n");
  EXPECT_EQ(gltf_messages(file_with(R"("nodes":[{"mesh":0}],"meshes":{"primitives":[]})")),
            "2:31 `meshes`: expected a list of objects\n"
            "2:18 `nodes[0].mesh`: there is no 0; `meshes` holds 0\n");
}

TEST(GltfMistakes, OneCostsOnlyWhatNeedsIt) {
  const GltfReading reading(gltf_of(std::string(R"({"attributes":{"POSITION":2}},)") + kTriangle + R"(,{"attributes":{}})", "",
                                    R"(,{"bufferView":3,"componentType":5126,"count":3,"type":"VEC3"})"));
  EXPECT_EQ(reading.messages(),
            "3:170 `accessors[2].bufferView`: there is no 3; `bufferViews` holds 1\n"
            "2:98 `meshes[0].primitives[2]`: a primitive without `POSITION` cannot be drawn\n");
  EXPECT_TRUE(reading.holds("field point 0 0 0 1 0 0 0 1 0"));
}

TEST(GltfMistakes, AccessorsThatDoNotFit) {
  const auto said = [](const std::string& accessor) {
    const std::string text = gltf_messages(gltf_of(R"({"attributes":{"POSITION":2}})", "", "," + accessor));
    return text.substr(text.find(' ') + 1);
  };
  EXPECT_EQ(
      said(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})"),
      "`accessors[2]`: 4 elements of 12 bytes, 12 bytes apart from byte 0 on, do not fit the 42 bytes of buffer view 0\n");
  EXPECT_EQ(said(R"({"bufferView":0,"byteOffset":2147483647,"componentType":5126,"count":2147483647,"type":"VEC3"})"),
            "`accessors[2]`: 6442450941 numbers are more than plugc reads from a file of this size\n");
  EXPECT_EQ(said(R"({"componentType":5126,"count":2147483647,"type":"VEC3"})"),
            "`accessors[2]`: 6442450941 numbers are more than plugc reads from a file of this size\n");
  EXPECT_EQ(said(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})"),
            "`meshes[0].primitives[0].attributes.POSITION`: `POSITION` takes VEC3, but accessor 2 is VEC2\n");
  EXPECT_EQ(said(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":9,)"
                 R"("indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}})"),
            "`accessors[2].sparse`: 9 elements do not fit their buffer views\n");
  EXPECT_EQ(said(R"({"bufferView":0,"componentType":5126,"count":1,"type":"VEC3","sparse":{"count":1,)"
                 R"("indices":{"bufferView":0,"componentType":5121,"byteOffset":38},"values":{"bufferView":0}}})"),
            "`accessors[2].sparse`: element 1 is replaced, but there are 1\n");
}

TEST(GltfMistakes, IndicesOfAPrimitive) {
  const auto said = [](const std::string& accessor) {
    const std::string text = gltf_messages(gltf_of(R"({"attributes":{"POSITION":0},"indices":2})", "", "," + accessor));
    return text.substr(text.find(' ') + 1);
  };
  EXPECT_EQ(said(R"({"componentType":5123,"count":3,"type":"SCALAR"})"),
            "`meshes[0].primitives[0].indices`: this accessor has no `bufferView`, so there are no indices\n");
  EXPECT_EQ(said(R"({"bufferView":0,"componentType":5123,"count":3,"type":"VEC2"})"),
            "`meshes[0].primitives[0].indices`: indices are read from an accessor of type `SCALAR`\n");
  EXPECT_EQ(said(R"({"bufferView":0,"componentType":5126,"byteOffset":4,"count":3,"type":"SCALAR","normalized":7})"),
            "`accessors[2].normalized`: expected `true` or `false`\n");
}

TEST(GltfMistakes, Buffers) {
  const auto with_uri = [](const std::string& uri, std::map<std::string, std::string> beside) {
    std::string json = gltf_of(kTriangle);
    const std::size_t begin = json.find("data:"), end = json.find('"', begin);
    json.replace(begin, end - begin, uri);
    const std::string text = GltfReading(json, std::move(beside)).messages();
    return text.substr(text.find(' ') + 1);
  };
  EXPECT_EQ(with_uri("none.bin", {}), "cannot read `none.bin`\n");
  EXPECT_EQ(with_uri("http://example.org/a.bin", {}), "`http://example.org/a.bin` is no local file; plugc reads no network\n");
  EXPECT_EQ(with_uri("short.bin", {{"short.bin", "abc"}}), "`buffers[0].byteLength`: 42 bytes are promised, but there are 3\n");
  EXPECT_EQ(with_uri("data:application/octet-stream;base64,!", {}),
            "`buffers[0].uri`: this `data:` url holds no readable base64\n");
}

TEST(GltfMistakes, Views) {
  std::string json = gltf_of(kTriangle);
  json.replace(json.find(R"({"buffer":0,)"), 12, R"({"buffer":0,"byteOffset":2,)");
  EXPECT_EQ(gltf_messages(json), "4:16 `bufferViews[0]`: bytes 2 to 44 are meant, but buffer 0 has 42\n");
}

TEST(GltfMistakes, NodesMakeATree) {
  EXPECT_EQ(gltf_messages(file_with(R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}])")),
            "2:35 `nodes[0]`: this node has two parents, or contains itself; it is read once\n");
  std::string chain = R"("scenes":[{"nodes":[0]}],"nodes":[)";
  for (int i = 1; i < 2000; ++i) chain += "{\"children\":[" + std::to_string(i) + "]},";
  const GltfReading reading(file_with(chain + "{}]"));
  ASSERT_EQ(reading.diagnostics.all().size(), 1U);
  EXPECT_EQ(reading.diagnostics.all()[0].id, DiagnosticId::nesting_limit);
}

TEST(GltfMistakes, TexturesAndImages) {
  const auto with_image = [](const std::string& rest) {
    return gltf_messages(gltf_of(R"({"attributes":{"POSITION":0},"material":0})",
                                 ",\n\"materials\":[{\"emissiveTexture\":{\"index\":0}}],\n" + rest));
  };
  EXPECT_EQ(with_image(R"("textures":[{}])"), "6:13 `textures[0]`: this texture has no `source`, the image that it shows\n");
  EXPECT_EQ(with_image(R"("textures":[{"source":0}],"images":[{}])"),
            "6:37 `images[0]`: this image has neither a `uri` nor a `bufferView`\n");
  EXPECT_EQ(with_image(R"("textures":[{"source":0,"sampler":0}],"images":[{"uri":"a.png"}],"samplers":[{"wrapS":5}])"),
            "6:87 `samplers[0].wrapS`: OpenGL has no such number for this; the default is taken\n");
}

TEST(GltfMistakes, BrokenContainersAndTexts) {
  EXPECT_EQ(gltf_messages("glTF"), "1:1 this .glb file is cut short in its header\n");
  EXPECT_EQ(gltf_messages("glTF" + little_endian(1) + std::string(20, ' ')),
            "1:1 this .glb file is of version 1; plugc reads glTF 2.0\n");
  EXPECT_EQ(gltf_messages("glTF" + little_endian(2) + little_endian(20) + little_endian(99) + "JSON"),
            "1:1 a chunk of this .glb file has 99 bytes, but the file ends after 0 of them\n");
  EXPECT_EQ(gltf_messages("glTF" + little_endian(2) + little_endian(20) + little_endian(0) + std::string("BIN\0", 4)),
            "1:1 this .glb file has no chunk of JSON\n");
  EXPECT_EQ(gltf_messages("{\"asset\":{\"version\":\"1.0\"}}"), "1:21 this is glTF 1.0; plugc reads glTF 2.0\n");
  EXPECT_EQ(gltf_messages("{\"asset\":{\"version\":\"2.0\"},}"), "1:27 no `,` may stand before `}`\n");
  EXPECT_NE(gltf_messages(file_with("\"nodes\":[{\"name\":\"\xFF\"}]")).find("this file cannot be read"), std::string::npos);
  const GltfReading deep(file_with("\"extras\":" + std::string(100'000, '[')));
  EXPECT_EQ(deep.diagnostics.all()[0].id, DiagnosticId::nesting_limit);
}

TEST(GltfMistakes, AreListedUpToALimit) {
  std::string nodes = "{\"mesh\":1}";
  for (int i = 0; i < 500; ++i) nodes += ",{\"mesh\":1}";
  const GltfReading reading(file_with("\"nodes\":[" + nodes + "]"));
  EXPECT_EQ(reading.diagnostics.all().size(), kMaxSyntaxMistakes + 1);
}

}  // namespace
}  // namespace plugc
