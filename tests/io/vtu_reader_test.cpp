// SPDX-License-Identifier: AGPL-3.0-or-later
// VTU files as other programs write them: each way in which numbers can stand in one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path corpus = TEDIT_SOURCE_DIR "/tests/fuzz/corpus";

std::string grid_text(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  return {bytes->begin(), bytes->end()};
}

expected<imported_mesh> read_grid(const std::string& text) {
  return import_mesh_bytes(std::span(text.data(), text.size()), "mm");
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

TEST(VtuReader, TextBase64RawAndZlibAreTheSameMesh) {
  for (const auto* name : {"two_tets_ascii.vtu", "two_tets_base64.vtu", "two_tets_base64_zlib.vtu",
                           "two_tets_raw.vtu", "two_tets_raw_zlib.vtu"}) {
    SCOPED_TRACE(name);
    const auto mesh = import_mesh(corpus / name, "mm");

    ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
    EXPECT_EQ(mesh->version->tet_count(), 2U);
    EXPECT_NEAR(total_volume(*mesh->version), 0.5e-9, 1e-20);  // 1/6 and 1/3 mm3.
    EXPECT_EQ(mesh->version->regions(), (std::vector<region_info>{{1, ""}, {2, ""}}));
  }
}

/// The 120 bytes of the points as one of 64 and one of 56, packed by Python's zlib.
TEST(VtuReader, PackedBlocksAreReadOneBehindTheOther) {
  const auto one_block = grid_text(corpus / "two_tets_base64_zlib.vtu");
  const auto mesh =
    read_grid(replaced(one_block, "AQAAAHgAAAAAAAAAFAAAAA==eJxjYMAHPtjjlSZaHpMGAPByBxs=",
                       "AgAAAEAAAAA4AAAAEgAAAA8AAAA=eJxjYMAHPtjjlQbKAwAqXgJfeJxjYMAHPtjjogFBhAS9"));

  ASSERT_TRUE(mesh.has_value()) << render(mesh.error());
  EXPECT_EQ(mesh->version->id(), read_grid(one_block)->version->id());
}

TEST(VtuReader, CountsAreHeldAgainstTheBytesThatAreThere) {
  for (const auto* name : {"two_billion_points_raw.vtu", "two_billion_points_zlib.vtu"}) {
    const auto mesh = import_mesh(corpus / name, "mm");

    ASSERT_FALSE(mesh.has_value());
    EXPECT_THAT(mesh.error().message,
                HasSubstr("the array \"Points\" has 15 numbers where 6000000000 should be"));
    EXPECT_THAT(mesh.error().where, HasSubstr("array \"Points\""));
  }
}

TEST(VtuReader, WhatIsBrokenOrOtherIsRefusedWithItsPlace) {
  const auto good = grid_text(corpus / "two_tets_ascii.vtu");
  const auto raw = grid_text(corpus / "two_tets_raw.vtu");
  const std::pair<std::string, std::string> rows[] = {
    {replaced(good, ">10 10<", ">10 12<"), "the mesh holds a hexahedron (cell type 12)"},
    {replaced(good, ">10 10<", ">10 x<"), "holds \"x\" where a number should be"},
    {replaced(good, ">4 8<", ">4 3<"), "cell 0 ends at 4 of the connectivity"},
    {replaced(good, "1 2 3 4<", "1 2 3 5<"), "cell 1 names point 5, which does not exist"},
    {replaced(good, ">0 0 0 1", ">0 0 0 1e999"), "holds \"1e999\" where a number should be"},
    {replaced(good, "\"UnstructuredGrid\"", "\"PolyData\""), "of type \"PolyData\""},
    {replaced(good, "<Cells>", "<Cell>"), "the file is no sound XML"},
    {replaced(good, "byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order"),
     "packed by vtkLZ4DataCompressor"},
    {raw.substr(0, raw.size() - 40), "the array \"region\" says 16 bytes, but 1 are left"},
  };
  for (const auto& [text, message] : rows) {
    SCOPED_TRACE(text);
    const auto mesh = read_grid(text);
    ASSERT_FALSE(mesh.has_value());
    EXPECT_THAT(mesh.error().message, HasSubstr(message));
    EXPECT_FALSE(mesh.error().remedy.empty());
  }
}

}  // namespace
}  // namespace tedit
