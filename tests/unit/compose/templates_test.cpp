#include "compose/templates.h"

#include <gmock/gmock.h>

#include <future>
#include <vector>

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
    if (!file.name.starts_with("templates/") && !file.name.starts_with("shadows/")) continue;
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
  const auto made = library.get("light.glsl", {"POSITIONAL", "SPOT", "ATTENUATION"}, 3);
  const auto upgraded = make_code_unit(made->text, ShaderStage::fragment);
  EXPECT_THAT(made->castle_names, testing::Contains("castle_LightSource3Color"));
  EXPECT_EQ(made->castle_names, upgraded->castle_names);
}

/// Forms of templates are shared by all source sets of a process; a place in one is a place in each of them.
TEST(Templates, AreTheSameInEverySourceSet) {
  SourceSet first, second;
  second.add("scene.x3dv", "a file of its own, so that numbers of files differ");
  TemplateLibrary one(first), other(second);
  const auto made = one.get("light.glsl", {"SPOT"}, 1);
  EXPECT_EQ(other.get("light.glsl", {"SPOT"}, 1), made);
  const Span place = made->span(0, 10);
  EXPECT_EQ(first.name(place.source), "plugc:/templates/light.glsl");
  EXPECT_EQ(second.name(place.source), "plugc:/templates/light.glsl");
  EXPECT_EQ(second.text(place), first.text(place));
}

TEST(Templates, MayBeAskedForByManyThreads) {
  const auto make_all = [] {
    SourceSet sources;
    TemplateLibrary library(sources);
    std::string text;
    for (int number = 0; number < 200; ++number)
      text += library.get("light.glsl", {"POSITIONAL", "ATTENUATION"}, number)->text.text();
    return text;
  };
  std::vector<std::future<std::string>> threads;
  for (int i = 0; i < 4; ++i) threads.push_back(std::async(std::launch::async, make_all));
  const std::string wanted = make_all();
  for (auto& thread : threads) EXPECT_EQ(thread.get(), wanted);
}

}  // namespace
}  // namespace plugc
