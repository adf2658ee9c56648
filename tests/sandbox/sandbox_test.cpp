// SPDX-License-Identifier: AGPL-3.0-or-later
#include "sandbox/sandbox.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/said.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

/// What `work` says in a copy of this process that is confined to `reach`.
std::string said_confined(const sandbox::reach& reach, const std::function<std::string()>& work) {
  forked_limits limits;
  limits.confine = [&]() -> expected<void> {
    if (auto ok = sandbox::confine_files(reach); !ok)
      return ok;
    return sandbox::confine_calls();
  };
  const auto heard = test::said_in_copy(limits, work);
  return heard ? *heard : heard.error().message;
}

std::string could(bool done) {
  return done ? "done" : "refused";
}

class Sandbox : public ::testing::Test {
protected:
  test::scratch_folder given;
  test::scratch_folder own;
  test::scratch_folder others;
  sandbox::reach reach{{given.path()}, own.path(), 1 << 20};

  void SetUp() override {
    if (const auto can = sandbox::check(); !can)
      GTEST_SKIP() << render(can.error());
    for (const auto* folder : {&given, &own, &others})
      std::ofstream(folder->path() / "file") << "content";
  }
};

TEST_F(Sandbox, IsThereAndWantedUnlessItIsSwitchedOff) {
  EXPECT_TRUE(sandbox::is_wanted());
  setenv("TEDIT_SANDBOX", "off", 1);
  EXPECT_FALSE(sandbox::is_wanted());
  EXPECT_TRUE(sandbox::is_switched_off());
  setenv("TEDIT_SANDBOX", "on", 1);
  EXPECT_TRUE(sandbox::is_wanted());
  unsetenv("TEDIT_SANDBOX");
}

TEST_F(Sandbox, WhatIsGivenIsReadAndNothingElse) {
  const auto read = [](const std::filesystem::path& file) {
    return [file] { return could(std::ifstream(file / "file").good()); };
  };
  EXPECT_EQ(said_confined(reach, read(given.path())), "done");
  EXPECT_EQ(said_confined(reach, read(own.path())), "done");
  EXPECT_EQ(said_confined(reach, read(others.path())), "refused");
}

TEST_F(Sandbox, FilesAreMadeInTheOwnFolderAlone) {
  const auto make = [](const std::filesystem::path& folder) {
    return [folder] { return could(std::ofstream(folder / "new").good()); };
  };
  EXPECT_EQ(said_confined(reach, make(own.path())), "done");
  EXPECT_EQ(said_confined(reach, make(given.path())), "refused");
  EXPECT_EQ(said_confined(reach, make(others.path())), "refused");
  reach.own_folder.clear();
  EXPECT_EQ(said_confined(reach, make(own.path())), "refused");
}

TEST_F(Sandbox, AFileGrowsToItsLimit) {
  const auto grow = [&](off_t bytes) {
    return said_confined(reach, [&, bytes] {
      const int file = open((own.path() / "file").c_str(), O_WRONLY);
      return could(ftruncate(file, bytes) == 0);
    });
  };
  EXPECT_EQ(grow(1 << 20), "done");
  EXPECT_THAT(grow((1 << 20) + 1), HasSubstr("File size limit exceeded"));
}

TEST_F(Sandbox, RightsOfRootAndRoomAboveTheLimitsAreGone) {
  EXPECT_EQ(said_confined(reach,
                          [] {
                            std::ifstream in("/proc/thread-self/status");
                            __user_cap_header_struct head{_LINUX_CAPABILITY_VERSION_3, 0};
                            std::array<__user_cap_data_struct, 2> rights{};
                            (void)syscall(SYS_capget, &head, rights.data());
                            rlimit files{};
                            getrlimit(RLIMIT_NOFILE, &files);
                            return could(rights[0].permitted == 0 && rights[1].permitted == 0 &&
                                         files.rlim_cur == files.rlim_max);
                          }),
            "done");
}

// A thread that was there before must not be a way around.
TEST_F(Sandbox, AllThreadsAreBounded) {
  forked_limits limits;
  std::atomic<bool> go{false};
  limits.confine = [&] { return sandbox::confine_files(reach); };
  const auto end = call_forked(
    [&](const caller_line&) {
      std::thread before([&] {
        while (!go)
          std::this_thread::yield();
        (void)!socket(AF_INET, SOCK_STREAM, 0);
      });
      if (sandbox::confine_calls().has_value())
        go = true;
      before.join();
    },
    limits, {}, [](std::uint32_t, auto) {});

  ASSERT_FALSE(end.has_value());
  EXPECT_EQ(end.error().message, "tried to open a network connection");
}

TEST_F(Sandbox, AFilterReadsAndWritesWhatIsOpen) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs as much at its end as a plugin has";
#endif
  forked_limits limits;
  limits.confine = [&]() -> expected<void> {
    if (auto ok = sandbox::confine_files({}); !ok)
      return ok;
    return sandbox::confine_calls(sandbox::calls::of_filters);
  };
  std::string heard;
  const auto end = call_forked(
    [&](const caller_line& line) {
      const std::string text =
        could(open("/dev/null", O_RDONLY) >= 0) + " " + could(socket(AF_INET, SOCK_STREAM, 0) >= 0);
      line.send(1, std::as_bytes(std::span(text)));
    },
    limits, {},
    [&](std::uint32_t, std::span<const std::byte> bytes) {
      heard.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });

  EXPECT_TRUE(end.has_value()) << render(end.error());
  EXPECT_EQ(heard, "refused refused");
}

}  // namespace
}  // namespace tedit
