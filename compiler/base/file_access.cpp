// A path is judged by where it really leads (weakly_canonical follows every link) before a byte of it is read.

#include "base/file_access.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "base/gzip.h"

namespace plugc {
namespace fs = std::filesystem;
namespace {

bool lies_under(const fs::path& path, const fs::path& root) {
  const auto [root_end, path_at] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
  return !root.empty() && root_end == root.end();
}

/// Absolute, without links and dots, without a slash at the end; empty when it leads nowhere (links in a circle).
fs::path real_path(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return {};
  const fs::path real = fs::weakly_canonical(absolute, error);
  if (error) return {};
  return real.has_filename() || real == real.root_path() ? real : real.parent_path();
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// "scheme:" in front of a url (RFC 3986, 3.1), or "". One letter is a drive, not a scheme.
std::string_view scheme_of(std::string_view url) {
  const std::size_t colon = url.find_first_of(":/?#");
  if (colon == std::string_view::npos || url[colon] != ':' || colon < 2) return "";
  return url.substr(0, colon);
}

FileContent unpacked(std::string bytes) {
  if (!is_gzip(bytes)) return {FileStatus::ok, std::move(bytes)};
  auto text = gunzip(bytes, kMaxFileBytes);
  if (!text) return {FileStatus::damaged, ""};
  return {FileStatus::ok, std::move(*text)};
}

}  // namespace

DiskFiles::DiskFiles(fs::path root, std::size_t most_bytes)
    : root_(real_path(root)), confined_(!root.empty()), bytes_left_(most_bytes) {}

FileContent DiskFiles::read(const fs::path& path) {
  const fs::path real = real_path(path);
  if (real.empty()) return {FileStatus::missing, ""};
  if (confined_ && !lies_under(real, root_)) return {FileStatus::outside_root, ""};
  if (const auto known = refused_.find(real); known != refused_.end()) return {known->second, ""};
  FileContent content = read_real(real);
  if (content.status == FileStatus::ok && content.bytes.size() > bytes_left_) {
    content = {FileStatus::total_too_large, ""};
  }
  bytes_left_ -= content.bytes.size();
  if (content.status == FileStatus::ok) {
    files_read_.insert(path.lexically_normal());
  } else {
    refused_[real] = content.status;
  }
  return content;
}

FileContent DiskFiles::read_real(const fs::path& real) const {
  std::error_code error;
  if (!fs::is_regular_file(real, error)) return {FileStatus::missing, ""};
  const auto size = fs::file_size(real, error);
  if (error) return {FileStatus::missing, ""};
  if (size > kMaxFileBytes) return {FileStatus::too_large, ""};
  std::ifstream stream(real, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream && !stream.eof()) return {FileStatus::missing, ""};
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return unpacked(std::move(bytes));
}

FileContent MemoryFiles::read(const fs::path& path) {
  const auto found = files.find(path.lexically_normal().string());
  if (found == files.end()) return {};
  return unpacked(found->second);
}

fs::path default_root(const fs::path& scene) {
  std::error_code error;
  const fs::path folder = real_path(scene).parent_path();
  for (fs::path above = folder;; above = above.parent_path()) {
    if (fs::exists(above / ".plugc.toml", error) || fs::exists(above / ".git", error)) return above;
    if (above == above.parent_path()) break;
  }
  const fs::path current = real_path(fs::current_path(error));
  if (folder.empty()) return current;  // never empty, which would allow every file
  return current != current.root_path() && lies_under(folder, current) ? current : folder;
}

std::optional<fs::path> resolve_url(std::string_view url, const fs::path& base) {
  const std::string_view scheme = scheme_of(url);
  if (scheme == "file") {
    url.remove_prefix(5);
    if (url.starts_with("//")) url.remove_prefix(std::min(url.find('/', 2), url.size()));
  } else if (!scheme.empty()) {
    return std::nullopt;
  }
  const std::string name = percent_decode(url.substr(0, url.find('#')));
  if (name.find('\0') != std::string::npos) return std::nullopt;  // the system would cut the name there
  const fs::path path(name);
  return (path.is_absolute() ? path : base.parent_path() / path).lexically_normal();
}

void report_unreadable(FileStatus status, std::string_view name, const Span& span, Diagnostics& diagnostics) {
  const auto report = [&](DiagnosticId id, std::string message) { diagnostics.report(id, span, std::move(message)); };
  switch (status) {
    case FileStatus::ok: return;
    case FileStatus::missing: return report(DiagnosticId::file_unreadable, fmt::format("cannot read `{}`", name));
    case FileStatus::outside_root:
      return report(
          DiagnosticId::file_outside_root,
          fmt::format("`{}` leads outside the folder that this scene may read; `--root DIR` names a wider one", name));
    case FileStatus::damaged:
      return report(
          DiagnosticId::file_unreadable,
          fmt::format("`{}` is gzip-compressed and damaged, or unpacks to more than {} MiB", name, kMaxFileBytes >> 20));
    case FileStatus::too_large:
      return report(DiagnosticId::file_too_large, fmt::format("`{}` is larger than {} MiB", name, kMaxFileBytes >> 20));
    case FileStatus::total_too_large:
      return report(DiagnosticId::file_too_large,
                    fmt::format("`{}` is not read: the files of this scene are too large together", name));
  }
}

std::optional<std::string> read_url(FileAccess& files, std::string_view url, const fs::path& base, const Span& span,
                                    Diagnostics& diagnostics) {
  if (url.empty()) {
    diagnostics.report(DiagnosticId::file_unreadable, span, "an empty url names no file");
    return std::nullopt;
  }
  const auto path = resolve_url(url, base);
  if (!path) {
    diagnostics.report(DiagnosticId::file_unreadable, span, fmt::format("`{}` is no local file; plugc reads no network", url));
    return std::nullopt;
  }
  FileContent content = files.read(*path);
  if (content.status == FileStatus::ok) return std::move(content.bytes);
  report_unreadable(content.status, url, span, diagnostics);
  return std::nullopt;
}

std::string percent_decode(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
    decoded += escape ? static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])) : text[i];
    if (escape) i += 2;
  }
  return decoded;
}

}  // namespace plugc
