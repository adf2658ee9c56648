// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/forked_call.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "base/misdeed.hpp"
#include "base/process.hpp"
#include "base/program_line.hpp"
#include "base/unique_fd.hpp"

namespace tedit {

namespace {

/// Before each message: who writes to a descriptor that is not theirs is found out by it.
struct message_head {
  std::uint32_t tag = expected_tag;
  std::uint32_t kind = 0;
  std::uint64_t size = 0;
  std::uint64_t at = in_pipe;  ///< Where in the shared memory the bytes are.

  static constexpr std::uint64_t in_pipe = ~std::uint64_t{0};
  static constexpr std::uint32_t expected_tag = 0x4D454454;
};

/// Larger ones go through memory: a pipe would take them in many turns of both processes.
constexpr std::size_t most_in_pipe = 32 * 1024;

constexpr std::uint32_t kind_returned = 0xFFFFFFFF;
constexpr int status_line_lost = 119;
constexpr int status_not_confined = 118;

ino_t inode_of(int fd) {
  struct stat info {};
  return fstat(fd, &info) == 0 ? info.st_ino : 0;
}

/// Writes all by `put(bytes, offset)`, which is one system call.
template <class Put>
bool write_all(std::span<const std::byte> bytes, const Put& put) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t sent = put(bytes.subspan(done), done);
    if (sent < 0 && errno != EINTR)
      return false;
    done += static_cast<std::size_t>(std::max<ssize_t>(sent, 0));
  }
  return true;
}

/// Memory that both processes see and neither can make smaller, so that a mapping holds.
unique_fd shared_memory() {
  unique_fd memory(memfd_create("tedit-call", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (memory)
    fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK);
  return memory;
}

/// The file's first bytes, for reading; empty when it has fewer.
class mapping {
public:
  mapping(int file, std::size_t size) {
    struct stat info {};
    if (fstat(file, &info) != 0 || static_cast<std::uint64_t>(info.st_size) < size)
      return;
    if (void* made = mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0); made != MAP_FAILED)
      bytes_ = {static_cast<const std::byte*>(made), size};
  }
  mapping(const mapping&) = delete;
  mapping& operator=(const mapping&) = delete;
  ~mapping() {
    if (!bytes_.empty())
      munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
  }

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

private:
  std::span<const std::byte> bytes_;
};

/// Not RLIMIT_AS: threads and sanitizers reserve addresses that nobody writes to.
void limit_memory(std::size_t more) {
  std::ifstream in("/proc/self/statm");
  std::array<std::uint64_t, 6> pages{};
  for (auto& value : pages)
    in >> value;
  const auto now = pages[5] * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  const rlimit limit{now + more, now + more};
  setrlimit(RLIMIT_DATA, &limit);
}

void prepare_child(pid_t parent, const forked_limits& limits) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(status_line_lost);
  for (const int number : {SIGINT, SIGTERM})
    signal(number, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nowhere, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  // Where the system runs out of memory, this process shall go and not another one.
  std::ofstream("/proc/self/oom_score_adj") << 1000;
  if (limits.memory_bytes > 0)
    limit_memory(limits.memory_bytes);
}

/// Takes the child's bytes apart into messages.
class message_reader {
public:
  message_reader(const message_handler& heard, int memory) : heard_(heard), memory_(memory) {}

  /// Reads what is there; false at the end of the line.
  bool read_from(int fd) {
    std::array<std::byte, 65536> buffer;
    while (true) {
      const auto got = read(fd, buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR)
        continue;
      if (got <= 0)
        return got < 0 && errno == EAGAIN;
      bytes_.insert(bytes_.end(), buffer.data(), buffer.data() + got);
      take_messages();
      if (returned || garbled)
        return false;
    }
  }

  bool returned = false;  ///< The child said that its work is done.
  bool garbled = false;   ///< What came is no message.

private:
  void take_messages() {
    std::size_t at = 0;
    message_head head;
    while (bytes_.size() - at >= sizeof(head) && !returned && !garbled) {
      std::memcpy(&head, bytes_.data() + at, sizeof(head));
      const bool in_pipe = head.at == message_head::in_pipe;
      garbled = head.tag != message_head::expected_tag || (in_pipe && head.size > most_in_pipe);
      if (garbled || (in_pipe && bytes_.size() - at - sizeof(head) < head.size))
        break;
      at += sizeof(head);
      if (!in_pipe) {
        take_from_memory(head);
        continue;
      }
      returned = head.kind == kind_returned;
      if (!returned)
        heard_(head.kind, std::span(bytes_).subspan(at, head.size));
      at += head.size;
    }
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  void take_from_memory(const message_head& head) {
    const mapping all(memory_, head.at + head.size);
    garbled = head.size > head.at + head.size || all.bytes().empty();
    if (!garbled)
      heard_(head.kind, all.bytes().subspan(head.at, head.size));
  }

  const message_handler& heard_;
  int memory_;
  std::vector<std::byte> bytes_;
};

std::string seconds(std::chrono::milliseconds time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g s", 1e-3 * static_cast<double>(time.count()));
  return text.data();
}

/// Listens until the child returned or died (`child` is its process descriptor), and starts
/// programs for it; an error when it must be killed.
expected<void> listen(int line, int child, const forked_limits& limits, const execution& run,
                      message_reader& reader, program_host* programs) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<pollfd> ends{{line, POLLIN, 0}, {child, POLLIN, 0}};
  while (true) {
    ends.resize(2);
    if (programs)
      programs->wait_for(ends);
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the work was cancelled");
    if (limits.time.count() > 0 && std::chrono::steady_clock::now() - begin > limits.time)
      return fail(ec::timeout, "did not end within " + seconds(limits.time));
    // A cancel from another thread wakes nobody: look again after a moment.
    (void)poll(ends.data(), ends.size(), 20);
    if (programs)
      programs->look();
    bool dead = ends[1].revents != 0;  // Before the line is read: then all that came is read.
    if (!reader.read_from(line)) {
      ends[0].fd = -1;           // At its end the line would wake at once, again and again.
      dead = dead || child < 0;  // Nothing else would tell.
    }
    if (reader.garbled)
      return fail(ec::internal, "wrote to a descriptor that is not its own");
    if (reader.returned || dead)
      return {};
  }
}

void confine(const forked_limits& limits, const caller_line& caller, unique_fd programs) {
  std::vector<int> kept{programs.get()};
  std::ranges::copy(caller.descriptors(), std::back_inserter(kept));
  close_files_except(std::move(kept));
  if (programs)
    start_programs_by(std::move(programs), limits.programs);
  if (const auto done = limits.confine(); !done) {
    std::fprintf(stderr, "%s\n", render(done.error()).c_str());
    _exit(status_not_confined);
  }
}

[[noreturn]] void do_in_child(const std::function<void(const caller_line&)>& work,
                              const forked_limits& limits, const caller_line& caller,
                              unique_fd programs) {
  if (limits.confine)
    confine(limits, caller, std::move(programs));
  work(caller);
  caller.send(kind_returned, {});
  _exit(0);
}

int wait_for_end(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    // Interrupted by a signal of ours: wait on.
  }
  return status;
}

std::string unasked_end(int status) {
  if (auto deed = misdeed_of(status))
    return *deed;
  if (WIFEXITED(status) && WEXITSTATUS(status) == status_not_confined)
    return "was not begun: its process could not be confined";
  if (WIFEXITED(status) && WEXITSTATUS(status) == status_line_lost)
    return "closed descriptors that are not its own";
  if (WIFEXITED(status))
    return "ended its process with status " + std::to_string(WEXITSTATUS(status));
  const bool killed = WTERMSIG(status) == SIGKILL;
  return describe_end(status) + (killed ? "; the system may have run out of memory" : "");
}

}  // namespace

caller_line::caller_line(int pipe, int memory)
    : pipe_(pipe), memory_(memory), pipe_inode_(inode_of(pipe)), memory_inode_(inode_of(memory)) {}

void caller_line::send(std::uint32_t kind, std::span<const std::byte> bytes) const {
  const std::lock_guard lock(mutex_);
  const auto to_pipe = [&](std::span<const std::byte> part, std::size_t) {
    return write(pipe_, part.data(), part.size());
  };
  const auto to_memory = [&](std::span<const std::byte> part, std::size_t done) {
    return pwrite(memory_, part.data(), part.size(), static_cast<off_t>(written_ + done));
  };
  // Who closed the line may have opened a file by the same number.
  bool ok = inode_of(pipe_) == pipe_inode_ && inode_of(memory_) == memory_inode_;
  message_head head{message_head::expected_tag, kind, bytes.size(), message_head::in_pipe};
  if (bytes.size() > most_in_pipe) {
    ok = ok && write_all(bytes, to_memory);
    head.at = std::exchange(written_, written_ + bytes.size());
    bytes = {};
  }
  if (!ok || !write_all(std::as_bytes(std::span(&head, 1)), to_pipe) || !write_all(bytes, to_pipe))
    _exit(status_line_lost);
}

expected<void> call_forked(const std::function<void(const caller_line&)>& work,
                           const forked_limits& limits, const execution& run,
                           const message_handler& heard) {
  std::array<int, 2> ends{};
  const auto memory = shared_memory();
  if (!memory || pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    return fail(ec::service_unavailable,
                std::string("no pipe to a child process: ") + std::strerror(errno),
                "Close other programs, or raise the limit of open files (ulimit -n)");
  unique_fd line(ends[0]);
  unique_fd to_caller(ends[1]);
  line_ends programs;
  if (limits.confine && !limits.programs.empty()) {
    auto made = make_line();
    if (!made)
      return fail(made.error());
    programs = std::move(*made);
  }
  fcntl(to_caller.get(), F_SETFL, 0);
  const pid_t parent = getpid();
  std::cout.flush();
  std::fflush(nullptr);  // Else the child could print it a second time.
  const pid_t child = fork();
  if (child == 0) {
    prepare_child(parent, limits);
    programs.ours.reset();
    do_in_child(work, limits, caller_line(to_caller.get(), memory.get()),
                std::move(programs.theirs));
  }
  if (child < 0)
    return fail(ec::service_unavailable,
                std::string("no child process can be started: ") + std::strerror(errno),
                "Close other programs, or raise the limit of processes (ulimit -u)");
  setpgid(child, child);  // Whoever is first: the group must be there when it is killed.
  to_caller.reset();
  programs.theirs.reset();
  std::optional<program_host> host;
  if (programs.ours)
    host.emplace(std::move(programs.ours), limits.programs, child_limits{});
  // By its number: the header of glibc 2.36 declares it for C alone.
  const unique_fd end_of_child(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  message_reader reader(heard, memory.get());
  auto listened =
    listen(line.get(), end_of_child.get(), limits, run, reader, host ? &*host : nullptr);
  // With what the work started and left. One that is dead already keeps the status that it has.
  kill(-child, SIGKILL);
  const int status = wait_for_end(child);
  if (listened && !reader.returned)
    return fail(ec::internal, unasked_end(status));
  return listened;
}

}  // namespace tedit
