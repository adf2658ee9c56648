// SPDX-License-Identifier: AGPL-3.0-or-later
// A system on a Vulkan device that follows edits, against systems made anew and the native cycle.
#include "fem/native/backend.hpp"
#include "fem/solve_session.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "tests/gpu/followed_system.hpp"

namespace tedit::fem {
namespace {

using test::followed_system;
using test::held_at_one_end;
using test::in_pieces;

class VulkanUpdate : public ::testing::TestWithParam<int> {
protected:
  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  static void expect_follows_edits(const vulkan_settings& settings) {
    followed_system one(bar(), held_at_one_end(), GetParam(), settings);
    for (int round = 0; round < 2; ++round) {
      const double at = 0.5 + 0.75 * round;
      const auto follow = [&](const version_ptr& next) {
        ASSERT_NO_FATAL_FAILURE(one.follow(next));
        ASSERT_NO_FATAL_FAILURE(one.expect_as_fresh_and_native());
      };
      ASSERT_NO_FATAL_FAILURE(
        follow(tedit::test::split(one.mesh(), [&](tet_id t) { return t % 801 == 17u * round; })));
      ASSERT_NO_FATAL_FAILURE(follow(tedit::test::dig(
        one.mesh(),
        [&](vec3 x) {
          return norm(x - vec3{at, .75, 1.5}) < 0.22;
        },
        7)));
      ASSERT_NO_FATAL_FAILURE(follow(tedit::test::move(one.mesh(), [&](vec3 x) {
        return norm(x - vec3{at, .75, .75}) < 0.2 ? x + vec3{0, .01, .01} : x;
      })));
    }
  }

  static version_ptr bar() { return tedit::test::box_mesh({16, 6, 6}, {4, 1.5, 1.5}); }

  int before_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Orders, VulkanUpdate, ::testing::Values(1, 2));

TEST_P(VulkanUpdate, ProductsAndCyclesFollowEdits) {
  expect_follows_edits({});
}

TEST_P(VulkanUpdate, InManyPiecesAndLevelsToo) {
  vulkan_settings settings = in_pieces();
  settings.most_bytes_per_binding = 200'000;  // Four pieces of most, with room in each.
  expect_follows_edits(settings);
}

TEST_P(VulkanUpdate, OneRowASliceAndOneLevelToo) {
  vulkan_settings settings;
  settings.slice_rows = 1;
  settings.group_size = 32;
  settings.multilevel.coarsest = 800;
  expect_follows_edits(settings);
}

/// A grid plane that nearly meets the next one: tets of 1/50 of their height, and back again.
TEST_P(VulkanUpdate, SliverClustersComeAndGo) {
  followed_system one(bar(), held_at_one_end(), GetParam(), {});
  const auto near = [](vec3 x) { return norm(x - vec3{2, .5, .5}) < 0.1; };
  for (int round = 0; round < 2; ++round) {
    ASSERT_NO_FATAL_FAILURE(one.follow(tedit::test::move(one.mesh(), [&](vec3 x) {
      return near(x) ? x + vec3{.245, 0, 0} : x;
    })));
    ASSERT_NO_FATAL_FAILURE(one.expect_as_fresh_and_native());
    ASSERT_NO_FATAL_FAILURE(one.follow(tedit::test::move(one.mesh(), [](vec3 x) {
      return std::abs(x.x - 2.245) < 1e-9 ? x - vec3{.245, 0, 0} : x;
    })));
    ASSERT_NO_FATAL_FAILURE(one.expect_as_fresh_and_native());
  }
}

/// Slices keep their width while their rows fit; the one of this node does not.
version_ptr split_at_middle(const version_ptr& mesh) {
  return tedit::test::split(mesh, [&](tet_id t) {
    return std::ranges::any_of(mesh->corners(t), [](vec3 x) {
      return norm(x - vec3{2, .75, .75}) < 1e-9;
    });
  });
}

TEST_P(VulkanUpdate, ANodeGetsManyMoreNeighbours) {
  followed_system one(bar(), held_at_one_end(), GetParam(), {});

  ASSERT_NO_FATAL_FAILURE(one.follow(split_at_middle(one.mesh())));

  one.expect_as_fresh_and_native();
}

TEST_P(VulkanUpdate, WithoutRoomForThemTheEditIsRefusedAndTheSystemWorksNoMore) {
  followed_system one(bar(), held_at_one_end(), GetParam(), in_pieces());
  ASSERT_NO_FATAL_FAILURE(one.advance(split_at_middle(one.mesh())));

  const auto updated = one.update_device();

  ASSERT_TRUE(updated.has_value()) << render(updated.error());
  EXPECT_FALSE(*updated);
  std::vector<double> y(one.current().dofs());
  EXPECT_FALSE(one.system().multiply(test::wave(y.size(), 0.7), y).has_value());
  EXPECT_FALSE(one.system().solve({test::wave(y.size(), 0.7), y, 1e-4}, 10, {}).has_value());
}

/// Sessions on a Vulkan device: each version solved after the one before, and anew.
class VulkanSession : public VulkanUpdate {
protected:
  solve_session::result value(solve_session& session, const version_ptr& mesh) {
    auto result = session.solve(mesh, held_at_one_end(), GetParam(), *device_, {}, {});
    EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
    return result ? std::move(*result) : solve_session::result{};
  }

  void open(const vulkan_settings& settings) {
    device_ = std::move(*open_vulkan("", settings));
    value(session_, mesh_);
  }

  void expect_same_answer(const version_ptr& next, bool assembled) {
    ASSERT_TRUE(next);
    const auto kept = value(session_, next);
    solve_session anew;
    const auto fresh = value(anew, next);
    const auto& a = kept.solution;
    const auto& b = fresh.solution;
    EXPECT_EQ(kept.assembled, assembled);
    EXPECT_TRUE(a.converged);
    EXPECT_LE(a.true_relative_residual, 1e-6);
    EXPECT_LE(a.iterations, b.iterations + 4);
    EXPECT_NEAR(a.compliance_j, b.compliance_j, 1e-5 * b.compliance_j);
    EXPECT_NEAR(a.max_displacement_m, b.max_displacement_m, 1e-5 * b.max_displacement_m);
    EXPECT_NEAR(a.max_von_mises_pa, b.max_von_mises_pa, 1e-4 * b.max_von_mises_pa);
    mesh_ = next;
  }

  std::unique_ptr<backend> device_;
  solve_session session_;
  version_ptr mesh_ = bar();
};

INSTANTIATE_TEST_SUITE_P(Orders, VulkanSession, ::testing::Values(1, 2));

TEST_P(VulkanSession, EditsCostTheirRowsAndGiveTheSameAnswer) {
  open({});
  for (int round = 0; round < 2; ++round) {
    const double at = 0.7 + round;
    expect_same_answer(tedit::test::split(mesh_, [&](tet_id t) { return t % 801 == 17u * round; }),
                       false);
    expect_same_answer(tedit::test::dig(
                         mesh_,
                         [&](vec3 x) {
                           return norm(x - vec3{at, .75, 1.5}) < 0.22;
                         },
                         7),
                       false);
  }
}

TEST_P(VulkanSession, WithoutRoomForAnEditItIsAssembledAnew) {
  open(in_pieces());

  // 90 elements more: the last range of quadratic ones has room for 84, and no chunk of rows for so
  // many longer rows.
  expect_same_answer(tedit::test::split(mesh_, [](tet_id t) { return t % 118 == 3; }), true);
}

TEST_P(VulkanSession, ACancelAtAnyCheckLeavesTheDeviceUsable) {
  open({});
  const auto solve = [&](solve_session& session, const version_ptr& mesh, const execution& run) {
    return session.solve(mesh, held_at_one_end(), GetParam(), *device_, {}, run);
  };
  solve_session first;
  execution whole;
  const auto right = solve(first, mesh_, whole);
  ASSERT_TRUE(right.has_value());
  const auto last = whole.cancel.polls();
  ASSERT_GE(last, 100);
  // Submissions follow measured times, and with them the number of checks.
  for (std::uint64_t poll = 1; poll <= last / 2; poll += 1 + poll / 3) {
    solve_session session;
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = solve(session, mesh_, run);
    ASSERT_FALSE(result.has_value()) << poll;
    ASSERT_EQ(result.error().code, ec::cancelled) << render(result.error());
  }
  solve_session again;
  const auto after = solve(again, mesh_, {});
  ASSERT_TRUE(after.has_value());
  EXPECT_EQ(after->solution.displacement, right->solution.displacement);
}

TEST_P(VulkanSession, ACancelAfterAnEditKeepsTheSystem) {
  open({});
  for (std::uint64_t poll = 1; poll < 60; poll += 1 + poll / 2) {
    const auto next = tedit::test::split(mesh_, [&](tet_id t) { return t % 801 == poll; });
    ASSERT_TRUE(next);
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = session_.solve(next, held_at_one_end(), GetParam(), *device_, {}, run);
    ASSERT_TRUE(result || result.error().code == ec::cancelled) << render(result.error());
    EXPECT_TRUE(!result || poll > 5) << poll;
    ASSERT_NO_FATAL_FAILURE(expect_same_answer(next, false)) << poll;
  }
}

/// Some tets cut up in a part that came from CAD. The dense inverse of the coarsest level goes
/// whole: in so coarse a mesh it is most of what is sent.
TEST_P(VulkanUpdate, ARealPartSendsAFractionOfItself) {
  const std::filesystem::path folder = TEDIT_TEST_DATA "/parts/ctc01_plate";
  const auto mesh = import_mesh(folder / "ctc01_plate.coarse.msh", "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");
  ASSERT_TRUE(mesh && loads);
  followed_system one(mesh->version, *loads, GetParam(), {});
  const auto cold = one.system().uploaded_bytes();
  const auto c = mesh->version->corners(0);
  const vec3 centre = 0.25 * (c[0] + c[1] + c[2] + c[3]);

  ASSERT_NO_FATAL_FAILURE(one.follow(tedit::test::split(one.mesh(), [&](tet_id t) {
    const auto x = one.mesh()->corners(t);
    return norm(0.25 * (x[0] + x[1] + x[2] + x[3]) - centre) < 5e-3;
  })));

  EXPECT_GT(one.system().uploaded_bytes(), 0u);
  EXPECT_LT(one.system().uploaded_bytes() - one.dense_bytes(), cold / (GetParam() == 1 ? 6 : 20));
  RecordProperty("cold", static_cast<int>(cold));
  RecordProperty("after", static_cast<int>(one.system().uploaded_bytes()));
  one.expect_as_fresh_and_native();
}

}  // namespace
}  // namespace tedit::fem
