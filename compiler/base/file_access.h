#pragma once
// The only way to the file system. Readers take this interface, so that tests feed them from memory.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/limits.h"

namespace plugc {

enum class FileStatus { ok, missing, outside_root, too_large, damaged, total_too_large };

struct FileContent {
  FileStatus status = FileStatus::missing;
  std::string bytes;
};

class FileAccess {
 public:
  virtual ~FileAccess() = default;
  /// The whole file, unpacked when it is gzip-compressed, or why not. Never throws.
  virtual FileContent read(const std::filesystem::path& path) = 0;
};

/// Real files under `root` only, links followed before the question is asked, and together no more than `most_bytes` of
/// them. An empty root allows every file.
class DiskFiles : public FileAccess {
 public:
  explicit DiskFiles(std::filesystem::path root, std::size_t most_bytes = kMaxTotalBytes);
  /// Regular files only: nothing that could wait, such as a pipe, or never end, such as /dev/zero.
  FileContent read(const std::filesystem::path& path) override;
  /// Every file read so far, as it was asked for, each once, in name order: what the result depends on.
  const std::set<std::filesystem::path>& files_read() const { return files_read_; }

 private:
  FileContent read_real(const std::filesystem::path& real) const;
  std::filesystem::path root_;
  bool confined_;
  std::set<std::filesystem::path> files_read_;
  std::map<std::filesystem::path, FileStatus> refused_;  ///< By real path: a bomb is unpacked once, however often it is named.
  std::size_t bytes_left_;
};

/// Files in memory, for tests and fuzzers.
class MemoryFiles : public FileAccess {
 public:
  std::map<std::string, std::string> files;
  FileContent read(const std::filesystem::path& path) override;
};

/// The folder that a scene may read: the nearest one above it that holds `.plugc.toml` or `.git`, else the current folder
/// where that lies above it and is not `/`, else its own folder.
std::filesystem::path default_root(const std::filesystem::path& scene);

/// Where `url`, written in the file `base`, leads, without its `#fragment`; nullopt when it is no local file (`http:`, `urn:`).
std::optional<std::filesystem::path> resolve_url(std::string_view url, const std::filesystem::path& base);

/// Reports at `span` why a file was not read (its status is not ok); `name` as the author wrote it.
void report_unreadable(FileStatus status, std::string_view name, const Span& span, Diagnostics& diagnostics);

/// Reads the file that a url names, or reports at `span` why it cannot be read.
std::optional<std::string> read_url(FileAccess& files, std::string_view url, const std::filesystem::path& base,
                                    const Span& span, Diagnostics& diagnostics);

/// Undoes %XX; a stray % stays as it is.
std::string percent_decode(std::string_view text);

}  // namespace plugc
