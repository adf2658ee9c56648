// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/forked_call.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/parallel.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

void say(const caller_line& line, std::uint32_t kind, const std::string& text) {
  line.send(kind, std::as_bytes(std::span(text)));
}

/// What `work` said, and how it ended.
struct outcome {
  std::vector<std::pair<std::uint32_t, std::string>> heard;
  expected<void> end;
};

outcome call(const std::function<void(const caller_line&)>& work, const forked_limits& limits = {},
             const execution& run = {}) {
  outcome result;
  result.end =
    call_forked(work, limits, run, [&](std::uint32_t kind, std::span<const std::byte> bytes) {
      result.heard.emplace_back(
        kind, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    });
  return result;
}

std::string how_it_ended(const std::function<void(const caller_line&)>& work) {
  const auto result = call(work);
  EXPECT_FALSE(result.end.has_value());
  return result.end ? "" : result.end.error().message;
}

TEST(ForkedCall, HandsOverMessagesOfAnySizeInTheirOrder) {
  const std::string large(std::size_t{5} << 20, 'x');

  const auto result = call([&](const caller_line& line) {
    say(line, 7, "one");
    say(line, 8, large);
    say(line, 9, "");
  });

  ASSERT_TRUE(result.end.has_value()) << render(result.end.error());
  ASSERT_EQ(result.heard.size(), 3u);
  EXPECT_EQ(result.heard[0], std::pair(7u, std::string("one")));
  EXPECT_EQ(result.heard[1], std::pair(8u, large));
  EXPECT_EQ(result.heard[2], std::pair(9u, std::string()));
}

TEST(ForkedCall, SaysHowTheCopyDied) {
  const auto fault = [](const caller_line&) {
    signal(SIGSEGV, SIG_DFL);  // A sanitizer has a handler of its own.
    raise(SIGSEGV);
  };
  EXPECT_THAT(how_it_ended(fault), HasSubstr("was killed by signal 11 (Segmentation fault)"));
  EXPECT_THAT(how_it_ended([](const caller_line&) { raise(SIGKILL); }),
              HasSubstr("may have run out of memory"));
  EXPECT_EQ(how_it_ended([](const caller_line&) { _exit(0); }), "ended its process with status 0");
  EXPECT_EQ(how_it_ended([](const caller_line&) { close_range(3, ~0U, 0); }),
            "closed descriptors that are not its own");
}

TEST(ForkedCall, WhatWasSaidBeforeTheEndIsHeard) {
  const auto result = call([](const caller_line& line) {
    say(line, 1, "last words");
    _exit(3);
  });

  ASSERT_EQ(result.heard.size(), 1u);
  EXPECT_EQ(result.heard[0].second, "last words");
  EXPECT_EQ(result.end.error().message, "ended its process with status 3");
}

TEST(ForkedCall, ATimeLimitAndACancelEndIt) {
  const auto sleep_long = [](const caller_line&) { sleep(600); };

  const auto late = call(sleep_long, {std::chrono::milliseconds(50), 0});
  execution run;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    run.cancel.cancel();
  });
  const auto cancelled = call(sleep_long, {}, run);
  later.join();

  EXPECT_EQ(late.end.error().code, ec::timeout);
  EXPECT_EQ(late.end.error().message, "did not end within 0.05 s");
  EXPECT_EQ(cancelled.end.error().code, ec::cancelled);
}

TEST(ForkedCall, AProcessThatTheCopyStartedEndsWithIt) {
  const auto result = call([](const caller_line& line) {
    const pid_t left = fork();
    if (left == 0) {
      sleep(600);  // It holds the copy's end of the line all the time.
      _exit(0);
    }
    say(line, 1, std::to_string(left));
  });

  ASSERT_TRUE(result.end.has_value());
  const auto left = static_cast<pid_t>(std::stol(result.heard.at(0).second));
  for (int i = 0; i < 1000 && kill(left, 0) == 0; ++i)  // Until its new parent has reaped it.
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_NE(kill(left, 0), 0);
}

TEST(ForkedCall, MemoryBeyondTheLimitIsRefusedToTheCopyAlone) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's allocator ends the process instead of throwing";
#endif
  const auto result = call(
    [](const caller_line& line) {
      try {
        const std::string eaten(std::size_t{512} << 20, 'x');
        say(line, 1, eaten.substr(0, 1));
      } catch (const std::bad_alloc&) {
        say(line, 2, "refused");
      }
    },
    {std::chrono::milliseconds(0), std::size_t{128} << 20});

  ASSERT_EQ(result.heard.size(), 1u);
  EXPECT_EQ(result.heard[0].second, "refused");
}

TEST(ForkedCall, LoopsRunOnThreadsOfTheCopysOwn) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "ThreadSanitizer ends a copy of a process with threads that starts one";
#endif
  std::atomic<std::size_t> done{0};
  const auto count = [&](std::size_t first, std::size_t last, std::size_t) {
    done += last - first;
  };
  parallel_for(100, count, 1);  // Now this process has its threads.

  const auto result = call([&](const caller_line& line) {
    done = 0;
    parallel_for(1000, count, 1);
    say(line, 1, std::to_string(done.load()));
  });

  EXPECT_EQ(result.heard.at(0).second, "1000");
  parallel_for(100, count, 1);
  EXPECT_EQ(done.load(), 200u) << "the caller's threads are as they were";
}

}  // namespace
}  // namespace tedit
