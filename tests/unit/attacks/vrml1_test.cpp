// VRML 1.0: what one node says may be asked for by every shape behind it, and a USE may write it anew.

#include "attack.h"

namespace plugc {
namespace {

std::string vrml1_scene(const std::string& nodes) {
  return "#VRML V1.0 ascii\n" + nodes;
}

TEST(Attacks, AFieldGivenOverAndOverIsNotReadForEachShape) {
  const auto scene = [](std::size_t size) {
    return vrml1_scene("Material {" + repeated(" shininess 1", size) + " }\n" + repeated("Cube { }\n", size));
  };
  EXPECT_LT(growth(scene, 2'000), kLinear);
}

TEST(Attacks, ListsOfAMaterialAreNotReadForEachShape) {
  const auto lines = [](std::size_t size) {
    return vrml1_scene("Material { emissiveColor [" + repeated(" 0 0 0", 20 * size) + " ] }\n" +
                       repeated("IndexedLineSet { }\n", size));
  };
  EXPECT_LT(growth(lines, 500), kLinear);
  const auto faces = [](std::size_t size) {
    return vrml1_scene("MaterialBinding { value PER_FACE }\nMaterial { transparency [" + repeated(" 0", 60 * size) +
                       " ] diffuseColor [ 1 0 0, 0 1 0 ] }\n" + repeated("Sphere { }\n", size));
  };
  EXPECT_LT(growth(faces, 500), kLinear);
}

TEST(Attacks, WordsOfASetAreNotReadForEachVisit) {
  const auto scene = [](std::size_t size) {
    return vrml1_scene("DEF C Cylinder { parts (SIDES" + repeated("|SIDES", 20 * size) + ") }\n" +
                       repeated("Material { } USE C\n", size));
  };
  EXPECT_LT(growth(scene, 500), kLinear);
}

/// Each USE meets another material, so that the group is written anew, under a name of its own.
TEST(Attacks, ALongNameIsNotKeptForEachVisit) {
  const std::size_t peak = peak_of([] {
    const auto built = build(vrml1_scene("DEF S Separator { DEF " + std::string(100'000, 'n') + " Cube { } }\n" +
                                         repeated("Material { } USE S\n", 2'000)));
    if (count_of(built->diagnostics, DiagnosticId::syntax) != 1 || built->graph.size() < 2'000) _exit(1);
  });
  expect_peak(peak, std::size_t{100} << 20);
}

}  // namespace
}  // namespace plugc
