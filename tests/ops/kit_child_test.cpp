// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "ops/conformance/child.hpp"

namespace tedit::ops {
namespace {

// Two threads that said where they are at once now and then lost the line that ends a check: a
// correct plugin failed one in a thousand checks.
TEST(KitChild, NoLineOfSeveralThreadsIsLost) {
  constexpr int threads = 4;
  constexpr int lines = 2000;
  const auto work = [](const child_reporter& to) {
    std::vector<std::jthread> all;
    for (int t = 0; t < threads; ++t)
      all.emplace_back([&to, t] {
        for (int i = 0; i < lines; ++i)  // Of different lengths: what is written over shows.
          to.say(std::to_string(t) + "." + std::to_string(i) + std::string(20U * t, '-'));
      });
  };

  const auto outcome = run_forked(work, "/tmp", {});

  EXPECT_EQ(outcome.death, "");
  EXPECT_EQ(outcome.lines.size(), std::size_t{threads} * lines);
  EXPECT_EQ(std::set(outcome.lines.begin(), outcome.lines.end()).size(),
            std::size_t{threads} * lines);
}

}  // namespace
}  // namespace tedit::ops
