#include "base/file_access.h"

#include <unistd.h>

#include <fstream>

#include <gtest/gtest.h>

namespace plugc {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test: root/scene.x3dv, root/sub/a.glsl, and secret.txt beside root.
class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::canonical(fs::temp_directory_path()) /
              ("plugc_base_" + std::to_string(getpid()) + "_" + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_ / "root/sub");
    write("root/scene.x3dv", "scene");
    write("root/sub/a.glsl", "code");
    write("secret.txt", "secret");
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const fs::path& name, std::string_view text) { std::ofstream(folder_ / name) << text; }
  fs::path root() const { return folder_ / "root"; }

  fs::path folder_;
};

TEST_F(Files, ReadsAFileUnderTheRoot) {
  DiskFiles files(root());
  const FileContent content = files.read(root() / "sub/a.glsl");
  EXPECT_EQ(content.status, FileStatus::ok);
  EXPECT_EQ(content.bytes, "code");
  EXPECT_EQ(files.read(root() / "sub/../scene.x3dv").bytes, "scene");
}

TEST_F(Files, TakesARootWithASlashAtItsEnd) {
  DiskFiles files(root().string() + "/");
  EXPECT_EQ(files.read(root() / "scene.x3dv").status, FileStatus::ok);
  EXPECT_EQ(files.read(folder_ / "secret.txt").status, FileStatus::outside_root);
}

TEST_F(Files, ReadsNothingOutsideTheRoot) {
  DiskFiles files(root());
  EXPECT_EQ(files.read(folder_ / "secret.txt").status, FileStatus::outside_root);
  EXPECT_EQ(files.read(root() / "../secret.txt").status, FileStatus::outside_root);
  EXPECT_EQ(files.read(root() / "absent/../../secret.txt").status, FileStatus::outside_root);
  EXPECT_EQ(files.read("/etc/passwd").status, FileStatus::outside_root);
}

TEST_F(Files, IsNotFooledByARootsNameAsPrefix) {
  fs::create_directories(folder_ / "root2");
  write("root2/b", "b");
  EXPECT_EQ(DiskFiles(root()).read(folder_ / "root2/b").status, FileStatus::outside_root);
}

TEST_F(Files, FollowsLinksBeforeItAsksWhereTheyLead) {
  fs::create_symlink(folder_ / "secret.txt", root() / "link.txt");
  fs::create_directory_symlink(folder_, root() / "up");
  fs::create_symlink(root() / "scene.x3dv", root() / "inside.x3dv");
  DiskFiles files(root());
  EXPECT_EQ(files.read(root() / "link.txt").status, FileStatus::outside_root);
  EXPECT_EQ(files.read(root() / "up/secret.txt").status, FileStatus::outside_root);
  EXPECT_EQ(files.read(root() / "inside.x3dv").bytes, "scene");
}

TEST_F(Files, TakesARootThatIsALink) {
  fs::create_directory_symlink(root(), folder_ / "alias");
  DiskFiles files(folder_ / "alias");
  EXPECT_EQ(files.read(root() / "scene.x3dv").status, FileStatus::ok);
  EXPECT_EQ(files.read(folder_ / "alias/scene.x3dv").status, FileStatus::ok);
}

TEST_F(Files, ReportsLinksInACircleAsMissing) {
  fs::create_symlink(root() / "b", root() / "a");
  fs::create_symlink(root() / "a", root() / "b");
  EXPECT_NE(DiskFiles(root()).read(root() / "a").status, FileStatus::ok);
  EXPECT_EQ(DiskFiles("").read(root() / "a").status, FileStatus::missing);
}

TEST_F(Files, ReadsRegularFilesOnly) {
  DiskFiles files(root());
  EXPECT_EQ(files.read(root()).status, FileStatus::missing);
  EXPECT_EQ(files.read(root() / "absent").status, FileStatus::missing);
  EXPECT_EQ(DiskFiles("").read("/dev/zero").status, FileStatus::missing);
}

TEST_F(Files, ReadsAnythingWithoutARoot) {
  EXPECT_EQ(DiskFiles("").read(folder_ / "secret.txt").bytes, "secret");
}

TEST_F(Files, FindsTheRootByItsMarker) {
  write("root/.plugc.toml", "");
  EXPECT_EQ(default_root(root() / "sub/x.x3dv"), root());
}

TEST_F(Files, FallsBackToTheFolderOfTheScene) {
  EXPECT_EQ(default_root(root() / "sub/x.x3dv"), root() / "sub");
}

TEST_F(Files, TakesTheCurrentFolderWhereTheSceneLiesInIt) {
  const fs::path before = fs::current_path();
  fs::current_path(root());
  EXPECT_EQ(default_root("sub/x.x3dv"), root());
  EXPECT_EQ(default_root(folder_ / "x.x3dv"), folder_);
  write("root/sub/.plugc.toml", "");
  EXPECT_EQ(default_root("sub/x.x3dv"), root() / "sub");
  fs::current_path(before);
}

TEST_F(Files, ReadsAUrlOrSaysWhyNot) {
  SourceSet sources;
  const SourceId id = sources.add("scene.x3dv", "url");
  Diagnostics diagnostics(sources);
  DiskFiles files(root());
  const auto read = [&](std::string_view url) { return read_url(files, url, root() / "scene.x3dv", {id, 0, 3}, diagnostics); };
  EXPECT_EQ(read("sub/a.glsl"), "code");
  EXPECT_EQ(read("absent.glsl"), std::nullopt);
  EXPECT_EQ(read("../secret.txt"), std::nullopt);
  EXPECT_EQ(read("http://x.org/a"), std::nullopt);
  ASSERT_EQ(diagnostics.all().size(), 3U);
  EXPECT_EQ(to_text(diagnostics.all()[0], sources),
            "scene.x3dv:1:1: error: cannot read `absent.glsl` [file-unreadable]\n  url\n  ^~~\n");
  EXPECT_EQ(diagnostics.all()[1].message,
            "`../secret.txt` leads outside the folder that this scene may read; `--root DIR` names a wider one");
  EXPECT_EQ(diagnostics.all()[2].message, "`http://x.org/a` is no local file; plugc reads no network");
}

TEST_F(Files, ResolvesUrlsBesideTheirFile) {
  EXPECT_EQ(resolve_url("a.png", "/s/scene.x3dv"), fs::path("/s/a.png"));
  EXPECT_EQ(resolve_url("../t/a%20b.png", "/s/scene.x3dv"), fs::path("/t/a b.png"));
  EXPECT_EQ(resolve_url("/t/a.png", "/s/scene.x3dv"), fs::path("/t/a.png"));
  EXPECT_EQ(resolve_url("file:///t/a.png", "/s/scene.x3dv"), fs::path("/t/a.png"));
  EXPECT_EQ(resolve_url("file://host/t/a.png", "/s/scene.x3dv"), fs::path("/t/a.png"));
  EXPECT_EQ(resolve_url("file:a.png", "/s/scene.x3dv"), fs::path("/s/a.png"));
  EXPECT_EQ(resolve_url("a.png", "scene.x3dv"), fs::path("a.png"));
}

TEST_F(Files, DropsTheFragmentOfAUrlAndKeepsAnEscapedHash) {
  EXPECT_EQ(resolve_url("lib.x3dv#Lamp", "/s/scene.x3dv"), fs::path("/s/lib.x3dv"));
  EXPECT_EQ(resolve_url("a%23b.png", "/s/scene.x3dv"), fs::path("/s/a#b.png"));
}

TEST_F(Files, ResolvesNoUrlOfAnotherScheme) {
  EXPECT_EQ(resolve_url("http://x.org/a.png", "/s/scene.x3dv"), std::nullopt);
  EXPECT_EQ(resolve_url("urn:web3d:a", "/s/scene.x3dv"), std::nullopt);
  EXPECT_EQ(resolve_url("data:text/plain,a", "/s/scene.x3dv"), std::nullopt);
  EXPECT_EQ(resolve_url("a%00.png", "/s/scene.x3dv"), std::nullopt);
}

TEST_F(Files, DecodesPercentSigns) {
  EXPECT_EQ(percent_decode("a%20b%2Fc%c3%a4"), "a b/c\xC3\xA4");
  EXPECT_EQ(percent_decode("100%"), "100%");
  EXPECT_EQ(percent_decode("%4"), "%4");
  EXPECT_EQ(percent_decode("%zz%41"), "%zzA");
  EXPECT_EQ(percent_decode("%%41"), "%A");
}

TEST_F(Files, ServesFilesFromMemory) {
  MemoryFiles files;
  files.files["dir/a"] = "x";
  EXPECT_EQ(files.read("dir/./sub/../a").bytes, "x");
  EXPECT_EQ(files.read("dir/b").status, FileStatus::missing);
}

}  // namespace
}  // namespace plugc
