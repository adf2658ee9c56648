// SPDX-License-Identifier: AGPL-3.0-or-later
// services::boolean at round walls: where new vertices lie, on blocks whose volumes can be had by
// hand.
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "mesh/features/known_wall.hpp"
#include "ops/services/host_services.hpp"
#include "ops/tools/tools.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using std::numbers::pi;

/// A round wall by hand: the axis through a point, and the radius there.
struct by_hand {
  std::string name;
  vec3 point;
  vec3 axis;
  double radius = 0;
  double slope = 0;

  [[nodiscard]] double off(vec3 p) const {
    const vec3 d = p - point;
    const double along = dot(d, axis);
    return std::abs(norm(d - along * axis) - radius - slope * along) / std::hypot(1, slope);
  }
};

class VerticesOnWalls : public ::testing::Test {
protected:
  static tool_surface rod(const by_hand& wall, double length, int segments) {
    const vec3 top = wall.point + 0.5 * length * wall.axis;
    return revolve(make_frame(top, wall.axis),
                   {{0, 0, ""},
                    {wall.radius + wall.slope * 0.5 * length, 0, "top"},
                    {wall.radius - wall.slope * 0.5 * length, -length, wall.name},
                    {0, -length, "end"}},
                   segments, 0.12);
  }

  boolean_result made(const version_ptr& mesh, const tool_surface& tool,
                      boolean_mode mode = boolean_mode::cut) {
    const auto result = host_->boolean(mesh, tool, {mode, 0}, {});
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return {mesh, {}, 0, 0, 0, 0, {}};
    edit_claim claim;
    claim.touched = result->touched;
    claim.volume_change = result->volume_change;
    claim.quality_floor = lowest_boolean_quality;
    const auto report = check_edit(*mesh, *result->candidate, claim);
    EXPECT_TRUE(report.ok()) << to_error(report).message;
    EXPECT_EQ(check_version(*result->candidate).total, 0u);
    return *result;
  }

  /// The block with a coarse bore: its wall has twelve facets.
  version_ptr bored() { return made(block_, rod(bore_, 3, 12)).candidate; }

  /// The block, which says of its top what it is.
  version_ptr block_with_a_known_top() {
    mesh_builder named(block_);
    const auto top =
      named.add_surface("top of it", {surface_geometry::kind::plane, {0, 0, 1}, {0, 0, 1}});
    for (facet_id f = 0; f < block_->facet_slots(); ++f)
      if (std::ranges::all_of(block_->facet(f).v,
                              [&](vertex_id v) { return block_->position(v).z == 1; }))
        named.set_surface(f, top);
    return named.freeze();
  }

  /// How far corners of the facets of these walls are off them at most, m.
  static double furthest_off(const mesh_version& mesh, const std::vector<by_hand>& walls) {
    double most = 0;
    std::set<std::string> seen;
    for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
      if (!mesh.is_live_facet(f))
        continue;
      const auto* row = mesh.find_surface(mesh.facet(f).surface);
      for (const auto& wall : walls)
        if (row && row->name == wall.name) {
          seen.insert(wall.name);
          for (const auto v : mesh.facet(f).v)
            most = std::max(most, wall.off(mesh.position(v)));
        }
    }
    EXPECT_EQ(seen.size(), walls.size());
    return most;
  }

  static std::vector<vec3> new_vertices_of(const mesh_version& before, const mesh_version& after,
                                           surface_id wall) {
    std::set<vertex_id> ids;
    for (const auto f : facets_of(after, std::array{wall}))
      for (const auto v : after.facet(f).v)
        if (v >= before.vertex_slots() || !before.is_live_vertex(v) ||
            before.position(v) != after.position(v))
          ids.insert(v);
    std::vector<vec3> places;
    for (const auto v : ids)
      places.push_back(after.position(v));
    return places;
  }

  std::unique_ptr<services> host_ = make_host_services();
  version_ptr block_ = test::box_mesh({8, 8, 8}, {1, 1, 1});
  const by_hand bore_{"bore", {0.5, 0.5, 0.5}, {0, 0, 1}, 0.2};
};

/// What a hole of radius r across a bore of radius R takes of the block: 8 times the integral over
/// y from 0 to r of (1/2 - sqrt(R^2 - y^2)) sqrt(r^2 - y^2), by the middle rule.
double taken_across(double bore, double hole) {
  double sum = 0;
  constexpr int n = 20'000;
  for (int i = 0; i < n; ++i) {
    const double angle = (i + 0.5) * pi / 2 / n;
    const double y = hole * std::sin(angle);
    const double width = hole * std::cos(angle);
    sum += (0.5 - std::sqrt(bore * bore - y * y)) * width * width * pi / 2 / n;
  }
  return 8 * sum;
}

// The middles of the bore's twelve chords are .2 (1 - cos 15 degrees) = .0068 off it, a third of
// the holes' radius: put on as they are, their rims would be turned over.
TEST_F(VerticesOnWalls, AHoleThatIsSmallBesideAChordOfABoreHasItsVerticesOnBoth) {
  const auto part = bored();
  int on_both = 0;
  for (int side = 0; side < 12; ++side) {
    const double angle = (15 + 30 * side) * pi / 180;
    const vec3 out{std::cos(angle), std::sin(angle), 0};
    const by_hand pit{"pit", vec3{0.5, 0.5, 0.47} + 0.3 * out, out, 0.04};

    const auto result = made(part, rod(pit, 0.24, 24));

    on_both += furthest_off(*result.candidate, {bore_, pit}) < 1e-9;
    EXPECT_GE(result.worst_after, lowest_boolean_quality);
  }
  EXPECT_GE(on_both, 11);
}

TEST_F(VerticesOnWalls, AHoleAcrossABoreHasItsVerticesOnBoth) {
  const by_hand across{"across", {0.5, 0.5, 0.47}, {1, 0, 0}, 0.11};

  const auto cut = made(bored(), rod(across, 3, 24));

  EXPECT_LT(furthest_off(*cut.candidate, {bore_, across}), 1e-12);
  EXPECT_NEAR(cut.volume_change, -taken_across(0.2, 0.11), 0.05 * taken_across(0.2, 0.11));
}

TEST_F(VerticesOnWalls, HolesBesideABoreHaveTheirVerticesOnBothOrOnTheChordsOfBoth) {
  const auto base = bored();
  int on_both = 0;
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const double angle = 0.4 + i * pi / 4;
    const vec3 way{std::cos(angle), std::sin(angle), 0};
    const by_hand beside{"beside", vec3{0.5, 0.5, 0.5} + 0.23 * way, {0, 0, 1}, 0.1};

    const auto cut = made(base, rod(beside, 3, 24));

    const double off = furthest_off(*cut.candidate, {bore_, beside});
    on_both += off < 1e-12;
    // Where no good tets come of it: a chord of 30 degrees is R (1 - cos 15 degrees) off its arc.
    EXPECT_LT(off, 0.2 * (1 - std::cos(pi / 12)) + 1e-12);
  }
  EXPECT_GE(on_both, 6);
}

TEST_F(VerticesOnWalls, ATiltedBlindHoleThatMeetsABoreToo) {
  const vec3 way{std::cos(0.67), std::sin(0.67), 0};
  const by_hand tilted{"tilted", vec3{0.5, 0.5, 0.5} + 0.27 * way,
                       normalized(way + vec3{0, 0, 0.3}), 0.09};

  const auto cut = made(bored(), rod(tilted, 0.4, 24));

  EXPECT_LT(furthest_off(*cut.candidate, {bore_, tilted}), 1e-12);
}

TEST_F(VerticesOnWalls, AConesVerticesLieOnTheCone) {
  const by_hand cone{"cone", {0.5, 0.5, 1}, {0, 0, 1}, 0.3, 0.5};

  const auto cut = made(bored(), rod(cone, 0.3, 24));

  EXPECT_LT(furthest_off(*cut.candidate, {bore_, cone}), 1e-12);
}

// A groove whose axis is a little askew to the block's top: facet edges of the tool meet the top at
// half a degree. Kept to the digit, each would leave a needle from there to the next edge.
TEST_F(VerticesOnWalls, FacetEdgesThatGrazeAWallMakeNoNeedles) {
  int on_wall = 0;
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const by_hand groove{
      "groove", {0.5, 0.5, 1.02 + 0.004 * i}, normalized(vec3{1, 0.3, 0.009}), 0.11};

    const auto cut = host_->boolean(block_, rod(groove, 3, 24), {boolean_mode::cut, 0}, {});

    if (cut) {
      EXPECT_LT(cut->deviation, 1e-6);
      on_wall += cut->worst_after >= 0.1 && furthest_off(*cut->candidate, {groove}) < 1e-9;
    }
  }
  // 4 of 12 where each bend is kept.
  EXPECT_GE(on_wall, 8);
}

TEST_F(VerticesOnWalls, ABarAcrossABoreEndsOnItsWall) {
  const by_hand bar{"bar", {0.5, 0.5, 0.5}, {0, 1, 0}, 0.09};

  const auto added = made(bored(), rod(bar, 0.5, 24), boolean_mode::add);

  EXPECT_LT(furthest_off(*added.candidate, {bore_, bar}), 1e-12);
}

/// The rod of six edges, whose chords are .0268 off the wall, that says it is the bore.
TEST_F(VerticesOnWalls, AToolOfFewFacetsThatSaysWhatItIsHasItsVerticesOnThat) {
  auto tool = rod(bore_, 3, 6);
  const surface_geometry cylinder{surface_geometry::kind::cylinder, bore_.point, bore_.axis,
                                  bore_.radius};
  tool.geometries.resize(tool.names.size());
  const auto face = std::ranges::find(tool.names, "bore") - tool.names.begin();
  tool.geometries[static_cast<std::size_t>(face)] = cylinder;
  const auto block = block_with_a_known_top();
  const auto top = std::ranges::find(block->surfaces(), "top of it", &surface_info::name)->id;

  const auto cut = made(block, tool);
  const auto as_polygon = made(block, rod(bore_, 3, 6));

  const auto& after = *cut.candidate;
  EXPECT_LT(furthest_off(after, {bore_}), 1e-12);
  EXPECT_GT(furthest_off(*as_polygon.candidate, {bore_}), 0.02);
  const auto row = std::ranges::find(after.surfaces(), "bore", &surface_info::name);
  ASSERT_NE(row, after.surfaces().end());
  EXPECT_EQ(row->geometry, cylinder);
  EXPECT_EQ(find_geometry(after, row->id), cylinder);
  EXPECT_EQ(after.find_surface(top)->geometry.type, surface_geometry::kind::plane);
}

/// Of holes anywhere across a bore of eight facets, in a part that says what its walls are: those
/// that came out on chords (.2 (1 - cos 22.5 degrees) = .0152 off it) where one way was tried.
TEST_F(VerticesOnWalls, WhereOneWayDoesNotGetThemOntoAKnownWallAnotherIsTried) {
  auto tool = rod(bore_, 3, 8);
  tool.geometries.resize(tool.names.size());
  for (std::size_t face = 0; face < tool.names.size(); ++face)
    if (tool.names[face] == "bore")
      tool.geometries[face] = {surface_geometry::kind::cylinder, bore_.point, bore_.axis,
                               bore_.radius};
  const auto part = made(block_with_a_known_top(), tool).candidate;
  int on_both = 0;
  for (const int i : {15, 37, 91, 123, 124}) {
    SCOPED_TRACE(i);
    const double turn = 0.37 * i;
    const vec3 way = normalized({std::cos(turn), std::sin(turn), 0.02 * (i % 11)});
    const by_hand across{
      "across", {0.5 + 0.003 * (i % 17), 0.5 + 0.002 * (i % 23), 0.47}, way, 0.05 + 0.0009 * i};

    const auto cut = made(part, rod(across, 3, 24));

    // To within what is left to settle after a boolean.
    on_both += furthest_off(*cut.candidate, {bore_, across}) < 1e-3;
  }
  EXPECT_GE(on_both, 4);
}

TEST_F(VerticesOnWalls, AHoleInAFilletHasItsVerticesOnTheTorus) {
  // A pin of 0.12 on a foot of 0.27, a fillet of 0.15 between them: three facets along the arc.
  std::vector<section_point> section{{0, 0.4, ""}, {0.12, 0.4, "top"}, {0.12, 0.25, "pin"}};
  for (const double angle : {210 * pi / 180, 240 * pi / 180, 1.5 * pi})
    section.push_back({0.27 + 0.15 * std::cos(angle), 0.25 + 0.15 * std::sin(angle), "fillet"});
  section.push_back({0.27, -0.1, "foot"});
  section.push_back({0, -0.1, "end"});
  const auto pin = revolve(make_frame({0.5, 0.5, 1}, {0, 0, 1}), section, 16, 0.12);
  const auto pinned = made(block_, pin, boolean_mode::add).candidate;
  const by_hand hole{"hole", {0.69, 0.52, 1.1}, {0, 0, 1}, 0.035};

  const auto cut = made(pinned, rod(hole, 0.3, 24));

  EXPECT_LT(furthest_off(*cut.candidate, {hole}), 1e-12);
  const auto off = [](vec3 p) {
    return std::abs(std::hypot(std::hypot(p.x - 0.5, p.y - 0.5) - 0.27, p.z - 1.25) - 0.15);
  };
  const auto& rows = pinned->surfaces();
  const auto fillet = std::ranges::find(rows, "fillet", &surface_info::name);
  ASSERT_NE(fillet, rows.end());
  const auto vertices = new_vertices_of(*pinned, *cut.candidate, fillet->id);
  EXPECT_GT(vertices.size(), 8u);
  for (const auto& p : vertices)
    EXPECT_LT(off(p), 1e-12);
}

TEST_F(VerticesOnWalls, AFlatWallWhoseCornersAreALittleOffItIsThePlaneOfTheOthers) {
  // As CAD programs leave them where faces meet.
  const auto askew = test::box_mesh({8, 8, 8}, {1, 1, 1}, [](vec3 p) {
    return p.z == 1 && p.x == 0 ? p + vec3{0, 0, p.y < 0.5 ? 3e-7 : -2e-7} : p;
  });
  const by_hand hole{"hole", {0.11, 0.52, 1}, {0, 0, 1}, 0.05};

  const auto cut = made(askew, rod(hole, 0.4, 24));

  const auto vertices = new_vertices_of(*askew, *cut.candidate, 6);
  EXPECT_GT(vertices.size(), 8u);
  for (const auto& p : vertices)
    EXPECT_NEAR(p.z, 1, 1e-12);
}

TEST_F(VerticesOnWalls, OnTurnedAndMovedPartsToo) {
  const frame f = make_frame({3.1, -2.7, 0.4}, normalized({0.3, -0.5, 0.8}));
  const auto place = [&](vec3 p) { return f.at(p.x, p.y, p.z); };
  const auto turned = test::box_mesh({8, 8, 8}, {1, 1, 1}, place);
  const by_hand bore{"bore", place({0.5, 0.5, 0.5}), f.z, 0.2};
  const by_hand across{"across", place({0.5, 0.5, 0.47}), f.x, 0.11};

  const auto bored = made(turned, rod(bore, 3, 12));
  const auto cut = made(bored.candidate, rod(across, 3, 24));

  EXPECT_LT(furthest_off(*cut.candidate, {bore, across}), 1e-12);
}

TEST_F(VerticesOnWalls, AToolOfFewSidesIsAPrism) {
  const by_hand prism{"prism", {0.45, 0.55, 0.5}, {0, 0, 1}, 0.3};

  const auto cut = made(block_, rod(prism, 3, 6));

  EXPECT_NEAR(cut.volume_change, -1.5 * std::sqrt(3.0) * 0.09, 1e-12);
}

}  // namespace
}  // namespace tedit::ops
