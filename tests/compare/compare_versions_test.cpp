// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/compare_versions.hpp"

#include <gtest/gtest.h>

#include "compare/boundary_deviation.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/renumbered.hpp"

namespace tedit {
namespace {

version_ptr box_of_64() {
  return test::box_mesh({4, 4, 4}, {1, 1, 1});
}

version_comparison compare(const version_side& before, const version_side& after) {
  return *compare_versions(before, after, *match_versions(before.mesh, after.mesh, {}), {});
}

version_comparison compare(const version_ptr& before, const version_ptr& after) {
  return compare(version_side{*before}, version_side{*after});
}

const compared_surface& row_of(const version_comparison& all, surface_id id) {
  return *std::ranges::find(all.surfaces, id, &compared_surface::id);
}

fem::load_case steel(std::string name, double density) {
  return {std::move(name), {{"steel", 2.1e11, .3, density}}};
}

TEST(CompareVersions, EqualVersionsDifferInNothing) {
  const auto all = compare(box_of_64(), box_of_64());

  EXPECT_EQ(all.before_id, all.after_id);
  EXPECT_EQ(all.tets_in_common, 384u);
  EXPECT_EQ(all.before, all.after);
  EXPECT_EQ(all.deviation.distance_m, 0);
  EXPECT_EQ(all.surfaces.size(), 6u);
  for (const auto& one : all.surfaces)
    EXPECT_FALSE(one.changed) << one.id;
}

TEST(CompareVersions, ACornerThatWasTakenAwayIsSaidInFigures) {
  const auto before = box_of_64();
  const auto after = test::dig(
    before, [](vec3 p) { return p.x < .25 && p.y < .25 && p.z < .25; }, 1);

  const auto all = compare(before, after);

  EXPECT_NEAR(all.before.volume_m3, 1, 1e-14);
  EXPECT_NEAR(all.after.volume_m3, 1 - 1.0 / 64, 1e-14);
  EXPECT_EQ(all.before.tets, 384u);
  EXPECT_EQ(all.after.tets, 378u);
  EXPECT_EQ(all.tets_in_common, 378u);
  EXPECT_EQ(all.vertices_in_common, 124u);
  EXPECT_NEAR(all.deviation.distance_m, .25, 1e-15);
  for (const surface_id id : {1, 3, 5})
    EXPECT_TRUE(row_of(all, id).changed) << id;
  for (const surface_id id : {2, 4, 6})
    EXPECT_FALSE(row_of(all, id).changed) << id;
  EXPECT_NEAR(row_of(all, 3).area_before_m2, 1, 1e-14);
  EXPECT_NEAR(row_of(all, 3).area_after_m2, 15.0 / 16, 1e-14);
  EXPECT_NEAR(row_of(all, 1).area_after_m2, 15.0 / 16 + 3.0 / 16, 1e-14);
}

TEST(CompareVersions, ASurfaceThatMergedNamesWhereItWent) {
  const auto before = box_of_64();
  mesh_builder builder(before);
  const std::vector<surface_id> list{2};
  for (const auto f : facets_of(*before, list))
    builder.set_surface(f, 4);

  const auto all = compare(before, builder.freeze());

  EXPECT_EQ(row_of(all, 2).where, presence::only_before);
  EXPECT_EQ(row_of(all, 2).kin, 4);
  EXPECT_TRUE(row_of(all, 4).changed);
  EXPECT_NEAR(row_of(all, 4).area_after_m2, 2, 1e-14);
  EXPECT_EQ(all.deviation.distance_m, 0);
}

TEST(CompareVersions, ASurfaceThatWasSplitNamesWhereItCameFromAlsoWithOtherNumbers) {
  const auto before = box_of_64();
  mesh_builder builder(before);
  const auto fresh = builder.add_surface("part");
  const std::vector<surface_id> list{6};
  builder.set_surface(facets_of(*before, list).front(), fresh);

  const auto all = compare(before, test::renumbered(*builder.freeze()));

  EXPECT_EQ(row_of(all, fresh).where, presence::only_after);
  EXPECT_EQ(row_of(all, fresh).kin, 6);
  EXPECT_FALSE(row_of(all, 1).changed);
  EXPECT_EQ(all.tets_in_common, 384u);
}

TEST(CompareVersions, VersionsThatDoNotStemFromEachOtherAreCompared) {
  const auto before = test::box_mesh({3, 3, 3}, {1, 1, 1});
  const auto after = test::box_mesh({2, 2, 2}, {1, 1, 1.5});

  const auto all = compare(before, after);

  EXPECT_EQ(all.tets_in_common, 0u);
  EXPECT_EQ(all.vertices_in_common, 4u);  // The corners at z = 0.
  EXPECT_NEAR(all.deviation.distance_m, .5, 1e-14);
  EXPECT_EQ(all.deviation.of, presence::only_after);
  EXPECT_NEAR(row_of(all, 1).area_after_m2, 1.5, 1e-14);
}

TEST(CompareVersions, MassIsByTheVersionsOwnMaterials) {
  const std::vector<fem::load_case> was{steel("pull", 1000), steel("gone", 0)};
  const std::vector<fem::load_case> is{steel("new", 3000), steel("pull", 2000)};
  const auto mesh = box_of_64();

  const auto all = compare(version_side{*mesh, was}, version_side{*mesh, is});

  ASSERT_EQ(all.load_cases.size(), 3u);
  EXPECT_EQ(all.load_cases[0].name, "new");
  EXPECT_EQ(all.load_cases[0].where, presence::only_after);
  EXPECT_FALSE(all.load_cases[0].mass_before_kg);
  EXPECT_NEAR(*all.load_cases[0].mass_after_kg, 3000, 1e-9);
  EXPECT_NEAR(*all.load_cases[1].mass_before_kg, 1000, 1e-9);
  EXPECT_NEAR(*all.load_cases[1].mass_after_kg, 2000, 1e-9);
  EXPECT_EQ(all.load_cases[1].differences,
            std::vector<std::string>{"materials[steel].density_kg_m3: 1000 -> 2000"});
  EXPECT_EQ(all.load_cases[2].where, presence::only_before);
  EXPECT_FALSE(all.load_cases[2].mass_before_kg);  // A density of 0 is none.
}

}  // namespace
}  // namespace tedit
