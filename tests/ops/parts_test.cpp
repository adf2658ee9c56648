// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "mesh/quality.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/parts.hpp"

namespace tedit::ops {
namespace {

using ::testing::ElementsAreArray;

class RealParts : public ::testing::TestWithParam<const char*> {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
    const auto folder = test::parts_folder / GetParam();
    auto imported = import_mesh(folder / (std::string(GetParam()) + ".coarse.msh"), "mm");
    ASSERT_TRUE(imported.has_value());
    mesh_ = imported->version;
    std::ifstream in(folder / "features.json");
    features_ = nlohmann::json::parse(in);
  }

  expected<edit_result> fill(const std::vector<surface_id>& walls) {
    context ctx;
    ctx.host = host_.get();
    return run_operation(plugins_, "fill_hole", mesh_, {walls}, {}, ctx);
  }

  /// What the host makes of a candidate.
  expected<finished_edit> finish(const edit_result& result) {
    edit_claim claim;
    claim.touched = result.touched;
    claim.volume_change = result.volume_change;
    claim.quality_floor = result.quality_floor;
    return finish_edit(mesh_, result.candidate, claim, result.improve, {}, {});
  }

  catalogue plugins_;
  std::unique_ptr<services> host_ = make_host_services();
  version_ptr mesh_;
  nlohmann::json features_;
};

/// Grooves whose rim crosses slots, part convex and part concave: refused by name.
const std::map<std::pair<std::string, surface_id>, ec> refused{
  {{"foot_cup", 15}, ec::mixed_rim},
  {{"foot_cup", 17}, ec::mixed_rim},
};

TEST_P(RealParts, EveryListedHoleIsFilledOrRefusedByName) {
  const double before = total_volume(*mesh_);
  for (const auto& hole : features_["holes"]) {
    const auto walls = hole["surfaces"].get<std::vector<surface_id>>();
    SCOPED_TRACE(hole["surfaces"].dump());
    const auto result = fill(walls);
    if (const auto row = refused.find({GetParam(), walls.front()}); row != refused.end()) {
      ASSERT_FALSE(result.has_value());
      EXPECT_EQ(result.error().code, row->second);
      continue;
    }
    ASSERT_TRUE(result.has_value()) << render(result.error());

    const auto done = finish(*result);

    ASSERT_TRUE(done.has_value()) << render(done.error());
    EXPECT_NEAR(total_volume(*done->version), before + result->volume_change, 1e-9 * before);
    ASSERT_TRUE(done->ratios.has_value());
    EXPECT_GE(done->ratios->min_after, std::min(0.15, done->ratios->min_before) * (1 - 1e-9));
    for (const auto id : walls)
      EXPECT_EQ(done->version->find_surface(id), nullptr);
  }
}

TEST_P(RealParts, EveryFinComesOffFromOneOfItsFaces) {
  for (const auto& fin : features_.value("fins", nlohmann::json::array())) {
    const auto face = fin["faces"][0].get<surface_id>();
    SCOPED_TRACE(face);
    context ctx;
    ctx.host = host_.get();
    const auto result = run_operation(plugins_, "remove_surfaces", mesh_, {{face}}, {}, ctx);
    ASSERT_TRUE(result.has_value()) << render(result.error());

    const auto done = finish(*result);

    ASSERT_TRUE(done.has_value()) << render(done.error());
    EXPECT_LT(result->volume_change, 0);
    for (const auto& side : fin["faces"])
      EXPECT_EQ(done->version->find_surface(side.get<surface_id>()), nullptr);
  }
}

/// A refusal that a person can act on: what is wrong with the selection, not a defect.
void expect_good_refusal(const error& e) {
  static const std::set<ec> reasons{
    ec::not_a_hole, ec::non_planar_rim,  ec::mixed_rim,     ec::cap_intersects,
    ec::flat_plug,  ec::empty_selection, ec::mesher_failed, ec::postcondition_failed};
  EXPECT_TRUE(reasons.contains(e.code)) << render(e);
  EXPECT_FALSE(e.message.empty());
  EXPECT_FALSE(e.remedy.empty()) << render(e);
}

/// Surfaces that bound a hole, a slot or a pocket by themselves or with what is completed; all
/// others are refused.
const std::map<std::string, std::vector<surface_id>> filled_alone{
  {"as1_assembly", {}},
  {"bracket_4040", {1, 2, 4, 6, 7, 9, 11, 12, 14, 16, 17, 18, 19, 20, 21}},
  {"ctc01_plate", {}},
  {"foot_cup", {153}},
  {"fork_thin", {37, 38, 98, 100}},
  {"heatsink_125", {71, 72, 73}},
  {"holes_block", {2, 23, 95, 96, 120}},
  {"inch_block", {1}},
};

/// Either the surface is gone, the part has grown by what was said and every promise of an edit
/// holds, or there is a reason.
TEST_P(RealParts, AnySurfaceAloneIsFilledSoundlyOrRefusedAndTheVersionIsLeftAlone) {
  const auto id = mesh_->id();
  const double before = total_volume(*mesh_);
  const auto faults = check_version(*mesh_).total;
  std::vector<surface_id> fills;
  for (const auto& row : mesh_->surfaces()) {
    SCOPED_TRACE(row.id);
    const auto result = fill({row.id});
    const auto done = result ? finish(*result) : fail(result.error());
    if (!done) {
      expect_good_refusal(done.error());
      continue;
    }
    fills.push_back(row.id);
    EXPECT_GT(result->volume_change, 0);
    EXPECT_NEAR(total_volume(*done->version), before + result->volume_change, 1e-9 * before);
    EXPECT_EQ(done->version->find_surface(row.id), nullptr);
    EXPECT_LE(check_version(*done->version).total, faults);
  }
  EXPECT_THAT(fills, ElementsAreArray(filled_alone.at(GetParam())));
  EXPECT_EQ(mesh_->id(), id);
}

INSTANTIATE_TEST_SUITE_P(Open, RealParts,
                         ::testing::Values("as1_assembly", "bracket_4040", "ctc01_plate",
                                           "foot_cup", "fork_thin", "heatsink_125", "holes_block",
                                           "inch_block"));

}  // namespace
}  // namespace tedit::ops
