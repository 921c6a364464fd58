// Each scene is a head, as many repeated pieces as the size asks for, and a tail.

#include "read_scenes.h"

#include <cmath>

#include <fmt/format.h>

namespace plugc {
namespace {

struct Frame {
  std::string_view head, tail;
};

Frame numbers_frame(Encoding encoding) {
  switch (encoding) {
    case Encoding::xml:
      return {"<X3D version='4.0'>\n<Scene>\n<Shape>\n<PointSet><Coordinate point='\n",
              "'/></PointSet>\n</Shape>\n</Scene>\n</X3D>\n"};
    case Encoding::json:
      return {R"({ "X3D": { "@version": "4.0", "Scene": { "-children": [ { "Shape": { "-geometry": { "PointSet": { "-coord":
 { "Coordinate": { "@point": [
)",
              "0, 0, 0 ] } } } } } } ] } } }\n"};
    default:
      return {"#X3D V4.0 utf8\nPROFILE Interchange\nShape { geometry PointSet { coord Coordinate { point [\n", "] } } }\n"};
  }
}

Frame nodes_frame(Encoding encoding) {
  switch (encoding) {
    case Encoding::xml: return {"<X3D version='4.0'>\n<Scene>\n  <Group>\n", "  </Group>\n</Scene>\n</X3D>\n"};
    case Encoding::json:
      return {R"({ "X3D": { "@version": "4.0", "Scene": { "-children": [ { "Group": { "-children": [
)",
              R"({ "Group": { } } ] } } ] } } }
)"};
    default: return {"#X3D V4.0 utf8\nPROFILE Interchange\nGroup {\n  children [\n", "  ]\n}\n"};
  }
}

constexpr std::string_view kClassicShape = R"(    Transform {{
      translation {0:.3f} 0.25 {1:.2f}
      children [
        Shape {{
          appearance Appearance {{
            material Material {{
              diffuseColor 0.5 {2:.2f} 0.75
            }}
          }}
          geometry Box {{
            size 1 2 {2:.2f}
          }}
        }}
      ]
    }}
)";
constexpr std::string_view kXmlShape = R"(    <Transform translation='{0:.3f} 0.25 {1:.2f}'>
      <Shape>
        <Appearance>
          <Material diffuseColor='0.5 {2:.2f} 0.75'/>
        </Appearance>
        <Box size='1 2 {2:.2f}'/>
      </Shape>
    </Transform>
)";
constexpr std::string_view kJsonShape = R"(    {{
      "Transform": {{
        "@translation": [ {0:.3f}, 0.25, {1:.2f} ],
        "-children": [
          {{
            "Shape": {{
              "-appearance": {{
                "Appearance": {{
                  "-material": {{
                    "Material": {{
                      "@diffuseColor": [ 0.5, {2:.2f}, 0.75 ]
                    }}
                  }}
                }}
              }},
              "-geometry": {{
                "Box": {{
                  "@size": [ 1, 2, {2:.2f} ]
                }}
              }}
            }}
          }}
        ]
      }}
    }},
)";

std::string_view shape_format(Encoding encoding) {
  if (encoding == Encoding::xml) return kXmlShape;
  return encoding == Encoding::json ? kJsonShape : kClassicShape;
}

}  // namespace

std::string numbers_scene(Encoding encoding, std::size_t bytes) {
  const Frame frame = numbers_frame(encoding);
  std::string text(frame.head);
  for (int i = 0; text.size() + frame.tail.size() < bytes; ++i) {
    const double x = std::sin(i), y = i % 100'000 * 0.37, z = -std::cos(i) * 100;
    text += encoding == Encoding::json ? fmt::format("{:.6f}, {:.5f}, {:.4f},\n", x, y, z)
                                       : fmt::format("{:.6f} {:.5f} {:.4f},\n", x, y, z);
  }
  return text.append(frame.tail);
}

std::string nodes_scene(Encoding encoding, std::size_t bytes) {
  const Frame frame = nodes_frame(encoding);
  std::string text(frame.head);
  for (int i = 0; text.size() + frame.tail.size() < bytes; ++i) {
    text += fmt::format(fmt::runtime(shape_format(encoding)), i % 1000 * 0.125, i / 1000 * 0.25, 0.1 + i % 90 * 0.01);
  }
  return text.append(frame.tail);
}

}  // namespace plugc
