// SPDX-License-Identifier: AGPL-3.0-or-later
// What is written has the vertices and tets of the file that was read, in its order.
#include <gtest/gtest.h>

#include "mesh/io/compaction.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/read_mesh.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/parts.hpp"

namespace tedit {
namespace {

const auto plate = test::parts_folder / "ctc01_plate/ctc01_plate.coarse.msh";

raw_mesh read_raw(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  return read_any(std::span<const char>(*bytes))->mesh;
}

TEST(FileOrder, OfAWrittenMeshIsThatOfTheOneThatWasRead) {
  const auto imported = import_mesh(plate, "mm");
  ASSERT_GT(imported->version->data().vertex_order.size(), 0u);
  const auto written = std::filesystem::path(::testing::TempDir()) / "tedit_file_order.msh";

  ASSERT_TRUE(formats::msh::write(written, *imported->version, {"mm"}).has_value());

  const auto before = read_raw(plate);
  const auto after = read_raw(written);
  std::filesystem::remove(written);
  ASSERT_EQ(after.positions.size(), before.positions.size());
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    EXPECT_LT(norm(after.positions[v] - before.positions[v]), 1e-12) << v;
  ASSERT_EQ(after.tets.size(), before.tets.size());
  for (std::size_t t = 0; t < before.tets.size(); ++t) {
    auto was = before.tets[t].v;
    auto is = after.tets[t].v;
    std::ranges::sort(was);
    std::ranges::sort(is);
    EXPECT_EQ(is, was) << t;
  }
}

TEST(FileOrder, StaysWhereAnEditLeavesThings) {
  const auto before = import_mesh(plate, "mm")->version;
  const auto removed = before->tet_at(1000).v;

  const auto after = test::split(before, [](tet_id t) { return t == 1000; });

  const auto was = vertices_of_file(*before);
  const auto is = vertices_of_file(*after);
  ASSERT_EQ(is.slots.size(), was.slots.size() + 1);
  for (std::size_t v = 0; v < was.slots.size(); ++v)
    EXPECT_EQ(is.slots[v], was.slots[v]);
  EXPECT_EQ(tets_of_file(*after).slots.size(), tets_of_file(*before).slots.size() + 3);
  EXPECT_NE(after->tet_at(1000).v, removed);
}

}  // namespace
}  // namespace tedit
