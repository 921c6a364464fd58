#include "base/gzip.h"

#include <gtest/gtest.h>

#include <zlib.h>

#include "base/file_access.h"

namespace plugc {
namespace {

std::string gzipped(const std::string& text) {
  z_stream stream = {};
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

TEST(Gzip, UnpacksWhatWasPacked) {
  const std::string text(1'000'000, 'x');
  EXPECT_EQ(gunzip(gzipped(text), text.size()), text);
  EXPECT_EQ(gunzip(gzipped(""), 0), "");
}

TEST(Gzip, ReadsMembersOneAfterTheOther) {
  EXPECT_EQ(gunzip(gzipped("#X3D V4.0 ") + gzipped("utf8\n"), 100), "#X3D V4.0 utf8\n");
}

TEST(Gzip, StopsABombAtTheLimit) {
  EXPECT_EQ(gunzip(gzipped(std::string(10'000'000, '\0')), 1'000'000), std::nullopt);
}

TEST(Gzip, RefusesDamagedData) {
  std::string packed = gzipped("Shape { geometry Box { } }");
  EXPECT_EQ(gunzip(packed.substr(0, packed.size() / 2), 1000), std::nullopt);
  packed[packed.size() / 2] = static_cast<char>(packed[packed.size() / 2] ^ 0x55);
  EXPECT_EQ(gunzip(packed, 1000), std::nullopt);
  EXPECT_EQ(gunzip("\x1f\x8b", 1000), std::nullopt);
}

TEST(Gzip, FilesAreUnpackedWhateverTheirName) {
  MemoryFiles files;
  files.files["scene.x3dv"] = gzipped("#X3D V4.0 utf8\n");
  files.files["broken.x3dvz"] = "\x1f\x8b none";
  EXPECT_EQ(files.read("scene.x3dv").bytes, "#X3D V4.0 utf8\n");
  EXPECT_EQ(files.read("broken.x3dvz").status, FileStatus::damaged);
}

}  // namespace
}  // namespace plugc
