// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/facet_sheet.hpp"

#include <random>

#include <gtest/gtest.h>

#include "mesh/distances.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/parts.hpp"

namespace tedit::ops {
namespace {

void expect_near(vec3 a, vec3 b, double off) {
  EXPECT_NEAR(a.x, b.x, off);
  EXPECT_NEAR(a.y, b.y, off);
  EXPECT_NEAR(a.z, b.z, off);
}

TEST(FacetSheet, IsThePlaneAtTheNearestPointAlsoBeyondTheBorder) {
  const auto box = test::box_mesh({4, 4, 4}, {1, 1, 1});
  const facet_sheet top(*box, 6);

  const auto above = top.plane_at({0.4, 0.3, 1.7});
  expect_near(above.point, {0.4, 0.3, 1}, 1e-12);
  expect_near(above.axis, {0, 0, 1}, 1e-12);

  const auto beyond = top.plane_at({40, 0.5, 3});
  expect_near(beyond.point, {1, 0.5, 1}, 1e-12);
  expect_near(beyond.axis, {0, 0, 1}, 1e-12);
}

/// A surface of several sides, as files have them: where they meet its normal is their mean.
TEST(FacetSheet, WhereFacetsMeetTheNormalIsTheirMean) {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  raw.tets = {{{0, 1, 2, 3}}};
  raw.tet_regions = {1};
  raw.triangles = {
    {{0, 2, 1}, 5, true}, {{0, 1, 3}, 5, true}, {{0, 3, 2}, 7, true}, {{1, 2, 3}, 8, true}};
  const auto corner = build_version(std::move(raw), 1)->version;
  const facet_sheet both(*corner, 5);

  // Nearest to the edge between z = 0 and y = 0, from outside.
  const auto plane = both.plane_at({0.5, -0.2, -0.2});

  expect_near(plane.point, {0.5, 0, 0}, 1e-12);
  expect_near(plane.axis, {0, -std::sqrt(0.5), -std::sqrt(0.5)}, 1e-12);
}

TEST(FacetSheet, FindsWhatALookAtEveryFacetFinds) {
  const auto part =
    import_mesh(test::parts_folder / "ctc01_plate/ctc01_plate.coarse.msh", "mm")->version;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-0.4, 0.4);
  for (const surface_id id : {57, 99, 98, 1}) {
    const facet_sheet sheet(*part, id);
    for (int i = 0; i < 50; ++i) {
      const vec3 p{anywhere(random), anywhere(random), anywhere(random)};
      double least = 1e300;
      for (const auto f : facets_of(*part, std::vector{id})) {
        const auto& v = part->facet(f).v;
        least = std::min(least, point_to_triangle(p, part->position(v[0]), part->position(v[1]),
                                                  part->position(v[2])));
      }
      const auto plane = sheet.plane_at(p);
      // Of several facets as near it is the last one's, up to a millionth of a facet.
      EXPECT_NEAR(norm(p - plane.point), least, 1e-7);
      EXPECT_NEAR(norm(plane.axis), 1, 1e-12);
    }
  }
}

}  // namespace
}  // namespace tedit::ops
