// SPDX-License-Identifier: AGPL-3.0-or-later
// From triangles that only lie side by side to closed shells.
#include "scan/reader/mend.hpp"

#include <gmock/gmock.h>

#include "scan/reader/part_of_file.hpp"
#include "tests/scan/surfaces.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::scan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

file_surface as_file(const test::soup& triangles) {
  file_surface read;
  for (const auto& t : triangles) {
    const auto first = static_cast<std::uint32_t>(read.surface.points.size());
    read.surface.points.insert(read.surface.points.end(), t.begin(), t.end());
    read.surface.triangles.push_back({first, first + 1, first + 2});
  }
  return read;
}

expected<part_of_file> made_of(const test::soup& triangles) {
  return make_part(as_file(triangles), "mm", [](double, const char*) {});
}

TEST(Weld, MakesOnePointOfEqualOnes) {
  auto cube = test::cube_soup(10);
  cube[0][1] += vec3{1e-6, 0, 0};  // As far as a file's rounding.
  auto read = as_file(cube);
  const auto done = weld(read, weld_tolerance(read.surface));

  EXPECT_EQ(read.surface.points.size(), 8U);
  EXPECT_EQ(read.surface.triangles.size(), 12U);
  EXPECT_EQ(done.degenerate + done.duplicate, 0U);
}

TEST(Weld, DropsTrianglesWithoutAreaAndThoseThatAreThereTwice) {
  auto cube = test::cube_soup(10);
  cube.push_back(cube[3]);
  cube.push_back({cube[5][1], cube[5][0], cube[5][2]});  // The other way round.
  cube.push_back({cube[0][0], cube[0][1], cube[0][1]});
  auto read = as_file(cube);
  const auto done = weld(read, weld_tolerance(read.surface));

  EXPECT_EQ(read.surface.triangles.size(), 12U);
  EXPECT_EQ(done.duplicate, 2U);
  EXPECT_EQ(done.degenerate, 1U);
}

TEST(ClosedCube, HasSixPlanesAndItsVolume) {
  const auto made = test::value(made_of(test::cube_soup(10)));

  ASSERT_EQ(made.part.shapes.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(made.part.shapes[i].form, surface_form::plane);
    EXPECT_NEAR(made.facts.faces[i].area_mm2, 100, 1e-12);
    EXPECT_EQ(made.facts.faces[i].name, "plane " + std::to_string(i + 1));
  }
  ASSERT_EQ(made.facts.solids.size(), 1U);
  EXPECT_NEAR(made.facts.solids[0].volume_mm3, 1000, 1e-9);
  EXPECT_TRUE(made.facts.notices.empty()) << made.facts.notices.front();
}

TEST(CubeThatIsBroken, IsMendedAndThatIsSaid) {
  const auto cube = test::cube_soup(10);
  auto flipped = cube;
  std::swap(flipped[3][0], flipped[3][1]);
  std::swap(flipped[8][0], flipped[8][1]);
  auto inward = cube;
  for (auto& t : inward)
    std::swap(t[0], t[1]);
  // One diagonal ends in the middle of an edge on one side alone.
  auto cracked = cube;
  const vec3 middle = 0.5 * (cube[0][0] + cube[0][1]);
  cracked[0] = {cube[0][0], middle, cube[0][2]};
  cracked.push_back({middle, cube[0][1], cube[0][2]});
  // The walls stand 0.002 mm apart there.
  auto gaping = cube;
  for (auto& p : gaping[2])
    p += vec3{0.002, 0, 0};
  const std::vector<std::pair<test::soup, const char*>> files{
    {flipped, "2 triangles that looked another way than those around turned"},
    {inward, "the surface looked inward: turned"},
    {cracked, ""},
    {gaping, "gaps up to 0.002 mm wide are closed"}};
  for (const auto& [file, notice] : files) {
    const auto made = test::value(made_of(file));

    EXPECT_EQ(made.part.shapes.size(), 6U) << notice;
    EXPECT_NEAR(made.facts.solids[0].volume_mm3, 1000, 0.2) << notice;
    if (*notice != '\0') {
      ASSERT_EQ(made.facts.notices.size(), 1U) << notice;
      EXPECT_THAT(made.facts.notices[0], HasSubstr(notice));
    }
  }
}

TEST(SmallHole, IsFilled) {
  // A ball of 1 mm without one triangle at its lower end: 0.139 mm around.
  std::vector<std::array<double, 2>> rings;
  for (int i = 0; i <= 48; ++i) {
    const double angle = std::numbers::pi * i / 48;
    rings.push_back({i % 48 == 0 ? 0 : std::sin(angle), -std::cos(angle)});
  }
  auto ball = test::turned_soup(rings, 48);
  const auto whole = test::value(made_of(ball));
  ball.erase(ball.begin());
  const auto made = test::value(made_of(ball));

  EXPECT_THAT(made.facts.notices, ElementsAre("1 small hole filled"));
  EXPECT_NEAR(made.facts.solids[0].volume_mm3, whole.facts.solids[0].volume_mm3, 1e-9);
}

TEST(SurfaceThatCannotBeMended, IsRefusedWithThePlace) {
  const auto cube = test::cube_soup(10);
  const test::soup open(cube.begin() + 1, cube.end());
  struct broken {
    test::soup file;
    ec code;
    const char* message;
  };
  const std::vector<broken> files{
    {open, ec::bad_input,
     "the surface is not closed: it has 1 hole, the longest is 34.14 mm around, its middle at (0, "
     "3.333, 6.667) mm"},
    {test::joined(cube, test::cube_soup(10, {5, 5, 5})), ec::bad_input,
     "the surface goes through itself: 18 pairs of triangles cut or cover each other, the first at "
     "(6.667, 3.333, 10) mm"},
    {test::joined(cube, test::cube_soup(10, {10, 10, 0})), ec::non_manifold,
     "1 edge has more than two triangles, the first at (10, 10, 5) mm"},
    {test::joined(cube, test::cube_soup(10, {10, 10, 10})), ec::non_manifold,
     "the surface touches itself in one point, at (10, 10, 10) mm"}};
  for (const auto& one : files) {
    const auto made = made_of(one.file);
    ASSERT_FALSE(made) << one.message;
    EXPECT_EQ(made.error().code, one.code) << one.message;
    EXPECT_THAT(made.error().message, HasSubstr(one.message));
    EXPECT_NE(made.error().remedy, "");
  }
}

TEST(NestedShells, AreCavities) {
  const auto made =
    test::value(made_of(test::joined(test::cube_soup(10), test::cube_soup(4, {3, 3, 3}))));

  ASSERT_EQ(made.facts.solids.size(), 1U);
  EXPECT_NEAR(made.facts.solids[0].volume_mm3, 1000 - 64, 1e-9);
  EXPECT_EQ(made.part.shapes.size(), 12U);
  EXPECT_THAT(made.facts.notices, ElementsAre("1 inner surface is a cavity"));
}

TEST(ShellsSideBySide, AreRegions) {
  const auto made =
    test::value(made_of(test::joined(test::cube_soup(10), test::cube_soup(4, {20, 3, 3}))));

  ASSERT_EQ(made.facts.solids.size(), 2U);
  EXPECT_NEAR(made.facts.solids[1].volume_mm3, 64, 1e-9);
  EXPECT_EQ(made.part.solid_of[5], 0U);
  EXPECT_EQ(made.part.solid_of[6], 1U);
  EXPECT_THAT(made.facts.notices, ElementsAre(HasSubstr("2 bodies that do not touch")));
}

TEST(Groups, StayTogetherAsSurfaces) {
  auto read = as_file(test::cube_soup(10));
  read.groups = {{"ends", cad::colour{1, 0, 0}, 0}, {"walls", {}, 0}};
  read.group_of = {0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  const auto made = test::value(make_part(std::move(read), "cm", [](double, const char*) {}));

  ASSERT_EQ(made.facts.faces.size(), 6U);
  EXPECT_EQ(made.facts.faces[1].name, "ends");
  EXPECT_THAT(made.facts.faces[1].ids, ElementsAre(1));
  EXPECT_EQ(made.facts.faces[1].looks, (cad::colour{1, 0, 0}));
  EXPECT_THAT(made.facts.faces[5].ids, ElementsAre(2));
  EXPECT_NEAR(made.facts.solids[0].volume_mm3, 1e6, 1e-3);
}

}  // namespace
}  // namespace tedit::scan
