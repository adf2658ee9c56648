// SPDX-License-Identifier: AGPL-3.0-or-later
// A solve that is cancelled at any of its checks ends with `cancelled`, and its session goes on.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "fem/solve_session.hpp"
#include "tests/support/edits.hpp"
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
  /// Starts from what there is, so the last digits differ.
  void expect_near(const expected<std::vector<double>>& got, const std::vector<double>& right) {
    ASSERT_TRUE(got.has_value()) << render(got.error());
    const double largest =
      std::abs(std::ranges::max(right, {}, [](double u) { return std::abs(u); }));
    ASSERT_EQ(got->size(), right.size());
    for (std::size_t i = 0; i < right.size(); ++i)
      ASSERT_NEAR((*got)[i], right[i], 1e-5 * largest) << i;
  }

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
  EXPECT_EQ(*again, *right);
  expect_near(kept, *right);
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

/// A mesh with so many tets that some can be cut up and the rest be followed.
class CancelAfterAnEdit : public Cancel {
protected:
  void SetUp() override {
    Cancel::SetUp();
    edited_ = test::split(part_, [](tet_id t) { return t == 700; });
    again_ = test::split(edited_, [](tet_id t) { return t == 40; });
    ASSERT_TRUE(edited_ && again_);
  }

  /// The version solved without history.
  solution anew(const version_ptr& mesh) {
    auto result = solve_session().solve(mesh, loads_, GetParam(), *device_, {}, {});
    EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
    return result ? std::move(result->solution) : solution{};
  }

  /// Nodes of a problem that followed an edit have other numbers.
  static void expect_same(const expected<solve_session::result>& got, const solution& right,
                          bool assembled) {
    ASSERT_TRUE(got.has_value()) << render(got.error());
    EXPECT_EQ(got->assembled, assembled);
    EXPECT_NEAR(got->solution.compliance_j, right.compliance_j, 1e-5 * right.compliance_j);
    EXPECT_NEAR(got->solution.max_displacement_m, right.max_displacement_m,
                1e-5 * right.max_displacement_m);
    EXPECT_NEAR(got->solution.max_von_mises_pa, right.max_von_mises_pa,
                1e-4 * right.max_von_mises_pa);
  }

  /// On a session that knows `part_`, solves the edit and cancels at a check. False when it was
  /// over before.
  bool cancelled_at(std::uint64_t poll, solve_session& session) {
    EXPECT_TRUE(solve(session, part_).has_value());
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = solve(session, edited_, run);
    EXPECT_TRUE(result || result.error().code == ec::cancelled) << render(result.error());
    return !result;
  }

  version_ptr part_ = box_mesh({6, 6, 7}, {1, 1, 1});
  version_ptr edited_, again_;
};

INSTANTIATE_TEST_SUITE_P(Orders, CancelAfterAnEdit, ::testing::Values(1, 2));

TEST_P(CancelAfterAnEdit, AtAnyCheckTheSystemIsKept) {
  const auto right = anew(edited_);
  bool cancelled = true;
  std::uint64_t poll = 1;
  for (; cancelled; poll += 1 + poll / 2) {
    solve_session session;
    cancelled = cancelled_at(poll, session);
    const auto after = session.solve(edited_, loads_, GetParam(), *device_, {}, {});
    ASSERT_NO_FATAL_FAILURE(expect_same(after, right, false)) << poll;
  }
  EXPECT_GT(poll, 50);  // The update and the iterations after it were both hit.
}

TEST_P(CancelAfterAnEdit, WhileTheSystemFollowsTheNextEditIsFollowed) {
  solve_session session;
  ASSERT_TRUE(cancelled_at(1, session));

  const auto after = session.solve(again_, loads_, GetParam(), *device_, {}, {});

  expect_same(after, anew(again_), false);
}

TEST_P(CancelAfterAnEdit, WhileTheSystemFollowsTheSessionMayForgetOrEnd) {
  solve_session session;
  ASSERT_TRUE(cancelled_at(1, session));
  session.forget();
  const auto after = session.solve(edited_, loads_, GetParam(), *device_, {}, {});
  expect_same(after, anew(edited_), true);
  {
    solve_session other;
    ASSERT_TRUE(cancelled_at(1, other));
  }
}

TEST_P(CancelAfterAnEdit, AnEditThatIsRefusedMeanwhileIsForgotten) {
  auto loose = loads_;
  loose.constraints = {{{1}, prescribed_displacement{{}, {}, 0.0}}};
  solve_session session;
  ASSERT_TRUE(solve(session, part_).has_value());
  execution run;
  run.cancel = cancel_token::at_poll(1);
  ASSERT_FALSE(session.solve(edited_, loose, GetParam(), *device_, {}, run).has_value());

  const auto after = session.solve(edited_, loads_, GetParam(), *device_, {}, {});

  expect_same(after, anew(edited_), true);
}

}  // namespace
}  // namespace tedit::fem
