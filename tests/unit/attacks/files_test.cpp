// Files that a scene has no business with, named in every way that a scene can name a file: nothing of them is read or
// quoted, and nothing waits for what never comes.

#include <sys/stat.h>
#include <zlib.h>

#include <filesystem>

#include <fmt/format.h>

#include "attack.h"
#include "base/limits.h"
#include "image/load_images.h"
#include "scene/scene.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSecret = "TOP-SECRET-WORDS";

/// root/ with a scene in it; beside it secret.txt and the folder out/.
class FileAttacks : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::canonical(fs::temp_directory_path()) / fmt::format("plugc_attacks_{}_{}", getpid(), test_name());
    fs::create_directories(folder_ / "root/sub");
    fs::create_directories(folder_ / "out");
    write("secret.txt", kSecret);
    write("out/secret.x3dv", classic_scene(std::string("PROTO ") + kSecret + " [ ] { " + kSecret + " { } }"));
  }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string test_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
  void write(const fs::path& name, std::string_view text) { std::ofstream(folder_ / name, std::ios::binary) << text; }

  /// Everything that is said, excerpts too, when a scene under root names that url in every way.
  std::string said_of(const std::string& url) {
    SourceSet sources;
    Diagnostics diagnostics(sources);
    DiskFiles files(folder_ / "root");
    const std::string text = classic_scene(fmt::format(R"(Inline {{ url "{0}" }}
EXTERNPROTO P [ ] "{0}#P"
P {{ }}
Shape {{
  appearance Appearance {{
    texture ImageTexture {{ url "{0}" }}
    effects Effect {{ language "GLSL" parts EffectPart {{ url "{0}" }} }}
    shaders ComposedShader {{ language "GLSL" parts ShaderPart {{ url "{0}" }} }}
  }}
  geometry Box {{ }}
}}
)",
                                                       url));
    const fs::path path = folder_ / "root/scene.x3dv";
    const SourceId source = sources.add("scene.x3dv", text);
    const NodeGraph graph = build_graph(read_document(source, sources, diagnostics), path, sources, files, diagnostics);
    const Scene scene = build_scene(graph, sources, files, {}, diagnostics);
    load_images(graph, scene, files, diagnostics);
    std::string said;
    for (const Diagnostic& one : diagnostics.all()) said += to_text(one, sources);
    outside_ = count_of(diagnostics, DiagnosticId::file_outside_root);
    unreadable_ = count_of(diagnostics, DiagnosticId::file_unreadable);
    return said;
  }

  void expect_outside(const std::string& url) {
    const std::string said = said_of(url);
    EXPECT_EQ(said.find(kSecret), std::string::npos) << said;
    EXPECT_EQ(outside_, 5U) << said;  // Inline, external prototype, texture, effect, shader
    EXPECT_NE(said.find("leads outside the folder that this scene may read; `--root DIR` names a wider one"),
              std::string::npos);
  }
  void expect_unreadable(const std::string& url) {
    const std::string said = said_of(url);
    EXPECT_EQ(said.find(kSecret), std::string::npos) << said;
    EXPECT_EQ(unreadable_, 5U) << said;
    EXPECT_EQ(outside_, 0U) << said;
  }

  fs::path folder_;
  std::size_t outside_ = 0, unreadable_ = 0;
};

TEST_F(FileAttacks, UrlsThatLeaveTheRootReadNothing) {
  expect_outside("../secret.txt");
  expect_outside("../out/secret.x3dv");
  expect_outside("sub/../../secret.txt");
  expect_outside("absent/../../secret.txt");
  expect_outside("%2e%2e/secret.txt");
  expect_outside("%2E%2E%2Fsecret.txt");
  expect_outside("sub/%2e%2e/%2e%2e/secret.txt");
  expect_outside((folder_ / "secret.txt").string());
  expect_outside("file://" + (folder_ / "secret.txt").string());
  expect_outside("file:../secret.txt");
  expect_outside("file://localhost" + (folder_ / "secret.txt").string());
  expect_outside("/etc/passwd");
}

TEST_F(FileAttacks, LinksThatLeaveTheRootReadNothing) {
  fs::create_symlink(folder_ / "secret.txt", folder_ / "root/link.txt");
  fs::create_directory_symlink(folder_ / "out", folder_ / "root/folder");
  fs::create_symlink("/proc/self/environ", folder_ / "root/environ");
  fs::create_symlink("/dev/zero", folder_ / "root/zero");
  fs::create_directory_symlink("/proc/self", folder_ / "root/self");
  expect_outside("link.txt");
  expect_outside("folder/secret.x3dv");
  expect_outside("environ");
  expect_outside("self/cmdline");
  expect_outside("zero");
}

TEST_F(FileAttacks, WhatIsNoFileIsNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder_ / "root/pipe").c_str(), 0600), 0);
  fs::create_symlink(folder_ / "root/pipe", folder_ / "root/link");
  expect_unreadable("pipe");
  expect_unreadable("link");
  expect_unreadable("sub");
  expect_unreadable("sub/");
  expect_unreadable("absent");
}

TEST_F(FileAttacks, UrlsOfOtherSchemesAskNoNetwork) {
  expect_unreadable("http://localhost/secret.txt");
  expect_unreadable("ftp://localhost/secret.txt");
  expect_unreadable("sub%00/../../secret.txt");
}

/// Zeros that unpack to `megabytes`, as a gzip file of a thousandth of that. A block that ends with a full flush stands for
/// itself, so one can be repeated.
std::string zeros_packed(std::size_t megabytes) {
  z_stream stream = {};
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string zeros(std::size_t{1} << 20, '\0'), block(4096, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(zeros.data());
  stream.avail_in = static_cast<uInt>(zeros.size());
  stream.next_out = reinterpret_cast<Bytef*>(block.data());
  stream.avail_out = static_cast<uInt>(block.size());
  EXPECT_EQ(deflate(&stream, Z_FULL_FLUSH), Z_OK);
  block.resize(block.size() - stream.avail_out);
  deflateEnd(&stream);
  return std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10) + repeated(block, megabytes) + std::string("\x03\0", 2) +
         std::string(4, '\0') + std::string("\0\0\0\x80", 4);  // a wrong checksum, and the size: 2 GiB
}

TEST_F(FileAttacks, ABombIsUnpackedToTheLimitAndOnce) {
  const std::string bomb = zeros_packed(2048);
  EXPECT_LT(bomb.size(), 3'000'000U);
  write("root/bomb.x3dz", bomb);
  const std::size_t peak = peak_of([&] {
    DiskFiles files(folder_ / "root");
    for (int i = 0; i < 1000; ++i) {
      if (files.read(folder_ / "root/bomb.x3dz").status != FileStatus::damaged) _exit(1);
    }
  });
  expect_peak(peak, kMaxFileBytes + (std::size_t{64} << 20));
}

TEST_F(FileAttacks, AFileThatIsTooLargeIsNotRead) {
  write("root/large.x3dv", "#X3D V3.3 utf8\n");
  fs::resize_file(folder_ / "root/large.x3dv", kMaxFileBytes + 1);  // a hole: it takes no disk
  const std::size_t peak = peak_of([&] {
    if (DiskFiles(folder_ / "root").read(folder_ / "root/large.x3dv").status != FileStatus::too_large) _exit(1);
  });
  EXPECT_GT(peak + 1, 1U);
  EXPECT_NE(said_of("large.x3dv").find("`large.x3dv` is larger than 512 MiB [file-too-large]"), std::string::npos);
}

TEST_F(FileAttacks, AllFilesTogetherHaveALimit) {
  for (int i = 0; i < 5; ++i) write(fmt::format("root/{}.txt", i), std::string(1'000'000, 'x'));
  SourceSet sources;
  Diagnostics diagnostics(sources);
  const SourceId id = sources.add("s", "url");
  DiskFiles files(folder_ / "root", 4'500'000);
  const auto read = [&](int i) {
    return read_url(files, fmt::format("{}.txt", i), folder_ / "root/scene", {id, 0, 3}, diagnostics).has_value();
  };
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(read(i));
  EXPECT_FALSE(read(4));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message, "`4.txt` is not read: the files of this scene are too large together");
}

TEST_F(FileAttacks, AFilePackedTwiceIsUnpackedOnce) {
  const auto gzip = [](const std::string& text) {
    std::string packed(text.size() + 100, '\0');
    z_stream stream = {};
    deflateInit2(&stream, 1, Z_DEFLATED, 31, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
  };
  write("root/twice.x3dvz", gzip(gzip(classic_scene("Shape { }"))));
  EXPECT_NE(said_of("twice.x3dvz").find("this file is compressed; unpack it with `gunzip` first [encoding-unknown]"),
            std::string::npos);
}

}  // namespace
}  // namespace plugc
