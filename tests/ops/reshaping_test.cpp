// SPDX-License-Identifier: AGPL-3.0-or-later
// deform, refine and coarsen on random walls of the real parts: what holds for each of them.
#include <cmath>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/adapt/wall_places.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "ops/coarsen/coarsen.hpp"
#include "ops/deform/deform.hpp"
#include "ops/refine/refine.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/parts.hpp"

namespace tedit::ops {
namespace {

constexpr int walls_of_each = 2;
/// m: corners of flat walls are so far off their planes, and shapes that are fitted to walls that
/// touch so far apart.
constexpr double rounding_of_files = 1e-6;
/// Of an area: a bore of six sides, or its bottom, gains 21 % on its way to a round one.
constexpr double rounder = 0.21;

class Reshaping : public ::testing::TestWithParam<const char*> {
protected:
  void SetUp() override {
    const auto file = test::parts_folder / GetParam() / (std::string(GetParam()) + ".coarse.msh");
    auto imported = import_mesh(file, "mm");
    ASSERT_TRUE(imported.has_value());
    mesh_ = imported->version;
    // The same walls on each run, others of each part.
    std::mt19937_64 random(11 + std::string_view(GetParam()).size());
    const auto& table = mesh_->surfaces();
    while (walls_.size() < walls_of_each) {
      const auto id = table[random() % table.size()].id;
      if (surface_sizes(*mesh_).contains(id) && !std::ranges::count(walls_, id))
        walls_.push_back(id);
    }
  }

  /// What the host makes of a candidate; it must take it.
  static version_ptr finish(const version_ptr& base, const edit_result& result) {
    edit_claim claim;
    claim.touched = result.touched;
    claim.volume_change = result.volume_change;
    claim.quality_floor = result.quality_floor;
    auto done = finish_edit(base, result.candidate, claim, result.improve, {}, {});
    EXPECT_TRUE(done) << render(done.error());
    if (!done)
      return nullptr;
    EXPECT_LE(check_version(*done->version).total, check_version(*base).total);
    return done->version;
  }

  static double mean_edge(const mesh_version& mesh, surface_id wall) {
    return mean_size(mesh, {{wall}, {}, 0});
  }

  static void expect_same_walls(const mesh_version& before, const mesh_version& after,
                                double share) {
    EXPECT_EQ(before.surfaces(), after.surfaces());
    EXPECT_EQ(before.regions(), after.regions());
    const auto now = surface_areas(after);
    for (const auto& [id, area] : surface_areas(before)) {
      ASSERT_TRUE(now.contains(id)) << "surface " << id;
      EXPECT_NEAR(now.at(id), area, share * area) << "surface " << id;
    }
  }

  std::unique_ptr<services> host_ = make_host_services();
  context ctx_{{}, host_.get(), [](std::string_view) {}, 0};
  version_ptr mesh_;
  std::vector<surface_id> walls_;
};

TEST_P(Reshaping, RefiningKeepsThePartAndCoarseningBringsTheTetsBack) {
  for (const auto wall : walls_) {
    SCOPED_TRACE("surface " + std::to_string(wall));
    const mesh_pick pick{{wall}, {}, 0};
    const double size = mean_edge(*mesh_, wall);
    const auto fine = refine(mesh_, pick, 0.6 * size, ctx_);
    ASSERT_TRUE(fine) << render(fine.error());
    const auto finer = finish(mesh_, *fine);
    ASSERT_TRUE(finer);
    expect_same_walls(*mesh_, *finer, rounder);
    EXPECT_NEAR(fine->volume_change, 0, 2e-3 * total_volume(*mesh_));

    const auto back = coarsen(finer, pick, {.size = 1.5 * size, .tolerance = 0.05 * size}, ctx_);
    ASSERT_TRUE(back) << render(back.error());
    const auto coarser = finish(finer, *back);
    ASSERT_TRUE(coarser);
    expect_same_walls(*finer, *coarser, rounder);
    const auto count = [](const version_ptr& of) { return static_cast<double>(of->tet_count()); };
    EXPECT_LT(count(coarser), 0.5 * (count(mesh_) + count(finer)));
    EXPECT_GT(count(coarser), 0.9 * count(mesh_));
  }
}

TEST_P(Reshaping, NewVerticesLieOnTheWallsBehindTheirFacets) {
  wall_places walls(*mesh_);
  const auto fine = refine(mesh_, {walls_, {}, 0}, 0, ctx_);
  ASSERT_TRUE(fine) << render(fine.error());
  const auto& after = *fine->candidate;
  // Those that could not go there are told with their number.
  const std::size_t told = fine->notices.empty() ? 0 : std::stoul(fine->notices.front());
  std::set<vertex_id> off;
  for (facet_id f = 0; f < after.facet_slots(); ++f)
    if (after.is_live_facet(f))
      for (const auto v : after.facet(f).v)
        if (v >= mesh_->vertex_slots() &&
            walls.off(after.facet(f).surface, after.position(v)) > rounding_of_files)
          off.insert(v);
  EXPECT_LE(off.size(), told);
  EXPECT_GT(after.vertex_slots(), mesh_->vertex_slots());
}

TEST_P(Reshaping, DeformingKeepsTheMeshAndWhatIsBeyondTheReach) {
  for (const auto wall : walls_) {
    SCOPED_TRACE("surface " + std::to_string(wall));
    const double size = mean_edge(*mesh_, wall);
    deform_settings settings;
    settings.by = 0.05 * size * normalized(vec3{0.3, -0.5, 0.8});
    settings.reach = 4 * size;
    const auto made = deform(mesh_, {wall}, settings, ctx_);
    if (!made) {
      // Parts come with tets that are too flat to be moved.
      EXPECT_EQ(made.error().code, ec::inverted_tet) << render(made.error());
      EXPECT_FALSE(made.error().remedy.empty());
      continue;
    }
    const auto after = finish(mesh_, *made);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->tet_count(), mesh_->tet_count());
    EXPECT_EQ(after->data().tets.to_vector(), mesh_->data().tets.to_vector());
    expect_same_walls(*mesh_, *after, 0.2);
    const pick_distance off(*mesh_, {{wall}, {}, 0});
    for (vertex_id v = 0; v < mesh_->vertex_slots(); ++v) {
      if (!mesh_->is_live_vertex(v))
        continue;
      const vec3 step = after->position(v) - mesh_->position(v);
      const double distance = off(mesh_->position(v), 5 * size);
      if (distance >= settings.reach) {
        EXPECT_EQ(step, vec3{});
      } else {
        EXPECT_LE(norm(step), 1.5 * norm(*settings.by));  // The field may overshoot.
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, Reshaping,
                         ::testing::Values("as1_assembly", "base_so101", "bracket_4040",
                                           "ctc01_plate", "foot_cup", "fork_thin", "heatsink_125",
                                           "holes_block", "inch_block"),
                         [](const auto& part) { return std::string(part.param); });

}  // namespace
}  // namespace tedit::ops
