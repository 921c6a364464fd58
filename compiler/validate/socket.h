#pragma once
// Messages over a socket pair, each with a deadline. Nothing here raises SIGPIPE or throws.

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace plugc {

using Deadline = std::chrono::steady_clock::time_point;

/// Owns a file descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Descriptor();

  int get() const { return value_; }
  bool valid() const { return value_ >= 0; }
  int release() { return std::exchange(value_, -1); }

 private:
  int value_ = -1;
};

/// Two ends joined to each other, closed on exec; both invalid when the system has none left.
std::pair<Descriptor, Descriptor> make_socket_pair();

enum class Transfer { done, closed, late };

/// A message is its size and its bytes.
Transfer send_message(const Descriptor& socket, std::string_view bytes, Deadline deadline);
Transfer receive_message(const Descriptor& socket, std::string& bytes, Deadline deadline);

/// Hands a descriptor to the process at the other end, or word that there is none. The caller keeps its own.
bool send_descriptor(const Descriptor& socket, const Descriptor& sent);
/// Not valid when none came in time.
Descriptor receive_descriptor(const Descriptor& socket, Deadline deadline);

/// For ends that have all the time in the world.
inline constexpr Deadline kNoDeadline = Deadline::max();

}  // namespace plugc
