// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/program_line.hpp"

#include <signal.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace tedit {

namespace {

/// The most descriptors of one message.
constexpr std::size_t most_descriptors = 4;

union control_room {
  cmsghdr head;
  std::array<char, CMSG_SPACE(most_descriptors * sizeof(int))> bytes;
};

}  // namespace

expected<line_ends> make_line() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return fail(ec::service_unavailable,
                std::string("no line to a child process: ") + std::strerror(errno),
                "Close other programs, or raise the limit of open files (ulimit -n)");
  return line_ends{unique_fd(ends[0]), unique_fd(ends[1])};
}

bool send_descriptors(int line, const std::vector<int>& descriptors, std::uint8_t number) {
  iovec text{&number, 1};
  control_room room{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = room.bytes.data();
  message.msg_controllen = CMSG_SPACE(descriptors.size() * sizeof(int));
  auto* head = CMSG_FIRSTHDR(&message);
  head->cmsg_level = SOL_SOCKET;
  head->cmsg_type = SCM_RIGHTS;
  head->cmsg_len = CMSG_LEN(descriptors.size() * sizeof(int));
  std::memcpy(CMSG_DATA(head), descriptors.data(), descriptors.size() * sizeof(int));
  ssize_t sent = -1;
  do
    sent = sendmsg(line, &message, MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  return sent == 1;
}

taken_descriptors take_descriptors(int line, bool& ended, bool wait) {
  taken_descriptors result;
  iovec text{&result.number, 1};
  control_room room{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = room.bytes.data();
  message.msg_controllen = room.bytes.size();
  ssize_t got = -1;
  do
    got = recvmsg(line, &message, MSG_CMSG_CLOEXEC | (wait ? 0 : MSG_DONTWAIT));
  while (got < 0 && errno == EINTR);
  ended = got == 0 || (got < 0 && errno != EAGAIN);
  if (got <= 0)
    return result;
  for (auto* head = CMSG_FIRSTHDR(&message); head; head = CMSG_NXTHDR(&message, head)) {
    if (head->cmsg_level != SOL_SOCKET || head->cmsg_type != SCM_RIGHTS)
      continue;
    std::array<int, most_descriptors> numbers{};
    const auto bytes = std::min(head->cmsg_len - CMSG_LEN(0), sizeof(numbers));
    std::memcpy(numbers.data(), CMSG_DATA(head), bytes);
    for (std::size_t i = 0; i < bytes / sizeof(int); ++i)
      result.all.emplace_back(numbers[i]);
  }
  return result;
}

program_host::~program_host() {
  for (const auto& one : all_) {
    kill(one.pid, SIGKILL);
    while (waitpid(one.pid, nullptr, 0) < 0 && errno == EINTR) {
      // Interrupted by a signal of ours: wait on.
    }
  }
}

void program_host::wait_for(std::vector<pollfd>& list) const {
  if (line_)
    list.push_back({line_.get(), POLLIN, 0});
  for (const auto& one : all_) {
    list.push_back({one.end.get(), POLLIN, 0});
    list.push_back({one.wanted.get(), 0, 0});  // Its other end is closed: POLLHUP.
  }
}

void program_host::start(taken_descriptors order) {
  auto& ends = order.all;
  // Otherwise the line of its status closes without one, and who asked knows.
  if (ends.size() != most_descriptors || order.number >= programs_.size() ||
      all_.size() >= most_at_once)
    return;
  running one;
  one.pid =
    start_program({programs_[order.number].string()}, ends[0].get(), ends[1].get(), limits_);
  if (one.pid < 0)
    return;
  // By its number: the header of glibc 2.36 declares it for C alone.
  one.end = unique_fd(static_cast<int>(syscall(SYS_pidfd_open, one.pid, 0)));
  one.status = std::move(ends[2]);
  one.wanted = std::move(ends[3]);
  all_.push_back(std::move(one));
}

void program_host::look() {
  // Not without end: whoever asks again and again must not keep the host from its other work.
  for (std::size_t i = 0; line_ && i < most_at_once; ++i) {
    bool ended = false;
    auto order = take_descriptors(line_.get(), ended);
    if (ended)
      line_.reset();
    if (order.all.empty())
      break;
    start(std::move(order));
  }
  for (auto one = all_.begin(); one != all_.end();) {
    pollfd wanted{one->wanted.get(), 0, 0};
    if (poll(&wanted, 1, 0) > 0)
      kill(one->pid, SIGKILL);
    int status = 0;
    if (waitpid(one->pid, &status, WNOHANG) != one->pid) {
      ++one;
      continue;
    }
    pollfd room{one->status.get(), POLLOUT, 0};
    if (poll(&room, 1, 0) > 0 && room.revents == POLLOUT)
      (void)!write(one->status.get(), &status, sizeof(status));
    one = all_.erase(one);
  }
}

}  // namespace tedit
