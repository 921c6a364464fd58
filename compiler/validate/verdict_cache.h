#pragma once
// Verdicts on disk, so that a program judged once is not judged again.

#include <filesystem>
#include <optional>
#include <string_view>

#include "validate/verdict.h"

namespace plugc {

/// One file a verdict, found by the candidate's hash and compared by its content. Every failure (no folder, no right to
/// write, a damaged file, another user's file) is only a miss. Any number of processes may share a folder.
class VerdictCache {
 public:
  /// An empty folder: nothing is kept.
  explicit VerdictCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Nothing can be found: there is no folder, or nothing in it.
  bool empty() const;
  /// `candidate` is encoded.
  std::optional<Verdict> find(std::string_view candidate) const;
  /// Keeps a valid verdict; others are not kept, as people mend those programs.
  void store(std::string_view candidate, const Verdict& verdict) const;

 private:
  std::filesystem::path path_of(std::string_view candidate) const;
  std::filesystem::path folder_;
};

}  // namespace plugc
