// SPDX-License-Identifier: AGPL-3.0-or-later
// A plugin that tries each way out of a worker of a real server, and what stops it
// (docs/operating.md, What workers may do).
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "base/misdeed.hpp"
#include "base/process.hpp"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

#ifdef TEDIT_SANITIZED
/// Their reports need processes, and the calls around them.
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// Whether the kernel takes calls of 32-bit programs; where it does not, one ends the process by
/// itself.
bool takes_old_calls() {
#if defined(__x86_64__)
  const pid_t child = fork();
  if (child == 0) {
    long result = 20;  // getpid
    asm volatile("int $0x80" : "+a"(result) : : "memory");
    _exit(0);
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status);
#else
  return true;
#endif
}

/// A server whose one plugin of others tries to get out, with a document in its folder.
class Escape : public ::testing::Test {
protected:
  scratch_folder folder;
  scratch_folder cache;
  std::unique_ptr<server> host;
  std::unique_ptr<client::client> user;

  void SetUp() override {
    if (const auto can = sandbox::check(); !can)
      GTEST_SKIP() << render(can.error());
    setenv("TEDIT_PLUGIN_PATH", TEDIT_ESCAPE, 1);
    setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
    host = start(options_for(folder, true));
    user = connect(host->url());
    value(user->open("plate", true, true));
    value(user->import_file(plate_mesh, "mm", {}));
    std::ofstream(folder.path() / "token") << "secret";
  }
  void TearDown() override {
    user.reset();
    host.reset();
    unsetenv("TEDIT_PLUGIN_PATH");
  }

  /// What came of a way: the words of the refusal.
  std::string attempt(const std::string& way, const std::filesystem::path& path = {}) {
    const auto done = user->edit("escape", {1}, {{"way", way}, {"path", path.string()}}, {});
    return done ? "an edit" : done.error().message;
  }
};

struct way_and_words {
  const char* way;
  const char* words;
};

std::string name_of(const ::testing::TestParamInfo<way_and_words>& row) {
  return row.param.way;
}

class EndedWay : public Escape, public ::testing::WithParamInterface<way_and_words> {};

constexpr const char* network = "tried to open a network connection";
constexpr const char* program = "tried to start a program";
constexpr const char* process = "tried to start a process";
constexpr const char* other = "tried to reach into another process";
constexpr const char* rights = "tried to gain other rights";
constexpr const char* kernel = "tried to use a part of the system that is closed to it";
constexpr const char* something = "something else that it may not do";

INSTANTIATE_TEST_SUITE_P(
  Ways, EndedWay,
  ::testing::Values(way_and_words{"inet", network}, way_and_words{"inet6", network},
                    way_and_words{"packet", network}, way_and_words{"vsock", network},
                    way_and_words{"connect", network}, way_and_words{"exec", program},
                    way_and_words{"system", something}, way_and_words{"spawn", something},
                    way_and_words{"fork", process}, way_and_words{"clone", process},
                    way_and_words{"kill_parent", other}, way_and_words{"kill_all", other},
                    way_and_words{"kill_group", other}, way_and_words{"ask_parent", other},
                    way_and_words{"ptrace", other}, way_and_words{"read_parent", other},
                    way_and_words{"pidfd", other}, way_and_words{"setuid", rights},
                    way_and_words{"mount", rights}, way_and_words{"unshare", rights},
                    way_and_words{"chroot", rights}, way_and_words{"keyctl", rights},
                    way_and_words{"bpf", kernel}, way_and_words{"io_uring", kernel},
                    way_and_words{"userfaultfd", kernel}, way_and_words{"perf", kernel},
                    way_and_words{"old_call", something},
                    way_and_words{"grow_file", "File size limit exceeded"},
                    way_and_words{"fill_folder", "filled its folder for temporary files"}),
  name_of);

TEST_P(EndedWay, EndsTheWorkerAndIsNamed) {
  const auto& [way, words] = GetParam();
  const std::string said = words;
  if (sanitized && (said == program || said == process || said == other || said == something))
    GTEST_SKIP() << "sanitizers need processes";
#ifdef __SANITIZE_THREAD__
  if (std::string(way) == "setuid")
    GTEST_SKIP() << "all threads are asked by a signal, in which the sanitizer hears no other";
#endif
  if (std::string(way) == "old_call" && !takes_old_calls())
    GTEST_SKIP() << "this kernel takes no calls of 32-bit programs";

  const auto came = attempt(way);

  EXPECT_THAT(came, AllOf(HasSubstr("operation escape"), HasSubstr(words)));
  const auto honest = user->edit("fill_hole", {1, 2}, {}, {});
  EXPECT_TRUE(honest.has_value()) << render(honest.error());
}

TEST_F(Escape, AMisdeedIsToldWithWhoseItIsAndWhatHolds) {
  value(user->operations());  // The pool knows the plugins' names once somebody asked.

  const auto done = user->edit("escape", {1}, {{"way", std::string("inet")}}, {});

  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().message,
            "the operation escape of the plugin escape 1.0.0 tried to open a network connection");
  EXPECT_THAT(done.error().remedy, AllOf(HasSubstr("run without network"),
                                         HasSubstr("docs/operating.md, What workers may do")));
  EXPECT_EQ(value(user->status()).workers.front().restarts, 1U) << "it is not tried again";
}

TEST_F(Escape, ThreeMisdeedsInADocumentSwitchTheOperationOff) {
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(attempt("inet"), HasSubstr(network));

  EXPECT_THAT(attempt("own_file"), AllOf(HasSubstr("the operation escape is switched off"),
                                         HasSubstr("the process that ran it tried to open")));
}

/// Ways that libraries take without harm in mind: refused, and the plugin goes on.
class RefusedWay : public Escape, public ::testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Ways, RefusedWay,
                         ::testing::Values("unix", "netlink", "tmp", "shared_folder", "clone3",
                                           "signal_of_a_file", "other_processor", "outlive_parent",
                                           "new_group", "own_handler", "shared_memory",
                                           "memory_file", "more_memory", "new_filter"),
                         [](const auto& row) { return std::string(row.param); });

TEST_P(RefusedWay, IsRefused) {
  const std::string way = GetParam();
  if (sanitized && (way == "own_handler" || way == "outlive_parent" || way == "clone3"))
    GTEST_SKIP() << "sanitizers need it";
  EXPECT_THAT(attempt(way), StartsWith("refused: "));
  EXPECT_EQ(value(user->status()).workers.front().restarts, 0U);
}

/// What is done to files of the server's user: its documents, its token.
class FileWay : public Escape, public ::testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Ways, FileWay,
                         ::testing::Values("read", "read_through_proc", "write", "make", "truncate",
                                           "truncate_by_reading", "rights", "remove", "rename",
                                           "link", "move_in"),
                         [](const auto& row) { return std::string(row.param); });

TEST_P(FileWay, IsRefusedForEachFileOfTheServer) {
  std::size_t files = 0;
  for (const auto& item : std::filesystem::directory_iterator(folder.path())) {
    if (!item.is_regular_file())
      continue;
    ++files;
    const auto size = item.file_size();
    const auto mode = item.status().permissions();
    EXPECT_THAT(attempt(GetParam(), item.path()), StartsWith("refused: ")) << item.path();
    ASSERT_TRUE(std::filesystem::exists(item.path()));
    EXPECT_GE(std::filesystem::file_size(item.path()), size);
    EXPECT_EQ(std::filesystem::status(item.path()).permissions(), mode);
    EXPECT_FALSE(std::filesystem::exists(item.path().string() + ".new"));
  }
  EXPECT_GE(files, 2U) << "a document and a token";
}

TEST_F(Escape, FoldersOfTheUserAreNotListed) {
  const std::array<std::filesystem::path, 5> folders{folder.path(), cache.path(), "/tmp", "/root",
                                                     "/home"};
  for (const auto& folder_of_others : folders)
    EXPECT_THAT(attempt("list", folder_of_others), StartsWith("refused: ")) << folder_of_others;
  EXPECT_THAT(attempt("list", TEDIT_ESCAPE), "GOT OUT") << "its own";
}

TEST_F(Escape, WhatOtherProcessesHoldIsNotRead) {
  EXPECT_THAT(attempt("read_environment"), StartsWith("refused: "));
  const auto mine = "/proc/" + std::to_string(getpid());
  EXPECT_THAT(attempt("read", mine + "/mem"), StartsWith("refused: "));
  EXPECT_THAT(attempt("read", mine + "/maps"), StartsWith("refused: "));
  EXPECT_THAT(attempt("read", "/etc/passwd"), StartsWith("refused: "));
}

TEST_F(Escape, TemporaryFilesLieInAFolderThatGoesWithTheWorker) {
  const auto said = attempt("own_file");

  ASSERT_THAT(said, HasSubstr("in "));
  const std::filesystem::path own = said.substr(said.find('/'));
  EXPECT_THAT(own.filename().string(), StartsWith("tedit-worker-"));
  EXPECT_TRUE(std::filesystem::exists(own / "mine.txt"));
  EXPECT_EQ(std::filesystem::status(own).permissions(), std::filesystem::perms::owner_all);
  EXPECT_THAT(attempt("inet"), HasSubstr(network));
  EXPECT_FALSE(std::filesystem::exists(own)) << "the worker has ended";
  const std::filesystem::path next = attempt("own_file").substr(said.find('/'));
  EXPECT_NE(next, own);
  EXPECT_TRUE(std::filesystem::exists(next));
  user.reset();
  host.reset();
  EXPECT_FALSE(std::filesystem::exists(next)) << "the server has ended";
}

TEST_F(Escape, WithoutTheSandboxItGetsOut) {
  user.reset();
  auto options = options_for(folder, true);
  options.sandbox = false;
  host.reset();
  host = start(options);
  user = connect(host->url());
  value(user->open("plate", false, false));

  EXPECT_EQ(attempt("unix"), "GOT OUT");
  EXPECT_EQ(attempt("inet"), "GOT OUT");
  EXPECT_EQ(attempt("read", folder.path() / "token"), "GOT OUT");
  EXPECT_TRUE(user->edit("fill_hole", {1, 2}, {}, {}).has_value());
}

}  // namespace
}  // namespace tedit::test
