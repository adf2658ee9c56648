// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/guard.hpp"

#include <atomic>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/parallel.hpp"

namespace tedit {
namespace {

constexpr std::size_t kItems = 100 * parallel_chunk + 1;

TEST(Guard, MemoryThatRunsOutOnAnyThreadIsAnError) {
  const auto result = guarded([]() -> expected<int> {
    parallel_for(kItems, [](std::size_t, std::size_t, std::size_t) { throw std::bad_alloc(); });
    return 1;
  });

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::out_of_memory);
}

TEST(Guard, ACancelEndsALoopBeforeItsNextChunk) {
  execution run;
  std::atomic<int> chunks{0};

  const auto result = guarded(run, [&]() -> expected<void> {
    parallel_for(kItems, [&](std::size_t, std::size_t, std::size_t) {
      ++chunks;
      run.cancel.cancel();
    });
    return {};
  });

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
  EXPECT_LT(chunks, 100);
}

TEST(Guard, LoopsWorkAgainAfterOneFailed) {
  (void)guarded([]() -> expected<int> {
    parallel_for(kItems, [](std::size_t, std::size_t, std::size_t) { throw std::bad_alloc(); });
    return 1;
  });

  EXPECT_EQ(parallel_sum(kItems, [](std::size_t first, std::size_t last) { return last - first; }),
            kItems);
}

TEST(Guard, ALoopInsideALoopRunsInline) {
  std::atomic<std::size_t> sum{0};
  parallel_for(3 * parallel_chunk, [&](std::size_t, std::size_t, std::size_t) {
    parallel_for(2 * parallel_chunk,
                 [&](std::size_t first, std::size_t last, std::size_t) { sum += last - first; });
  });

  EXPECT_EQ(sum, 6 * parallel_chunk);
}

TEST(Guard, ATokenTripsAtTheGivenCheck) {
  const auto token = cancel_token::at_poll(3);

  EXPECT_FALSE(token.cancelled());
  EXPECT_FALSE(token.cancelled());
  EXPECT_TRUE(token.cancelled());
  EXPECT_TRUE(token.cancelled());
  EXPECT_EQ(token.polls(), 4);
}

TEST(Guard, OutsideOfAScopeNothingIsAsked) {
  const cancel_token token;
  {
    const cancel_scope scope(token);
    check_cancelled();
    EXPECT_EQ(cancel_scope::current(), &token);
  }
  check_cancelled();

  EXPECT_EQ(cancel_scope::current(), nullptr);
  EXPECT_EQ(token.polls(), 1);
}

}  // namespace
}  // namespace tedit
