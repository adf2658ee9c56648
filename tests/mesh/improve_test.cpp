// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/improve.hpp"

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "mesh/finish_edit.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

/// A box whose middle vertex (13 of 27) was dragged almost onto a neighbour.
version_ptr spoiled() {
  return test::box_mesh({2, 2, 2}, {1, 1, 1}, [](vec3 p) {
    return p == vec3{0.5, 0.5, 0.5} ? vec3{0.95, 0.52, 0.53} : p;
  });
}

TEST(Improve, LiftsTheWorstTetAndKeepsTheBoundary) {
  const auto mesh = spoiled();
  mesh_builder builder(mesh);

  const auto report = improve(builder, test::all_tets(*mesh), {}, {});
  const auto after = builder.freeze();

  ASSERT_TRUE(report.has_value());
  EXPECT_LT(report->min_before, 0.15);
  EXPECT_GT(report->min_after, 0.3);
  EXPECT_NEAR(report->min_after, radius_ratios(*after).min, 1e-12);
  EXPECT_TRUE(check_version(*after).ok());
  EXPECT_NEAR(total_volume(*after), 1, 1e-14);
  EXPECT_EQ(after->data().facets.pages().front()->bytes().size(),
            mesh->data().facets.pages().front()->bytes().size());
}

TEST(Improve, RepeatsItself) {
  const auto mesh = spoiled();
  mesh_builder first(mesh);
  mesh_builder second(mesh);

  (void)improve(first, test::all_tets(*mesh), {}, {});
  (void)improve(second, test::all_tets(*mesh), {}, {});

  EXPECT_EQ(first.freeze()->id(), second.freeze()->id());
}

TEST(Improve, LeavesInterfacesBetweenRegionsAlone) {
  raw_mesh raw;
  const auto mesh = spoiled();
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    raw.positions.push_back(mesh->position(v));
  for (tet_id t = 0; t < mesh->tet_slots(); ++t) {
    raw.tets.push_back(mesh->tet_at(t));
    // Every second tet another material: no face may be flipped.
    raw.tet_regions.push_back(static_cast<region_id>(t % 2));
  }
  const auto mixed = build_version(std::move(raw), 1)->version;
  mesh_builder builder(mixed);

  const auto report = improve(builder, test::all_tets(*mixed), {}, {});

  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->moves.relocations, 0u);
  EXPECT_EQ(builder.freeze()->tet_count(), mixed->tet_count());
}

TEST(Improve, CancelIsObeyed) {
  const auto mesh = spoiled();
  mesh_builder builder(mesh);
  execution run;
  run.cancel.cancel();

  const auto report = improve(builder, test::all_tets(*mesh), {}, run);

  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, ec::cancelled);
}

TEST(FinishEdit, AFacetOnWhichNoTetCanBeGoodIsNamedAtOnce) {
  const auto base = test::box_mesh({2, 2, 2}, {1, 1, 1});
  mesh_builder builder(base);
  for (vertex_id v = 0; v < base->vertex_slots(); ++v)
    if (base->position(v) == vec3{0.5, 0.5, 1})
      builder.set_position(v, {0.995, 0.5, 1});
  edit_claim claim;
  claim.touched = builder.touched();

  const auto finished = finish_edit(base, builder.freeze(), claim, improvement::local, {}, {});

  ASSERT_FALSE(finished.has_value());
  EXPECT_EQ(finished.error().code, ec::postcondition_failed);
  // Sides 0.005, 0.7071, 0.7036 and area 0.00125: r_in = 0.001766, R_circ = 0.4975; 3 r_in /
  // R_circ.
  EXPECT_NE(finished.error().message.find("surface 6 would get a facet"), std::string::npos);
  EXPECT_NE(finished.error().message.find("more than q = 0.0106"), std::string::npos)
    << finished.error().message;
}

TEST(FinishEdit, AFaultyCandidateGivesNoVersion) {
  const auto base = spoiled();
  mesh_builder builder(base);
  builder.set_position(13, {3, 3, 3});
  edit_claim claim;
  claim.touched = builder.touched();

  const auto finished = finish_edit(base, builder.freeze(), claim, improvement::none, {}, {});

  ASSERT_FALSE(finished.has_value());
  EXPECT_EQ(finished.error().code, ec::postcondition_failed);
}

}  // namespace
}  // namespace tedit
