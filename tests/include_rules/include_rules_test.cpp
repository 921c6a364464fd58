#include "include_rules/include_rules.h"

#include <gmock/gmock.h>

namespace plugc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path kTree = PLUGC_SOURCE_DIR;

TEST(IncludeRules, TheTreeKeepsThem) {
  EXPECT_GT(count_includes(kTree), 300U) << "the tree was not found";
  EXPECT_THAT(broken_includes(kTree), IsEmpty());
}

TEST(IncludeRules, TheTableHasNoCircle) {
  std::string rooms_above = " ";
  for (const RoomRule& rule : room_rules()) {
    std::string allowed(rule.may_include);
    allowed += ' ';
    for (std::size_t begin = 0; begin + 1 < allowed.size();) {
      const std::size_t end = allowed.find(' ', begin);
      EXPECT_NE(rooms_above.find(" " + allowed.substr(begin, end - begin) + " "), std::string::npos)
          << rule.room << " may include " << allowed.substr(begin, end - begin) << ", which does not stand above it";
      begin = end + 1;
    }
    rooms_above += std::string(rule.room) + " ";
  }
}

TEST(IncludeRules, APlantedTreeBreaksThem) {
  EXPECT_THAT(
      broken_includes(kTree / "tests/include_rules/planted"),
      ElementsAre("compiler/base/opens_a_scene.cpp:2: `base` includes `scene/scene.h`; it may include no other room",
                  "compiler/compose/calls_the_judge.h:3: `compose` includes `glslang/Public/ShaderLang.h`; only `validate` may",
                  "compiler/compose/calls_the_judge.h:4: `compose` includes `compile.h`; it may include only stdlib_plugs "
                  "base document scene glsl",
                  "compiler/compose/calls_the_judge.h:6: `compose` includes `validate/validate.h`; it may include only "
                  "stdlib_plugs base document scene glsl",
                  "compiler/glsl/knows_x3d.cpp:2: `glsl` includes `../scene/node_table.h`; write it as `room/header.h`",
                  "compiler/glsl/knows_x3d.cpp:4: `glsl` includes `scene/scene.h`; it may include only base",
                  "runtime/draws_directly.cpp:2: `runtime` includes `GL/glcorearb.h`; only `runtime/gl` may",
                  "runtime/draws_directly.cpp:3: `runtime` includes `package/assemble_package.h`; it may include only base "
                  "package_file runtime/gl",
                  "runtime/gl/plans_the_frame.h:3: `runtime/gl` includes `runtime/render.h`; it may include only base "
                  "package_file"));
}

}  // namespace
}  // namespace plugc
