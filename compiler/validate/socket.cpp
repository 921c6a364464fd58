// Every transfer is a loop of poll() until the deadline and one call that does not block. MSG_NOSIGNAL turns a closed other
// end into an error instead of SIGPIPE. Descriptors travel as SCM_RIGHTS beside one byte of data (unix(7)).

#include "validate/socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace plugc {
namespace {

/// More than any verdict; a worker that claims more is broken.
constexpr std::uint32_t kMaxMessageBytes = std::uint32_t{512} << 20;

int milliseconds_until(Deadline deadline) {
  if (deadline == kNoDeadline) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1 << 30));
}

/// Waits until the socket can be read or written; a closed one counts as ready.
bool wait_for(const Descriptor& socket, short events, Deadline deadline) {
  pollfd polled{socket.get(), events, 0};
  int ready = 0;
  do {
    ready = poll(&polled, 1, milliseconds_until(deadline));
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

bool is_passing(int error) {
  return error == EINTR || error == EAGAIN || error == EWOULDBLOCK;
}

/// Moves `size` bytes with `move(offset)`, which is send() or recv() on what is left.
template <typename Move>
Transfer transfer(const Descriptor& socket, short events, std::size_t size, Deadline deadline, Move move) {
  for (std::size_t moved = 0; moved < size;) {
    if (!wait_for(socket, events, deadline)) return Transfer::late;
    const ssize_t count = move(moved);
    if (count == 0 || (count < 0 && !is_passing(errno))) return Transfer::closed;
    if (count > 0) moved += static_cast<std::size_t>(count);
  }
  return Transfer::done;
}

Transfer send_bytes(const Descriptor& socket, const char* bytes, std::size_t size, Deadline deadline) {
  return transfer(socket, POLLOUT, size, deadline, [&](std::size_t offset) {
    return send(socket.get(), bytes + offset, size - offset, MSG_NOSIGNAL | MSG_DONTWAIT);
  });
}

Transfer receive_bytes(const Descriptor& socket, char* bytes, std::size_t size, Deadline deadline) {
  return transfer(socket, POLLIN, size, deadline,
                  [&](std::size_t offset) { return recv(socket.get(), bytes + offset, size - offset, MSG_DONTWAIT); });
}

/// A message of one byte with room for one descriptor beside it.
struct DescriptorMessage {
  char byte = 0;
  iovec data{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr header{};

  DescriptorMessage() {
    header.msg_iov = &data;
    header.msg_iovlen = 1;
    header.msg_control = control;
    header.msg_controllen = sizeof control;
  }
  DescriptorMessage(const DescriptorMessage&) = delete;
  DescriptorMessage& operator=(const DescriptorMessage&) = delete;
};

}  // namespace

Descriptor::~Descriptor() {
  if (value_ >= 0) close(value_);
}

std::pair<Descriptor, Descriptor> make_socket_pair() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return {};
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Transfer send_message(const Descriptor& socket, std::string_view bytes, Deadline deadline) {
  if (bytes.size() > kMaxMessageBytes) return Transfer::closed;
  const auto size = static_cast<std::uint32_t>(bytes.size());
  const Transfer result = send_bytes(socket, reinterpret_cast<const char*>(&size), sizeof size, deadline);
  return result == Transfer::done ? send_bytes(socket, bytes.data(), bytes.size(), deadline) : result;
}

Transfer receive_message(const Descriptor& socket, std::string& bytes, Deadline deadline) {
  std::uint32_t size = 0;
  const Transfer result = receive_bytes(socket, reinterpret_cast<char*>(&size), sizeof size, deadline);
  if (result != Transfer::done) return result;
  if (size > kMaxMessageBytes) return Transfer::closed;
  bytes.resize(size);
  return receive_bytes(socket, bytes.data(), size, deadline);
}

bool send_descriptor(const Descriptor& socket, const Descriptor& sent) {
  DescriptorMessage message;
  if (!sent.valid()) return send(socket.get(), &message.byte, 1, MSG_NOSIGNAL) == 1;
  cmsghdr* control = CMSG_FIRSTHDR(&message.header);
  control->cmsg_level = SOL_SOCKET;
  control->cmsg_type = SCM_RIGHTS;
  control->cmsg_len = CMSG_LEN(sizeof(int));
  const int value = sent.get();
  std::memcpy(CMSG_DATA(control), &value, sizeof value);
  return sendmsg(socket.get(), &message.header, MSG_NOSIGNAL) == 1;
}

Descriptor receive_descriptor(const Descriptor& socket, Deadline deadline) {
  DescriptorMessage message;
  if (!wait_for(socket, POLLIN, deadline)) return {};
  if (recvmsg(socket.get(), &message.header, MSG_DONTWAIT | MSG_CMSG_CLOEXEC) != 1) return {};
  const cmsghdr* control = CMSG_FIRSTHDR(&message.header);
  if (control == nullptr || control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_RIGHTS) return {};
  int value = -1;
  std::memcpy(&value, CMSG_DATA(control), sizeof value);
  return Descriptor(value);
}

}  // namespace plugc
