#include "compose/templates.h"

#include <gmock/gmock.h>

#include "stdlib_plugs/stdlib_plugs.h"

namespace plugc {
namespace {

/// The text with the lines of all branches.
std::string with_all_branches(std::string_view text) {
  std::string all;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string_view line = text.substr(begin, end - begin);
    if (!line.starts_with("#if") && !line.starts_with("#else") && !line.starts_with("#endif")) all += line;
    begin = end;
  }
  return all;
}

TEST(Templates, NeedNoUpgrading) {
  int templates = 0;
  for (const StdlibFile& file : stdlib_files()) {
    if (!file.name.starts_with("templates/")) continue;
    ++templates;
    for (const ShaderStage stage : {ShaderStage::vertex, ShaderStage::fragment}) {
      MappedText text;
      text.append_generated(with_all_branches(file.text));
      EXPECT_EQ(upgrade(text, stage, {}).text.text(), text.text()) << file.name;
    }
  }
  EXPECT_GT(templates, 0);
}

TEST(Templates, NameWhatUpgradingWouldName) {
  SourceSet sources;
  TemplateLibrary library(sources);
  const auto made = library.get("light.glsl", ShaderStage::fragment, {"POSITIONAL", "SPOT", "ATTENUATION"}, 3);
  const auto upgraded = make_code_unit(made->text, ShaderStage::fragment);
  EXPECT_THAT(made->castle_names, testing::Contains("castle_LightSource3Color"));
  EXPECT_EQ(made->castle_names, upgraded->castle_names);
}

}  // namespace
}  // namespace plugc
