// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>

#include "tests/support/rounding.hpp"
#include "tests/support/tube.hpp"

namespace tedit::test {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

using Open = rounding;

TEST_F(Open, ABoxEdgeLosesTheExactVolumeOfItsPolygon) {
  const auto base = box_mesh({4, 4, 4}, {4, 3, 4});
  for (const double r : {0.1, 0.7, 1.2}) {
    SCOPED_TRACE(r);

    const auto result = round(base, {2, 6}, -1, r);

    const auto after = finish(base, result);
    ASSERT_TRUE(after);
    const auto made = fresh(*base, *after);
    ASSERT_EQ(made.size(), 1u);
    for (const auto p : points_of(*after, made.front()))
      EXPECT_NEAR(std::hypot(p.x - 4 + r, p.z - 4 + r), r, 1e-12);
    EXPECT_NEAR(total_volume(*base) - total_volume(*after), spandrel(4) * r * r * 3, 1e-11);
    EXPECT_NEAR(area(*after, 6), (4 - r) * 3, 1e-11);
    EXPECT_NEAR(area(*after, 3), 16 - spandrel(4) * r * r, 1e-11);
  }
}

TEST_F(Open, AnObliqueEdgeIsRoundedBetweenObliqueEnds) {
  // The top leans over: the angle at its edge with x = 4 is not 90 degrees, its ends are oblique.
  const auto base = box_mesh({4, 4, 4}, {4, 4, 4}, [](vec3 p) {
    return vec3{p.x, p.y + 0.2 * p.x, p.z * (1 + 0.1 * p.x)};
  });
  const double r = 0.5;

  const auto result = round(base, {2, 6}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  // The axis lies r below both planes.
  const vec3 top = normalized({-0.4, 0, 1});
  const double x = 4 - r;
  const double z = 4 - (r + top.x * x) / top.z;
  for (const auto p : points_of(*after, fresh(*base, *after).front()))
    EXPECT_NEAR(std::hypot(p.x - x, p.z - z), r, 1e-11);
}

TEST_F(Open, AllEdgesOfABoxGiveTheRoundedBox) {
  const auto base = box_mesh({4, 4, 4}, {4, 4, 4});
  const double r = 0.6;

  const auto result = round(base, {1, 2, 3, 4, 5, 6}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  const auto made = fresh(*base, *after);
  EXPECT_EQ(made.size(), 20u);  // Twelve edges, eight corners.
  const auto inner = [&](double c) { return std::clamp(c, r, 4 - r); };
  for (const auto id : made)
    for (const auto p : points_of(*after, id))
      EXPECT_NEAR(norm(p - vec3{inner(p.x), inner(p.y), inner(p.z)}), r, 1e-12);
  // Steiner's formula for the smooth body; the facets are inscribed.
  const double a = 4 - 2 * r;
  const double smooth = a * a * a + 6 * a * a * r + 3 * pi * r * r * a + 4 * pi / 3 * r * r * r;
  EXPECT_LT(total_volume(*after), smooth);
  EXPECT_GT(total_volume(*after), smooth - 12 * 4 * (spandrel(4) - (1 - pi / 4)) * r * r);
}

TEST_F(Open, ATopsEdgesMeetInMitres) {
  const auto base = box_mesh({4, 4, 4}, {4, 4, 4});
  const double r = 0.6;

  const auto result = round(base, {6}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  const auto made = fresh(*base, *after);
  EXPECT_EQ(made.size(), 4u);
  const auto beyond = [&](double c) { return std::max({r - c, c - 4 + r, 0.0}); };
  for (const auto id : made)
    for (const auto p : points_of(*after, id))
      EXPECT_NEAR(std::hypot(std::max(beyond(p.x), beyond(p.y)), p.z - 4 + r), r, 1e-12);
}

TEST_F(Open, AnEdgeThatEndsAtAStepRunsOutInTheRiser) {
  // The front's edge with the lower step ends where the riser goes up.
  auto base = blocks({4, 3, 4}, [](int x, int, int z) { return x < 2 || z < 2; });
  mesh_builder builder(base);
  static_cast<void>(builder.add_surface("riser"));
  for (facet_id f = 0; f < builder.facet_slots(); ++f)
    if (builder.facet(f).surface == 7 && std::ranges::all_of(builder.facet(f).v, [&](vertex_id v) {
          return builder.position(v).x == 2;
        }))
      builder.set_surface(f, 8);
  base = builder.freeze();
  const double r = 0.5;

  const auto result = round(base, {3, 7}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  EXPECT_NEAR(total_volume(*base) - total_volume(*after), spandrel(4) * r * r * 2, 1e-11);
  // The riser goes on down to the rounded edge.
  EXPECT_NEAR(area(*after, 8), 6 + spandrel(4) * r * r, 1e-11);
}

TEST_F(Open, TheSameEditGivesTheSameVersion) {
  const auto base = box_mesh({3, 3, 3}, {3, 3, 3});

  const auto once = round(base, {2, 6}, -1, 0.4);
  const auto again = round(base, {2, 6}, -1, 0.4);

  ASSERT_TRUE(once && again);
  EXPECT_EQ(once->candidate->id(), again->candidate->id());
}

TEST_F(Open, SurfacesThatDoNotMeetAreRefused) {
  const auto base = box_mesh({2, 2, 2}, {1, 1, 1});

  const auto result = round(base, {1, 2}, -1, 0.1);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::empty_selection);
  EXPECT_THAT(result.error().message, HasSubstr("between surfaces 1, 2 there is no convex edge"));
}

TEST_F(Open, TheRimOfAConeIsRounded) {
  // Radii of 2 m below and 2.3 m above: the wall leans outward.
  tube leaning;
  leaning.sides = 32;
  leaning.slope = 0.3;
  const auto base = tube_mesh(leaning);
  constexpr double r = 0.1;

  const auto result = round(base, {2, 4}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  const auto made = fresh(*base, *after);
  ASSERT_EQ(made.size(), 1u);
  // The ball's centre is r below the top and as far from the cone.
  const double rho = 2 + 0.3 * (1 - r) - r * std::hypot(1, 0.3);
  for (const auto p : points_of(*after, made.front()))
    EXPECT_NEAR(std::hypot(std::hypot(p.x, p.y) - rho, p.z - 1 + r), r, 1e-9);
  EXPECT_TRUE(check_version(*after).ok());
}

TEST_F(Open, TheEdgeOfADomeIsRounded) {
  constexpr double R = 10;
  const auto base = box_mesh({6, 6, 4}, {4, 4, 4}, [](vec3 p) -> vec3 {
    return {p.x, p.y, p.z / 4 * std::sqrt(R * R - p.x * p.x - p.y * p.y)};
  });
  constexpr double r = 0.4;

  const auto result = round(base, {2, 6}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  const auto made = fresh(*base, *after);
  ASSERT_EQ(made.size(), 1u);
  // The ball rolls in the plane x = 4 - r, its centre R - r off the origin.
  const double rho = std::sqrt((R - r) * (R - r) - (4 - r) * (4 - r));
  for (const auto p : points_of(*after, made.front()))
    EXPECT_NEAR(std::hypot(p.x - 4 + r, std::hypot(p.y, p.z) - rho), r, 1e-9);
}

TEST_F(Open, ABallGoesFromAFlatWallToARoundOneWhereItTouchesTheLineBetween) {
  // Side 2 is half of a cylinder, tangent to the sides 3 and 4; the top leans over all of them, so
  // that its edges do not cross the lines between them at right angles.
  const auto top = [](double x, double y) { return 1 + 0.2 * x + 0.1 * y; };
  const auto base = box_mesh({8, 12, 6}, {1, 2, 1}, [&](vec3 p) -> vec3 {
    const double turn = pi / 2 * (p.y - 1);
    const double x = p.x * (2 + std::cos(turn));
    const double y = (1 - p.x) * (p.y - 1) + p.x * std::sin(turn);
    return {x, y, p.z * top(x, y)};
  });
  constexpr double r = 0.2;

  const auto result = round(base, {2, 6}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  EXPECT_EQ(result->surfaces_used, (std::vector<surface_id>{2, 3, 4, 6}));
  // The ball's centre is r inside the walls, and r below the top.
  std::vector<vec3> spine;
  const double below = r * std::sqrt(1 + 0.2 * 0.2 + 0.1 * 0.1);
  const auto add = [&](double x, double y) { spine.push_back({x, y, top(x, y) - below}); };
  constexpr int fine = 10'000;
  for (int i = 0; i <= fine; ++i) {
    const double turn = pi * (static_cast<double>(i) / fine - 0.5);
    add(2 + (1 - r) * std::cos(turn), (1 - r) * std::sin(turn));
    for (const double side : {-1.0, 1.0})
      add(2.5 * i / fine - 0.5, side * (1 - r));
  }
  for (const auto id : fresh(*base, *after))
    for (const auto p : points_of(*after, id)) {
      double least = 1;
      for (const auto& c : spine)
        least = std::min(least, norm(p - c));
      EXPECT_NEAR(least, r, 1e-6) << p.x << ", " << p.y << ", " << p.z;
    }
}

TEST_F(Open, AWallThatIsNeitherFlatNorRoundIsNamed) {
  const auto base = box_mesh({6, 6, 6}, {1, 1, 1}, [](vec3 p) {
    return vec3{p.x, p.y, p.z * (1 + 0.2 * std::sin(5 * p.x) * std::sin(5 * p.y))};
  });

  const auto result = round(base, {2, 6}, -1, 0.1);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message,
              HasSubstr("surface 6 is neither a plane, a cylinder, a cone, a sphere nor a torus"));
}

TEST_F(Open, ARadiusThatTakesAWholeEdgeIsRefused) {
  const auto base = box_mesh({4, 4, 4}, {1, 4, 4});

  const auto result = round(base, {2, 6}, -1, 1.2);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("which is only 1000 mm long"));
}

}  // namespace
}  // namespace tedit::test
