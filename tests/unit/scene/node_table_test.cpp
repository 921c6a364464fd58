#include "scene/node_table.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "scene/default_values.h"

namespace plugc {
namespace {

TEST(NodeTable, FindsNodesAndFieldsByName) {
  const NodeInfo* box = find_node_info("Box");
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->container_field, "geometry");
  const FieldInfo* size = find_field_info(*box, "size");
  ASSERT_NE(size, nullptr);
  EXPECT_EQ(size->type, FieldType::SFVec3f);
  EXPECT_EQ(size->access, FieldAccess::initialize_only);
  EXPECT_EQ(find_node_info("Boxx"), nullptr);
  EXPECT_EQ(find_field_info(*box, "radius"), nullptr);
}

TEST(NodeTable, IsSortedSoThatEveryNodeAndFieldIsFound) {
  for (const NodeInfo& node : node_table()) {
    EXPECT_EQ(find_node_info(node.name), &node) << node.name;
    for (const FieldInfo& field : node.fields) EXPECT_EQ(find_field_info(node, field.name), &field) << node.name << field.name;
  }
}

TEST(NodeTable, KnowsAbstractTypes) {
  EXPECT_TRUE(is_a(*find_node_info("SpotLight"), "X3DLightNode"));
  EXPECT_TRUE(is_a(*find_node_info("SpotLight"), "X3DNode"));
  EXPECT_TRUE(is_a(*find_node_info("SpotLight"), "SpotLight"));
  EXPECT_FALSE(is_a(*find_node_info("SpotLight"), "PointLight"));
  EXPECT_FALSE(is_a(*find_node_info("SpotLight"), "NoSuchType"));
}

TEST(NodeTable, ExtendsStandardNodes) {
  EXPECT_NE(find_field_info(*find_node_info("Appearance"), "effects"), nullptr);
  EXPECT_NE(find_field_info(*find_node_info("NavigationInfo"), "timeOriginAtLoad"), nullptr);
  for (const NodeInfo& node : node_table()) {
    if (is_a(node, "X3DTextureNode")) {
      EXPECT_NE(find_field_info(node, "effects"), nullptr) << node.name;
    }
    if (is_a(node, "X3DLightNode")) {
      EXPECT_NE(find_field_info(node, "effects"), nullptr) << node.name;
    }
  }
}

TEST(NodeTable, NodesInheritTheFieldsOfTheNodeThatTheyExtend) {
  const NodeInfo& kambi = *find_node_info("KambiNavigationInfo");
  EXPECT_TRUE(is_a(kambi, "NavigationInfo"));
  EXPECT_TRUE(is_a(kambi, "X3DBindableNode"));
  EXPECT_NE(find_field_info(kambi, "headlight"), nullptr);
  EXPECT_NE(find_field_info(*find_node_info("Text3D"), "string"), nullptr);
  EXPECT_NE(find_field_info(*find_node_info("Text3D"), "depth"), nullptr);
}

TEST(NodeTable, FewNodesDeclareFieldsOfTheirOwn) {
  std::vector<std::string_view> names;
  for (const NodeInfo& node : node_table()) {
    if (node.has_interface) names.push_back(node.name);
  }
  EXPECT_EQ(names, (std::vector<std::string_view>{"ComposedShader", "Effect", "PackagedShader", "Script", "ShaderProgram"}));
}

TEST(NodeTable, TypesKnowTheirNamesAndSizes) {
  for (int i = 0; i < static_cast<int>(FieldType::unknown); ++i) {
    const auto type = static_cast<FieldType>(i);
    EXPECT_EQ(field_type(to_text(type)), type);
    EXPECT_EQ(is_multiple(type), i % 2 == 1);
    EXPECT_EQ(is_numeric(type) + is_string(type) + is_node(type), 1);
  }
  EXPECT_EQ(component_count(FieldType::MFVec3f), 3U);
  EXPECT_EQ(component_count(FieldType::SFMatrix4d), 16U);
  EXPECT_EQ(component_count(FieldType::SFImage), 0U);
  EXPECT_EQ(field_type("SFFlot"), FieldType::unknown);
}

TEST(NodeTable, EveryDefaultHasTheSizeOfItsType) {
  for (const FieldInfo& field : field_table()) {
    const FieldValue& value = default_value(field);
    const std::uint32_t components = component_count(field.type);
    if (components == 0) continue;
    EXPECT_EQ(value.numbers.size() % components, 0U) << field.name;
    if (!is_multiple(field.type)) {
      EXPECT_EQ(value.numbers.size(), components) << field.name;
    }
  }
}

TEST(NodeTable, DefaultsAreTyped) {
  const FieldValue& type = default_value(*find_field_info(*find_node_info("NavigationInfo"), "type"));
  ASSERT_EQ(type.strings.size(), 2U);
  EXPECT_EQ(type.strings[0].text(), "EXAMINE");
  EXPECT_EQ(type.strings[1].text(), "ANY");
  const FieldValue& uniform = default_value(*find_field_info(*find_node_info("Effect"), "uniformMissing"));
  ASSERT_EQ(uniform.strings.size(), 1U);
  EXPECT_EQ(uniform.strings[0].text(), "WARNING");
  EXPECT_EQ(default_value(*find_field_info(*find_node_info("Box"), "solid")).numbers[0], 1);
}

}  // namespace
}  // namespace plugc
