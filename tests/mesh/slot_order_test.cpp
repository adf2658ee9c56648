// SPDX-License-Identifier: AGPL-3.0-or-later
#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/build_version.hpp"
#include "mesh/builder.hpp"
#include "mesh/checks.hpp"
#include "mesh/io/compaction.hpp"
#include "mesh/morton.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

/// The mesh as a file of a mesher that numbers vertices and tets at random.
raw_mesh shuffled(const mesh_version& mesh) {
  std::mt19937 dice(7);
  raw_mesh raw;
  std::vector<vertex_id> place(mesh.vertex_slots());
  std::iota(place.begin(), place.end(), 0);
  std::ranges::shuffle(place, dice);
  raw.positions.resize(place.size());
  for (vertex_id v = 0; v < place.size(); ++v)
    raw.positions[place[v]] = mesh.position(v);
  auto tets = test::all_tets(mesh);
  std::ranges::shuffle(tets, dice);
  for (const auto t : tets) {
    auto corners = mesh.tet_at(t);
    for (auto& v : corners.v)
      v = place[v];
    raw.tets.push_back(corners);
    raw.tet_regions.push_back(1);
  }
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    auto corners = mesh.facet(f).v;
    for (auto& v : corners)
      v = place[v];
    raw.triangles.push_back({corners, mesh.facet(f).surface, true});
  }
  return raw;
}

/// 6 * 12^3 = 10,368 tets: three pages of 4096.
version_ptr three_pages() {
  return test::box_mesh({12, 12, 12}, {.012, .012, .012});
}

std::size_t tet_pages_within(const mesh_version& mesh, double side) {
  std::set<std::size_t> pages;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    const auto c = mesh.corners(t);
    const auto middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    if (std::max({middle.x, middle.y, middle.z}) < side)
      pages.insert(t >> paged_array<tet>::shift);
  }
  return pages.size();
}

TEST(MortonCurve, InterleavesTheBitsOfThreeCoordinates) {
  box extents;
  extents.add(vec3{0, 0, 0});
  extents.add(vec3{2097151, 0, 1});  // A cell is a metre.
  const morton_curve curve(extents);

  EXPECT_EQ(curve.code({0, 0, 0}), 0u);
  EXPECT_EQ(curve.code({1, 0, 0}), 1u);
  EXPECT_EQ(curve.code({0, 1, 0}), 2u);
  EXPECT_EQ(curve.code({0, 0, 1}), 4u);
  EXPECT_EQ(curve.code({3, 0, 1}), 1u + 8u + 4u);
}

TEST(SlotOrder, PutsNeighboursIntoThePagesOfNeighbours) {
  const auto raw = shuffled(*three_pages());

  const auto given = build_version(raw, 1)->version;
  const auto sorted = build_version(raw, 1, slot_order::along_curve)->version;

  EXPECT_EQ(tet_pages_within(*given, .003), 3u);
  EXPECT_EQ(tet_pages_within(*sorted, .003), 1u);
  EXPECT_TRUE(check_version(*sorted).findings.empty());
}

TEST(SlotOrder, KeepsTheOrderOfTheFileForFiles) {
  const auto raw = shuffled(*three_pages());

  const auto mesh = build_version(raw, 1, slot_order::along_curve)->version;

  const auto vertices = vertices_of_file(*mesh);
  const auto tets = tets_of_file(*mesh);
  ASSERT_EQ(vertices.slots.size(), raw.positions.size());
  for (std::size_t v = 0; v < raw.positions.size(); ++v)
    EXPECT_EQ(mesh->position(vertices.slots[v]), raw.positions[v]);
  ASSERT_EQ(tets.slots.size(), raw.tets.size());
  for (std::size_t t = 0; t < raw.tets.size(); ++t)
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(vertices.index[mesh->tet_at(tets.slots[t]).v[i]], raw.tets[t].v[i]);
  EXPECT_NE(vertices.slots.front(), 0u);  // Else nothing was sorted.
}

TEST(SlotOrder, OfAPageOfTetsIsThatOfTheFile) {
  const auto raw = shuffled(*test::box_mesh({8, 8, 8}, {1, 1, 1}));  // 3,072 tets.

  const auto sorted = build_version(raw, 1, slot_order::along_curve)->version;

  EXPECT_EQ(sorted->id(), build_version(raw, 1)->version->id());
  EXPECT_EQ(sorted->data().tet_order.size(), 0u);
}

TEST(SlotOrder, OfAnEditedMeshPutsWhatIsNewBehind) {
  const auto raw = shuffled(*three_pages());
  const auto before = build_version(raw, 1, slot_order::along_curve)->version;

  const auto after = test::split(before, [](tet_id t) { return t % 1000 == 0; });

  ASSERT_TRUE(after);
  EXPECT_EQ(after->data().vertex_order.size(), after->vertex_slots());
  EXPECT_EQ(after->data().tet_order.size(), after->tet_slots());
  const auto vertices = vertices_of_file(*after);
  for (std::size_t v = 0; v < raw.positions.size(); ++v)
    EXPECT_EQ(after->position(vertices.slots[v]), raw.positions[v]);
  EXPECT_EQ(vertices.slots.size(), raw.positions.size() + 11);
  // Each of the 11 slots that was split is taken again by a new tet and keeps its place.
  EXPECT_EQ(tets_of_file(*after).slots.size(), raw.tets.size() + 33);
}

TEST(SlotOrder, TravelsWithTheManifest) {
  const auto raw = shuffled(*three_pages());
  const auto mesh = build_version(raw, 1, slot_order::along_curve)->version;
  std::map<hash128, page_ptr> pages;
  mesh->for_each_page([&](const page_ptr& p) { pages[p->id()] = p; });
  const auto find = [&](const hash128& id) { return pages.contains(id) ? pages[id] : nullptr; };
  auto list = *manifest::from_bytes(mesh->pages().to_bytes());

  const auto again = mesh_version::from_manifest(list, find);

  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ((*again)->id(), mesh->id());
  EXPECT_EQ(tets_of_file(**again).slots, tets_of_file(*mesh).slots);
  list.arrays.back().size += paged_array<std::uint32_t>::items_per_page;
  EXPECT_FALSE(mesh_version::from_manifest(list, find).has_value());
  list.arrays.pop_back();
  const auto eight = mesh_version::from_manifest(list, find);
  ASSERT_FALSE(eight.has_value());
  EXPECT_THAT(eight.error().message, HasSubstr("7 or 9 arrays, this one 8"));
}

TEST(SlotOrder, FaultsAreToldByTheNumbersOfTheFile) {
  auto raw = shuffled(*three_pages());
  for (std::uint64_t t = 0; t < raw.tets.size(); ++t)
    raw.tet_numbers.push_back(100000 + t);
  raw.tets[5] = raw.tets[9];

  const auto built = build_version(raw, 1, slot_order::along_curve);

  ASSERT_FALSE(built.has_value());
  EXPECT_THAT(built.error().message, HasSubstr("tet 100005 and tet 100009 are the same tet twice"));
}

}  // namespace
}  // namespace tedit
