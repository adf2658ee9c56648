// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/build_version.hpp"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/quality.hpp"

namespace tedit {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Two tets on the triangle 1-2-3: volumes 1/6 each.
raw_mesh two_tets() {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  raw.tets = {{{0, 1, 2, 3}}, {{4, 1, 3, 2}}};
  raw.tet_regions = {1, 1};
  return raw;
}

error refusal(raw_mesh raw) {
  const auto built = build_version(std::move(raw), 1.0);
  EXPECT_FALSE(built.has_value());
  return built ? error{} : built.error();
}

TEST(BuildVersion, LinksTwoTetsOverTheirSharedFace) {
  const auto built = build_version(two_tets(), 1.0);

  ASSERT_TRUE(built.has_value());
  const auto& mesh = *built->version;
  EXPECT_EQ(mesh.tet_count(), 2u);
  EXPECT_EQ(mesh.facet_count(), 6u);
  EXPECT_EQ(mesh.neighbours(0)[0], 1u);
  EXPECT_EQ(mesh.neighbours(1)[0], 0u);
  EXPECT_DOUBLE_EQ(total_volume(mesh), 1.0 / 6 + 1.0 / 3);
}

TEST(BuildVersion, ScalesToMetres) {
  const auto built = build_version(two_tets(), 1e-3);

  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->version->position(1), (vec3{1e-3, 0, 0}));
}

TEST(BuildVersion, SameContentHasTheSameId) {
  EXPECT_EQ(build_version(two_tets(), 1.0)->version->id(),
            build_version(two_tets(), 1.0)->version->id());
  EXPECT_NE(build_version(two_tets(), 1.0)->version->id(),
            build_version(two_tets(), 2.0)->version->id());
}

TEST(BuildVersion, TurnsATetListedTheWrongWayRound) {
  auto raw = two_tets();
  std::swap(raw.tets[1].v[2], raw.tets[1].v[3]);

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  EXPECT_GT(signed_volume(built->version->corners(1)), 0);
  EXPECT_THAT(built->warnings, Contains(HasSubstr("turned")));
}

TEST(BuildVersion, KeepsATetInvertedByItsVerticesAndWarns) {
  auto raw = two_tets();
  raw.positions[4] = {-1, -1, -1};  // beyond the first tet: the second folds back over it

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  EXPECT_LT(signed_volume(built->version->corners(1)), 0);
  EXPECT_THAT(built->warnings, Contains(HasSubstr("inverted")));
}

TEST(BuildVersion, WarnsOfFlatTets) {
  auto raw = two_tets();
  raw.positions[4] = {0.5, 0.5, 0};  // in the plane of 1-2-3

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  // In the middle of (.5, .5, 0) and the ends of the three unit vectors.
  EXPECT_THAT(built->warnings,
              Contains(HasSubstr("1 tet has zero volume (flat within rounding), the first at (375, "
                                 "375, 250) mm")));
}

TEST(BuildVersion, ATetThatIsFlatWithinRoundingIsNotCalledInverted) {
  auto raw = two_tets();
  raw.positions[4] = {0.5, 0.5, -1e-14};

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  EXPECT_THAT(built->warnings, Contains(HasSubstr("zero volume (flat within rounding)")));
  EXPECT_THAT(built->warnings, Not(Contains(HasSubstr("inverted"))));
}

TEST(BuildVersion, NamesADuplicateTet) {
  auto raw = two_tets();
  raw.tets.push_back(raw.tets[0]);
  raw.tet_regions.push_back(1);

  EXPECT_THAT(refusal(std::move(raw)).message, HasSubstr("tet 1 and tet 3 are the same tet twice"));
}

TEST(BuildVersion, NamesAFaceInThreeTets) {
  auto raw = two_tets();
  raw.positions.push_back({2, 2, 2});
  raw.tets.push_back({{5, 1, 3, 2}});
  raw.tet_regions.push_back(1);

  EXPECT_THAT(refusal(std::move(raw)).message, HasSubstr("face 2-3-4 belongs to 3 tets"));
}

TEST(BuildVersion, RefusesATriangleThatIsNoFace) {
  auto raw = two_tets();
  raw.triangles = {{{0, 1, 4}, 7, true}};

  EXPECT_THAT(refusal(std::move(raw)).message, HasSubstr("triangle 1-2-5 is no face of any tet"));
}

TEST(BuildVersion, RefusesATriangleOfTwoSurfaces) {
  auto raw = two_tets();
  raw.triangles = {{{0, 1, 2}, 7, true}, {{2, 1, 0}, 8, true}};

  EXPECT_THAT(refusal(std::move(raw)).message, HasSubstr("surface 7 and by surface 8"));
}

TEST(BuildVersion, RefusesIndicesOutOfRangeAndRepeatedCorners) {
  auto beyond = two_tets();
  beyond.tets[0].v[3] = 5;
  auto repeated = two_tets();
  repeated.tets[0].v[3] = 0;

  EXPECT_THAT(refusal(std::move(beyond)).message, HasSubstr("does not exist"));
  EXPECT_THAT(refusal(std::move(repeated)).message, HasSubstr("same node twice"));
}

TEST(BuildVersion, GivesSurfacesToABareBoundaryByItsSharpEdges) {
  const auto built = build_version(two_tets(), 1.0);

  ASSERT_TRUE(built.has_value());
  // All edges of this body are sharper than 30 degrees: six facets, six surfaces.
  EXPECT_EQ(built->version->surfaces().size(), 6u);
  EXPECT_THAT(built->warnings, Contains(HasSubstr("had no surface id")));
}

TEST(BuildVersion, KeepsTrianglesBetweenRegionsAsInterfaces) {
  auto raw = two_tets();
  raw.tet_regions = {1, 2};
  raw.triangles = {{{1, 2, 3}, 9, true}};

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  ASSERT_EQ(built->version->data().interfaces.size(), 1u);
  EXPECT_EQ(built->version->data().interfaces[0].surface, 9);
  EXPECT_NE(built->version->find_surface(9), nullptr);
}

TEST(BuildVersion, WarnsOfBodiesThatTouchInAVertex) {
  auto raw = two_tets();
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  raw.tets = {{{0, 1, 2, 3}}, {{0, 4, 5, 6}}};
  std::swap(raw.tets[1].v[2], raw.tets[1].v[3]);

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  EXPECT_THAT(built->warnings, Contains(HasSubstr("at 1 vertices")));
  EXPECT_THAT(built->warnings, Contains(HasSubstr("2 separate bodies")));
}

/// Two tets that lie against each other with nodes of their own, apart by rounding.
TEST(BuildVersion, WarnsOfNodesThatAreNotMergedWhereBodiesTouch) {
  auto raw = two_tets();
  for (const vertex_id v : {1, 2, 3})
    raw.positions.push_back(raw.positions[v] + vec3{1e-12, 0, -1e-12});
  raw.tets[1] = {{4, 5, 7, 6}};

  const auto apart = build_version(raw, 1.0);
  const auto joined = build_version(two_tets(), 1.0);

  ASSERT_TRUE(apart.has_value());
  EXPECT_THAT(apart->warnings, Contains(HasSubstr("6 nodes lie at the place of another node, from "
                                                  "(0, 0, 0) mm to (1000, 1000, 1000) mm")));
  ASSERT_TRUE(joined.has_value());
  EXPECT_THAT(joined->warnings, Not(Contains(HasSubstr("place of another"))));
}

TEST(BuildVersion, NodesThatAreNearButApartAreNoFault) {
  auto raw = two_tets();
  for (const vertex_id v : {1, 2, 3})
    raw.positions.push_back(raw.positions[v] + vec3{1e-5, 1e-5, 1e-5});
  raw.tets[1] = {{4, 5, 7, 6}};

  EXPECT_THAT(build_version(raw, 1.0)->warnings, Not(Contains(HasSubstr("place of another"))));
}

raw_mesh::triangle face(std::array<vertex_id, 3> v, surface_id surface) {
  return {v, surface, true};
}

TEST(BuildVersion, WarnsOfOneSurfaceIdForAWholeBoundaryWithEdges) {
  auto raw = two_tets();
  for (const auto& v :
       {std::array<vertex_id, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {4, 1, 2}, {4, 2, 3}, {4, 3, 1}})
    raw.triangles.push_back(face(v, 5));

  const auto one = build_version(raw, 1.0);
  raw.triangles.front().surface = 6;
  const auto two = build_version(raw, 1.0);

  ASSERT_TRUE(one.has_value()) << render(one.error());
  EXPECT_THAT(one->warnings, Contains(HasSubstr("all boundary faces have the surface id 5")));
  EXPECT_THAT(one->warnings, Contains(HasSubstr("6 patches")));
  ASSERT_TRUE(two.has_value());
  EXPECT_THAT(two->warnings, IsEmpty());
}

/// An octahedron whose triangles are cut into four, twice, on the sphere; a tet from the middle to
/// each.
raw_mesh ball() {
  raw_mesh raw;
  raw.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<vertex_id, 3>> faces;
  for (const vertex_id x : {0, 1})
    for (const vertex_id y : {2, 3})
      for (const vertex_id z : {4, 5})
        faces.push_back({x, y, z});
  std::map<std::pair<vertex_id, vertex_id>, vertex_id> middles;
  const auto middle = [&](vertex_id a, vertex_id b) {
    const auto [at, fresh] =
      middles.try_emplace(std::minmax(a, b), static_cast<vertex_id>(raw.positions.size()));
    if (fresh)
      raw.positions.push_back(normalized(raw.positions[a] + raw.positions[b]));
    return at->second;
  };
  for (int round = 0; round < 2; ++round) {
    std::vector<std::array<vertex_id, 3>> cut;
    for (const auto& [a, b, c] : faces) {
      const auto ab = middle(a, b);
      const auto bc = middle(b, c);
      const auto ca = middle(c, a);
      cut.insert(cut.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    faces = std::move(cut);
  }
  const auto centre = static_cast<vertex_id>(raw.positions.size());
  raw.positions.push_back({0, 0, 0});
  for (const auto& v : faces) {
    tet t{{centre, v[0], v[1], v[2]}};
    const auto& p = raw.positions;
    if (signed_volume(p[t.v[0]], p[t.v[1]], p[t.v[2]], p[t.v[3]]) < 0)
      std::swap(t.v[2], t.v[3]);
    raw.tets.push_back(t);
    raw.tet_regions.push_back(1);
    raw.triangles.push_back(face(v, 3));
  }
  return raw;
}

TEST(BuildVersion, ABallHasOneSurfaceAndNoWarning) {
  const auto built = build_version(ball(), 1.0);

  ASSERT_TRUE(built.has_value()) << render(built.error());
  EXPECT_EQ(built->version->surfaces().size(), 1u);
  EXPECT_THAT(built->warnings, IsEmpty());
}

TEST(BuildVersion, DropsVerticesWithoutTets) {
  auto raw = two_tets();
  raw.positions.insert(raw.positions.begin(), vec3{9, 9, 9});
  for (auto& t : raw.tets)
    for (auto& v : t.v)
      ++v;

  const auto built = build_version(std::move(raw), 1.0);

  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->version->vertex_count(), 5u);
  EXPECT_EQ(built->version->position(0), (vec3{0, 0, 0}));
}

TEST(Manifest, RoundTripsThroughBytes) {
  const auto version = build_version(two_tets(), 1.0)->version;

  const auto list = manifest::from_bytes(version->pages().to_bytes());

  ASSERT_TRUE(list.has_value());
  EXPECT_EQ(*list, version->pages());
}

TEST(Manifest, EveryTruncationIsRefused) {
  const auto bytes = build_version(two_tets(), 1.0)->version->pages().to_bytes();

  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(manifest::from_bytes(std::span(bytes).first(size)).has_value()) << size;
}

TEST(Manifest, RebuildsTheVersionFromPages) {
  const auto version = build_version(two_tets(), 1.0)->version;
  std::map<hash128, page_ptr> store;
  version->for_each_page([&](const page_ptr& p) { store[p->id()] = p; });

  const auto rebuilt =
    mesh_version::from_manifest(version->pages(), [&](const hash128& id) { return store.at(id); });
  const auto missing =
    mesh_version::from_manifest(version->pages(), [](const hash128&) { return page_ptr{}; });

  ASSERT_TRUE(rebuilt.has_value());
  EXPECT_EQ((*rebuilt)->id(), version->id());
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ec::not_found);
}

TEST(Quality, RegularTetHasRatioOneAndKnownEnergy) {
  const std::array<vec3, 4> p{{{1, 1, 1}, {1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}}};
  const double edge = std::sqrt(8.0);

  EXPECT_NEAR(radius_ratio(p), 1.0, 1e-14);
  EXPECT_NEAR(harmonic_energy(p), 9 / std::sqrt(2.0) * edge, 1e-12);
  for (const double angle : dihedral_angles(p))
    EXPECT_NEAR(angle, std::acos(1.0 / 3), 1e-14);
}

TEST(Quality, UnitCornerTetHasTheClosedFormRatio) {
  // r = 1 / (3 + sqrt 3), R = sqrt(3) / 2.
  const double expected = 3 * (1 / (3 + std::sqrt(3.0))) / (std::sqrt(3.0) / 2);

  EXPECT_NEAR(radius_ratio({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), expected, 1e-14);
}

TEST(Quality, RatioIsScaleFreeAndZeroWhenInverted) {
  const std::array<vec3, 4> p{{{0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0}, {0, 0, 1e-9}}};

  EXPECT_NEAR(radius_ratio(p), radius_ratio({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1e-14);
  EXPECT_EQ(radius_ratio(p[0], p[2], p[1], p[3]), 0);
}

}  // namespace
}  // namespace tedit
