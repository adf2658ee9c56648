// SPDX-License-Identifier: AGPL-3.0-or-later
// What the start page and the README tell of the shipped parts, carried out: a surface is clicked,
// what belongs to it is picked as the window does, the operation runs with its defaults.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/features/select.hpp"
#include "mesh/features/surface_shape.hpp"
#include "mesh/features/wall_shape.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/flat.hpp"
#include "mesh/io/import.hpp"
#include "mesh/quality.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::ops {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Stories : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
  }

  static version_ptr part(const std::string& name,
                          const std::filesystem::path& parts = TEDIT_EXAMPLES) {
    const auto folder = parts / name;
    auto imported = import_mesh(folder / (name + ".coarse.msh"), "mm");
    EXPECT_TRUE(imported) << render(imported.error());
    return imported ? imported->version : nullptr;
  }

  /// A hole, else a boss, rib or fin, else the surface alone.
  static std::vector<surface_id> click(const mesh_version& mesh, surface_id id) {
    for (const auto kind : {feature_kind::hole, feature_kind::protrusion}) {
      selection_query query;
      query.kind = kind;
      query.surfaces = {id};
      if (const auto found = select_surfaces(mesh, query, {}))
        return found->front().surfaces;
    }
    return {id};
  }

  expected<finished_edit> edit(const version_ptr& base, const std::string& operation,
                               const std::vector<surface_id>& surfaces,
                               const parameters& values = {}) {
    context ctx;
    ctx.host = host_.get();
    ctx.search_s = 1e9;  // What is found does not depend on the clock.
    const auto made = run_operation(plugins_, operation, base, {surfaces}, values, ctx);
    if (!made)
      return fail(made.error());
    edit_claim claim;
    claim.touched = made->touched;
    claim.volume_change = made->volume_change;
    claim.quality_floor = made->quality_floor;
    claim.bodies_added = made->bodies_added;
    return finish_edit(base, made->candidate, claim, {made->improve, made->thorough}, {}, {});
  }

  /// Of the part's volume.
  static double share(const version_ptr& base, const finished_edit& done) {
    return (total_volume(*done.version) - total_volume(*base)) / total_volume(*base);
  }

  static double area(const mesh_version& mesh, surface_id id) { return shape_of(mesh, id).area; }

  catalogue plugins_;
  std::unique_ptr<services> host_ = make_host_services();
};

TEST_F(Stories, TheClickedFinGetsThinnerAndKeepsItsLoad) {
  const auto base = part("heatsink_125");
  ASSERT_TRUE(base);
  const auto fin = click(*base, 69);
  ASSERT_THAT(fin, ElementsAre(66, 67, 68, 69, 70));

  const auto done = edit(base, "erode", fin);

  ASSERT_TRUE(done) << render(done.error());
  // Half a millimetre off each side of one of eleven fins 3 mm thick, that are 60 % of the part.
  EXPECT_NEAR(share(base, *done), -0.019, 0.002);
  // The load's surface and the supports are where they were, but for the tip that went down.
  EXPECT_NEAR(area(*done->version, 69), area(*base, 69), 0.03 * area(*base, 69));
  for (const surface_id screw : {71, 72, 73})
    EXPECT_EQ(area(*done->version, screw), area(*base, screw));
  // The fillets at the root went along: as wide as before.
  for (const surface_id fillet : {66, 67})
    EXPECT_NEAR(area(*done->version, fillet), area(*base, fillet), 0.01 * area(*base, fillet));
}

TEST_F(Stories, TheWallsOfThePrintedBracketGetThicker) {
  const auto base = part("bracket_4040");
  ASSERT_TRUE(base);
  // Both walls from inside and from outside.
  for (const surface_id wall : {3, 5, 140, 154}) {
    SCOPED_TRACE(wall);
    const auto picked = click(*base, wall);
    ASSERT_THAT(picked, ElementsAre(wall));

    const auto done = edit(base, "thicken", picked);

    ASSERT_TRUE(done) << render(done.error());
    EXPECT_NEAR(share(base, *done) * total_volume(*base), 1e-3 * area(*base, wall),
                0.1 * 1e-3 * area(*base, wall));
  }
  for (const double height : {0.5, 0.2}) {
    const auto done = edit(base, "thicken", {3}, {{"depth_mm", height}});
    EXPECT_TRUE(done) << height << ": " << render(done.error());
  }
  EXPECT_TRUE(edit(base, "thicken", {140}, {{"depth_mm", 0.05}}));
}

TEST_F(Stories, TheClickedBoreOfThePlateIsClosed) {
  const auto base = part("ctc01_plate");
  ASSERT_TRUE(base);
  const auto bore = click(*base, 1);
  ASSERT_THAT(bore, ElementsAre(1, 2));

  const auto done = edit(base, "fill_hole", bore);

  ASSERT_TRUE(done) << render(done.error());
  EXPECT_GT(share(base, *done), 0);
  EXPECT_EQ(done->version->find_surface(1), nullptr);
}

TEST_F(Stories, ThePlateOfTheReadmeGetsThinner) {
  const auto base = part("ctc01_plate");
  ASSERT_TRUE(base);

  const auto done = edit(base, "erode", {98}, {{"depth_mm", 2.0}});

  ASSERT_TRUE(done) << render(done.error());
  EXPECT_LT(share(base, *done), 0);
}

TEST_F(Stories, FlatWallsAreNoHolesAndNoRibs) {
  for (const auto* name : {"heatsink_125", "bracket_4040", "ctc01_plate", "inch_block", "fork_thin",
                           "holes_block", "foot_cup", "as1_assembly"}) {
    const auto base = part(name, std::filesystem::path(TEDIT_TEST_DATA) / "parts");
    ASSERT_TRUE(base);
    for (const auto& row : base->surfaces()) {
      const auto shape = fit_wall(*base, facets_of(*base, std::vector{row.id}));
      if (!shape || shape->type != wall_shape::kind::plane)
        continue;
      SCOPED_TRACE(std::string(name) + " " + std::to_string(row.id));
      selection_query query;
      query.surfaces = {row.id};
      const auto hole = select_surfaces(*base, query, {});
      // A pocket has walls beside its floor.
      EXPECT_TRUE(!hole || hole->front().surfaces.size() > 1);
    }
  }
}

TEST_F(Stories, AFlangeWithADentThatAFilledBoreLeftIsNoPocket) {
  const auto base = part("bracket_4040");
  ASSERT_TRUE(base);
  const auto filled = edit(base, "fill_hole", {7}, {});
  ASSERT_TRUE(filled) << render(filled.error());
  selection_query query;

  query.surfaces = {8};  // The flange; the bore went out of the countersink in it.
  const auto flange = select_surfaces(*filled->version, query, {});
  query.surfaces = {6};  // The countersink.
  const auto dent = select_surfaces(*filled->version, query, {});

  ASSERT_FALSE(flange);
  EXPECT_EQ(flange.error().code, ec::not_a_hole);
  ASSERT_TRUE(dent) << render(dent.error());
  EXPECT_EQ(dent->front().surfaces.size(), 2U);
}

/// The rim of the copy lies in line with the walls of the hole, and nothing else is there.
TEST_F(Stories, ACopyInLineWithItsHoleIsNoCutAlongTheHolesWalls) {
  const auto base = part("bracket_4040");
  ASSERT_TRUE(base);
  for (const char* by : {"0,0.012,0", "0,-0.012,0"}) {
    const auto made = edit(base, "move", {2}, {{"by", std::string(by)}, {"copy", true}});
    ASSERT_FALSE(made) << made->volume_change;
    EXPECT_EQ(made.error().code, ec::empty_selection) << render(made.error());
  }
}

TEST_F(Stories, LayersAreTakenWhereTheyAloneAreGiven) {
  const auto erode = plugins_.find("erode");
  ASSERT_TRUE(erode);
  const auto& about = (*erode)->description;

  const auto usual = complete_parameters(about, {});
  const auto layers = complete_parameters(about, {{"layers", std::int64_t{2}}});
  const auto both = complete_parameters(about, {{"layers", std::int64_t{1}}, {"depth_mm", 2.0}});

  ASSERT_TRUE(usual && layers && both);
  EXPECT_EQ(std::get<double>(usual->at("depth")), 0.0005);
  EXPECT_EQ(std::get<std::int64_t>(usual->at("layers")), 0);
  EXPECT_EQ(std::get<double>(layers->at("depth")), 0);
  EXPECT_EQ(std::get<double>(both->at("depth")), 0.002);
}

/// Whatever is asked for, the limit is the same, and the edit works there and a little below.
TEST_F(Stories, TheMostThatWorksIsThePartsAndWorks) {
  struct wall {
    const char* part;
    const char* operation;
    const char* parameter;
    std::vector<surface_id> surfaces;
    std::vector<double> asked;  // m
  };
  const std::vector<wall> walls{
    {"heatsink_125", "erode", "depth", {66, 67, 68, 69, 70}, {0.00095, 0.0012}},
    {"heatsink_125", "erode", "depth", {69}, {0.002, 0.005}},
    {"ctc01_plate", "open", "radius", {37, 98}, {0.04, 0.15}},
  };
  for (const auto& one : walls) {
    const auto base = part(one.part);
    ASSERT_TRUE(base);
    std::optional<double> most;
    for (const double value : one.asked) {
      SCOPED_TRACE(std::string(one.part) + " " + one.operation + " " + std::to_string(value));
      const auto refused = edit(base, one.operation, one.surfaces, {{one.parameter, value}});
      ASSERT_FALSE(refused);
      EXPECT_THAT(refused.error().remedy, HasSubstr("the most that works"));
      ASSERT_TRUE(refused.error().most) << render(refused.error());
      EXPECT_EQ(refused.error().most->parameter, one.parameter);
      EXPECT_EQ(refused.error().most->value, most.value_or(refused.error().most->value));
      most = refused.error().most->value;
    }
    SCOPED_TRACE(*most);
    EXPECT_TRUE(edit(base, one.operation, one.surfaces, {{one.parameter, *most}}));
    const auto below = edit(base, one.operation, one.surfaces, {{one.parameter, 0.98 * *most}});
    EXPECT_TRUE(below) << render(below.error());
  }
}

/// A number that moves with what is asked is none of the part's.
TEST_F(Stories, WhatIsTooThinIsToldAlikeWhateverIsAskedFor) {
  const auto base = part("heatsink_125");
  ASSERT_TRUE(base);

  context ctx;  // Without a search for the most that works.
  ctx.host = host_.get();
  const auto six = run_operation(plugins_, "erode", base, {{1}}, {{"depth", 0.006}}, ctx);
  const auto eight = run_operation(plugins_, "erode", base, {{1}}, {{"depth", 0.008}}, ctx);

  ASSERT_FALSE(six);
  ASSERT_FALSE(eight);
  // The material over a screw hole.
  EXPECT_THAT(six.error().message, HasSubstr("only 0.9997 mm thick between surfaces 1 and 71 at"));
  EXPECT_EQ(six.error().message, eight.error().message);
}

/// As imported it cannot be solved: three tets have no volume.
TEST_F(Stories, APartWithFlatTetsIsMendedByImprovingItsMesh) {
  const auto imported = import_mesh(
    std::filesystem::path(TEDIT_TEST_DATA "/parts/base_so101/base_so101.coarse.msh"), "mm");
  ASSERT_TRUE(imported);
  const auto& base = imported->version;
  const auto flat = [](const mesh_version& mesh) {
    std::size_t count = 0;
    for (tet_id t = 0; t < mesh.tet_slots(); ++t)
      if (mesh.is_live_tet(t))
        count += is_flat(mesh.corners(t), signed_volume(mesh.corners(t)));
    return count;
  };
  ASSERT_EQ(flat(*base), 3U);

  const auto made = edit(base, "improve_mesh", {}, {});

  ASSERT_TRUE(made) << render(made.error());
  EXPECT_EQ(flat(*made->version), 0U);
  EXPECT_NEAR(total_volume(*made->version), total_volume(*base), 1e-12 * total_volume(*base));
  EXPECT_EQ(made->version->surfaces(), base->surfaces());
}

}  // namespace
}  // namespace tedit::ops
