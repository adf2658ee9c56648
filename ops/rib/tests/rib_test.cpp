// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/rib/rib.hpp"

#include <gmock/gmock.h>

#include "tests/support/features_on_plate.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

/// A plate with two posts on it, 0.6 m from each other.
class Rib : public test::features_on_plate {
protected:
  version_ptr part_ = with_boss(with_boss(plate_, {0.1, 0.3, 0.2}, {0.2, 0.7, 0.6}),
                                {0.8, 0.3, 0.2}, {0.9, 0.7, 0.6});

  /// The surface with a facet that has this outward normal and lies at this x.
  surface_id wall_at(double x, double normal) {
    for (facet_id f = 0; f < part_->facet_slots(); ++f) {
      if (!part_->is_live_facet(f))
        continue;
      const vec3 n = normalized(area_vector(*part_, part_->facet(f)));
      const auto& v = part_->facet(f).v;
      if (n.x * normal > 0.99 && std::abs(part_->position(v[0]).x - x) < 1e-9 &&
          part_->position(v[0]).z > 0.2 - 1e-9 && part_->position(v[1]).z > 0.2 - 1e-9)
        return part_->facet(f).surface;
    }
    ADD_FAILURE() << "no wall at " << x;
    return 0;
  }
};

TEST_F(Rib, InACornerItIsATriangle) {
  const auto result = add_rib(part_, {6, wall_at(0.2, 1)},
                              {.thickness = 0.06, .size = 0.2, .at = vec3{0.2, 0.5, 0.2}}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(part_, *result);
  EXPECT_NEAR(result->volume_change, 0.5 * 0.2 * 0.2 * 0.06, 1e-9);
}

TEST_F(Rib, BetweenWallsThatFaceEachOtherItIsAPlate) {
  const auto result = add_rib(
    part_, {wall_at(0.2, 1), wall_at(0.8, -1)},
    {.thickness = 0.06, .size = 0.1, .at = vec3{0.5, 0.5, 0.45}, .direction = vec3{0, 0, 1}}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(part_, *result);
  EXPECT_NEAR(result->volume_change, 0.6 * 0.1 * 0.06, 1e-9);
}

TEST_F(Rib, WallsWithNoSpaceBetweenThemAreRefused) {
  const auto away = add_rib(part_, {wall_at(0.2, 1), wall_at(0.9, 1)}, {0.06, 0.2, {}, {}}, ctx_);
  const auto which = add_rib(part_, {wall_at(0.2, 1), wall_at(0.8, -1)}, {0.06, 0.2, {}, {}}, ctx_);
  const auto one = add_rib(part_, {6}, {0.06, 0.2, {}, {}}, ctx_);
  const auto beside = add_rib(part_, {6, wall_at(0.2, 1)},
                              {.thickness = 0.06, .size = 0.05, .at = vec3{0.2, 0.95, 0.2}}, ctx_);

  EXPECT_THAT(away.error().message, HasSubstr("nor face each other"));
  EXPECT_THAT(which.error().message, HasSubstr("which way the rib stands"));
  EXPECT_THAT(one.error().message, HasSubstr("between two walls"));
  ASSERT_FALSE(beside);
  EXPECT_THAT(beside.error().message, HasSubstr("would not touch surface"));
}

}  // namespace
}  // namespace tedit::ops
