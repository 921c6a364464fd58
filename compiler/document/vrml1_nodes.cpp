#include "document/vrml1_nodes.h"

#include <algorithm>
#include <array>

namespace plugc {
namespace {

using Field = Vrml1FieldInfo;
using enum Vrml1Type;

constexpr std::string_view kBindings =
    "DEFAULT OVERALL PER_PART PER_PART_INDEXED PER_FACE PER_FACE_INDEXED PER_VERTEX PER_VERTEX_INDEXED";

// clang-format off

constexpr std::array kAnchor = {Field{"name", SFString}, Field{"description", SFString}, Field{"map", SFEnum, "NONE POINT"}};
constexpr std::array kAsciiText = {Field{"string", MFString}, Field{"spacing", SFFloat}, Field{"width", MFFloat},
                                   Field{"justification", SFEnum, "LEFT CENTER RIGHT"}};
constexpr std::array kBackground = {Field{"groundAngle", MFFloat}, Field{"groundColor", MFColor}, Field{"skyAngle", MFFloat},
                                    Field{"skyColor", MFColor}, Field{"backUrl", MFString}, Field{"bottomUrl", MFString},
                                    Field{"frontUrl", MFString}, Field{"leftUrl", MFString}, Field{"rightUrl", MFString},
                                    Field{"topUrl", MFString}};
constexpr std::array kBinding = {Field{"value", SFEnum, kBindings}};
constexpr std::array kCone = {Field{"parts", SFBitMask, "SIDES BOTTOM ALL"}, Field{"bottomRadius", SFFloat},
                              Field{"height", SFFloat}};
constexpr std::array kCube = {Field{"width", SFFloat}, Field{"height", SFFloat}, Field{"depth", SFFloat}};
constexpr std::array kCylinder = {Field{"parts", SFBitMask, "SIDES TOP BOTTOM ALL"}, Field{"radius", SFFloat},
                                  Field{"height", SFFloat}};
constexpr std::array kDirectionalLight = {Field{"on", SFBool}, Field{"intensity", SFFloat}, Field{"color", SFColor},
                                          Field{"direction", SFVec3f}};
constexpr std::array kFog = {Field{"color", SFColor}, Field{"fogType", SFString}, Field{"visibilityRange", SFFloat}};
constexpr std::array kFontStyle = {Field{"size", SFFloat}, Field{"family", SFEnum, "SERIF SANS TYPEWRITER"},
                                   Field{"style", SFBitMask, "NONE BOLD ITALIC"}};
constexpr std::array kIndexed = {Field{"coordIndex", MFLong}, Field{"materialIndex", MFLong}, Field{"normalIndex", MFLong},
                                 Field{"textureCoordIndex", MFLong}};
constexpr std::array kInfo = {Field{"string", SFString}};
constexpr std::array kInline = {Field{"name", SFString}, Field{"bboxSize", SFVec3f}, Field{"bboxCenter", SFVec3f}};
constexpr std::array kLod = {Field{"range", MFFloat}, Field{"center", SFVec3f}};
constexpr std::array kMaterial = {Field{"ambientColor", MFColor}, Field{"diffuseColor", MFColor},
                                  Field{"specularColor", MFColor}, Field{"emissiveColor", MFColor},
                                  Field{"shininess", MFFloat}, Field{"transparency", MFFloat}};
constexpr std::array kMatrix = {Field{"matrix", SFMatrix}};
constexpr std::array kNavigationInfo = {Field{"avatarSize", MFFloat}, Field{"headlight", SFBool}, Field{"speed", SFFloat},
                                        Field{"type", MFString}, Field{"visibilityLimit", SFFloat}};
constexpr std::array kOrthographic = {Field{"position", SFVec3f}, Field{"orientation", SFRotation},
                                      Field{"focalDistance", SFFloat}, Field{"height", SFFloat}};
constexpr std::array kPerspective = {Field{"position", SFVec3f}, Field{"orientation", SFRotation},
                                     Field{"focalDistance", SFFloat}, Field{"heightAngle", SFFloat}};
constexpr std::array kPoint2 = {Field{"point", MFVec2f}};
constexpr std::array kPoint3 = {Field{"point", MFVec3f}};
constexpr std::array kPointLight = {Field{"on", SFBool}, Field{"intensity", SFFloat}, Field{"color", SFColor},
                                    Field{"location", SFVec3f}};
constexpr std::array kPointSet = {Field{"startIndex", SFLong}, Field{"numPoints", SFLong}};
constexpr std::array kRotation = {Field{"rotation", SFRotation}};
constexpr std::array kScale = {Field{"scaleFactor", SFVec3f}};
constexpr std::array kSeparator = {Field{"renderCulling", SFEnum, "ON OFF AUTO"}};
constexpr std::array kShapeHints = {Field{"vertexOrdering", SFEnum, "UNKNOWN_ORDERING CLOCKWISE COUNTERCLOCKWISE"},
                                    Field{"shapeType", SFEnum, "UNKNOWN_SHAPE_TYPE SOLID"},
                                    Field{"faceType", SFEnum, "UNKNOWN_FACE_TYPE CONVEX"}, Field{"creaseAngle", SFFloat}};
constexpr std::array kSphere = {Field{"radius", SFFloat}};
constexpr std::array kSpotLight = {Field{"on", SFBool}, Field{"intensity", SFFloat}, Field{"color", SFColor},
                                   Field{"location", SFVec3f}, Field{"direction", SFVec3f}, Field{"dropOffRate", SFFloat},
                                   Field{"cutOffAngle", SFFloat}};
constexpr std::array kSwitch = {Field{"whichChild", SFLong}};
constexpr std::array kTexture = {Field{"filename", SFString}, Field{"image", SFImage}, Field{"wrapS", SFEnum, "REPEAT CLAMP"},
                                 Field{"wrapT", SFEnum, "REPEAT CLAMP"}};
constexpr std::array kTextureTransform = {Field{"translation", SFVec2f}, Field{"rotation", SFFloat},
                                          Field{"scaleFactor", SFVec2f}, Field{"center", SFVec2f}};
constexpr std::array kTransform = {Field{"translation", SFVec3f}, Field{"rotation", SFRotation}, Field{"scaleFactor", SFVec3f},
                                   Field{"scaleOrientation", SFRotation}, Field{"center", SFVec3f}};
constexpr std::array kTranslation = {Field{"translation", SFVec3f}};
constexpr std::array kVector = {Field{"vector", MFVec3f}};
constexpr std::array kWorldInfo = {Field{"title", SFString}, Field{"info", MFString}};

using Node = Vrml1NodeInfo;
using Kind = Vrml1Kind;
using Slot = Vrml1Slot;

constexpr Node kNodes[] = {
    {"AsciiText", Kind::shape, kAsciiText},
    {"Background", Kind::world, kBackground},
    {"Cone", Kind::shape, kCone},
    {"Coordinate3", Kind::property, kPoint3, Slot::coordinate},
    {"Cube", Kind::shape, kCube},
    {"Cylinder", Kind::shape, kCylinder},
    {"DirectionalLight", Kind::light, kDirectionalLight},
    {"Fog", Kind::world, kFog},
    {"FontStyle", Kind::property, kFontStyle, Slot::font_style},
    {"Group", Kind::group, {}},
    {"IndexedFaceSet", Kind::shape, kIndexed},
    {"IndexedLineSet", Kind::shape, kIndexed},
    {"Info", Kind::information, kInfo},
    {"LOD", Kind::lod, kLod},
    {"Material", Kind::property, kMaterial, Slot::material},
    {"MaterialBinding", Kind::property, kBinding, Slot::material_binding},
    {"MatrixTransform", Kind::transform, kMatrix},
    {"NavigationInfo", Kind::world, kNavigationInfo},
    {"Normal", Kind::property, kVector, Slot::normal},
    {"NormalBinding", Kind::property, kBinding, Slot::normal_binding},
    {"OrthographicCamera", Kind::camera, kOrthographic},
    {"PerspectiveCamera", Kind::camera, kPerspective},
    {"PointLight", Kind::light, kPointLight},
    {"PointSet", Kind::shape, kPointSet},
    {"Rotation", Kind::transform, kRotation},
    {"Scale", Kind::transform, kScale},
    {"Separator", Kind::separator, kSeparator},
    {"ShapeHints", Kind::property, kShapeHints, Slot::shape_hints},
    {"Sphere", Kind::shape, kSphere},
    {"SpotLight", Kind::light, kSpotLight},
    {"Switch", Kind::switch_group, kSwitch},
    {"Texture2", Kind::property, kTexture, Slot::texture},
    {"Texture2Transform", Kind::property, kTextureTransform, Slot::texture_transform},
    {"TextureCoordinate2", Kind::property, kPoint2, Slot::texture_coordinate},
    {"Transform", Kind::transform, kTransform},
    {"TransformSeparator", Kind::transform_separator, {}},
    {"Translation", Kind::transform, kTranslation},
    {"WWWAnchor", Kind::anchor, kAnchor},
    {"WWWInline", Kind::inlined, kInline},
    {"WorldInfo", Kind::world, kWorldInfo},
};

// clang-format on

struct TypeFacts {
  std::string_view name;
  std::size_t components;
};

constexpr std::array<TypeFacts, 18> kTypes = {{{"SFBool", 0},
                                               {"SFEnum", 0},
                                               {"SFBitMask", 0},
                                               {"SFFloat", 1},
                                               {"SFVec2f", 2},
                                               {"SFVec3f", 3},
                                               {"SFColor", 3},
                                               {"SFRotation", 4},
                                               {"SFMatrix", 16},
                                               {"SFImage", 0},
                                               {"SFString", 0},
                                               {"MFFloat", 1},
                                               {"MFLong", 1},
                                               {"MFVec2f", 2},
                                               {"MFVec3f", 3},
                                               {"MFColor", 3},
                                               {"MFString", 0},
                                               {"SFLong", 1}}};

}  // namespace

std::string_view to_text(Vrml1Type type) {
  return kTypes[static_cast<std::size_t>(type)].name;
}

bool is_multiple(Vrml1Type type) {
  return to_text(type).starts_with("MF");
}

std::size_t component_count(Vrml1Type type) {
  return kTypes[static_cast<std::size_t>(type)].components;
}

const Vrml1NodeInfo* find_vrml1_node(std::string_view name) {
  const auto* const found = std::ranges::lower_bound(kNodes, name, {}, &Vrml1NodeInfo::name);
  return found != std::end(kNodes) && found->name == name ? found : nullptr;
}

const Vrml1FieldInfo* find_field(const Vrml1NodeInfo& node, std::string_view name) {
  const auto found = std::ranges::find(node.fields, name, &Vrml1FieldInfo::name);
  return found == node.fields.end() ? nullptr : &*found;
}

}  // namespace plugc
