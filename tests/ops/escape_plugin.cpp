// SPDX-License-Identifier: AGPL-3.0-or-later
// A plugin that tries one way out of its worker, the one that its parameter names, and says what
// came of it: "refused: REASON" or "GOT OUT". With none it is an honest operation that has no
// effect.
#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/bpf.h>
#include <linux/perf_event.h>
#include <netinet/in.h>
#include <sched.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include "ops/sdk/operation.hpp"

extern char** environ;

namespace {

using namespace tedit;

/// What a call that answers below zero came to.
std::string outcome(long answer) {
  return answer < 0 ? std::string("refused: ") + std::strerror(errno) : "GOT OUT";
}

std::string outcome_of(std::initializer_list<long> answers) {
  for (const long answer : answers)
    if (answer >= 0)
      return "GOT OUT";
  return outcome(-1);
}

std::string read_file(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  char byte = 0;
  return outcome(file < 0 ? -1 : read(file, &byte, 1) < 0 ? -1 : 0);
}

std::string start(const char* program) {
  std::string name = program;
  char* arguments[] = {name.data(), nullptr};
  return outcome(execve(program, arguments, environ));
}

std::string spawn() {
  pid_t child = 0;
  std::string name = "/bin/true";
  char* arguments[] = {name.data(), nullptr};
  errno = posix_spawn(&child, name.c_str(), nullptr, nullptr, arguments, environ);
  return outcome(errno == 0 ? 0 : -1);
}

std::string connect_to_a_port() {
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_port = htons(7464);
  inet_pton(AF_INET, "127.0.0.1", &there.sin_addr);
  // The link is the one socket that is there; whatever it is, it leads nowhere else.
  long answer = -1;
  for (int fd = 3; fd < 32; ++fd)
    if (connect(fd, reinterpret_cast<const sockaddr*>(&there), sizeof(there)) == 0)
      answer = 0;
  return outcome(answer);
}

std::string read_parent() {
  char byte = 0;
  const iovec mine{&byte, 1};
  const iovec its{reinterpret_cast<void*>(0x400000), 1};
  return outcome(process_vm_readv(getppid(), &mine, 1, &its, 1, 0));
}

/// Files of 250 MiB until something ends it.
std::string fill_folder() {
  for (int i = 0; i < 8; ++i) {
    const auto name = std::filesystem::temp_directory_path() / std::to_string(i);
    const int file = open(name.c_str(), O_WRONLY | O_CREAT, 0600);
    if (file < 0 || posix_fallocate(file, 0, 250 << 20) != 0)
      return "refused: " + std::string(std::strerror(errno));
    close(file);
  }
  sleep(20);
  return "GOT OUT";
}

std::string grow_file() {
  const int file =
    open((std::filesystem::temp_directory_path() / "one").c_str(), O_WRONLY | O_CREAT, 0600);
  return outcome(ftruncate(file, off_t{4} << 30));
}

std::string own_handler() {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  return outcome(sigaction(SIGSYS, &action, nullptr));
}

std::string more_memory() {
  rlimit all{RLIM_INFINITY, RLIM_INFINITY};
  return outcome_of({setrlimit(RLIMIT_DATA, &all), prlimit(0, RLIMIT_DATA, &all, nullptr),
                     prlimit(getppid(), RLIMIT_DATA, &all, nullptr)});
}

std::string change_rights(const std::string& path) {
  return outcome_of({chmod(path.c_str(), 0666), fchmodat(AT_FDCWD, path.c_str(), 0666, 0),
                     chown(path.c_str(), 1, 1), setxattr(path.c_str(), "user.tedit", "x", 1, 0),
                     fchmod(open(path.c_str(), O_PATH), 0666)});
}

/// Of 32-bit programs, whose numbers a filter of the others does not know.
long old_call() {
#if defined(__x86_64__)
  long result = 20;  // getpid
  asm volatile("int $0x80" : "+a"(result) : : "memory");
  return result;
#else
  return kill(getpid(), SIGSYS);
#endif
}

using way = std::function<std::string(const std::string& path)>;

const std::map<std::string, way>& ways() {
  static const std::map<std::string, way> all{
    {"inet", [](auto&) { return outcome(socket(AF_INET, SOCK_STREAM, 0)); }},
    {"inet6", [](auto&) { return outcome(socket(AF_INET6, SOCK_DGRAM, 0)); }},
    {"packet", [](auto&) { return outcome(socket(AF_PACKET, SOCK_RAW, 0)); }},
    {"vsock", [](auto&) { return outcome(socket(AF_VSOCK, SOCK_STREAM, 0)); }},
    {"unix", [](auto&) { return outcome(socket(AF_UNIX, SOCK_STREAM, 0)); }},
    {"netlink", [](auto&) { return outcome(socket(AF_NETLINK, SOCK_RAW, 0)); }},
    {"connect", [](auto&) { return connect_to_a_port(); }},
    {"read", read_file},
    {"read_through_proc", [](auto& path) { return read_file("/proc/self/root" + path); }},
    {"read_environment",
     [](auto&) { return read_file("/proc/" + std::to_string(getppid()) + "/environ"); }},
    {"list", [](auto& path) { return outcome(open(path.c_str(), O_RDONLY | O_DIRECTORY)); }},
    {"write", [](auto& path) { return outcome(open(path.c_str(), O_WRONLY)); }},
    {"make",
     [](auto& path) { return outcome(open((path + ".new").c_str(), O_WRONLY | O_CREAT, 0600)); }},
    {"truncate", [](auto& path) { return outcome(truncate(path.c_str(), 0)); }},
    {"truncate_by_reading",
     [](auto& path) { return outcome(open(path.c_str(), O_RDONLY | O_TRUNC)); }},
    {"rights", change_rights},
    {"remove", [](auto& path) { return outcome(unlink(path.c_str())); }},
    {"rename", [](auto& path) { return outcome(rename(path.c_str(), (path + "2").c_str())); }},
    {"link",
     [](auto& path) {
       const auto mine = std::filesystem::temp_directory_path() / "mine";
       return outcome_of({link(path.c_str(), mine.c_str()), symlink(path.c_str(), mine.c_str())});
     }},
    {"move_in",
     [](auto& path) {
       return outcome(
         rename(path.c_str(), (std::filesystem::temp_directory_path() / "mine").c_str()));
     }},
    {"tmp", [](auto&) { return outcome(open("/tmp/tedit-escaped", O_WRONLY | O_CREAT, 0600)); }},
    {"shared_folder",
     [](auto&) { return outcome(open("/dev/shm/tedit-escaped", O_RDWR | O_CREAT, 0600)); }},
    {"exec", [](auto&) { return start("/bin/true"); }},
    {"system", [](auto&) { return outcome(std::system("true")); }},
    {"spawn", [](auto&) { return spawn(); }},
    {"fork", [](auto&) { return outcome(fork()); }},
    {"clone", [](auto&) { return outcome(syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0)); }},
    {"clone3", [](auto&) { return outcome(syscall(SYS_clone3, nullptr, 0)); }},
    {"kill_parent", [](auto&) { return outcome(kill(getppid(), SIGKILL)); }},
    {"kill_all", [](auto&) { return outcome(kill(-1, SIGKILL)); }},
    {"kill_group", [](auto&) { return outcome(kill(0, SIGKILL)); }},
    {"ask_parent", [](auto&) { return outcome(kill(getppid(), 0)); }},
    {"ptrace", [](auto&) { return outcome(ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr)); }},
    {"read_parent", [](auto&) { return read_parent(); }},
    {"pidfd", [](auto&) { return outcome(syscall(SYS_pidfd_open, getppid(), 0)); }},
    {"signal_of_a_file", [](auto&) { return outcome(fcntl(2, F_SETOWN, getppid())); }},
    {"other_processor",
     [](auto&) {
       cpu_set_t one;
       CPU_ZERO(&one);
       CPU_SET(0, &one);
       return outcome(sched_setaffinity(getppid(), sizeof(one), &one));
     }},
    {"outlive_parent", [](auto&) { return outcome(prctl(PR_SET_PDEATHSIG, 0)); }},
    {"new_group",
     [](auto&) {
       return outcome_of({setsid(), setpgid(0, 0)});
     }},
    {"own_handler", [](auto&) { return own_handler(); }},
    {"shared_memory",
     [](auto&) {
       void* made =
         mmap(nullptr, 1 << 20, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
       return outcome(made == MAP_FAILED ? -1 : 0);
     }},
    {"memory_file", [](auto&) { return outcome(syscall(SYS_memfd_create, "x", 0)); }},
    {"more_memory", [](auto&) { return more_memory(); }},
    {"grow_file", [](auto&) { return grow_file(); }},
    {"fill_folder", [](auto&) { return fill_folder(); }},
    {"setuid", [](auto&) { return outcome(setuid(0)); }},
    {"mount", [](auto&) { return outcome(mount("none", "/mnt", "tmpfs", 0, nullptr)); }},
    {"unshare", [](auto&) { return outcome(unshare(CLONE_NEWUSER)); }},
    {"chroot", [](auto&) { return outcome(chroot("/tmp")); }},
    {"keyctl", [](auto&) { return outcome(syscall(SYS_keyctl, 0, -3, 0)); }},
    {"bpf", [](auto&) { return outcome(syscall(SYS_bpf, BPF_PROG_LOAD, nullptr, 0)); }},
    {"io_uring", [](auto&) { return outcome(syscall(SYS_io_uring_setup, 1, nullptr)); }},
    {"userfaultfd", [](auto&) { return outcome(syscall(SYS_userfaultfd, 0)); }},
    {"perf", [](auto&) { return outcome(syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0)); }},
    {"new_filter", [](auto&) { return outcome(syscall(SYS_seccomp, 1, 0, nullptr)); }},
    {"old_call", [](auto&) { return outcome(old_call()); }},
    // No way out: what honest plugins do.
    {"own_file",
     [](auto&) {
       const auto name = std::filesystem::temp_directory_path() / "mine.txt";
       std::ofstream(name) << "kept until the end";
       return std::ifstream(name).good() ? "in " + name.parent_path().string() : "no file";
     }},
  };
  return all;
}

class escape final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "escape";
    d.name = "Escape";
    d.summary = "Tries a way out of its worker.";
    d.version = "1.0.0";
    d.selection.help = "Any surface.";
    d.parameters = {{"way",
                     "Way",
                     "Which way.",
                     ops::parameter_type::text,
                     "",
                     {},
                     {},
                     {},
                     std::string("own_file")},
                    {"path",
                     "Path",
                     "A file that it tries.",
                     ops::parameter_type::text,
                     "",
                     {},
                     {},
                     {},
                     std::string("/nowhere")}};
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr&, const ops::selection&,
                                   const ops::parameters& values, ops::context&) const override {
    const auto found = ways().find(std::get<std::string>(values.at("way")));
    if (found == ways().end())
      return fail(ec::invalid_argument, "there is no such way", "Take another");
    return fail(ec::conflict, found->second(std::get<std::string>(values.at("path"))), "None");
  }
};

}  // namespace

TEDIT_PLUGIN("escape", "1.0.0", escape)
