// An entry is a header, the candidate, its verdict and a hash of all that:
//
//     "plugc verdict" tag with versions | u64 candidate size | candidate | verdict | u64 XXH3-64 of what is before
//
// Its name is XXH3-128 of tag and candidate. A reader takes nothing on trust: the file is regular, this user's and
// writable by nobody else, the tag and the hash fit (a torn write, a full disk), and the candidate is the very same bytes.
// A writer makes a temporary file and renames it, so a reader never sees half of one.

#include "validate/verdict_cache.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <glslang/build_info.h>
#include <spirv-tools/libspirv.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "validate/socket.h"

namespace plugc {
namespace {

/// To be counted up whenever judging changes: old entries are no longer found.
constexpr int kJudgingVersion = 5;
constexpr std::size_t kMaxEntryBytes = std::size_t{64} << 20;

std::string entry_tag() {
  return fmt::format("plugc verdict {} glslang {}.{}.{}, {}\n", kJudgingVersion, GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR,
                     GLSLANG_VERSION_PATCH, spvSoftwareVersionDetailsString());
}

template <typename Number>
std::string_view bytes_of(const Number& number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// All before the verdict.
std::string entry_head(std::string_view candidate) {
  const std::uint64_t size = candidate.size();
  return entry_tag().append(bytes_of(size)).append(candidate);
}

/// The file's bytes when it is this user's alone.
std::string read_own_file(const std::filesystem::path& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat status {};
  if (!file.valid() || fstat(file.get(), &status) != 0) return {};
  const bool is_own = S_ISREG(status.st_mode) && status.st_uid == geteuid() && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  if (!is_own || status.st_size <= 0 || static_cast<std::size_t>(status.st_size) > kMaxEntryBytes) return {};
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  const ssize_t count = read(file.get(), bytes.data(), bytes.size());
  return count == status.st_size ? bytes : std::string();
}

bool write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void write_through_rename(const std::filesystem::path& path, std::string_view bytes) {
  std::string temporary = path.string() + ".XXXXXX";
  const Descriptor file(mkostemp(temporary.data(), O_CLOEXEC));  // readable and writable by this user only
  if (!file.valid()) return;
  if (!write_all(file, bytes) || rename(temporary.c_str(), path.c_str()) != 0) unlink(temporary.c_str());
}

}  // namespace

std::filesystem::path VerdictCache::path_of(std::string_view candidate) const {
  const std::string head = entry_head(candidate);
  const XXH128_hash_t hash = XXH3_128bits(head.data(), head.size());
  return folder_ / fmt::format("{:016x}{:016x}.verdict", hash.high64, hash.low64);
}

bool VerdictCache::empty() const {
  std::error_code missing;
  return folder_.empty() || std::filesystem::directory_iterator(folder_, missing) == std::filesystem::directory_iterator();
}

std::optional<Verdict> VerdictCache::find(std::string_view candidate) const {
  if (folder_.empty()) return std::nullopt;
  const std::string entry = read_own_file(path_of(candidate));
  std::string_view rest = entry;
  const std::string head = entry_head(candidate);
  if (!rest.starts_with(head) || rest.size() < head.size() + sizeof(XXH64_hash_t)) return std::nullopt;
  const std::string_view hash = rest.substr(rest.size() - sizeof(XXH64_hash_t));
  rest.remove_suffix(hash.size());
  const XXH64_hash_t computed = XXH3_64bits(rest.data(), rest.size());
  if (hash != bytes_of(computed)) return std::nullopt;
  std::optional<Verdict> verdict = decode_verdict(rest.substr(head.size()));
  return verdict && verdict->valid() ? verdict : std::nullopt;
}

void VerdictCache::store(std::string_view candidate, const Verdict& verdict) const {
  if (folder_.empty() || !verdict.valid()) return;
  std::string entry = entry_head(candidate).append(encode(verdict));
  const XXH64_hash_t hash = XXH3_64bits(entry.data(), entry.size());
  entry.append(bytes_of(hash));
  if (entry.size() > kMaxEntryBytes) return;
  std::error_code ignored;
  std::filesystem::create_directories(folder_, ignored);
  write_through_rename(path_of(candidate), entry);
}

}  // namespace plugc
