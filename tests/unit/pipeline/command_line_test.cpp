// The program itself: its exit status, its streams, its formats.

#include <sys/stat.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "image/image.h"
#include "support/compile_text.h"
#include "support/draw_package.h"

namespace plugc {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Ended {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs plugc in the folder, without its caches.
Ended run_plugc(const SceneFolder& folder, std::string_view arguments) {
  const std::string command =
      fmt::format("cd {} && PLUGC_CACHE_DIR=cache {} {} >out.txt 2>err.txt", folder.path().string(), PLUGC_CLI, arguments);
  const int result = std::system(command.c_str());
  return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, read_file(folder.path() / "out.txt"),
          read_file(folder.path() / "err.txt")};
}

/// The colour in the middle of a picture of 32 by 32 pixels.
Color middle_of(const SceneFolder& folder, std::string_view name) {
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const auto image = decode_image(read_file(folder.path() / name), name, {}, diagnostics);
  if (!image || image->width != 32 || image->height != 32) return {-1, -1, -1};
  const std::size_t middle = (16 * 32 + 16) * std::size_t{image->channels};
  return {image->pixels[middle], image->pixels[middle + 1], image->pixels[middle + 2]};
}

constexpr std::string_view kFine = R"(#X3D V4.0 utf8
Shape {
  appearance Appearance {
    material UnlitMaterial { emissiveColor 1 1 1 }
    effects Effect { parts EffectPart { type "FRAGMENT" url "data:text/plain,
void PLUG_fragment_modify(inout vec4 c) { c.r = 0.5; }" } }
  }
  geometry Box { }
}
)";

// Three mistakes, each at a line and column of its own, and a fourth effect that works.
constexpr std::string_view kFaulty = R"(#X3D V4.0 utf8
Shape {
  appearance Appearance {
    material UnlitMaterial { emissiveColor 1 1 1 }
    effects [
      Effect { language "CG" parts EffectPart { type "FRAGMENT" url "data:text/plain,float4 main() { }" } }
      Effect { language "GLSL" parts EffectPart { type "PIXEL" url "data:text/plain,void PLUG_fragment_modify(inout vec4 c) { }" } }
      Effect { language "GLSL" parts EffectPart { type "FRAGMENT" url "data:text/plain,
void helper() { }
  void PLUG_fragment_modfy(inout vec4 c) { c.r = 0.0; }" } }
      Effect { language "GLSL" parts EffectPart { type "FRAGMENT" url "data:text/plain,
void PLUG_fragment_modify(inout vec4 c) { c.r = 0.5; }" } }
    ]
  }
  geometry Box { }
}
)";

TEST(CommandLine, LintNamesEveryMistakeWhereItStands) {
  const SceneFolder folder;
  folder.write("faulty.x3dv", kFaulty);
  const Ended run = run_plugc(folder, "lint faulty.x3dv");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("faulty.x3dv:6:25: warning: an effect in language `CG` is passed over"));
  EXPECT_THAT(run.err, HasSubstr("faulty.x3dv:7:56: error: `PIXEL` is no shader stage"));
  EXPECT_THAT(
      run.err,
      HasSubstr("faulty.x3dv:10:8: error: no plug `fragment_modfy` in a fragment stage; did you mean `fragment_modify`?"));
  EXPECT_EQ(run.out, "1 files, 2 errors, 1 warnings, 0 notes\n");
}

TEST(CommandLine, TheFaultySceneIsDrawnWithTheEffectThatWorks) {
  const SceneFolder folder;
  folder.write("faulty.x3dv", kFaulty);
  EXPECT_EQ(run_plugc(folder, "preview faulty.x3dv -o picture.png --size 32x32").status, 1);
  EXPECT_THAT(middle_of(folder, "picture.png"), IsColor(Color{128, 255, 255}));
}

constexpr std::string_view kSwitched = R"(#X3D V4.0 utf8
Shape {
  appearance Appearance {
    material UnlitMaterial { emissiveColor 1 1 1 }
    effects DEF Tint Effect { inputOutput SFColor color 1 0 0 parts EffectPart { type "FRAGMENT" url "data:text/plain,
uniform vec3 color;
void PLUG_fragment_modify(inout vec4 c) { c.rgb = color; }" } }
  }
  geometry Box { }
}
)";

TEST(CommandLine, PreviewShowsAnotherState) {
  const SceneFolder folder;
  folder.write("scene.x3dv", kSwitched);
  EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o on.png --size 32x32").status, 0);
  EXPECT_THAT(middle_of(folder, "on.png"), IsColor(Color{255, 0, 0}));
  EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o off.png --size 32x32 --set Tint.enabled=FALSE").status, 0);
  EXPECT_THAT(middle_of(folder, "off.png"), IsColor(Color{255, 255, 255}));
  EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o blue.png --size 32x32 --set 'Tint.color=0 0 1'").status, 0);
  EXPECT_THAT(middle_of(folder, "blue.png"), IsColor(Color{0, 0, 255}));
}

constexpr std::string_view kReddening = R"(#X3D V4.0 utf8
DEF Clock TimeSensor { loop TRUE cycleInterval 4 }
DEF Fade ScalarInterpolator { key [0 1] keyValue [0 1] }
Shape {
  appearance Appearance {
    material UnlitMaterial { emissiveColor 0 0 1 }
    effects DEF Tint Effect { inputOutput SFFloat amount 1 parts EffectPart { type "FRAGMENT" url "data:text/plain,
uniform float amount;
void PLUG_fragment_modify(inout vec4 c) { c.r = amount; }" } }
  }
  geometry Box { }
}
ROUTE Clock.fraction_changed TO Fade.set_fraction
ROUTE Fade.value_changed TO Tint.amount
)";

TEST(CommandLine, PreviewDrawsAnyTime) {
  const SceneFolder folder;
  folder.write("scene.x3dv", kReddening);
  EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o begin.png --size 32x32").status, 0);
  EXPECT_THAT(middle_of(folder, "begin.png"), IsColor(Color{255, 0, 255})) << "no clock has ticked";
  EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o later.png --size 32x32 --time 9").status, 0);
  EXPECT_THAT(middle_of(folder, "later.png"), IsColor(Color{64, 0, 255}));
  for (const std::string wrong : {"--time -1", "--time nan", "--step -1", "--step inf", "--frames 0"})
    EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o no.png " + wrong).status, 2) << wrong;
}

TEST(CommandLine, PreviewDrawsASeries) {
  const SceneFolder folder;
  folder.write("scene.x3dv", kReddening);
  EXPECT_EQ(run_plugc(folder, "preview scene.x3dv -o film.png --size 32x32 --time 1 --frames 3 --step 0.5").status, 0);
  EXPECT_THAT(middle_of(folder, "film0000.png"), IsColor(Color{64, 0, 255}));
  EXPECT_THAT(middle_of(folder, "film0001.png"), IsColor(Color{96, 0, 255}));
  EXPECT_THAT(middle_of(folder, "film0002.png"), IsColor(Color{128, 0, 255}));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "film0003.png"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "film.png"));
  const Ended refused = run_plugc(folder, "preview scene.x3dv -o nowhere/film.png --size 32x32 --frames 3");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("cannot write `nowhere/film0000.png`"));
}

constexpr std::string_view kLibrary = R"(#X3D V4.0 utf8
DEF Tint Effect { language "GLSL" inputOutput SFColor tint 1 0.5 0 parts EffectPart { type "FRAGMENT" url "data:text/plain,
uniform vec3 tint;
void PLUG_fragment_modify(inout vec4 c) { c.rgb = tint; /* PLUG: after_tint (c) */ }" } }
DEF Blue Effect { language "GLSL" parts EffectPart { type "LIGHT" url "data:text/plain,
void PLUG_lighting_apply(inout vec4 color, const vec4 vertex_eye, const vec3 normal_eye) { color.rgb = vec3(0.0, 0.0, 1.0); }" } }
)";

TEST(CommandLine, AFolderOfEffectsIsALibrary) {
  const SceneFolder folder;
  folder.write("effects/all.x3dv", kLibrary);
  EXPECT_EQ(run_plugc(folder, "build effects -o lib.plugpack").status, 0);
  const Ended listed = run_plugc(folder, "inspect lib.plugpack");
  EXPECT_EQ(listed.status, 0);
  EXPECT_THAT(listed.out, HasSubstr("Tint (all.x3dv:2)\n  needs fragment_modify; offers after_tint\n  field tint = 1 0.5 0\n"));
  EXPECT_THAT(listed.out, HasSubstr("Blue (all.x3dv:5)\n  needs lighting_apply; offers nothing\n"));
  EXPECT_EQ(run_plugc(folder, "preview lib.plugpack -o first.png --size 32x32").status, 0);
  EXPECT_THAT(middle_of(folder, "first.png"), IsColor(Color{255, 128, 0}));
  EXPECT_EQ(run_plugc(folder, "preview lib.plugpack --effect Blue --on sphere -o blue.png --size 32x32").status, 0);
  EXPECT_THAT(middle_of(folder, "blue.png"), IsColor(Color{0, 0, 255}));
  const Ended missing = run_plugc(folder, "preview lib.plugpack --effect Green -o x.png");
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, HasSubstr("there is no effect `Green`"));
}

TEST(CommandLine, APackageChangesOnlyWhatWasBuiltDynamic) {
  const SceneFolder folder;
  folder.write("scene.x3dv", kSwitched);
  EXPECT_EQ(run_plugc(folder, "build scene.x3dv -o scene.plugpack --dynamic Tint.enabled").status, 0);
  EXPECT_EQ(run_plugc(folder, "preview scene.plugpack -o off.png --size 32x32 --set Tint.enabled=FALSE").status, 0);
  EXPECT_THAT(middle_of(folder, "off.png"), IsColor(Color{255, 255, 255}));
  const Ended refused = run_plugc(folder, "preview scene.plugpack -o no.png --size 32x32 --set 'Tint.color=0 0 1'");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("the package does not let a host change `Tint.color`"));
  for (const std::string_view wrong : {"Tint.color", "Tint=1", "Tint.=1", "Tint.enabled=", "Tint.enabled=maybe"}) {
    const Ended run = run_plugc(folder, fmt::format("preview scene.plugpack -o no.png --set '{}'", wrong));
    EXPECT_EQ(run.status, 2) << wrong;
    EXPECT_THAT(run.err, HasSubstr("sets nothing")) << wrong;
  }
  EXPECT_EQ(run_plugc(folder, "build scene.x3dv -o scene.plugpack --dynamic Tint.enable").status, 1);
}

TEST(CommandLine, ExitStatusTellsMistakesOfTheInputFromThoseOfTheCommand) {
  const SceneFolder folder;
  folder.write("fine.x3dv", kFine);
  folder.write("faulty.x3dv", kFaulty);
  EXPECT_EQ(run_plugc(folder, "build fine.x3dv -o fine.plugpack").status, 0);
  EXPECT_EQ(run_plugc(folder, "lint fine.x3dv").status, 0);
  EXPECT_EQ(run_plugc(folder, "build faulty.x3dv -o faulty.plugpack").status, 1);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "faulty.plugpack"));
  for (const std::string_view wrong :
       {"", "bild fine.x3dv", "build fine.x3dv", "build missing.x3dv -o x", "build fine.x3dv -o no/such/folder/x",
        "lint --format yaml fine.x3dv", "preview fine.x3dv -o x.png --size huge"}) {
    const Ended run = run_plugc(folder, wrong);
    EXPECT_EQ(run.status, 2) << wrong;
    EXPECT_NE(run.err, "") << wrong;
  }
}

TEST(CommandLine, HelpIsNoMistake) {
  const SceneFolder folder;
  const Ended all = run_plugc(folder, "--help");
  EXPECT_EQ(all.status, 0);
  for (const std::string verb : {"build", "lint", "preview", "inspect"}) {
    EXPECT_THAT(all.out, HasSubstr(verb));
    const Ended run = run_plugc(folder, verb + " --help");
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, HasSubstr("Example: plugc " + verb));
  }
  EXPECT_THAT(run_plugc(folder, "--version").out, HasSubstr("plugc "));
}

TEST(CommandLine, LintWritesJson) {
  const SceneFolder folder;
  folder.write("faulty.x3dv", kFaulty);
  const Ended run = run_plugc(folder, "lint --format json faulty.x3dv");
  EXPECT_EQ(run.status, 1);
  const Json list = Json::parse(run.out, nullptr, false);
  ASSERT_TRUE(list.is_array());
  ASSERT_EQ(list.size(), 3U);
  const Json& unknown_plug = list[2];
  EXPECT_EQ(unknown_plug["code"], "effect-unknown-plug");
  EXPECT_EQ(unknown_plug["severity"], "error");
  EXPECT_EQ(unknown_plug["file"], "faulty.x3dv");
  EXPECT_EQ(unknown_plug["line"], 10);
  EXPECT_EQ(unknown_plug["column"], 8);
  EXPECT_EQ(unknown_plug["end_column"], 27);
}

TEST(CommandLine, LintWritesSarif) {
  const SceneFolder folder;
  folder.write("faulty.x3dv", kFaulty);
  const Json log = Json::parse(run_plugc(folder, "lint --format sarif faulty.x3dv").out, nullptr, false);
  ASSERT_TRUE(log.is_object());
  EXPECT_EQ(log["version"], "2.1.0");
  const Json& sarif_run = log["runs"][0];
  EXPECT_EQ(sarif_run["tool"]["driver"]["name"], "plugc");
  ASSERT_EQ(sarif_run["results"].size(), 3U);
  const Json& region = sarif_run["results"][2]["locations"][0]["physicalLocation"]["region"];
  EXPECT_EQ(region["startLine"], 10);
  EXPECT_EQ(region["startColumn"], 8);
}

TEST(CommandLine, LintWritesGithubCommands) {
  const SceneFolder folder;
  folder.write("faulty.x3dv", kFaulty);
  const std::string out = run_plugc(folder, "lint --format github faulty.x3dv").out;
  EXPECT_THAT(out, HasSubstr("::error file=faulty.x3dv,line=10,col=8::no plug `fragment_modfy`"));
  std::istringstream lines(out);
  const std::regex command(R"(::(error|warning|notice)( file=[^,]+,line=\d+,col=\d+)?::.+ \[[a-z-]+\])");
  for (std::string line; std::getline(lines, line);) EXPECT_TRUE(std::regex_match(line, command)) << line;
}

TEST(CommandLine, APackagePreviewsAsItsScene) {
  const SceneFolder folder;
  folder.write("fine.x3dv", kFine);
  EXPECT_EQ(run_plugc(folder, "build fine.x3dv -o fine.plugpack").status, 0);
  EXPECT_EQ(run_plugc(folder, "preview fine.x3dv -o scene.png --size 64x36").status, 0);
  EXPECT_EQ(run_plugc(folder, "preview fine.plugpack -o package.png --size 64x36").status, 0);
  const std::string picture = read_file(folder.path() / "scene.png");
  EXPECT_NE(picture, "");
  EXPECT_EQ(picture, read_file(folder.path() / "package.png"));
}

TEST(CommandLine, WhatIsNoFileIsNotWaitedFor) {
  const SceneFolder folder;
  ASSERT_EQ(mkfifo((folder.path() / "pipe.x3dv").c_str(), 0600), 0);
  for (const std::string_view verb : {"build {} -o out.plugpack", "lint {}", "preview {} -o out.png", "inspect {}",
                                      "inspect {} --dump document", "inspect {} --program 0"}) {
    for (const std::string_view path : {"pipe.x3dv", "/dev/zero"}) {
      const Ended run = run_plugc(folder, fmt::format(fmt::runtime(verb), path));
      EXPECT_NE(run.status, 0) << verb;
      EXPECT_THAT(run.err, HasSubstr(path)) << verb;
    }
  }
}

TEST(CommandLine, ADamagedPackageIsRefused) {
  const SceneFolder folder;
  folder.write("fine.x3dv", kFine);
  EXPECT_EQ(run_plugc(folder, "build fine.x3dv -o fine.plugpack").status, 0);
  std::string bytes = read_file(folder.path() / "fine.plugpack");
  bytes[bytes.size() / 2] ^= 1;
  folder.write("damaged.plugpack", bytes);
  const Ended run = run_plugc(folder, "preview damaged.plugpack -o picture.png");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("damaged.plugpack: content hash differs"));
}

TEST(CommandLine, AShadowMethodIsAWordAndPerhapsASize) {
  const SceneFolder folder;
  folder.write("fine.x3dv", kFine);
  EXPECT_EQ(run_plugc(folder, "lint fine.x3dv --shadows pcf3,512").status, 0);
  const std::pair<std::string_view, std::string_view> wrong[] = {
      {"bilinaer", "there is no method `bilinaer`; did you mean `bilinear`?"},
      {"soft", "there is no method `soft`; there are hard, bilinear, "},
      {"pcf3,0", "`0` is no size of a shadow map; write a whole number from 1 to 8192"},
      {"pcf3,", "`` is no size of a shadow map"}};
  for (const auto& [shadows, message] : wrong) {
    const Ended run = run_plugc(folder, fmt::format("lint fine.x3dv --shadows {}", shadows));
    EXPECT_EQ(run.status, 2) << shadows;
    EXPECT_THAT(run.out + run.err, HasSubstr(message));
  }
}

TEST(CommandLine, AShadowMethodCannotChangeAPackage) {
  const SceneFolder folder;
  folder.write("fine.x3dv", kFine);
  run_plugc(folder, "build fine.x3dv -o fine.plugpack");
  for (const std::string_view verb : {"preview fine.plugpack -o fine.png", "inspect fine.plugpack"}) {
    const Ended run = run_plugc(folder, fmt::format("{} --shadows pcf3", verb));
    EXPECT_EQ(run.status, 2) << verb;
    EXPECT_THAT(run.err, HasSubstr("`--shadows` is decided when a package is built"));
  }
}

constexpr std::string_view kShadowed = R"(#X3D V4.0 utf8
NavigationInfo { headlight FALSE }
Viewpoint { position 0 9 11 orientation 1 0 0 -0.68 }
DEF Sun DirectionalLight { direction -0.5 -1 -0.3 shadows TRUE }
Shape { appearance Appearance { material Material { } } geometry Box { size 3 1 3 } }
Transform { translation 0 -1 0 children Shape { appearance Appearance { material Material { } } geometry Box { size 30 1 30 } } }
)";

TEST(CommandLine, BuildChoosesShadowsForAnErrorAndTellsWhy) {
  const SceneFolder folder;
  folder.write("scene.x3dv", kShadowed);
  const Ended run = run_plugc(folder, "build scene.x3dv -o scene.plugpack --shadow-error 1% --size 160x90");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, testing::ContainsRegex(
                           "shadow of `Sun`: [a-z0-9]+ [0-9]+, slope scale [0-9]: 0[.][0-9]+ % of pixels wrong, 1 % allowed"));
  EXPECT_THAT(run.out, HasSubstr("<- taken"));
  const Ended inspected = run_plugc(folder, "inspect scene.plugpack --dump package");
  EXPECT_THAT(inspected.out, testing::ContainsRegex("chosen for at most 1 % of wrong pixels: 0[.][0-9]+ % in 1 view,"));
}

TEST(CommandLine, AShadowErrorIsAPercentage) {
  const SceneFolder folder;
  folder.write("scene.x3dv", kShadowed);
  for (const std::string_view wrong : {"0.5", "0%", "100%", "few"}) {
    const Ended run = run_plugc(folder, fmt::format("build scene.x3dv -o scene.plugpack --shadow-error {}", wrong));
    EXPECT_EQ(run.status, 2) << wrong;
    EXPECT_THAT(run.out + run.err,
                HasSubstr(fmt::format("`{}` is no share of wrong pixels; write a percentage, e.g. 0.5%", wrong)));
  }
  const Ended size = run_plugc(folder, "build scene.x3dv -o scene.plugpack --shadow-error 1% --size 0x90");
  EXPECT_EQ(size.status, 2);
  EXPECT_THAT(size.err, HasSubstr("`--size 0x90` is no size"));
}

TEST(CommandLine, InspectWritesTheSceneInEachEncoding) {
  const SceneFolder folder;
  folder.write("fine.x3dv", kFine);
  const auto written = [&](const std::string& scene, const std::string& encoding) {
    const Ended run = run_plugc(folder, "inspect " + scene + " --dump document --as " + encoding);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  };
  const std::string classic = written("fine.x3dv", "classic");
  EXPECT_THAT(classic, testing::StartsWith("#X3D V4.0 utf8\n"));
  folder.write("fine.x3d", written("fine.x3dv", "xml"));
  folder.write("fine.json", written("fine.x3d", "json"));
  EXPECT_TRUE(Json::parse(read_file(folder.path() / "fine.json")).contains("X3D"));
  EXPECT_EQ(written("fine.json", "classic"), classic);
  const Ended run = run_plugc(folder, "inspect fine.x3dv --as xml");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "plugc: `--as` writes a document; add `--dump document`\n");
}

TEST(CommandLine, AnyNumberOfJobsSaysAndMakesTheSame) {
  const SceneFolder folder;
  for (const int number : {1, 2, 3, 4, 5}) {
    folder.write(fmt::format("scenes/fine_{}.x3dv", number), kFine);
    folder.write(fmt::format("scenes/faulty_{}.x3dv", number), kFaulty);
  }
  const Ended one = run_plugc(folder, "lint --no-cache -j 1 scenes");
  EXPECT_THAT(one.err, HasSubstr("faulty_5.x3dv"));
  const std::string all =
      "scenes/fine_1.x3dv scenes/faulty_2.x3dv scenes/fine_3.x3dv --no-cache --target glsl330,essl300,spirv";
  run_plugc(folder, "build " + all + " -j 1 -o 1.plugpack");
  for (const std::string jobs : {"2", "4"}) {
    const Ended several = run_plugc(folder, "lint --no-cache -j " + jobs + " scenes");
    EXPECT_EQ(several.status, one.status);
    EXPECT_EQ(several.err, one.err);
    EXPECT_EQ(several.out, one.out);
    run_plugc(folder, "build " + all + " -j " + jobs + " -o " + jobs + ".plugpack");
    EXPECT_EQ(read_file(folder.path() / (jobs + ".plugpack")), read_file(folder.path() / "1.plugpack"));
  }
}

}  // namespace
}  // namespace plugc
