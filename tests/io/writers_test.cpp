// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/build_version.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
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

  ASSERT_TRUE(formats::msh::write(file, *first->version, {"mm"}).has_value());
  const auto second = import_mesh(file, "mm");

  ASSERT_TRUE(second.has_value()) << second.error().message;
  EXPECT_EQ(second->version->surfaces(), first->version->surfaces());
  EXPECT_EQ(second->version->regions(), first->version->regions());
  EXPECT_EQ(second->version->tet_count(), first->version->tet_count());
  EXPECT_NEAR(total_volume(*second->version), total_volume(*first->version), 1e-15);
  // Once through the writer, a mesh no longer changes.
  ASSERT_TRUE(formats::msh::write(file, *second->version, {"m"}).has_value());
  EXPECT_EQ(import_mesh(file, "m")->version->id(), second->version->id());
}

TEST(MshWriter, KeepsInterfacesOfAnAssembly) {
  const auto first = import_mesh(test::parts_folder / "as1_assembly/as1_assembly.coarse.msh", "mm");
  const auto file = scratch("assembly.msh");

  ASSERT_TRUE(formats::msh::write(file, *first->version, {"mm"}).has_value());
  const auto second = import_mesh(file, "mm");

  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->version->data().interfaces.size(), first->version->data().interfaces.size());
  EXPECT_GT(second->version->data().interfaces.size(), 0u);
}

TEST(MshWriter, NamesAFolderThatCannotBeWritten) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");

  const auto written = formats::msh::write("/proc/no/such/folder.msh", *mesh->version, {"mm"});

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

TEST(FileFormats, EachIsWrittenByItsName) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");

  for (const auto name : written_formats()) {
    if (name == "med" && !TEDIT_HAS_MED)
      continue;
    std::string bytes;
    EXPECT_TRUE(write_as(name, &bytes, *mesh->version, {"mm"}).has_value()) << name;
    EXPECT_GT(bytes.size(), 200U) << name;
    EXPECT_EQ((*format_for("Part." + std::string(name)))->name, name);
  }
  EXPECT_EQ((*format_for("/a.b/PART.STL"))->name, "stl");
}

TEST(FileFormats, OneThatIsNotThereIsRefusedWithThoseThatAre) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");
  std::string bytes;

  const auto written = write_as("step", &bytes, *mesh->version, {"mm"});
  const auto unnamed = format_for("part");

  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ec::invalid_argument);
  EXPECT_EQ(written.error().message, "there is no file format \"step\" to write");
  EXPECT_THAT(written.error().remedy, ::testing::StartsWith("Take msh, vtu, stl"));
  EXPECT_EQ(unnamed.error().message, "the file's name has no suffix that says its format");
}

TEST(FileFormats, OneThatIsOnlyWrittenIsNotRead) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");

  for (const auto& format : file_formats) {
    if (format.name == "med" && !TEDIT_HAS_MED)
      continue;
    std::string bytes;
    ASSERT_TRUE(write_as(format.name, &bytes, *mesh->version, {"mm"}).has_value());
    const auto again = import_mesh_bytes(bytes, "mm");
    EXPECT_EQ(again.has_value(), format.reads) << format.name;
    if (!again) {
      EXPECT_EQ(again.error().message, "this is " + std::string(format.kind) + ", not a Gmsh mesh");
    }
  }
}

/// Corner tet of a cube of 1 mm and the regular tet in its middle, which share a face.
version_ptr two_tets() {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  raw.tets = {{{0, 1, 2, 3}}, {{1, 2, 3, 4}}};
  raw.tet_regions = {1, 1};
  raw.triangles = {{{0, 1, 2}, 7},  {{0, 1, 3}, 7},  {{0, 2, 3}, 7},
                   {{1, 2, 4}, 12}, {{1, 3, 4}, 12}, {{2, 3, 4}, 12}};
  raw.surface_names = {{7, "three squares #1"}};
  return build_version(std::move(raw), 1e-3)->version;
}

TEST(ObjWriter, TwoTetsAreSixTrianglesInTheGroupsOfTheirSurfaces) {
  std::string text;

  ASSERT_TRUE(formats::obj::write(&text, *two_tets(), {"cm"}).has_value());

  EXPECT_EQ(text,
            "# TEdit boundary, unit cm\n"
            "v 0 0 0\n"
            "v 0.1 0 0\n"
            "v 0 0.1 0\n"
            "v 0 0 0.1\n"
            "v 0.1 0.1 0.1\n"
            "g three_squares__1_7\n"
            "f 1 3 2\n"
            "f 1 2 4\n"
            "f 1 4 3\n"
            "g surface_12\n"
            "f 2 3 5\n"
            "f 2 5 4\n"
            "f 3 4 5\n");
}

TEST(StlWriter, WritesOneRecordForEachFacet) {
  const auto mesh = import_mesh(TEDIT_TEST_DATA "/bad/good_six_tets_cube.msh", "mm");
  const auto file = scratch("cube.stl");

  ASSERT_TRUE(formats::stl::write(file, *mesh->version, {"mm"}).has_value());

  EXPECT_EQ(std::filesystem::file_size(file), 84 + 50 * 12u);
}

}  // namespace
}  // namespace tedit
