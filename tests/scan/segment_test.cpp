// SPDX-License-Identifier: AGPL-3.0-or-later
// Planes, cylinders, cones and spheres in triangles.
#include "mesh/segment/segment.hpp"

#include <gmock/gmock.h>

#include <map>

#include "tests/scan/surfaces.hpp"

namespace tedit {
namespace {

using ::testing::UnorderedElementsAre;

/// Equal places are one point.
triangle_surface surface_of(const test::soup& triangles) {
  triangle_surface made;
  std::map<std::array<long, 3>, std::uint32_t> known;
  for (const auto& t : triangles) {
    auto& corners = made.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto rounded = [](double x) { return std::lround(x * 1e7); };
      const auto next = static_cast<std::uint32_t>(made.points.size());
      const auto [found, is_new] =
        known.emplace(std::array{rounded(t[k].x), rounded(t[k].y), rounded(t[k].z)}, next);
      if (is_new)
        made.points.push_back(t[k]);
      corners[k] = found->second;
    }
  }
  return made;
}

segmentation segments_of(const test::soup& triangles) {
  const auto surface = surface_of(triangles);
  return segment_surface(surface, limits_for(surface));
}

std::vector<std::string> forms_of(const segmentation& found) {
  std::vector<std::string> forms;
  for (const auto& shape : found.shapes)
    forms.emplace_back(name_of(shape.form));
  return forms;
}

TEST(Segments, OfACubeAreSixPlanes) {
  const auto found = segments_of(test::cube_soup(10));

  EXPECT_EQ(found.shapes.size(), 6U);
  EXPECT_EQ(found.patch_of[0], found.patch_of[1]);
  EXPECT_NE(found.patch_of[1], found.patch_of[2]);
}

class TessellatedCylinder : public ::testing::TestWithParam<int> {};

TEST_P(TessellatedCylinder, IsTwoPlanesAndACylinderWithItsRadius) {
  const auto found = segments_of(test::cylinder_soup(4, 10, GetParam()));

  ASSERT_THAT(forms_of(found), UnorderedElementsAre("plane", "cylinder", "plane"));
  const auto& round = found.shapes[1];
  EXPECT_NEAR(round.wall.radius, 4, 1e-9);
  EXPECT_NEAR(std::abs(round.wall.axis.z), 1, 1e-12);
  EXPECT_EQ(name_of(round, 2, 1), "cylinder 2 d 8 mm");
  EXPECT_NEAR(round.distance({4, 0, 3}), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Facets, TessellatedCylinder, ::testing::Values(8, 12, 24, 200));

TEST(Segments, OfAPrismWithSixSidesAreEightPlanes) {
  EXPECT_EQ(segments_of(test::cylinder_soup(4, 10, 6)).shapes.size(), 8U);
}

/// Walls straight up over an outline that runs counterclockwise, with a fan for each end.
test::soup extruded(const std::vector<std::array<double, 2>>& outline, double height) {
  test::soup made;
  const auto at = [&](std::size_t i, double z) {
    return vec3{outline[i % outline.size()][0], outline[i % outline.size()][1], z};
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    made.push_back({at(i, 0), at(i + 1, 0), at(i + 1, height)});
    made.push_back({at(i, 0), at(i + 1, height), at(i, height)});
  }
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    made.push_back({at(0, 0), at(i + 1, 0), at(i, 0)});
    made.push_back({at(0, height), at(i, height), at(i + 1, height)});
  }
  return made;
}

TEST(Segments, OfASquareWithItsCornersCutAreTenPlanes) {
  // Its eight corners lie on a circle, but no cylinder has facets of 6 and 2.8 mm in turn.
  const auto found = segments_of(
    extruded({{3, -5}, {5, -3}, {5, 3}, {3, 5}, {-3, 5}, {-5, 3}, {-5, -3}, {-3, -5}}, 4));

  EXPECT_EQ(found.shapes.size(), 10U);
}

TEST(Segments, TellAFilletFromThePlanesThatItGoesOverInto) {
  // A block of 20 x 20 mm with one corner rounded by 5 mm in three facets of 30 degrees.
  std::vector<std::array<double, 2>> outline{{0, 0}, {20, 0}};
  for (int i = 0; i <= 3; ++i) {
    const double angle = i * std::numbers::pi / 6;
    outline.push_back({15 + 5 * std::cos(angle), 15 + 5 * std::sin(angle)});
  }
  outline.push_back({0, 20});
  const auto found = segments_of(extruded(outline, 8));

  EXPECT_THAT(forms_of(found), UnorderedElementsAre("plane", "plane", "cylinder", "plane", "plane",
                                                    "plane", "plane"));
  for (const auto& shape : found.shapes)
    if (shape.form == surface_form::cylinder) {
      EXPECT_NEAR(shape.wall.radius, 5, 1e-9);
    }
}

TEST(Segments, KnowConesAndSpheres) {
  // A cone from 6 to 3 mm, a cylinder, and half a ball on it.
  std::vector<std::array<double, 2>> rings{{0, 0}, {6, 0}, {3, 4}, {3, 9}};
  for (int i = 1; i <= 6; ++i)
    rings.push_back({i == 6 ? 0 : 3 * std::cos(i * std::numbers::pi / 12),
                     9 + 3 * std::sin(i * std::numbers::pi / 12)});
  const auto found = segments_of(test::turned_soup(rings, 24));

  ASSERT_THAT(forms_of(found), UnorderedElementsAre("plane", "cone", "cylinder", "sphere"));
  EXPECT_NEAR(found.shapes[1].wall.slope * found.shapes[1].wall.axis.z, -0.75, 1e-6);
  EXPECT_NEAR(found.shapes[3].wall.radius, 3, 1e-6);
  EXPECT_NEAR(norm(found.shapes[3].wall.point - vec3{0, 0, 9}), 0, 1e-6);
}

TEST(Segments, LeaveAWavyWallOneFreeForm) {
  // A wall along a wave, 5 mm high, 40 mm long, seen from the first corner; the others are planes.
  std::vector<std::array<double, 2>> outline{{20, -40}, {40, -10}};
  for (int i = 0; i <= 40; ++i) {
    const double x = 40.0 - i;
    outline.push_back({x, 3 * std::cos(0.3 * x) + std::cos(0.47 * x)});
  }
  outline.push_back({0, -10});
  const auto found = segments_of(extruded(outline, 5));

  EXPECT_THAT(forms_of(found), UnorderedElementsAre("plane", "plane", "plane", "plane", "plane",
                                                    "plane", "free form"));
}

TEST(Segments, DoNotCrossGroups) {
  const auto surface = surface_of(test::cylinder_soup(4, 10, 24));
  std::vector<std::uint32_t> groups(surface.triangles.size(), 0);
  for (std::size_t t = 0; t < groups.size(); ++t)
    groups[t] = surface.points[surface.triangles[t][0]].x > 0 ? 1 : 0;
  const auto found = segment_surface(surface, limits_for(surface), groups);

  for (std::size_t t = 0; t < groups.size(); ++t)
    for (std::size_t s = 0; s < t; ++s)
      if (found.patch_of[t] == found.patch_of[s]) {
        EXPECT_EQ(groups[t], groups[s]);
      }
}

}  // namespace
}  // namespace tedit
