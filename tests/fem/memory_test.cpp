// SPDX-License-Identifier: AGPL-3.0-or-later
// A solve that does not fit is refused before it starts; one that runs out all the same says so.
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>

#include <gmock/gmock.h>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using tedit::test::box_mesh;

problem bar(std::array<int, 3> cells, int order) {
  load_case loads;
  loads.materials = {{"a", 70e9, 0.33, 2700, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{100, 50, -200}}}};
  return *make_problem(*box_mesh(cells, {1, 1, 1}), loads, order);
}

class NativeMemory : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Orders, NativeMemory, ::testing::Values(1, 2));

TEST_P(NativeMemory, WhatDoesNotFitIsRefusedWithBothSizes) {
  const auto p = bar({8, 8, 8}, GetParam());
  const auto needed = native_solve_bytes(p);

  const auto refused = make_native_backend({.memory_limit = needed - 1})->assemble(p, {});
  const auto taken = make_native_backend({.memory_limit = needed})->assemble(p, {});

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::out_of_memory);
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("MiB"));
  EXPECT_FALSE(refused.error().remedy.empty());
  EXPECT_TRUE(taken.has_value());
}

TEST_P(NativeMemory, TheEstimateGrowsWithTheProblem) {
  const auto small = native_solve_bytes(bar({4, 4, 4}, GetParam()));
  const auto large = native_solve_bytes(bar({8, 8, 8}, GetParam()));

  EXPECT_GT(large, 6 * small);
  EXPECT_LT(large, 9 * small);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// In a process of its own with `more` bytes of address space left: 0 when the solve succeeded, 7
/// when it ended with `out_of_memory`, anything else is a defect.
int solve_within(std::size_t more, int order) {
  const auto p = bar({20, 20, 20}, order);
  const auto device =
    make_native_backend({.memory_limit = std::numeric_limits<std::uint64_t>::max()});
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlimit limit{pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more, RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &limit);
  const auto result = solve(p, *device, {}, {});
  if (result)
    return 0;
  return result.error().code == ec::out_of_memory ? 7 : 1;
}

bool succeeded_or_said_so(int status) {
  return WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 7);
}

TEST_P(NativeMemory, MemoryThatRunsOutAnywhereIsAnError) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(_exit(solve_within(1u << 20, GetParam())), ::testing::ExitedWithCode(7), "");
  for (std::size_t mib = 4; mib <= 100; mib += 16)
    EXPECT_EXIT(_exit(solve_within(mib << 20, GetParam())), succeeded_or_said_so, "") << mib;
  EXPECT_EXIT(_exit(solve_within(std::size_t{4} << 30, GetParam())), ::testing::ExitedWithCode(0),
              "");
}

#endif

}  // namespace
}  // namespace tedit::fem
