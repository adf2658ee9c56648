// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/builder.hpp"
#include "mesh/changes.hpp"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "tests/support/local_moves.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

TEST(Builder, AnUnchangedBuilderFreezesToTheSameId) {
  const auto mesh = test::box_mesh({3, 3, 3}, {1, 1, 1});

  EXPECT_EQ(mesh_builder(mesh).freeze()->id(), mesh->id());
}

TEST(Builder, RemovingACornerTetBaresItsInnerFaces) {
  const auto mesh = test::box_mesh({1, 1, 1}, {1, 1, 1});
  mesh_builder builder(mesh);
  cavity_change change;
  change.removed = {0};
  for (int face = 0; face < 4; ++face)
    if (!is_facet(mesh->neighbours(0)[face])) {
      const auto& order = tet_faces[face];
      const auto& v = mesh->tet_at(0).v;
      change.facets.push_back({{v[order[0]], v[order[1]], v[order[2]]}, 9});
    }

  ASSERT_TRUE(builder.apply(change).has_value());
  const auto after = builder.freeze();

  EXPECT_EQ(after->tet_count(), 5u);
  EXPECT_EQ(after->facet_count(), 12u);
  EXPECT_NEAR(total_volume(*after), 5.0 / 6, 1e-15);
}

TEST(Builder, ARefusedChangeLeavesEverythingAsItWas) {
  const auto mesh = test::box_mesh({2, 2, 2}, {1, 1, 1});
  mesh_builder builder(mesh);
  cavity_change bare;
  bare.removed = {0};  // its inner faces would be boundary without a surface
  cavity_change twice;
  twice.added = {{mesh->tet_at(3), 1}};  // lies on top of tet 3
  cavity_change nowhere;
  nowhere.removed = {100000};

  for (const auto& change : {bare, twice, nowhere}) {
    const auto applied = builder.apply(change);
    ASSERT_FALSE(applied.has_value());
    EXPECT_EQ(applied.error().code, ec::invalid_mesh);
  }

  EXPECT_EQ(builder.freeze()->id(), mesh->id());
}

TEST(Builder, SlotsAreReused) {
  const auto mesh = test::box_mesh({2, 2, 2}, {1, 1, 1});
  mesh_builder builder(mesh);
  cavity_change swap_same;
  swap_same.removed = {5};
  swap_same.added = {{mesh->tet_at(5), mesh->region_of(5)}};

  const auto ids = builder.apply(swap_same);

  ASSERT_TRUE(ids.has_value());
  EXPECT_EQ(ids->front(), 5u);
  EXPECT_EQ(builder.freeze()->id(), mesh->id());
}

TEST(Builder, AVertexThatNoTetUsesIsFreed) {
  const auto mesh = test::box_mesh({2, 2, 2}, {1, 1, 1});
  mesh_builder builder(mesh);

  (void)builder.add_vertex({0.5, 0.5, 0.5});
  const auto after = builder.freeze();

  EXPECT_EQ(after->vertex_count(), mesh->vertex_count());
  EXPECT_TRUE(check_version(*after).ok());
}

TEST(Builder, ALocalChangeTouchesFewPages) {
  const auto mesh = test::box_mesh({24, 24, 24}, {1, 1, 1});
  mesh_builder builder(mesh);

  builder.set_position(8000, mesh->position(8000) + vec3{1e-4, 0, 0});
  const auto after = builder.freeze();

  const auto dirty = [&](auto... arrays) {
    return std::vector{dirty_pages(mesh->data().*arrays, after->data().*arrays).size()...};
  };
  EXPECT_THAT(
    dirty(&mesh_data::positions, &mesh_data::vertex_tet, &mesh_data::tets, &mesh_data::tet_regions,
          &mesh_data::neighbours, &mesh_data::facets, &mesh_data::interfaces),
    testing::ElementsAre(1, 0, 0, 0, 0, 0, 0));
}

/// Random flips, removals of edges, insertions and moves keep every invariant, the volume and the
/// boundary.
TEST(BuilderProperty, RandomLocalMovesKeepAllInvariants) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const auto shake = [&](vec3 p) {
      const auto inner = [](double x) { return x > 1e-9 && x < 1 - 1e-9; };
      if (!inner(p.x) || !inner(p.y) || !inner(p.z))
        return p;
      std::uniform_real_distribution<double> d(-0.09, 0.09);
      return p + vec3{d(random), d(random), d(random)};
    };
    const auto mesh = test::box_mesh({4, 4, 4}, {1, 1, 1}, shake);
    mesh_builder builder(mesh);
    const auto tets = test::all_tets(*mesh);
    local_moves moves(builder, {tets.begin(), tets.end()});
    int done = 0;
    for (int i = 0; i < 300; ++i) {
      const auto t = random() % builder.tet_slots();
      if (!builder.is_live_tet(t))
        continue;
      const auto kind = random() % 3;
      done += kind == 0   ? moves.flip(t)
              : kind == 1 ? moves.relocate_corner(t)
                          : moves.insert_vertex(t);
    }
    EXPECT_GT(done, 20);

    const auto after = builder.freeze();

    const auto report = check_version(*after);
    EXPECT_TRUE(report.ok()) << to_error(report).message;
    EXPECT_NEAR(total_volume(*after), 1, 1e-12);
    EXPECT_EQ(after->facet_count(), mesh->facet_count());
    EXPECT_EQ(after->surfaces(), mesh->surfaces());
    EXPECT_GE(radius_ratios(*after).min, radius_ratios(*mesh).min * 0.999);
  }
}

}  // namespace
}  // namespace tedit
