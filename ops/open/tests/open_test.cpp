// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/support/rounding.hpp"

namespace tedit::test {
namespace {

using Open = rounding;

TEST_F(Open, ABoxEdgeLosesTheExactVolumeOfItsPolygon) {
  const auto base = box_mesh({4, 4, 4}, {4, 3, 4});
  for (const double r : {0.3, 0.7, 1.2}) {
    SCOPED_TRACE(r);

    const auto result = round(base, {2, 6}, -1, r);

    const auto after = finish(base, result);
    ASSERT_TRUE(after);
    const auto made = fresh(*base, *after);
    ASSERT_EQ(made.size(), 1u);
    for (const auto p : points_of(*after, made.front()))
      EXPECT_NEAR(std::hypot(p.x - 4 + r, p.z - 4 + r), r, 1e-12);
    EXPECT_NEAR(total_volume(*base) - total_volume(*after), spandrel(4) * r * r * 3, 1e-11);
  }
}

TEST_F(Open, AllEdgesOfABoxAndItsCorners) {
  const auto base = box_mesh({4, 4, 4}, {4, 4, 4});

  const auto result = round(base, {1, 2, 3, 4, 5, 6}, -1, 0.6);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
}

TEST_F(Open, ATopsEdgesMeetInMitres) {
  const auto base = box_mesh({4, 4, 4}, {4, 4, 4});

  const auto result = round(base, {6}, -1, 0.6);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
}

}  // namespace
}  // namespace tedit::test
