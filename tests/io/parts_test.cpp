// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/io/file.hpp"
#include "mesh/io/import.hpp"
#include "mesh/quality.hpp"
#include "tests/support/parts.hpp"

namespace tedit {
namespace {

class Parts : public ::testing::TestWithParam<const char*> {};

TEST_P(Parts, LoadWithTheCountsOfTheirDescription) {
  const auto folder = test::parts_folder / GetParam();
  std::ifstream in(folder / "meta.json");
  const auto meta = nlohmann::json::parse(in)["levels"]["coarse"];

  const auto mesh = import_mesh(folder / (std::string(GetParam()) + ".coarse.msh"), "mm");

  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  const auto& version = *mesh->version;
  EXPECT_EQ(version.tet_count(), meta["tets"]);
  EXPECT_EQ(version.vertex_count(), meta["vertices"]);
  // In the assembly the triangles between solids are interfaces.
  EXPECT_EQ(version.facet_count() + version.data().interfaces.size(), meta["boundary_triangles"]);
  const double volume = meta["volume"]["total"].get<double>() * 1e-9;
  EXPECT_NEAR(total_volume(version), volume, 1e-10 * volume);
  const auto quality = radius_ratios(version);
  EXPECT_NEAR(quality.median, 3 * meta["radius_ratio"]["median"].get<double>(), 1e-9);
  EXPECT_NEAR(quality.max, 3 * meta["radius_ratio"]["max"].get<double>(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Open, Parts,
                         ::testing::Values("as1_assembly", "base_so101", "bracket_4040",
                                           "ctc01_plate", "foot_cup", "fork_thin", "heatsink_125",
                                           "holes_block", "inch_block"));

TEST(PhysicalNames, BecomeSurfaceAndRegionNames) {
  const auto mesh =
    import_mesh(test::parts_folder / "ctc01_plate/ctc01_plate.coarse.physical.msh", "mm");

  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  EXPECT_EQ(mesh->version->find_surface(98)->name, "load");
  EXPECT_EQ(mesh->version->find_surface(72)->name, "fixed");
  EXPECT_EQ(mesh->version->regions().front().name, "bulk");
}

/// A large file would take its memory beside the part's while that is built.
TEST(Import, LetsTheBytesGoOnceTheyAreRead) {
  const auto file = test::parts_folder / "ctc01_plate/ctc01_plate.coarse.msh";
  auto bytes = read_file(file);
  ASSERT_TRUE(bytes);
  auto& held = *bytes;
  const auto kept = import_mesh_bytes(std::span<const char>(held), "mm");
  EXPECT_GT(held.size(), 100'000U);
  const auto mesh = import_mesh_bytes(std::move(held), "mm");
  EXPECT_EQ(held.capacity(), 0U);
  ASSERT_TRUE(mesh && kept);
  EXPECT_EQ(mesh->version->id(), kept->version->id());
}

}  // namespace
}  // namespace tedit
