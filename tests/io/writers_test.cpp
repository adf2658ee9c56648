// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/builder.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/msh_writer.hpp"
#include "mesh/io/stl_writer.hpp"
#include "mesh/io/vtu_writer.hpp"
#include "tests/support/parts.hpp"

namespace tedit {
namespace {

std::filesystem::path scratch(const std::string& name) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(::testing::TempDir()) / "tedit_io" / info->name();
  std::filesystem::create_directories(folder);
  return folder / name;
}

TEST(MshWriter, RoundTripKeepsMeshSurfacesAndNames) {
  const auto first =
    import_mesh(test::parts_folder / "ctc01_plate/ctc01_plate.coarse.physical.msh", "mm");
  ASSERT_TRUE(first.has_value());
  const auto file = scratch("plate.msh");

  ASSERT_TRUE(write_msh(file, *first->version, "mm").has_value());
  const auto second = import_mesh(file, "mm");

  ASSERT_TRUE(second.has_value()) << second.error().message;
  EXPECT_EQ(second->version->surfaces(), first->version->surfaces());
  EXPECT_EQ(second->version->regions(), first->version->regions());
  EXPECT_EQ(second->version->tet_count(), first->version->tet_count());
  EXPECT_NEAR(total_volume(*second->version), total_volume(*first->version), 1e-15);
  // Once through the writer, a mesh no longer changes.
  ASSERT_TRUE(write_msh(file, *second->version, "m").has_value());
  EXPECT_EQ(import_mesh(file, "m")->version->id(), second->version->id());
}

TEST(MshWriter, KeepsInterfacesOfAnAssembly) {
  const auto first = import_mesh(test::parts_folder / "as1_assembly/as1_assembly.coarse.msh", "mm");
  const auto file = scratch("assembly.msh");

  ASSERT_TRUE(write_msh(file, *first->version, "mm").has_value());
  const auto second = import_mesh(file, "mm");

  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->version->data().interfaces.size(), first->version->data().interfaces.size());
  EXPECT_GT(second->version->data().interfaces.size(), 0u);
}

TEST(MshWriter, NamesAFolderThatCannotBeWritten) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");

  const auto written = write_msh("/proc/no/such/folder.msh", *mesh->version, "mm");

  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ec::io_error);
  EXPECT_THAT(written.error().message, ::testing::HasSubstr("/proc/no/such"));
}

TEST(VtuWriter, WritesTheHeaderAndAllBytes) {
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::uint32_t> cells{0, 1, 2, 3};
  const std::vector<double> values{1, 2, 3, 4};
  const auto file = scratch("one.vtu");

  ASSERT_TRUE(write_vtu(file, {points, cells, 4, {{"a<b", 1, values}}, {}, {}}).has_value());

  std::ifstream in(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(text, ::testing::HasSubstr("NumberOfPoints=\"4\" NumberOfCells=\"1\""));
  EXPECT_THAT(text, ::testing::HasSubstr("Name=\"a&lt;b\""));
  // Five blocks of 8 + n bytes: 96 points, 32 connectivity, 8 offsets, 1 type, 32 values.
  const std::string opening = "encoding=\"raw\">\n_";
  const auto start = text.find(opening) + opening.size();
  const auto end = text.find("\n</AppendedData>");
  EXPECT_EQ(end - start, 5 * 8 + 96 + 32 + 8 + 1 + 32u);
}

TEST(StlWriter, WritesOneRecordForEachFacet) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");
  const auto file = scratch("cube.stl");

  ASSERT_TRUE(write_stl(file, *mesh->version, "mm").has_value());

  EXPECT_EQ(std::filesystem::file_size(file), 84 + 50 * 12u);
}

}  // namespace
}  // namespace tedit
