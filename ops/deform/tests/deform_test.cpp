// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/deform/deform.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

vec3 moved_by(const version_ptr& before, const edit_result& after, vec3 at) {
  for (vertex_id v = 0; v < before->vertex_slots(); ++v)
    if (norm(before->position(v) - at) < 1e-9)
      return after.candidate->position(v) - before->position(v);
  ADD_FAILURE() << "no vertex at " << at.x << ", " << at.y << ", " << at.z;
  return {};
}

class Deform : public test::tool_edits {
protected:
  expected<edit_result> deformed(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                 const deform_settings& settings) {
    return deform(mesh, surfaces, settings, ctx_);
  }

  /// 1 m long along x, 0.1 m wide and high; the wall with x = 1 is surface 2.
  version_ptr bar_ = test::box_mesh({10, 2, 2}, {1, 0.1, 0.1});
  version_ptr plate_ = test::box_mesh({12, 12, 3}, {1, 1, 0.25});
};

TEST_F(Deform, TheEndOfABarTakesItsAreaTimesTheDistanceAlong) {
  const auto result = deformed(bar_, {2}, {.distance = 0.02, .reach = 0.5});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(bar_, *result);
  EXPECT_NEAR(result->volume_change, 0.02 * 0.01, 1e-12 * 0.01);
  EXPECT_NEAR(moved_by(bar_, *result, {1, 0.05, 0.1}).x, 0.02, 1e-15);
  EXPECT_EQ(moved_by(bar_, *result, {0.5, 0, 0}), (vec3{}));
}

// Between ends whose value and slope are given, a beam that bends least is a cubic: w'''' = 0.
TEST_F(Deform, TheShareOfTheWayIsThatOfABeam) {
  const auto bar = test::box_mesh({20, 2, 2}, {1, 0.1, 0.1});
  const auto result = deformed(bar, {2}, {.distance = 0.02, .reach = 0.8});

  ASSERT_TRUE(result) << render(result.error());
  const auto cubic = [](double t) { return t * t * (3 - 2 * t); };
  const auto share = [&](int k) {
    return moved_by(bar, *result, {0.2 + 0.05 * k, 0.05, 0.05}).x / 0.02;
  };
  for (int k = 0; k <= 16; ++k) {
    EXPECT_NEAR(share(k), cubic(k / 16.0), 1e-3) << k;
    EXPECT_NEAR(share(k) + share(16 - k), 1, 1e-12) << k;
  }
}

TEST_F(Deform, WhereAllIsDraggedThePartMovesAsItIs) {
  const auto result = deformed(bar_, {1, 2, 3, 4, 5, 6}, {.by = vec3{0.25, -0.5, 0.125}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(bar_, *result);
  for (vertex_id v = 0; v < bar_->vertex_slots(); ++v)
    EXPECT_EQ(result->candidate->position(v), bar_->position(v) + (vec3{0.25, -0.5, 0.125}));
  EXPECT_NEAR(result->volume_change, 0, 1e-15);
}

TEST_F(Deform, AReachBelowAnEdgeMovesWhatIsDraggedAlone) {
  const auto result = deformed(bar_, {2}, {.distance = 0.02, .reach = 0.05});
  const auto all = deformed(bar_, {1, 2, 3, 4, 5, 6}, {.by = vec3{0, 0, 0.01}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(bar_, *result);
  EXPECT_NEAR(result->volume_change, 0.02 * 0.01, 1e-14);
  EXPECT_EQ(moved_by(bar_, *result, {0.9, 0, 0}), (vec3{}));
  EXPECT_THAT(result->notices, ::testing::Not(::testing::Contains(HasSubstr("whole part"))));
  ASSERT_TRUE(all);
  EXPECT_THAT(all->notices, ::testing::Contains(HasSubstr("the whole part moves")));
}

TEST_F(Deform, ASymmetricPartIsDeformedSymmetrically) {
  const auto result = deformed(
    plate_, {}, {.at = vec3{0.5, 0.5, 0.25}, .radius = 0.12, .distance = 0.03, .reach = 0.3});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  // The tets of each cell are the same with x and y exchanged.
  for (vertex_id v = 0; v < plate_->vertex_slots(); ++v) {
    const vec3 p = plate_->position(v);
    const double own = (result->candidate->position(v) - p).z;
    EXPECT_NEAR(own, moved_by(plate_, *result, {p.y, p.x, p.z}).z, 1e-12);
  }
  EXPECT_GT(result->volume_change, 0);
}

TEST_F(Deform, ThePatchGoesTheWholeWayAndWhatIsBeyondTheReachStays) {
  const auto result = deformed(
    plate_, {6}, {.at = vec3{0.5, 0.5, 0.25}, .radius = 0.12, .distance = 0.03, .reach = 0.3});

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_NEAR(moved_by(plate_, *result, {0.5, 0.5, 0.25}).z, 0.03, 1e-15);
  EXPECT_EQ(moved_by(plate_, *result, {0.5, 0.5, 0}), (vec3{}));  // The other side stays.
  EXPECT_EQ(moved_by(plate_, *result, {0, 0.5, 0.25}), (vec3{}));
  const double near = moved_by(plate_, *result, {8.0 / 12, 0.5, 0.25}).z;
  EXPECT_GT(near, 0.001);
  EXPECT_LT(near, 0.029);
}

TEST_F(Deform, TheOtherSideBendsAlongWhereNothingIsToStay) {
  const auto result = deformed(plate_, {6},
                               {.at = vec3{0.5, 0.5, 0.25},
                                .radius = 0.12,
                                .distance = 0.03,
                                .reach = 0.4,
                                .kept = kept_walls::none});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_GT(moved_by(plate_, *result, {0.5, 0.5, 0}).z, 0.003);
}

TEST_F(Deform, TheVolumeIsKeptWhereThatIsAskedFor) {
  deform_settings settings{
    .at = vec3{0.5, 0.5, 0.25}, .radius = 0.12, .distance = 0.02, .reach = 0.35};
  const auto without = deformed(plate_, {}, settings);
  settings.keep_volume = true;
  const auto with = deformed(plate_, {}, settings);

  ASSERT_TRUE(without) << render(without.error());
  ASSERT_TRUE(with) << render(with.error());
  expect_good(plate_, *with);
  EXPECT_GT(without->volume_change, 1e-4);
  EXPECT_NEAR(total_volume(*with->candidate), 0.25, 1e-12);
  EXPECT_NEAR(moved_by(plate_, *with, {0.5, 0.5, 0.25}).z, 0.02, 1e-15);
}

TEST_F(Deform, TooFarIsRefusedWithTheTetAndTheMostThatWorks) {
  ctx_.search_s = 5;
  // Cells of 0.1 m: within 0.3 m of the end no way of 0.5 m leaves a tet right.
  const auto inward = deformed(bar_, {2}, {.distance = -0.5, .reach = 0.3});

  ASSERT_FALSE(inward);
  EXPECT_THAT(inward.error().message, HasSubstr("would become too flat"));
  EXPECT_THAT(inward.error().message, HasSubstr("mm"));
  ASSERT_TRUE(inward.error().most);
  EXPECT_EQ(inward.error().most->parameter, "distance");
  const double most = inward.error().most->value;
  EXPECT_LT(most, -0.03);
  EXPECT_THAT(inward.error().remedy, HasSubstr("Take -"));
  EXPECT_TRUE(deformed(bar_, {2}, {.distance = most, .reach = 0.3}));
  EXPECT_FALSE(deformed(bar_, {2}, {.distance = 1.2 * most, .reach = 0.3}));
}

TEST_F(Deform, AWayThatIsTooFarIsRefusedWithThePartOfItThatWorks) {
  ctx_.search_s = 5;
  const auto result = deformed(bar_, {2}, {.by = vec3{-0.4, 0, -0.3}, .reach = 0.3});

  ASSERT_FALSE(result);
  EXPECT_FALSE(result.error().most);
  EXPECT_THAT(
    result.error().remedy,
    ::testing::MatchesRegex("Take by_mm=-[0-9.e-]+,0,-[0-9.e-]+: the most that works here"));
}

TEST_F(Deform, WhatMovesNothingIsRefusedByName) {
  const auto zero = deformed(bar_, {2}, {});
  const auto no_way = deformed(bar_, {2}, {.by = vec3{}});
  const auto nothing = deformed(bar_, {}, {.distance = 0.01});
  const auto all_ways = deformed(bar_, {1, 2}, {.distance = 0.01});
  const auto off = deformed(bar_, {}, {.at = vec3{1, 1, 1}, .radius = 0.1, .distance = 0.01});
  const auto touching = deformed(bar_, {2}, {.distance = 0.01, .stay = {3}});
  const auto unknown = deformed(bar_, {2}, {.distance = 0.01, .stay = {99}});

  for (const auto* refused : {&zero, &no_way, &nothing, &all_ways, &off, &touching, &unknown}) {
    ASSERT_FALSE(*refused);
    EXPECT_FALSE(refused->error().remedy.empty());
  }
  EXPECT_THAT(zero.error().message, HasSubstr("the distance is 0"));
  EXPECT_THAT(no_way.error().message, HasSubstr("0, 0, 0"));
  EXPECT_EQ(nothing.error().code, ec::empty_selection);
  EXPECT_THAT(all_ways.error().message, HasSubstr("no normal"));
  EXPECT_THAT(off.error().message, HasSubstr("off the wall"));
  EXPECT_THAT(touching.error().message, HasSubstr("surface 3"));
  EXPECT_EQ(unknown.error().code, ec::surface_not_found);
}

TEST_F(Deform, AWallThatWouldRunIntoAnotherIsRefused) {
  // A slot 0.1 m wide between two arms: the lower arm's inner wall is dragged 0.12 m up.
  const auto fork = test::box_mesh({8, 2, 6}, {0.8, 0.2, 0.6});
  mesh_builder builder(fork);
  cavity_change change;
  const auto in_slot = [&](tet_id t) {
    const auto c = fork->corners(t);
    const vec3 m = (c[0] + c[1] + c[2] + c[3]) / 4;
    return m.x > 0.2 && m.z > 0.2 && m.z < 0.3;
  };
  for (tet_id t = 0; t < fork->tet_slots(); ++t) {
    if (!in_slot(t))
      continue;
    change.removed.push_back(t);
    for (int i = 0; i < 4; ++i) {
      const auto behind = fork->neighbours(t)[i];
      const auto& v = fork->tet_at(t).v;
      if (!is_facet(behind) && !in_slot(behind)) {
        const std::array<vertex_id, 3> face{v[tet_faces[i][0]], v[tet_faces[i][1]],
                                            v[tet_faces[i][2]]};
        const auto on = [&](double z) {
          return std::ranges::all_of(
            face, [&](vertex_id u) { return std::abs(fork->position(u).z - z) < 1e-9; });
        };
        change.facets.push_back({face, on(0.2) ? 11 : on(0.3) ? 12 : 13});
      }
    }
  }
  for (int i = 7; i <= 13; ++i)
    (void)builder.add_surface("wall");
  ASSERT_TRUE(builder.apply(change));
  const auto slotted = builder.freeze();

  const auto result = deformed(slotted, {11},
                               {.at = vec3{0.8, 0.1, 0.2},
                                .radius = 0.11,
                                .distance = 0.12,
                                .reach = 0.5,
                                .kept = kept_walls::none});

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("would run into surface"));
}

}  // namespace
}  // namespace tedit::ops
