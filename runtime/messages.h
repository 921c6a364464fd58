#pragma once
// What a Renderer has to say: each different thing once.

#include <algorithm>
#include <string>
#include <vector>

namespace plugc {

class Messages {
 public:
  void add(std::string message) {
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
