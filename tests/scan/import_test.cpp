// SPDX-License-Identifier: AGPL-3.0-or-later
// Surface files on the command line.
#include <numbers>

#include "tests/cad/import_program.hpp"
#include "tests/scan/surfaces.hpp"

namespace tedit::test {
namespace {

std::string stl_file(const std::string& name, const soup& triangles) {
  return write_scratch(name, stl_of(triangles)).string();
}

TEST(ImportedStl, OfACubeHasItsPlanesAndVolume) {
  const auto part = import_part(stl_file("cube.stl", cube_soup(10)) + " --size coarse");

  EXPECT_EQ(part["surfaces"].size(), 6U);
  EXPECT_EQ(part["surfaces"][2]["name"], "plane 3");
  EXPECT_NEAR(part["volume_m3"].get<double>(), 1e-6, 1e-15);
  EXPECT_NEAR(part["cad_volume_m3"].get<double>(), 1e-6, 1e-15);
  EXPECT_NEAR(part["deviation_m"].get<double>(), 0, 1e-12);
  EXPECT_NEAR(part["edge_length_m"].get<double>(), 1e-3 * 2 * 1000 / 600, 1e-12);
  EXPECT_GT(part["radius_ratio"]["min"].get<double>(), 0.1);
  EXPECT_EQ(part["length_unit"], "mm");
  EXPECT_EQ(part["cad_unit"], "mm");
  for (const char* stage : {"read", "mesh", "repair", "total"})
    EXPECT_GE(part["timings_ms"][stage].get<double>(), 0) << stage;
}

}  // namespace
}  // namespace tedit::test
