#pragma once
// What a Renderer has to say: each different thing once. Names in it come from packages, so it is made fit for a terminal.

#include <algorithm>
#include <string>
#include <vector>

#include "base/clean_text.h"

namespace plugc {

class Messages {
 public:
  void add(std::string message) {
    message = printable(message);
    if (list_.size() >= kMaxMessages || std::find(list_.begin(), list_.end(), message) != list_.end()) return;
    list_.push_back(std::move(message));
    if (list_.size() == kMaxMessages) list_.back() = "further messages are left out";
  }
  const std::vector<std::string>& list() const { return list_; }

 private:
  static constexpr std::size_t kMaxMessages = 200;  ///< A broken driver can say something new about every program.
  std::vector<std::string> list_;
};

}  // namespace plugc
