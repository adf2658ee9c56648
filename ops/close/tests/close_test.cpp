// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>

#include "tests/support/edits.hpp"
#include "tests/support/rounding.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

using Close = rounding;

/// Gives facets other surfaces, by their corners.
version_ptr renamed(const version_ptr& mesh,
                    const std::function<surface_id(surface_id, vec3 centre)>& name) {
  mesh_builder builder(mesh);
  for (int i = 0; i < 6; ++i)
    static_cast<void>(builder.add_surface("wall"));
  for (facet_id f = 0; f < builder.facet_slots(); ++f)
    if (builder.is_live_facet(f)) {
      vec3 centre;
      for (const auto v : builder.facet(f).v)
        centre += builder.position(v) / 3;
      builder.set_surface(f, name(builder.facet(f).surface, centre));
    }
  return builder.freeze();
}

/// 4 x 3 x 4 with a step: the quarter x > 2, z > 2 is left out. Floor 7 at z = 2, riser 8 at x = 2.
version_ptr step() {
  const auto mesh = blocks({4, 3, 4}, [](int x, int, int z) { return x < 2 || z < 2; });
  return renamed(mesh, [](surface_id id, vec3 c) {
    return id == 7 && std::abs(c.x - 2) < 1e-9 ? surface_id{8} : id;
  });
}

/// A cube of 6 with a pocket 4 x 4 x 2 in its top: floor 7 at z = 4, walls 8 to 11.
version_ptr pocket() {
  const auto dug = dig(
    box_mesh({6, 6, 6}, {6, 6, 6}),
    [](vec3 p) { return p.x > 1 && p.x < 5 && p.y > 1 && p.y < 5 && p.z > 4; }, 7);
  return renamed(dug, [](surface_id id, vec3 c) {
    if (id != 7 || std::abs(c.z - 4) < 1e-9)
      return id;
    if (std::abs(c.x - 1) < 1e-9)
      return surface_id{8};
    if (std::abs(c.x - 5) < 1e-9)
      return surface_id{9};
    return surface_id{std::abs(c.y - 1) < 1e-9 ? 10 : 11};
  });
}

TEST_F(Close, AnInnerCornerGetsTheExactVolumeOfItsPolygon) {
  const auto base = step();
  // Far below, near and above the mesh's edge length of 1.
  for (const double r : {0.1, 0.7, 1.2})
    for (const int n : {4, 6}) {
      SCOPED_TRACE(r);

      const auto result = round(base, {7, 8}, +1, r, n);

      const auto after = finish(base, result);
      ASSERT_TRUE(after);
      const auto made = fresh(*base, *after);
      ASSERT_EQ(made.size(), 1u);
      for (const auto p : points_of(*after, made.front()))
        EXPECT_NEAR(std::hypot(p.x - 2 - r, p.z - 2 - r), r, 1e-12);
      EXPECT_NEAR(total_volume(*after) - total_volume(*base), spandrel(n) * r * r * 3, 1e-11);
      // The walls end at the contacts, the end faces gain what the fillet fills beside them.
      EXPECT_NEAR(area(*after, 7), (2 - r) * 3, 1e-11);
      EXPECT_NEAR(area(*after, 8), (2 - r) * 3, 1e-11);
      EXPECT_NEAR(area(*after, 3), 12 + spandrel(n) * r * r, 1e-11);
      EXPECT_NEAR(area(*after, 1), 12, 1e-12);
    }
}

TEST_F(Close, OneWallMeansAllItsInnerCorners) {
  const auto base = step();

  const auto one = round(base, {7}, +1, 0.5);
  const auto both = round(base, {7, 8}, +1, 0.5);

  ASSERT_TRUE(one && both);
  EXPECT_EQ(one->candidate->id(), both->candidate->id());
}

TEST_F(Close, APocketsCornersAreRoundedByTheBallItself) {
  const auto base = pocket();
  const double r = 0.8;

  const auto result = round(base, {7, 8, 9, 10, 11}, +1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  const auto made = fresh(*base, *after);
  EXPECT_EQ(made.size(), 12u);  // Eight edges, four corners.
  for (const auto id : made)
    for (const auto p : points_of(*after, id)) {
      // Where the ball's centre can be: the pocket less r.
      const vec3 centre{std::clamp(p.x, 1 + r, 5 - r), std::clamp(p.y, 1 + r, 5 - r),
                        std::max(p.z, 4 + r)};
      EXPECT_NEAR(norm(p - centre), r, 1e-12);
    }
  EXPECT_GT(total_volume(*after), total_volume(*base));
}

TEST_F(Close, APocketsFloorAloneGetsMitredCorners) {
  const auto base = pocket();
  const double r = 0.6;

  const auto result = round(base, {7}, +1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  EXPECT_EQ(fresh(*base, *after).size(), 4u);
  // Four fillets less what two of them share at each corner: the part of a cube of r beyond both.
  EXPECT_LT(total_volume(*after) - total_volume(*base), 4 * 4 * spandrel(4) * r * r);
  EXPECT_GT(total_volume(*after) - total_volume(*base), 4 * (4 - 2 * r) * spandrel(4) * r * r);
}

TEST_F(Close, ABoxHasNothingToClose) {
  const auto base = box_mesh({2, 2, 2}, {1, 1, 1});

  const auto result = round(base, {2, 6}, +1, 0.1);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::empty_selection);
  EXPECT_THAT(result.error().message, HasSubstr("no concave edge"));
  EXPECT_THAT(result.error().remedy, HasSubstr("open"));
}

TEST_F(Close, ARadiusLargerThanTheWallIsRefusedByNameAndPlace) {
  const auto base = step();

  const auto result = round(base, {7, 8}, +1, 2.5);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("the edge between surfaces 7 and 8"));
  EXPECT_THAT(result.error().message, HasSubstr("mm"));
  EXPECT_FALSE(result.error().remedy.empty());
}

TEST_F(Close, ABallLargerThanThePocketIsRefused) {
  const auto base = pocket();

  const auto result = round(base, {7, 8, 9, 10, 11}, +1, 2.5);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
}

TEST_F(Close, ARadiusFarBelowTheMeshIsRefusedWithTheLengths) {
  const auto base = step();

  const auto result = round(base, {7, 8}, +1, 1e-4);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("the mesh's edges 1000 mm"));
  EXPECT_THAT(result.error().remedy, HasSubstr("a radius of at least"));
}

}  // namespace
}  // namespace tedit::test
