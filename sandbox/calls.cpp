// SPDX-License-Identifier: AGPL-3.0-or-later
// Which system calls a confined process has left: seccomp.
#include <fcntl.h>
#include <linux/sched.h>
#include <netinet/tcp.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>

#include "base/misdeed.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit::sandbox {

namespace {

#ifdef TEDIT_SANITIZED
/// A sanitizer stops its threads, and finds names for its reports, with processes of its own.
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// Numbers, streams and memory that are there already, and when it is to end itself.
constexpr std::array basic{
  SCMP_SYS(read),          SCMP_SYS(write),          SCMP_SYS(readv),
  SCMP_SYS(writev),        SCMP_SYS(close),          SCMP_SYS(fstat),
  SCMP_SYS(newfstatat),    SCMP_SYS(lseek),          SCMP_SYS(munmap),
  SCMP_SYS(mprotect),      SCMP_SYS(mremap),         SCMP_SYS(madvise),
  SCMP_SYS(brk),           SCMP_SYS(futex),          SCMP_SYS(exit),
  SCMP_SYS(exit_group),    SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn),
  SCMP_SYS(sigaltstack),   SCMP_SYS(getpid),         SCMP_SYS(gettid),
  SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday),   SCMP_SYS(time),
  SCMP_SYS(getrandom),     SCMP_SYS(sched_yield),    SCMP_SYS(restart_syscall),
  SCMP_SYS(setitimer)};

constexpr std::array of_threads{SCMP_SYS(set_robust_list),
                                SCMP_SYS(get_robust_list),
                                SCMP_SYS(rseq),
                                SCMP_SYS(set_tid_address),
                                SCMP_SYS(arch_prctl),
                                SCMP_SYS(membarrier),
                                SCMP_SYS(getcpu),
                                SCMP_SYS(sched_getaffinity),
                                SCMP_SYS(sched_getscheduler),
                                SCMP_SYS(sched_getparam),
                                SCMP_SYS(sched_get_priority_max),
                                SCMP_SYS(sched_get_priority_min),
                                SCMP_SYS(getpriority),
                                SCMP_SYS(wait4),
                                SCMP_SYS(waitid),
                                SCMP_SYS(rt_sigpending),
                                SCMP_SYS(rt_sigtimedwait),
                                SCMP_SYS(rt_sigsuspend),
                                SCMP_SYS(pause),
                                SCMP_SYS(nanosleep),
                                SCMP_SYS(clock_nanosleep),
                                SCMP_SYS(clock_getres),
                                SCMP_SYS(alarm),
                                SCMP_SYS(getitimer),
                                SCMP_SYS(timer_create),
                                SCMP_SYS(timer_settime),
                                SCMP_SYS(timer_gettime),
                                SCMP_SYS(timer_getoverrun),
                                SCMP_SYS(timer_delete)};

constexpr std::array of_facts{
  SCMP_SYS(getppid), SCMP_SYS(getuid),    SCMP_SYS(geteuid),   SCMP_SYS(getgid),
  SCMP_SYS(getegid), SCMP_SYS(getresuid), SCMP_SYS(getresgid), SCMP_SYS(getgroups),
  SCMP_SYS(getpgrp), SCMP_SYS(getpgid),   SCMP_SYS(getsid),    SCMP_SYS(uname),
  SCMP_SYS(sysinfo), SCMP_SYS(getrusage), SCMP_SYS(times),     SCMP_SYS(getrlimit),
  SCMP_SYS(mincore), SCMP_SYS(msync),     SCMP_SYS(mlock),     SCMP_SYS(munlock)};

/// Landlock says which.
constexpr std::array of_files{
  SCMP_SYS(stat),      SCMP_SYS(lstat),           SCMP_SYS(statx),     SCMP_SYS(statfs),
  SCMP_SYS(fstatfs),   SCMP_SYS(access),          SCMP_SYS(faccessat), SCMP_SYS(faccessat2),
  SCMP_SYS(readlink),  SCMP_SYS(readlinkat),      SCMP_SYS(getdents),  SCMP_SYS(getdents64),
  SCMP_SYS(getcwd),    SCMP_SYS(chdir),           SCMP_SYS(fchdir),    SCMP_SYS(creat),
  SCMP_SYS(rmdir),     SCMP_SYS(unlink),          SCMP_SYS(unlinkat),  SCMP_SYS(rename),
  SCMP_SYS(renameat),  SCMP_SYS(renameat2),       SCMP_SYS(ftruncate), SCMP_SYS(fallocate),
  SCMP_SYS(fsync),     SCMP_SYS(fdatasync),       SCMP_SYS(flock),     SCMP_SYS(fadvise64),
  SCMP_SYS(readahead), SCMP_SYS(copy_file_range), SCMP_SYS(sendfile),  SCMP_SYS(pread64),
  SCMP_SYS(pwrite64),  SCMP_SYS(preadv),          SCMP_SYS(pwritev),   SCMP_SYS(preadv2),
  SCMP_SYS(pwritev2)};

/// Of lines that are open: there are no others.
constexpr std::array of_lines{SCMP_SYS(close_range),
                              SCMP_SYS(dup),
                              SCMP_SYS(dup2),
                              SCMP_SYS(dup3),
                              SCMP_SYS(pipe),
                              SCMP_SYS(pipe2),
                              SCMP_SYS(poll),
                              SCMP_SYS(ppoll),
                              SCMP_SYS(select),
                              SCMP_SYS(pselect6),
                              SCMP_SYS(epoll_create),
                              SCMP_SYS(epoll_create1),
                              SCMP_SYS(epoll_ctl),
                              SCMP_SYS(epoll_wait),
                              SCMP_SYS(epoll_pwait),
                              SCMP_SYS(epoll_pwait2),
                              SCMP_SYS(eventfd),
                              SCMP_SYS(eventfd2),
                              SCMP_SYS(signalfd4),
                              SCMP_SYS(timerfd_create),
                              SCMP_SYS(timerfd_settime),
                              SCMP_SYS(timerfd_gettime),
                              SCMP_SYS(sendto),
                              SCMP_SYS(recvfrom),
                              SCMP_SYS(sendmsg),
                              SCMP_SYS(recvmsg),
                              SCMP_SYS(getsockopt),
                              SCMP_SYS(getsockname),
                              SCMP_SYS(getpeername),
                              SCMP_SYS(shutdown)};

/// What is refused: libraries try some of it, and go on without.
constexpr std::array harmless{
  SCMP_SYS(chmod),          SCMP_SYS(fchmod),        SCMP_SYS(fchmodat),
  SCMP_SYS(chown),          SCMP_SYS(fchown),        SCMP_SYS(lchown),
  SCMP_SYS(fchownat),       SCMP_SYS(truncate),      SCMP_SYS(utime),
  SCMP_SYS(utimes),         SCMP_SYS(utimensat),     SCMP_SYS(futimesat),
  SCMP_SYS(setxattr),       SCMP_SYS(lsetxattr),     SCMP_SYS(fsetxattr),
  SCMP_SYS(removexattr),    SCMP_SYS(lremovexattr),  SCMP_SYS(fremovexattr),
  SCMP_SYS(link),           SCMP_SYS(linkat),        SCMP_SYS(symlink),
  SCMP_SYS(symlinkat),      SCMP_SYS(mknod),         SCMP_SYS(mknodat),
  SCMP_SYS(memfd_create),   SCMP_SYS(socketpair),    SCMP_SYS(setpgid),
  SCMP_SYS(setsid),         SCMP_SYS(umask),         SCMP_SYS(setrlimit),
  SCMP_SYS(setpriority),    SCMP_SYS(ioprio_set),    SCMP_SYS(sched_setscheduler),
  SCMP_SYS(sched_setparam), SCMP_SYS(sched_setattr), SCMP_SYS(personality),
  SCMP_SYS(seccomp),        SCMP_SYS(shmget),        SCMP_SYS(shmat),
  SCMP_SYS(msgget),         SCMP_SYS(semget),        SCMP_SYS(mq_open),
  SCMP_SYS(migrate_pages),  SCMP_SYS(move_pages)};

struct deed {
  int call;
  misdeed what;
};

/// What ends the process.
constexpr std::array deeds{deed{SCMP_SYS(socket), misdeed::network},
                           deed{SCMP_SYS(connect), misdeed::network},
                           deed{SCMP_SYS(bind), misdeed::network},
                           deed{SCMP_SYS(listen), misdeed::network},
                           deed{SCMP_SYS(accept), misdeed::network},
                           deed{SCMP_SYS(accept4), misdeed::network},
                           deed{SCMP_SYS(execve), misdeed::program},
                           deed{SCMP_SYS(execveat), misdeed::program},
                           deed{SCMP_SYS(fork), misdeed::process},
                           deed{SCMP_SYS(vfork), misdeed::process},
                           deed{SCMP_SYS(clone), misdeed::process},
                           deed{SCMP_SYS(kill), misdeed::other_process},
                           deed{SCMP_SYS(tkill), misdeed::other_process},
                           deed{SCMP_SYS(tgkill), misdeed::other_process},
                           deed{SCMP_SYS(rt_sigqueueinfo), misdeed::other_process},
                           deed{SCMP_SYS(rt_tgsigqueueinfo), misdeed::other_process},
                           deed{SCMP_SYS(pidfd_open), misdeed::other_process},
                           deed{SCMP_SYS(pidfd_getfd), misdeed::other_process},
                           deed{SCMP_SYS(pidfd_send_signal), misdeed::other_process},
                           deed{SCMP_SYS(ptrace), misdeed::other_process},
                           deed{SCMP_SYS(process_vm_readv), misdeed::other_process},
                           deed{SCMP_SYS(process_vm_writev), misdeed::other_process},
                           deed{SCMP_SYS(process_madvise), misdeed::other_process},
                           deed{SCMP_SYS(kcmp), misdeed::other_process},
                           deed{SCMP_SYS(setuid), misdeed::rights},
                           deed{SCMP_SYS(setgid), misdeed::rights},
                           deed{SCMP_SYS(setreuid), misdeed::rights},
                           deed{SCMP_SYS(setregid), misdeed::rights},
                           deed{SCMP_SYS(setresuid), misdeed::rights},
                           deed{SCMP_SYS(setresgid), misdeed::rights},
                           deed{SCMP_SYS(setfsuid), misdeed::rights},
                           deed{SCMP_SYS(setfsgid), misdeed::rights},
                           deed{SCMP_SYS(setgroups), misdeed::rights},
                           deed{SCMP_SYS(capset), misdeed::rights},
                           deed{SCMP_SYS(mount), misdeed::rights},
                           deed{SCMP_SYS(umount2), misdeed::rights},
                           deed{SCMP_SYS(pivot_root), misdeed::rights},
                           deed{SCMP_SYS(chroot), misdeed::rights},
                           deed{SCMP_SYS(unshare), misdeed::rights},
                           deed{SCMP_SYS(setns), misdeed::rights},
                           deed{SCMP_SYS(open_tree), misdeed::rights},
                           deed{SCMP_SYS(move_mount), misdeed::rights},
                           deed{SCMP_SYS(fsopen), misdeed::rights},
                           deed{SCMP_SYS(fsmount), misdeed::rights},
                           deed{SCMP_SYS(keyctl), misdeed::rights},
                           deed{SCMP_SYS(add_key), misdeed::rights},
                           deed{SCMP_SYS(request_key), misdeed::rights},
                           deed{SCMP_SYS(bpf), misdeed::kernel},
                           deed{SCMP_SYS(io_uring_setup), misdeed::kernel},
                           deed{SCMP_SYS(io_uring_enter), misdeed::kernel},
                           deed{SCMP_SYS(io_uring_register), misdeed::kernel},
                           deed{SCMP_SYS(userfaultfd), misdeed::kernel},
                           deed{SCMP_SYS(perf_event_open), misdeed::kernel},
                           deed{SCMP_SYS(init_module), misdeed::kernel},
                           deed{SCMP_SYS(finit_module), misdeed::kernel},
                           deed{SCMP_SYS(delete_module), misdeed::kernel},
                           deed{SCMP_SYS(kexec_load), misdeed::kernel},
                           deed{SCMP_SYS(kexec_file_load), misdeed::kernel},
                           deed{SCMP_SYS(reboot), misdeed::kernel},
                           deed{SCMP_SYS(swapon), misdeed::kernel},
                           deed{SCMP_SYS(swapoff), misdeed::kernel},
                           deed{SCMP_SYS(iopl), misdeed::kernel},
                           deed{SCMP_SYS(ioperm), misdeed::kernel},
                           deed{SCMP_SYS(modify_ldt), misdeed::kernel},
                           deed{SCMP_SYS(quotactl), misdeed::kernel},
                           deed{SCMP_SYS(acct), misdeed::kernel},
                           deed{SCMP_SYS(open_by_handle_at), misdeed::kernel},
                           deed{SCMP_SYS(name_to_handle_at), misdeed::kernel},
                           deed{SCMP_SYS(fanotify_init), misdeed::kernel},
                           deed{SCMP_SYS(sethostname), misdeed::kernel},
                           deed{SCMP_SYS(setdomainname), misdeed::kernel},
                           deed{SCMP_SYS(settimeofday), misdeed::kernel},
                           deed{SCMP_SYS(clock_settime), misdeed::kernel},
                           deed{SCMP_SYS(adjtimex), misdeed::kernel},
                           deed{SCMP_SYS(clock_adjtime), misdeed::kernel},
                           deed{SCMP_SYS(syslog), misdeed::kernel},
                           deed{SCMP_SYS(vhangup), misdeed::kernel}};

misdeed misdeed_by(int call) {
  for (const auto& one : deeds)
    if (one.call == call)
      return one.what;
  return misdeed::kernel;
}

/// Only what a handler may do: nobody else has a say, `rt_sigaction` is closed for this signal.
void end_for_misdeed(int, siginfo_t* info, void*) {
  _exit(status_of(misdeed_by(info->si_syscall)));
}

/// Signals, by the process's number.
constexpr std::array to_processes{SCMP_SYS(kill), SCMP_SYS(tgkill), SCMP_SYS(rt_sigqueueinfo),
                                  SCMP_SYS(rt_tgsigqueueinfo)};

/// Rules as they are gathered; the first that the library refuses is remembered.
class filter {
public:
  filter() : context_(seccomp_init(SCMP_ACT_ERRNO(ENOSYS)), &seccomp_release) {}

  void allow(std::span<const int> calls) {
    for (const int call : calls)
      add(SCMP_ACT_ALLOW, call, {});
  }
  void refuse(std::span<const int> calls) {
    for (const int call : calls)
      add(SCMP_ACT_ERRNO(EPERM), call, {});
  }
  void allow_if(int call, scmp_arg_cmp condition) { add(SCMP_ACT_ALLOW, call, {condition}); }
  void end_if(int call, scmp_arg_cmp condition) { add(SCMP_ACT_TRAP, call, {condition}); }
  void end(int call) { add(SCMP_ACT_TRAP, call, {}); }
  void add(std::uint32_t action, int call, std::initializer_list<scmp_arg_cmp> conditions) {
    const int done = seccomp_rule_add_array(
      context_.get(), action, call, static_cast<unsigned>(conditions.size()), conditions.begin());
    if (done != 0 && fault_ == 0)
      fault_ = done;
  }
  void set(scmp_filter_attr what, std::uint32_t value) {
    const int done = seccomp_attr_set(context_.get(), what, value);
    if (done != 0 && fault_ == 0)
      fault_ = done;
  }

  /// From now on, for all threads.
  expected<void> load() {
    set(SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    set(SCMP_FLTATR_CTL_TSYNC, 1);
    set(SCMP_FLTATR_CTL_OPTIMIZE, 2);  // A tree: each call passes few comparisons.
    if (fault_ == 0)
      fault_ = seccomp_load(context_.get());
    if (fault_ != 0)
      return fail(ec::service_unavailable,
                  std::string("system calls cannot be bounded: ") + std::strerror(-fault_),
                  "Set sandbox = \"off\" under [work] where the kernel does not allow it");
    return {};
  }

private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
  int fault_ = 0;
};

/// Memory of this process's own, and files: memory that is shared counts in no limit.
void add_memory(filter& to) {
  const int call = SCMP_SYS(mmap);
  to.allow_if(call, SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, 0));
  to.allow_if(call, SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_TYPE, MAP_PRIVATE));
  to.add(SCMP_ACT_ERRNO(EPERM), call,
         {SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_TYPE | MAP_ANONYMOUS, MAP_SHARED | MAP_ANONYMOUS)});
}

/// Signals to this process alone; the one that tells of misdeeds keeps its handler.
void add_signals(filter& to) {
  to.allow_if(SCMP_SYS(rt_sigaction), SCMP_A0(SCMP_CMP_NE, SIGSYS));
  to.add(SCMP_ACT_ERRNO(EPERM), SCMP_SYS(rt_sigaction), {SCMP_A0(SCMP_CMP_EQ, SIGSYS)});
  const auto self = static_cast<scmp_datum_t>(getpid());
  for (const int call : to_processes) {
    to.allow_if(call, SCMP_A0(SCMP_CMP_EQ, self));
    to.end_if(call, SCMP_A0(SCMP_CMP_NE, self));
  }
}

/// A file that may be read must not be emptied by opening it: Landlock knows that since Linux 6.2.
void add_files(filter& to) {
  const auto add = [&](int call, auto with) {
    to.allow_if(call, with(SCMP_CMP_MASKED_EQ, O_TRUNC, 0));
    to.allow_if(call, with(SCMP_CMP_MASKED_EQ, O_ACCMODE, O_WRONLY));
    to.allow_if(call, with(SCMP_CMP_MASKED_EQ, O_ACCMODE, O_RDWR));
    to.add(SCMP_ACT_ERRNO(EPERM), call,
           {with(SCMP_CMP_MASKED_EQ, O_ACCMODE | O_TRUNC, O_RDONLY | O_TRUNC)});
  };
  add(SCMP_SYS(open), [](scmp_compare how, std::uint64_t mask, std::uint64_t value) {
    return SCMP_A1(how, mask, value);
  });
  add(SCMP_SYS(openat), [](scmp_compare how, std::uint64_t mask, std::uint64_t value) {
    return SCMP_A2(how, mask, value);
  });
  // One that nobody may enter could not be removed with the rest.
  to.allow_if(SCMP_SYS(mkdir), SCMP_A1(SCMP_CMP_MASKED_EQ, S_IRWXU, S_IRWXU));
  to.allow_if(SCMP_SYS(mkdirat), SCMP_A2(SCMP_CMP_MASKED_EQ, S_IRWXU, S_IRWXU));
  for (const int what : {F_DUPFD, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_GETLK, F_SETLK, F_SETLKW,
                         F_DUPFD_CLOEXEC, F_GETPIPE_SZ, F_GET_SEALS})
    to.allow_if(SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(what)));
  for (const auto what : std::initializer_list<std::uint64_t>{FIONREAD, FIONBIO, FIOCLEX, FIONCLEX,
                                                              TCGETS, TIOCGWINSZ})
    to.allow_if(SCMP_SYS(ioctl), SCMP_A1(SCMP_CMP_EQ, what));
}

/// Of this process and its threads alone.
void add_own(filter& to) {
  // Of lines: their room and waits, and no programs for the kernel (SO_ATTACH_FILTER).
  for (const int what : {TCP_NODELAY, SO_SNDBUF, SO_RCVBUF, SO_KEEPALIVE, SO_RCVTIMEO, SO_SNDTIMEO})
    to.allow_if(SCMP_SYS(setsockopt), SCMP_A2(SCMP_CMP_EQ, static_cast<scmp_datum_t>(what)));
  to.add(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), {SCMP_A0(SCMP_CMP_EQ, 0), SCMP_A2(SCMP_CMP_EQ, 0)});
  to.allow_if(SCMP_SYS(sched_setaffinity), SCMP_A0(SCMP_CMP_EQ, 0));
  constexpr int name_of_memory = 0x53564d41;  // PR_SET_VMA, newer than Debian 12's header.
  for (const int what : {PR_SET_NAME, PR_GET_NAME, PR_GET_DUMPABLE, PR_GET_NO_NEW_PRIVS,
                         PR_SET_NO_NEW_PRIVS, PR_CAPBSET_READ, PR_GET_TIMERSLACK, PR_SET_TIMERSLACK,
                         PR_GET_PDEATHSIG, PR_GET_SECCOMP, name_of_memory})
    to.allow_if(SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(what)));
}

void add_threads(filter& to) {
  to.allow_if(SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
  to.end_if(SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
}

/// The C library looks for its name service's daemon and the machine's addresses by sockets of
/// these families.
void add_sockets(filter& to) {
  for (const int probed : {AF_UNIX, AF_NETLINK})
    to.add(SCMP_ACT_ERRNO(EACCES), SCMP_SYS(socket),
           {SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(probed))});
  to.end_if(SCMP_SYS(socket), SCMP_A0(SCMP_CMP_GT, AF_NETLINK));
  to.end_if(SCMP_SYS(socket), SCMP_A0(SCMP_CMP_EQ, AF_UNSPEC));
  for (int family = AF_UNIX + 1; family < AF_NETLINK; ++family)
    to.end_if(SCMP_SYS(socket), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(family)));
}

bool belongs_to_sanitizers(misdeed what) {
  return sanitized &&
         (what == misdeed::program || what == misdeed::process || what == misdeed::other_process);
}

void add_deeds(filter& to) {
  for (const auto& one : deeds) {
    const bool has_rules = one.call == SCMP_SYS(socket) || one.call == SCMP_SYS(clone) ||
                           std::ranges::find(to_processes, one.call) != to_processes.end();
    if (belongs_to_sanitizers(one.what))
      to.allow(std::array{one.call});
    else if (!has_rules)
      to.end(one.call);
  }
}

}  // namespace

expected<void> confine_calls(calls left) {
  struct sigaction action {};
  action.sa_sigaction = end_for_misdeed;
  action.sa_flags = SA_SIGINFO;
  if (sigaction(SIGSYS, &action, nullptr) != 0)
    return fail(ec::service_unavailable, "no handler for what workers may not do");
  filter all;
  all.allow(basic);
  add_memory(all);
  if (!sanitized)
    add_signals(all);
  else
    all.allow(std::array{SCMP_SYS(rt_sigaction), SCMP_SYS(prctl), SCMP_SYS(personality),
                         SCMP_SYS(sched_getaffinity), SCMP_SYS(wait4)});
  if (left == calls::of_plugins || sanitized) {
    all.refuse(harmless);
    all.allow(of_threads);
    all.allow(of_facts);
    all.allow(of_files);
    all.allow(of_lines);
    add_files(all);
    add_own(all);
    add_sockets(all);
    if (!sanitized)
      add_threads(all);
    add_deeds(all);
  }
  return all.load();
}

}  // namespace tedit::sandbox
