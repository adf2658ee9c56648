// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/builder.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

using test::unit_box;

/// Changes one slot of an array behind the builder's back.
template <class T, class Change>
paged_array<T> with(const paged_array<T>& array, std::size_t slot, Change&& change) {
  paged_array_builder<T> builder(array);
  change(builder.write(slot));
  return builder.freeze();
}

/// The rules that a planted fault breaks.
std::string broken(const mesh_data& data) {
  std::string rules;
  for (const auto& f : check_version(*mesh_version::create(data)).findings)
    rules += f.rule + " at " + f.element + " (" + f.numbers + "); ";
  return rules;
}

TEST(CheckVersion, ASoundMeshHasNoFinding) {
  EXPECT_TRUE(check_version(*unit_box()).ok());
}

TEST(CheckVersion, FindsAnInvertedTet) {
  auto data = unit_box()->data();
  // The middle vertex (index 13 of 27) goes outside.
  data.positions = with(data.positions, 13, [](vec3& p) { p = {3, 3, 3}; });

  EXPECT_THAT(broken(data), HasSubstr("positive orientation at tet"));
}

TEST(CheckVersion, FindsWrongNeighboursAndFacets) {
  const auto mesh = unit_box();
  auto neighbours = mesh->data();
  neighbours.neighbours = with(neighbours.neighbours, 0, [](adjacency& row) {
    for (auto& behind : row)
      if (!is_facet(behind))
        behind = behind == 1 ? 2 : 1;
  });
  auto facet = mesh->data();
  facet.facets = with(facet.facets, 0, [](boundary_facet& f) { std::swap(f.v[0], f.v[1]); });
  auto surface = mesh->data();
  surface.facets = with(surface.facets, 0, [](boundary_facet& f) { f.surface = 77; });
  auto incident = mesh->data();
  incident.vertex_tet = with(incident.vertex_tet, 0, [](std::uint32_t& t) { t = 47; });
  auto corner = mesh->data();
  corner.tets = with(corner.tets, 3, [](tet& t) { t.v[0] = 12345; });

  EXPECT_THAT(broken(neighbours), HasSubstr("neighbours share a face"));
  EXPECT_THAT(broken(facet), HasSubstr("boundary face has its facet"));
  EXPECT_THAT(broken(surface), HasSubstr("facet has a surface of the table"));
  EXPECT_THAT(broken(incident), HasSubstr("incident tet holds the vertex"));
  EXPECT_THAT(broken(corner), HasSubstr("corners exist"));
}

/// Pages of other machines hold any number: each is found, and none is followed.
TEST(CheckVersion, NumbersBeyondTheSlotsAreFoundAndNotFollowed) {
  static constexpr std::uint32_t beyond = 0x7fff'fffe;
  auto facet = unit_box()->data();
  facet.facets = with(facet.facets, 0, [](boundary_facet& f) { f.v[2] = beyond; });
  auto behind = unit_box()->data();
  behind.facets = with(behind.facets, 0, [](boundary_facet& f) { f.tet = beyond; });
  auto neighbour = unit_box()->data();
  neighbour.neighbours = with(neighbour.neighbours, 0, [](adjacency& row) { row.fill(beyond); });
  auto shorter = unit_box()->data();
  const auto regions = shorter.tet_regions.to_vector();
  shorter.tet_regions = paged_array<region_id>::from(std::span(regions).first(47));

  EXPECT_THAT(broken(facet), HasSubstr("corners exist at facet 0 (vertex 2147483646)"));
  EXPECT_THAT(broken(behind), HasSubstr("facet lies on its tet at facet 0 (tet 2147483646)"));
  EXPECT_THAT(broken(neighbour), HasSubstr("neighbours share a face at tet 0"));
  EXPECT_EQ(broken(shorter),
            "arrays of one kind have one length at tets and regions (48 and 47 slots); ");
}

TEST(CheckEdit, NumbersBeyondTheSlotsAreFoundAndNotFollowed) {
  const auto base = unit_box();
  auto facet = base->data();
  facet.facets = with(facet.facets, 0, [](boundary_facet& f) { f.v[2] = 0x7fff'fffe; });
  facet.positions = with(facet.positions, 13, [](vec3& p) { p.x += .01; });
  const auto report = check_edit(*base, *mesh_version::create(facet), {});
  EXPECT_THAT(report.findings,
              ::testing::Contains(::testing::Field(&finding::element, std::string("facet 0"))));
}

TEST(CheckVersion, FindsWrongCounts) {
  auto data = unit_box()->data();
  ++data.live_tets;

  EXPECT_THAT(broken(data), HasSubstr("48 live, 49 stated"));
}

TEST(CheckVersion, FindsWrongCountsOfFacetsAndOfVertices) {
  auto facets = unit_box()->data();
  ++facets.live_facets;
  auto vertices = unit_box()->data();
  --vertices.vertices;

  EXPECT_EQ(broken(facets), "counts are right at facets (48 live, 49 stated); ");
  EXPECT_EQ(broken(vertices), "counts are right at vertices (27 live, 26 stated); ");
}

/// Two cells that share an edge only, from vertex 0 to vertex 3.
version_ptr two_at_an_edge() {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
  raw.tets = {{{0, 1, 2, 3}}, {{0, 4, 5, 3}}};
  raw.tet_regions = {1, 1};
  return build_version(raw, 1)->version;
}

TEST(CheckVersion, FindsABoundaryThatTouchesItself) {
  const auto report = check_version(*two_at_an_edge());

  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings.front().code, ec::non_manifold);
}

/// An edit that moves one vertex, reported as the caller says.
check_report moved(vec3 by, bool reported, edit_claim claim = {}) {
  const auto base = unit_box();
  mesh_builder builder(base);
  builder.set_position(13, base->position(13) + by);
  if (reported)
    claim.touched = builder.touched();
  return check_edit(*base, *builder.freeze(), claim);
}

TEST(CheckEdit, AReportedSmallMoveIsFine) {
  EXPECT_TRUE(moved({0.01, 0, 0}, true).ok());
}

TEST(CheckEdit, AnUnreportedMoveIsFound) {
  EXPECT_THAT(to_error(moved({0.01, 0, 0}, false)).message,
              HasSubstr("untouched tets are identical"));
}

TEST(CheckEdit, AMoveIsSeenInAllTetsAroundAlsoWhereTheyHangTogetherAtTheVertexAlone) {
  const auto base = two_at_an_edge();
  for (const tet_id reported : {0u, 1u}) {
    mesh_builder builder(base);
    builder.set_position(0, {0, 0, -0.01});
    edit_claim claim;
    claim.touched = {reported};

    const auto fault = to_error(check_edit(*base, *builder.freeze(), claim));

    EXPECT_THAT(fault.message, HasSubstr("untouched tets are identical"));
    EXPECT_EQ(fault.where, "tet " + std::to_string(1 - reported));
  }
}

TEST(CheckEdit, AWrongVolumeClaimIsFound) {
  edit_claim claim;
  claim.volume_change = 1e-6;

  EXPECT_THAT(to_error(moved({0.01, 0, 0}, true, claim)).message,
              HasSubstr("volume changes as the operation says"));
}

TEST(CheckEdit, ALossOfQualityIsFound) {
  const auto report = moved({0.45, 0, 0}, true);

  ASSERT_FALSE(report.ok());
  EXPECT_THAT(to_error(report).message, HasSubstr("worst quality"));
}

TEST(CheckEdit, AVertexThatIsNowhereIsFound) {
  EXPECT_THAT(to_error(moved({std::nan(""), 0, 0}, true)).message,
              HasSubstr("positive orientation"));
}

TEST(CheckEdit, AFloorThatIsNoNumberAllowsNothing) {
  edit_claim claim;
  claim.quality_floor = std::nan("");

  EXPECT_THAT(to_error(moved({0.45, 0, 0}, true, claim)).message, HasSubstr("worst quality"));
}

TEST(CheckEdit, AnInversionIsFound) {
  EXPECT_THAT(to_error(moved({0.7, 0, 0}, true)).message, HasSubstr("positive orientation"));
}

TEST(CheckEdit, AClosedVoidIsFound) {
  const auto base = test::box_mesh({3, 3, 3}, {1, 1, 1});
  mesh_builder builder(base);
  cavity_change hole;
  edit_claim claim;
  // The six tets of the middle cell.
  for (tet_id t = 6 * 13; t < 6 * 14; ++t) {
    hole.removed.push_back(t);
    claim.volume_change -= signed_volume(base->corners(t));
    for (int face = 0; face < 4; ++face) {
      const auto& order = tet_faces[face];
      const auto& v = base->tet_at(t).v;
      hole.facets.push_back({{v[order[0]], v[order[1]], v[order[2]]}, 1});
    }
  }
  ASSERT_TRUE(builder.apply(hole).has_value());
  claim.touched = builder.touched();

  const auto report = check_edit(*base, *builder.freeze(), claim);

  EXPECT_THAT(to_error(report).message, HasSubstr("no new closed void"));
}

}  // namespace
}  // namespace tedit
