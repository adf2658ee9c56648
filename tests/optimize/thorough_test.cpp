// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "base/parallel.hpp"
#include "mesh/checks.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "mesh/optimize/harmonic.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/optimize/star_energy.hpp"
#include "mesh/optimize/worst_first.hpp"
#include "mesh/surface_map.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

improve_settings thorough(double relative_tolerance = 0) {
  improve_settings settings;
  settings.thorough.emplace();
  settings.thorough->tolerance.relative = relative_tolerance;
  return settings;
}

struct outcome {
  improve_report report;
  version_ptr mesh;
};

outcome improved(const version_ptr& mesh, const improve_settings& settings) {
  mesh_builder builder(mesh);
  const auto report = improve(builder, test::all_tets(*mesh), settings, {});
  if (!report)
    throw std::runtime_error(render(report.error()));
  return {*report, builder.freeze()};
}

/// The facets by their corners: what a kept boundary is.
std::map<std::array<vertex_id, 3>, surface_id> boundary(const mesh_version& mesh) {
  std::map<std::array<vertex_id, 3>, surface_id> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f)) {
      auto v = mesh.facet(f).v;
      std::ranges::rotate(v, std::ranges::min_element(v));
      result[v] = mesh.facet(f).surface;
    }
  return result;
}

std::map<surface_id, double> areas(const mesh_version& mesh) {
  std::map<surface_id, double> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      result[mesh.facet(f).surface] += norm(area_vector(mesh, mesh.facet(f)));
  return result;
}

/// Six vertices on the boundary, five tets: a flat one between a square's two diagonals, 2 mm apart
/// on 2 m, with an apex above and one below.
version_ptr flat_tet() {
  raw_mesh raw;
  raw.positions = {{1, 0, 0.001},   {0, 1, -0.001}, {-1, 0, 0.001},
                   {0, -1, -0.001}, {0, 0, 1},      {0, 0, -1}};
  raw.tets = {{{0, 2, 1, 3}}, {{0, 1, 2, 4}}, {{0, 2, 3, 4}}, {{0, 1, 3, 5}}, {{1, 2, 3, 5}}};
  for (auto& t : raw.tets) {
    const auto& p = raw.positions;
    if (signed_volume(p[t.v[0]], p[t.v[1]], p[t.v[2]], p[t.v[3]]) < 0)
      std::swap(t.v[2], t.v[3]);
    raw.tet_regions.push_back(1);
  }
  return build_version(std::move(raw), 1)->version;
}

TEST(WorstFirst, AVertexOnAnInteriorEdgeMendsAFlatTetOfFourBoundaryVertices) {
  const auto mesh = flat_tet();
  ASSERT_LT(radius_ratios(*mesh).min, 0.01);
  mesh_builder builder(mesh);
  work_mesh work(builder, test::all_tets(*mesh));
  move_counts counts;
  const surface_guard guard(work, {});

  const bool changed = worst_first(work, guard, 0.35, counts).insert(0);
  ASSERT_TRUE(work.write(builder).has_value());
  const auto after = builder.freeze();

  EXPECT_TRUE(changed);
  EXPECT_EQ(counts.insertions, 1u);
  EXPECT_EQ(after->vertex_count(), 7u);
  EXPECT_GT(radius_ratios(*after).min, 0.15);
  EXPECT_TRUE(check_version(*after).ok());
  EXPECT_EQ(boundary(*after), boundary(*mesh));
}

/// A regular tet cut into four at its middle: no flip fits and no other place is better.
version_ptr regular_in_four() {
  raw_mesh raw;
  raw.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  raw.tets = {{{0, 2, 1, 3}}};
  raw.tet_regions = {1};
  const auto regular = build_version(std::move(raw), 1)->version;
  return test::split(regular, [](tet_id) { return true; });
}

TEST(WorstFirst, AVertexTooManyGoesAndThatIsSaid) {
  const auto mesh = regular_in_four();
  mesh_builder builder(mesh);
  work_mesh work(builder, test::all_tets(*mesh));
  move_counts counts;
  const surface_guard guard(work, {});
  worst_first moves(work, guard, 0.9, counts);

  EXPECT_TRUE(moves.mend(0));

  EXPECT_EQ(counts.collapses, 1u);
  EXPECT_EQ(counts.all(), 1u);
  const auto left = std::ranges::count_if(std::views::iota(0u, work.tet_slots()),
                                          [&](auto t) { return work.is_live(t); });
  EXPECT_EQ(left, 1);
}

TEST(Harmonic, AVertexThatMovedIsCountedAndOneThatIsInItsPlaceIsNot) {
  const auto mesh = test::box_mesh({2, 2, 2}, {2, 2, 2}, [](vec3 p) {
    return p == vec3{1, 1, 1} ? vec3{1.2, 0.9, 1.3} : p;
  });
  mesh_builder builder(mesh);
  work_mesh work(builder, test::all_tets(*mesh));
  move_counts counts;

  const double before = relocate_to_harmonic(work, 0.1, counts);
  EXPECT_EQ(counts.harmonic_relocations, 1u) << "one vertex lies inside";
  double after = before;
  for (int sweep = 0; sweep < 4; ++sweep)
    after = relocate_to_harmonic(work, 0.1, counts);
  const auto moves = counts.harmonic_relocations;
  EXPECT_EQ(relocate_to_harmonic(work, 0.1, counts), after);

  EXPECT_EQ(counts.harmonic_relocations, moves) << "it lies in the middle";
  EXPECT_EQ(counts.all(), moves);
  ASSERT_TRUE(work.write(builder).has_value());
  EXPECT_LT(norm(builder.position(13) - vec3{1, 1, 1}), 1e-3);
  // 48 tets of right-angled legs 1, 1, 1.
  const double one = harmonic_energy({vec3{}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}});
  EXPECT_GT(before, 48 * one);
  EXPECT_NEAR(after, 48 * one, 1e-4 * 48 * one);
}

TEST(Harmonic, AVertexThatCouldOnlySpoilTheWorstTetStaysAndIsNotCounted) {
  // A corner is pulled out: where the worst tet is best, the sum of eta is not least.
  const auto at = [](vec3 middle) {
    return test::box_mesh({2, 2, 2}, {2, 2, 2}, [=](vec3 p) {
      return p == vec3{2, 2, 2} ? vec3{3, 3, 3} : p == vec3{1, 1, 1} ? middle : p;
    });
  };
  const auto first = at({1, 1, 1});
  vertex_star star;
  for (tet_id t = 0; t < first->tet_slots(); ++t)
    for (int i = 0; i < 4; ++i)
      if (first->tet_at(t).v[i] == 13)
        star.add(first->corners(t), i);
  const vec3 best = best_place(star, {1, 1, 1}, 0.5);
  ASSERT_GT(norm(star_minimum(star, best, 20) - best), 0.01);
  const auto mesh = at(best);
  mesh_builder builder(mesh);
  work_mesh work(builder, test::all_tets(*mesh));
  move_counts counts;

  relocate_to_harmonic(work, 1, counts);

  EXPECT_EQ(counts.all(), 0u);
  ASSERT_TRUE(work.write(builder).has_value());
  EXPECT_EQ(builder.position(13), best);
}

TEST(WorstFirst, AVertexTooManyGoes) {
  const auto mesh = regular_in_four();
  ASSERT_EQ(mesh->tet_count(), 4u);
  auto settings = thorough();
  settings.thorough->target = 0.9;
  settings.thorough->harmonic = false;

  const auto [report, after] = improved(mesh, settings);

  EXPECT_EQ(report.moves.collapses, 1u);
  EXPECT_EQ(after->tet_count(), 1u);
  EXPECT_EQ(after->vertex_count(), 4u);
  EXPECT_NEAR(report.min_after, 1, 1e-12);
  EXPECT_TRUE(check_version(*after).ok());
}

TEST(Thorough, WithToleranceZeroTheBoundaryIsTheSame) {
  const auto mesh = test::box_mesh({4, 3, 3}, {4, 3, 3}, [](vec3 p) {
    const bool inner = p.x > 0 && p.x < 4 && p.y > 0 && p.y < 3 && p.z > 0 && p.z < 3;
    return inner ? p + vec3{0.4 * std::sin(9 * p.y), 0.4 * std::sin(7 * p.z), 0.3} : p;
  });

  const auto [report, after] = improved(mesh, thorough());

  EXPECT_GT(report.min_after, report.min_before);
  EXPECT_EQ(boundary(*after), boundary(*mesh));
  EXPECT_EQ(report.surface_deviation, 0);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    if (mesh_builder(mesh).is_boundary_vertex(v)) {
      EXPECT_EQ(after->position(v), mesh->position(v));
    }
}

TEST(Thorough, ANeedleOnAFlatSurfaceGoesWithinTheTolerance) {
  // A vertex on the top is dragged to a hundredth of its neighbour on the edge.
  const auto mesh = test::box_mesh({3, 3, 2}, {3, 3, 2}, [](vec3 p) {
    return p == vec3{1, 1, 2} ? vec3{1, 0.01, 2} : p;
  });

  const auto kept = improved(mesh, thorough());
  const auto moved = improved(mesh, thorough(1e-3));

  EXPECT_LT(kept.report.min_after, 0.1);
  EXPECT_GT(moved.report.min_after, 0.2);
  EXPECT_LT(moved.report.surface_deviation, 1e-12);
  EXPECT_NEAR(total_volume(*moved.mesh), 18, 1e-11);
  EXPECT_TRUE(check_version(*moved.mesh).ok());
  for (const auto& [id, area] : areas(*moved.mesh))
    EXPECT_NEAR(area, areas(*mesh)[id], 1e-11);
}

TEST(Thorough, ASurfaceThinnerThanTheToleranceKeepsAFacetAndTheVolumeIsAccountedFor) {
  // A chamfer a tenth of a millimetre wide along a bar of 1 m.
  const auto mesh = test::box_mesh({6, 2, 2}, {6, 2, 2}, [](vec3 p) {
    return p.y == 1 && p.z == 2 ? vec3{p.x, 1.9999, 2.0001} : p;
  });
  edit_claim claim;
  claim.touched = test::all_tets(*mesh);
  improve_request wanted(improvement::thorough);
  wanted.thorough.tolerance.absolute = 1e-3;

  const auto done = finish_edit(mesh, mesh, claim, wanted, {}, {});

  ASSERT_TRUE(done.has_value()) << render(done.error());
  EXPECT_EQ(done->version->surfaces().size(), mesh->surfaces().size());
  EXPECT_LE(done->improvement.surface_deviation, 1e-3 + 1e-12);
  EXPECT_NEAR(total_volume(*done->version) - total_volume(*mesh), done->volume_change, 1e-12);
}

TEST(Thorough, IsTheSameOnAnyNumberOfThreads) {
  const auto mesh = test::box_mesh({9, 8, 8}, {9, 8, 8}, [](vec3 p) {
    const bool inner = p.x > 0 && p.x < 9 && p.y > 0 && p.y < 8 && p.z > 0 && p.z < 8;
    return inner ? p + 0.35 * vec3{std::sin(5 * p.y), std::sin(3 * p.z), std::cos(4 * p.x)} : p;
  });
  hash128 alone;

  // Inside a chunk of a parallel loop, inner loops run on one thread.
  parallel_for(
    2,
    [&](std::size_t first, std::size_t, std::size_t) {
      if (first == 0)
        alone = improved(mesh, thorough()).mesh->id();
    },
    1);

  EXPECT_EQ(improved(mesh, thorough()).mesh->id(), alone);
}

TEST(Thorough, ACancelAtAnyPollLeavesTheBuilderAlone) {
  const auto mesh = test::box_mesh({2, 2, 2}, {1, 1, 1}, [](vec3 p) {
    return p == vec3{0.5, 0.5, 0.5} ? vec3{0.95, 0.52, 0.53} : p;
  });
  mesh_builder builder(mesh);
  execution count;
  ASSERT_TRUE(improve(builder, test::all_tets(*mesh), thorough(1e-3), count).has_value());

  for (std::uint64_t poll = 1; poll <= count.cancel.polls(); ++poll) {
    mesh_builder stopped(mesh);
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto report = improve(stopped, test::all_tets(*mesh), thorough(1e-3), run);
    ASSERT_FALSE(report.has_value()) << "poll " << poll;
    EXPECT_EQ(report.error().code, ec::cancelled);
    EXPECT_EQ(stopped.freeze()->id(), mesh->id());
  }
}

TEST(Thorough, SettingsThatAreNoNumbersAreRefused) {
  thorough_settings settings;
  settings.tolerance.absolute = std::nan("");

  EXPECT_FALSE(validate(settings).has_value());
  EXPECT_TRUE(validate({}).has_value());
}

// -- any mesh ------------------------------------------------------------------------------------

/// A box whose inner vertices lie anywhere that keeps every tet positive.
version_ptr random_mesh() {
  const auto cells = [] { return *rc::gen::inRange(1, 4); };
  const std::array<int, 3> n{cells(), cells(), cells()};
  const auto mesh = test::box_mesh(n, {1.0 * n[0], 1.0 * n[1], 1.0 * n[2]});
  mesh_builder builder(mesh);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v) {
    if (builder.is_boundary_vertex(v))
      continue;
    const auto shift = [] { return *rc::gen::inRange(-900, 900) / 1000.0; };
    const vec3 from = builder.position(v);
    builder.set_position(v, from + vec3{shift(), shift(), shift()});
    for (const auto t : builder.star(v))
      if (!(signed_volume(builder.corners(t)) > 1e-9)) {
        builder.set_position(v, from);
        break;
      }
  }
  return builder.freeze();
}

/// A mesh whose worst tet (.3705) is above the target (.35): the target is no leave to fall to it.
TEST(Thorough, AMinimumAboveTheTargetStays) {
  const auto box = test::box_mesh({2, 2, 2}, {2, 2, 2});
  mesh_builder builder(box);
  for (vertex_id v = 0; v < box->vertex_slots(); ++v)
    if (!builder.is_boundary_vertex(v))
      builder.set_position(v, builder.position(v) + vec3{-0.656, -0.142, -0.265});
  const auto mesh = builder.freeze();
  ASSERT_GT(radius_ratios(*mesh).min, 0.37);

  const auto after = improved(mesh, thorough(0.05)).mesh;

  EXPECT_GE(radius_ratios(*after).min, radius_ratios(*mesh).min * (1 - 1e-12));
}

RC_GTEST_PROP(ThoroughProperty, NoMinimumFallsAndNothingIsLost, ()) {
  const auto mesh = random_mesh();
  const double tolerance = *rc::gen::element(0.0, 1e-3, 0.05);
  const auto settings = thorough(tolerance);

  const auto [report, after] = improved(mesh, settings);
  const auto again = improved(mesh, settings);

  RC_ASSERT(radius_ratios(*after).min >= radius_ratios(*mesh).min * (1 - 1e-12));
  RC_ASSERT(check_version(*after).ok());
  RC_ASSERT(after->id() == again.mesh->id());
  RC_ASSERT(std::abs(total_volume(*after) / total_volume(*mesh) - 1) < 1e-12);
  if (tolerance == 0)
    RC_ASSERT(boundary(*after) == boundary(*mesh));
  const auto before = areas(*mesh);
  for (const auto& [id, area] : areas(*after))
    RC_ASSERT(std::abs(area / before.at(id) - 1) < 1e-12);
  RC_ASSERT(areas(*after).size() == before.size());
}

class ThoroughOnParts : public ::testing::TestWithParam<const char*> {};

TEST_P(ThoroughOnParts, TheRegionAroundASurfaceGetsBetterAndPassesTheChecks) {
  const std::string name = GetParam();
  const auto imported = import_mesh(
    std::filesystem::path(TEDIT_TEST_DATA) / "parts" / name / (name + ".coarse.msh"), "mm");
  ASSERT_TRUE(imported.has_value());
  const auto mesh = imported->version;
  for (const double tolerance : {0.0, 1e-3}) {
    const auto surface = mesh->surfaces()[mesh->surfaces().size() / 2].id;
    std::vector<vertex_id> corners;
    for (const auto f : facets_of(*mesh, {&surface, 1}))
      corners.insert(corners.end(), mesh->facet(f).v.begin(), mesh->facet(f).v.end());
    edit_claim claim;
    claim.touched = tets_around(*mesh, corners);
    improve_request wanted(improvement::thorough);
    wanted.thorough.tolerance.relative = tolerance;

    const auto done = finish_edit(mesh, mesh, claim, wanted, {}, {});

    ASSERT_TRUE(done.has_value()) << render(done.error());
    EXPECT_GE(done->improvement.min_after, done->improvement.min_before * (1 - 1e-12));
    const auto& before = *done->improvement.before;
    const auto& after = *done->improvement.after;
    EXPECT_GE(after.ratio_1pct, before.ratio_1pct);
    // Vertices that mend the worst tets have tets of their own, which may lie below the mean.
    if (after.tets <= before.tets) {
      EXPECT_GE(after.mean_ratio, before.mean_ratio);
    }
    EXPECT_LE(check_version(*done->version).total, check_version(*mesh).total);
    EXPECT_EQ(done->version->surfaces().size(), mesh->surfaces().size());
    if (tolerance == 0) {
      EXPECT_EQ(boundary(*done->version), boundary(*mesh));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Open, ThoroughOnParts,
                         ::testing::Values("as1_assembly", "base_so101", "bracket_4040",
                                           "ctc01_plate", "foot_cup", "fork_thin", "heatsink_125",
                                           "holes_block", "inch_block"));

}  // namespace
}  // namespace tedit
