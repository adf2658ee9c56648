// SPDX-License-Identifier: AGPL-3.0-or-later
// A solve that is cancelled at any of its checks ends with `cancelled`, and its session goes on.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fem/native/native_backend.hpp"
#include "fem/solve_session.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using tedit::test::box_mesh;

class Cancel : public ::testing::TestWithParam<int> {
protected:
  [[nodiscard]] expected<std::vector<double>> solve(solve_session& session, const version_ptr& mesh,
                                                    const execution& run = {}) {
    const auto result = session.solve(mesh, loads_, GetParam(), *device_, {}, run);
    return result ? expected<std::vector<double>>(result->solution.displacement)
                  : fail(result.error());
  }

  void SetUp() override {
    loads_.materials = {{"a", 70e9, 0.33, 2700, 0, {}}};
    loads_.constraints = {{{1}, fixed{}}};
    loads_.loads = {{{2}, force{{100, 50, -200}}}};
  }

  load_case loads_;
  std::unique_ptr<backend> device_ = make_native_backend();
  version_ptr mesh_ = box_mesh({3, 3, 4}, {1, 1, 1});
  version_ptr other_ = box_mesh({3, 3, 4}, {1, 1, 1.5});
};

INSTANTIATE_TEST_SUITE_P(Orders, Cancel, ::testing::Values(1, 2));

TEST_P(Cancel, AtAnyCheckOfASolveAndTheSessionGoesOn) {
  solve_session fresh;
  execution whole;
  const auto right = solve(fresh, mesh_, whole);
  ASSERT_TRUE(right.has_value()) << render(right.error());
  const auto last = whole.cancel.polls();
  ASSERT_GE(last, 100);

  solve_session session;
  for (std::uint64_t poll = 1; poll <= last; poll += 1 + poll / 20) {
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = solve(session, poll % 2 == 0 ? mesh_ : other_, run);
    // A warm solve may be over before so many checks.
    ASSERT_TRUE(result || result.error().code == ec::cancelled) << poll << render(result.error());
  }
  solve_session clean;
  const auto again = solve(clean, mesh_);
  const auto kept = solve(session, mesh_);

  ASSERT_TRUE(again.has_value());
  ASSERT_TRUE(kept.has_value()) << render(kept.error());
  EXPECT_EQ(*again, *right);
  const double largest = std::ranges::max(*right, {}, [](double u) { return std::abs(u); });
  for (std::size_t i = 0; i < right->size(); ++i)  // It starts from what it has: other last digits.
    ASSERT_NEAR((*kept)[i], (*right)[i], 1e-5 * std::abs(largest)) << i;
}

TEST_P(Cancel, AtEachCheckOfAFreshSolveNothingComesBack) {
  solve_session fresh;
  execution whole;
  ASSERT_TRUE(solve(fresh, mesh_, whole).has_value());
  for (std::uint64_t poll = 1; poll <= whole.cancel.polls(); poll += 1 + poll / 20) {
    solve_session session;
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = solve(session, mesh_, run);
    ASSERT_FALSE(result.has_value()) << poll;
    ASSERT_EQ(result.error().code, ec::cancelled);
  }
}

}  // namespace
}  // namespace tedit::fem
