// Inflates piece by piece, so that a small file that unpacks to gigabytes is stopped at the limit, not at the memory's end.

#include "base/gzip.h"

#include <algorithm>

#include <zlib.h>

namespace plugc {
namespace {

constexpr std::size_t kPiece = std::size_t{256} << 10;
constexpr int kGzipWindow = 15 + 16;  // zlib: the largest window, with a gzip header

/// Appends pieces to `text` until the stream ends, fails or passes the limit; true when it ended.
bool inflate_all(z_stream& stream, std::string& text, std::size_t limit) {
  int state = Z_OK;
  while (state == Z_OK && text.size() <= limit) {
    const std::size_t filled = text.size();
    text.resize(filled + kPiece);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + filled);
    stream.avail_out = kPiece;
    state = inflate(&stream, Z_NO_FLUSH);
    text.resize(filled + kPiece - stream.avail_out);
    if (state == Z_STREAM_END && stream.avail_in > 0) state = inflateReset(&stream);  // members may follow each other
  }
  return state == Z_STREAM_END && text.size() <= limit;
}

/// What the last member says that it unpacks to (RFC 1952, ISIZE), as far as that many bytes can: deflate makes at most 1032
/// of one.
std::size_t size_hint(std::string_view bytes) {
  if (bytes.size() < 4) return 0;
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= std::size_t{static_cast<unsigned char>(bytes[bytes.size() - 4 + i])} << (8 * i);
  return std::min(size, 1032 * bytes.size());
}

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

std::optional<std::string> gunzip(std::string_view bytes, std::size_t limit) {
  z_stream stream = {};
  if (inflateInit2(&stream, kGzipWindow) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib takes no const, and writes nothing there
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  text.reserve(std::min(size_hint(bytes), limit) + kPiece);
  const bool whole = inflate_all(stream, text, limit);
  inflateEnd(&stream);
  return whole ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace plugc
