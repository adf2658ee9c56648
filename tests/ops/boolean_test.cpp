// SPDX-License-Identifier: AGPL-3.0-or-later
// services::boolean on blocks whose volumes can be had by hand, and on tools that are none.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/adapt/split_edges.hpp"
#include "mesh/checks.hpp"
#include "mesh/quality.hpp"
#include "ops/boolean/boolean.hpp"
#include "ops/services/host_services.hpp"
#include "ops/services/notices.hpp"
#include "ops/tools/tools.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Boolean : public ::testing::Test {
protected:
  /// A box with its lowest corner there.
  tool_surface brick(vec3 low, vec3 size, double edge = 0.15) {
    const frame f = make_frame(low + 0.5 * vec3{size.x, size.y, 0}, {0, 0, 1}, {0, 1, 0});
    auto tool = extrude(f, rectangle(size.x, size.y), 0, size.z, edge, "brick", *host_);
    EXPECT_TRUE(tool);
    return *tool;
  }

  tool_surface rod(vec3 from, vec3 along, double radius, double length) {
    return revolve(make_frame(from + length * along, along),
                   {{0, 0, ""}, {radius, 0, "top"}, {radius, -length, "side"}, {0, -length, "end"}},
                   24, 0.15);
  }

  boolean_result made(const version_ptr& mesh, const tool_surface& tool, boolean_mode mode) {
    const auto result = host_->boolean(mesh, tool, {mode, 0}, {});
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return {mesh, {}, 0, 0, 0, 0, {}};
    edit_claim claim;
    claim.touched = result->touched;
    claim.volume_change = result->volume_change;
    claim.quality_floor = lowest_boolean_quality;
    claim.bodies_added = 9;
    const auto report = check_edit(*mesh, *result->candidate, claim);
    EXPECT_TRUE(report.ok()) << to_error(report).message;
    EXPECT_EQ(check_version(*result->candidate).total, 0u);
    return *result;
  }

  error refusal(const tool_surface& tool, boolean_mode mode = boolean_mode::cut) {
    const auto result = host_->boolean(block_, tool, {mode, 0}, {});
    EXPECT_FALSE(result);
    return result ? error{} : result.error();
  }

  std::unique_ptr<services> host_ = make_host_services();
  version_ptr block_ = test::box_mesh({8, 8, 8}, {1, 1, 1});
};

TEST_F(Boolean, WhatIsCutAndWhatIsKeptIsAllThereWas) {
  const auto tool = rod({0.4, 0.45, 0.3}, normalized({0.3, 0.2, 1}), 0.2, 2);

  const auto cut = made(block_, tool, boolean_mode::cut);
  const auto kept = made(block_, tool, boolean_mode::keep);

  EXPECT_NEAR(total_volume(*cut.candidate) + total_volume(*kept.candidate), 1, 1e-9);
}

TEST_F(Boolean, WhatIsCutAndPutBackIsThePartAgain) {
  const auto tool = brick({0.35, 0.3, 0.6}, {0.3, 0.4, 0.7});

  const auto cut = made(block_, tool, boolean_mode::cut);
  const auto piece = brick({0.35, 0.3, 0.6}, {0.3, 0.4, 0.4});
  const auto back = made(cut.candidate, piece, boolean_mode::add);

  EXPECT_NEAR(cut.volume_change, -0.3 * 0.4 * 0.4, 1e-12);
  EXPECT_NEAR(total_volume(*back.candidate), 1, 1e-12);
}

TEST_F(Boolean, TheOrderOfDisjointCutsDoesNotMatter) {
  const auto one = rod({0.25, 0.25, -1}, {0, 0, 1}, 0.12, 3);
  const auto other = rod({0.7, 0.7, -1}, {0, 0, 1}, 0.15, 3);

  const auto forth = made(made(block_, one, boolean_mode::cut).candidate, other, boolean_mode::cut);
  const auto back = made(made(block_, other, boolean_mode::cut).candidate, one, boolean_mode::cut);

  EXPECT_NEAR(total_volume(*forth.candidate), total_volume(*back.candidate), 1e-12);
}

TEST_F(Boolean, WhatSeveralHaveTouchedIsFoundAgain) {
  const auto one = made(block_, rod({0.3, 0.3, -1}, {0, 0, 1}, 0.12, 3), boolean_mode::cut);
  const auto both = made(one.candidate, brick({0.4, 0.4, 1}, {0.3, 0.3, 0.2}), boolean_mode::add);

  edit_claim claim;
  claim.touched = changed_tets(*block_, *both.candidate);
  claim.volume_change = one.volume_change + both.volume_change;
  claim.quality_floor = lowest_boolean_quality;

  const auto report = check_edit(*block_, *both.candidate, claim);
  EXPECT_TRUE(report.ok()) << to_error(report).message;
  EXPECT_LT(claim.touched.size(), both.candidate->tet_count());
}

TEST_F(Boolean, WhereLittleIsLeftTetsAreAsSmallAsThat) {
  // A pocket that leaves a bottom of 4 mm, among edges of 125 mm.
  const auto pocket = made(block_, brick({0.4, 0.4, 0.004}, {0.1, 0.1, 1}), boolean_mode::cut);
  auto* const telling = dynamic_cast<telling_services*>(host_.get());
  ASSERT_NE(telling, nullptr);

  EXPECT_NEAR(pocket.volume_change, -0.1 * 0.1 * 0.996, 1e-12);
  EXPECT_GE(pocket.worst_after, 0.1);
  EXPECT_THAT(telling->take_notices(),
              ElementsAre(HasSubstr("only 4 mm of the part are left between two of its walls")));

  // And a tilted hole whose lowest corner ends 2 mm above the bottom.
  auto tool = rod({0.5, 0.5, 0}, normalized({0.3, 0, 1}), 0.15, 2);
  const double lowest = std::ranges::min(tool.points, {}, &vec3::z).z;
  for (auto& p : tool.points)
    p.z += 0.002 - lowest;
  const auto hole = made(block_, tool, boolean_mode::cut);

  EXPECT_GE(hole.worst_after, 0.1);
  EXPECT_THAT(telling->take_notices(), ElementsAre(HasSubstr("only 2 mm")));
}

TEST_F(Boolean, WhatIsTooThinForTetsIsNamed) {
  // 0.2 mm are left.
  const auto why = refusal(brick({0.4, 0.4, 2e-4}, {0.1, 0.1, 1}));

  EXPECT_EQ(why.code, ec::postcondition_failed);
  EXPECT_THAT(why.message, HasSubstr("only 0.2 mm of the part would be left near ("));
  EXPECT_THAT(why.remedy, HasSubstr("go through"));
}

TEST_F(Boolean, WhatIsNotThinIsNotTold) {
  (void)made(block_, brick({0.4, 0.4, 0.3}, {0.1, 0.1, 1}), boolean_mode::cut);

  EXPECT_THAT(dynamic_cast<telling_services&>(*host_).take_notices(), IsEmpty());
}

/// Of each surface in millionths, by its name and, where the part had it, its id.
std::multiset<std::tuple<surface_id, std::string, long>> areas_of(const mesh_version& mesh) {
  constexpr surface_id last_of_block = 6;
  std::multiset<std::tuple<surface_id, std::string, long>> result;
  for (const auto& row : mesh.surfaces()) {
    double sum = 0;
    for (const auto f : facets_of(mesh, std::array{row.id}))
      sum += norm(area_vector(mesh, mesh.facet(f)));
    result.insert({row.id <= last_of_block ? row.id : 0, row.name, std::lround(1e6 * sum)});
  }
  return result;
}

TEST_F(Boolean, ADraftHasTheWholeOnesSurfaces) {
  const auto drafts = make_draft_services();
  // Into the top, through, over an edge with flush faces, a void, and something that stands on it.
  const std::vector<std::pair<tool_surface, boolean_mode>> tools{
    {brick({0.3, 0.3, 0.6}, {0.4, 0.4, 0.7}), boolean_mode::cut},
    {rod({0.4, 0.45, 0.3}, normalized({0.3, 0.2, 1}), 0.2, 2), boolean_mode::cut},
    {brick({0, 0.3, 0.7}, {0.4, 0.4, 0.3}), boolean_mode::cut},
    {brick({0.35, 0.35, 0.35}, {0.3, 0.3, 0.3}), boolean_mode::cut},
    {brick({0.4, 0.4, 1}, {0.3, 0.3, 0.2}), boolean_mode::add},
    {rod({0.5, 0.5, 0.5}, {0, 0, 1}, 0.3, 1), boolean_mode::keep}};
  for (const auto& [tool, mode] : tools) {
    const auto whole = made(block_, tool, mode);
    const auto draft = drafts->boolean(block_, tool, {mode, 0}, {});
    ASSERT_TRUE(draft) << render(draft.error());
    EXPECT_NEAR(draft->volume_change, whole.volume_change, 1e-9);
    EXPECT_EQ(boundary_components(*draft->candidate), boundary_components(*whole.candidate));
    EXPECT_EQ(areas_of(*draft->candidate), areas_of(*whole.candidate));
  }
}

TEST_F(Boolean, ADraftIsRefusedForToolsThatAreNoneOrMeetNothing) {
  const auto drafts = make_draft_services();
  const auto refused = [&](const tool_surface& tool) {
    return drafts->boolean(block_, tool, {}, {}).error().code;
  };
  auto open = brick({0.3, 0.3, 0.6}, {0.4, 0.4, 0.7});
  open.triangles.pop_back();
  open.faces.pop_back();
  EXPECT_EQ(refused(open), ec::invalid_argument);
  EXPECT_EQ(refused(brick({3, 3, 3}, {1, 1, 1})), ec::empty_selection);
  EXPECT_EQ(refused(brick({-1, -1, -1}, {3, 3, 3})), ec::empty_selection) << "nothing is left";
}

// The vertex in the middle of the top is moved to near the edge of the plate. All tets have all of
// their corners on walls, so that no vertex inside can move.
TEST_F(Boolean, WhatIsFlatBetweenWallsIsMendedWithinThem) {
  const auto plate = test::box_mesh({2, 2, 1}, {1, 1, 0.3});
  mesh_builder builder(plate);
  for (vertex_id v = 0; v < plate->vertex_slots(); ++v)
    if (norm(plate->position(v) - vec3{0.5, 0.5, 0.3}) < 1e-12)
      builder.set_position(v, {0.02, 0.5, 0.3});
  ASSERT_LT(worst_quality(*builder.freeze(), builder.touched()), 0.1);

  ASSERT_TRUE(mend_flat(builder, builder.touched(), 1e-12, {}));

  const auto mended = builder.freeze();
  EXPECT_GT(worst_quality(*mended, builder.touched()), 0.2);
  EXPECT_NEAR(total_volume(*mended), 0.3, 1e-12);
  EXPECT_EQ(check_version(*mended).total, 0u);
}

// The slots' edges pass within rounding of the plate's: sheets of no thickness came of that, which
// the mesher crashed of.
TEST_F(Boolean, SlotsThroughAPlateOfOneTetAreAsLargeAsTheyShouldBe) {
  const auto plate = test::box_mesh({8, 8, 1}, {1, 1, 0.06});
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i);
    const double turn = 0.1 + 0.31 * i;
    const frame f =
      make_frame({0.5 + 0.004 * i, 0.5, -0.1}, {0, 0, 1}, {std::cos(turn), std::sin(turn), 0});
    const auto slot = extrude(f, rectangle(0.43, 0.07), 0, 0.3, 0.1, "slot", *host_);
    ASSERT_TRUE(slot);

    const auto cut = made(plate, *slot, boolean_mode::cut);

    EXPECT_NEAR(cut.volume_change, -0.43 * 0.07 * 0.06, 1e-12);
    EXPECT_GE(cut.worst_after, std::min(0.1, cut.worst_before));
  }
}

TEST_F(Boolean, AVoidInsideIsCutOut) {
  const auto cut = made(block_, brick({0.35, 0.35, 0.35}, {0.3, 0.3, 0.3}), boolean_mode::cut);

  EXPECT_NEAR(cut.volume_change, -0.027, 1e-12);
  EXPECT_EQ(cut.candidate->surfaces().size(), 12u);
}

TEST_F(Boolean, FacesThatAreFlushComeOutFlush) {
  // Top and one side of the brick lie in the block's.
  const auto cut = made(block_, brick({0, 0.3, 0.7}, {0.4, 0.4, 0.3}), boolean_mode::cut);
  const auto added = made(block_, brick({1, 0.3, 0.7}, {0.4, 0.4, 0.3}), boolean_mode::add);

  EXPECT_NEAR(cut.volume_change, -0.4 * 0.4 * 0.3, 1e-12);
  EXPECT_NEAR(added.volume_change, 0.4 * 0.4 * 0.3, 1e-12);
}

TEST_F(Boolean, OnTurnedAndMovedPartsToo) {
  const frame f = make_frame({3.1, -2.7, 0.4}, normalized({0.3, -0.5, 0.8}));
  const auto place = [&](vec3 p) { return f.at(p.x, p.y, p.z); };
  const auto turned = test::box_mesh({8, 8, 8}, {1, 1, 1}, place);
  auto tool = brick({0.3, 0.3, 0.6}, {0.4, 0.4, 0.4});
  for (auto& p : tool.points)
    p = place(p);

  const auto cut = made(turned, tool, boolean_mode::cut);

  EXPECT_NEAR(cut.volume_change, -0.4 * 0.4 * 0.4, 1e-9);
}

TEST_F(Boolean, FacesOfTheToolAreNewSurfacesThatAreNamed) {
  const auto tool = brick({0.3, 0.3, 0.6}, {0.4, 0.4, 1});

  const auto cut = made(block_, tool, boolean_mode::cut);

  ASSERT_EQ(cut.surfaces.size(), tool.names.size());
  for (std::size_t i = 0; i < tool.names.size(); ++i) {
    const bool top = tool.names[i] == "brick top";
    ASSERT_EQ(cut.surfaces[i].has_value(), !top) << tool.names[i];
    if (!top) {
      EXPECT_EQ(cut.candidate->find_surface(*cut.surfaces[i])->name, tool.names[i]);
    }
  }
}

TEST_F(Boolean, TetsAwayFromTheToolStayAsTheyAre) {
  const auto cut = made(block_, rod({0.5, 0.5, 0.7}, {0, 0, 1}, 0.1, 1), boolean_mode::cut);

  std::size_t kept = 0;
  for (tet_id t = 0; t < block_->tet_slots(); ++t)
    kept += cut.candidate->is_live_tet(t) && cut.candidate->tet_at(t) == block_->tet_at(t);
  EXPECT_GT(kept, block_->tet_count() * 8 / 10);
}

TEST_F(Boolean, TheSameToolGivesTheSameVersion) {
  const auto tool = rod({0.4, 0.4, 0.5}, normalized({0.1, 0.2, 1}), 0.15, 1);

  EXPECT_EQ(made(block_, tool, boolean_mode::cut).candidate->id(),
            made(block_, tool, boolean_mode::cut).candidate->id());
}

TEST_F(Boolean, ToolsThatMeetNothingOrTakeAllAreTold) {
  EXPECT_EQ(refusal(brick({2, 2, 2}, {1, 1, 1})).code, ec::empty_selection);
  EXPECT_EQ(refusal(brick({-1, -1, -1}, {3, 3, 3})).code, ec::empty_selection);
  EXPECT_EQ(refusal(brick({0.3, 0.3, 0.3}, {0.2, 0.2, 0.2}), boolean_mode::add).code,
            ec::empty_selection);
}

TEST_F(Boolean, WhatIsThereAlreadyIsNotAddedAgain) {
  const auto tool = brick({0.3, 0.3, 1}, {0.4, 0.4, 0.2});
  const auto added = made(block_, tool, boolean_mode::add);

  const auto again = host_->boolean(added.candidate, tool, {boolean_mode::add, 0}, {});

  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ec::empty_selection) << render(again.error());
}

TEST_F(Boolean, ToolsThatAreNoneAreTold) {
  const auto good = brick({0.3, 0.3, 0.6}, {0.4, 0.4, 1});

  auto open = good;
  open.triangles.pop_back();
  open.faces.pop_back();
  EXPECT_THAT(refusal(open).message, HasSubstr("not one triangle on each side"));

  auto inside_out = good;
  for (auto& t : inside_out.triangles)
    std::swap(t[1], t[2]);
  EXPECT_THAT(refusal(inside_out).message, HasSubstr("inside out"));

  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    auto broken = good;
    broken.points[3].y = bad;
    EXPECT_EQ(refusal(broken).code, ec::invalid_argument);
  }
  auto wild = good;
  wild.triangles[0][1] = 1'000'000;
  EXPECT_EQ(refusal(wild).code, ec::invalid_argument);
  auto nameless = good;
  nameless.faces[0] = 99;
  EXPECT_EQ(refusal(nameless).code, ec::invalid_argument);
  EXPECT_EQ(refusal({}).code, ec::invalid_argument);
  auto told = good;
  told.geometries.resize(good.names.size() + 1);
  EXPECT_THAT(refusal(told).message, HasSubstr("not each face has a geometry"));
  told.geometries.assign(good.names.size(),
                         {surface_geometry::kind::sphere, {0, 0, std::nan("")}, {}, 1});
  EXPECT_THAT(refusal(told).message, HasSubstr("not finite"));
  // A spline without its numbers.
  told.geometries.front() = {surface_geometry::kind::spline};
  EXPECT_EQ(refusal(told).code, ec::invalid_argument);
}

TEST_F(Boolean, AToolThatCutsItselfIsAnErrorAndNothingMore) {
  auto twisted = brick({0.3, 0.3, 0.6}, {0.4, 0.4, 1});
  twisted.points[0] = {2, 2, 2};
  const auto result = host_->boolean(block_, twisted, {}, {});
  if (!result) {
    EXPECT_FALSE(result.error().remedy.empty());
  } else {
    EXPECT_EQ(check_version(*result->candidate).total, 0u);
  }
}

TEST_F(Boolean, ACancelIsHeard) {
  execution run;
  run.cancel.cancel();
  const auto result = host_->boolean(block_, brick({0.3, 0.3, 0.6}, {0.4, 0.4, 1}), {}, run);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::cancelled);
}

TEST_F(Boolean, AToolThatPassesThroughItselfIsRefused) {
  // The top of a brick pulled down through its bottom at one corner.
  auto tool = brick({0.3, 0.3, 0.5}, {0.4, 0.4, 1}, 0.4);
  for (auto& p : tool.points)
    if (p.z == 1.5 && p.x == 0.7 && p.y == 0.7)
      p = {0.5, 0.5, 0.2};

  const auto why = refusal(tool);

  EXPECT_EQ(why.code, ec::invalid_argument);
  EXPECT_THAT(why.message, HasSubstr("passes through itself"));
}

// -- faces that continue surfaces ----------------------------------------------------------

TEST_F(Boolean, AFaceOfTheToolBecomesPartOfASurfaceThatIsThere) {
  // A boss that stands flush on the top's border: its side at x = 0 goes on with the block's.
  const auto tool = brick({0, 0.3, 0.9}, {0.3, 0.4, 0.4});
  std::vector<std::optional<surface_id>> continues(tool.names.size());
  for (std::size_t i = 0; i < tool.triangles.size(); ++i) {
    const auto& t = tool.triangles[i];
    if (tool.points[t[0]].x == 0 && tool.points[t[1]].x == 0 && tool.points[t[2]].x == 0)
      continues[tool.faces[i]] = 1;
  }

  const auto onto = host_->boolean_onto(block_, tool, continues, {boolean_mode::add, 0}, {});

  ASSERT_TRUE(onto) << render(onto.error());
  EXPECT_NEAR(total_volume(*onto->candidate), 1 + 0.3 * 0.4 * 0.3, 1e-9);
  double area = 0;
  for (const auto f : facets_of(*onto->candidate, std::vector<surface_id>{1}))
    area += norm(area_vector(*onto->candidate, onto->candidate->facet(f)));
  EXPECT_NEAR(area, 1 + 0.4 * 0.3, 1e-9);
  for (std::size_t i = 0; i < continues.size(); ++i)
    if (continues[i]) {
      EXPECT_EQ(onto->surfaces[i], 1);
    }
}

TEST_F(Boolean, AFaceBringsASurfaceBackThatThePartNoLongerHas) {
  const auto tool = brick({0.2, 0.3, 0.9}, {0.3, 0.4, 0.4});
  std::vector<std::optional<surface_id>> continues(tool.names.size());

  const std::size_t top = 1;  // "brick bottom" lies inside the block.
  continues[top] = 99;
  const auto back = host_->boolean_onto(block_, tool, continues, {boolean_mode::add, 0}, {});
  continues.pop_back();
  const auto short_list = host_->boolean_onto(block_, tool, continues, {boolean_mode::add, 0}, {});

  ASSERT_TRUE(back) << render(back.error());
  const auto* row = back->candidate->find_surface(99);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->name, tool.names[top]);
  EXPECT_EQ(back->surfaces[top], 99);
  ASSERT_FALSE(short_list);
  EXPECT_EQ(short_list.error().code, ec::invalid_argument);
}

}  // namespace
}  // namespace tedit::ops
