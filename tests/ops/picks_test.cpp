// SPDX-License-Identifier: AGPL-3.0-or-later
// Places that a request names by what the part has there, instead of numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>

#include "mesh/io/import.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/loader/picks.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/tube.hpp"

namespace tedit::ops {
namespace {

using test::parts_folder;
using ::testing::HasSubstr;

operation_description placed_by() {
  operation_description d;
  d.id = "placed_by";
  const auto add = [&](const char* id, parameter_type type, const char* unit) {
    d.parameters.push_back({id, "", "", type, unit, {}, {}, {}, std::string()});
  };
  add("at", parameter_type::point, "m");
  add("along", parameter_type::direction, "");
  add("axis", parameter_type::axis, "m");
  add("plane", parameter_type::plane, "m");
  add("path", parameter_type::polyline, "m");
  add("by", parameter_type::vector, "m");
  return d;
}

/// Operations of the program on parts whose numbers are known.
class PicksForOperations : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
  }

  expected<edit_result> run(const char* id, const version_ptr& mesh,
                            const std::vector<surface_id>& surfaces, const parameters& values) {
    context ctx;
    ctx.host = host_.get();
    return run_operation(plugins_, id, mesh, {surfaces}, values, ctx);
  }

  static parameter_value text(const char* words) { return std::string(words); }

  catalogue plugins_;
  std::unique_ptr<services> host_ = make_host_services();
};

/// 0.04 x 0.03 x 0.02 m; surfaces 1 to 6: x, y, z, the lower one first.
version_ptr brick() {
  return test::box_mesh({4, 3, 2}, {0.04, 0.03, 0.02});
}

/// From 1 to 2 m, of 16 sides, 1 m long; inner and outer wall 1 and 2, ends 3 and 4.
version_ptr pipe() {
  return test::tube_mesh({});
}

expected<parameters> values_of(const version_ptr& mesh, const std::string& id,
                               const std::string& pick) {
  return complete_parameters(placed_by(), {{id, pick}}, mesh.get());
}

std::string refusal(const version_ptr& mesh, const std::string& id, const std::string& pick) {
  const auto values = values_of(mesh, id, pick);
  EXPECT_FALSE(values) << id << " = " << pick;
  return values ? "" : render(values.error());
}

void expect_axis(const version_ptr& mesh, const std::string& id, const std::string& pick,
                 const axis_value& wanted) {
  const auto values = values_of(mesh, id, pick);
  ASSERT_TRUE(values) << id << " = " << pick << ": " << render(values.error());
  const auto got = axis_of(*values, id);
  ASSERT_TRUE(got) << pick;
  EXPECT_LT(norm(got->point - wanted.point), 1e-9) << id << " = " << pick;
  EXPECT_LT(norm(got->direction - wanted.direction), 1e-9) << id << " = " << pick;
}

void expect_point(const version_ptr& mesh, const std::string& id, const std::string& pick,
                  vec3 wanted) {
  const auto values = values_of(mesh, id, pick);
  ASSERT_TRUE(values) << id << " = " << pick << ": " << render(values.error());
  EXPECT_LT(norm(vector_of(*values, id).value_or(vec3{9, 9, 9}) - wanted), 1e-9)
    << id << " = " << pick;
}

TEST(Picks, TheSurfacesOfATextAreThoseOfItsPlaces) {
  EXPECT_THAT(ops::surfaces_of_picks("1, 2, 3; surface:12;edge:3, 7"),
              testing::ElementsAre(12, 3, 7));
  EXPECT_THAT(ops::surfaces_of_picks(" corner:-1,2,3"), testing::ElementsAre(-1, 2, 3));
  for (const auto* none : {"", "1, 2.5, 0", "a surface:12", "edge:", "surface:x", ";;"})
    EXPECT_THAT(ops::surfaces_of_picks(none), testing::IsEmpty()) << none;
}

TEST(Picks, AFlatWallIsItsMiddleAndItsNormal) {
  const axis_value low{{0, 0.015, 0.01}, {-1, 0, 0}};

  expect_axis(brick(), "plane", "surface:1", low);
  expect_axis(brick(), "axis", " surface: 1 ", low);
  expect_point(brick(), "at", "surface:1", low.point);
  expect_point(brick(), "along", "surface:1", low.direction);
}

TEST(Picks, ARoundWallIsItsAxis) {
  const axis_value axis{{0, 0, 0.5}, {0, 0, 1}};
  for (const auto* wall : {"surface:1", "surface:2"}) {
    expect_axis(pipe(), "axis", wall, axis);
    expect_axis(pipe(), "plane", wall, axis);
    expect_point(pipe(), "at", wall, axis.point);
    expect_point(pipe(), "along", wall, axis.direction);
  }
}

TEST(Picks, AStraightEdgeIsItsLineAndARoundOneItsCirclesAxis) {
  expect_axis(brick(), "axis", "edge:2,4", {{0.04, 0.03, 0.01}, {0, 0, 1}});
  expect_point(brick(), "at", "edge:4,6", {0.02, 0.03, 0.02});
  expect_axis(pipe(), "axis", "edge:1,4", {{0, 0, 1}, {0, 0, 1}});
  expect_point(pipe(), "at", "edge:3,2", {0, 0, 0});
}

TEST(Picks, ACornerIsThePointOfThreeSurfaces) {
  expect_point(brick(), "at", "corner:2,4,6", {0.04, 0.03, 0.02});
  expect_point(brick(), "at", "corner:5,1,3", {0, 0, 0});
}

TEST(Picks, AnEdgeIsAPolylineAndPlacesMayStandAmongPoints) {
  const auto edge = values_of(brick(), "path", "edge:4,6");
  ASSERT_TRUE(edge) << render(edge.error());
  const auto points = points_of(*edge, "path");
  ASSERT_EQ(points.size(), 5u);
  for (int i = 0; i < 5; ++i)
    EXPECT_LT(norm(points[i] - vec3{0.01 * i, 0.03, 0.02}), 1e-15);
  EXPECT_EQ(points_of(*values_of(pipe(), "path", "edge:1,4"), "path").size(), 17u);

  const auto mixed =
    complete_parameters(placed_by(),
                        {{"path_mm", std::string("corner:1,3,5; 1, 2, 3; surface:6")},
                         {"axis_mm", std::string("corner:2,4,6; 0, 0, 2")}},
                        brick().get());
  ASSERT_TRUE(mixed) << render(mixed.error());
  EXPECT_LT(norm(points_of(*mixed, "path")[1] - vec3{1e-3, 2e-3, 3e-3}), 1e-15);
  EXPECT_LT(norm(points_of(*mixed, "path")[2] - vec3{0.02, 0.015, 0.02}), 1e-9);
  EXPECT_EQ(axis_of(*mixed, "axis")->point, (vec3{0.04, 0.03, 0.02}));
  EXPECT_EQ(axis_of(*mixed, "axis")->direction, (vec3{0, 0, 1}));
}

TEST(Picks, WhatNamesNoPlaceIsRefusedWithWhatWould) {
  EXPECT_THAT(refusal(brick(), "at", "edge:1,2"),
              HasSubstr("parameter at: surfaces 1 and 2 have no edge in common"));
  EXPECT_THAT(refusal(brick(), "at", "surface:7"), HasSubstr("surface 7 is not in this version"));
  EXPECT_THAT(refusal(brick(), "at", "corner:1,2,3"), HasSubstr("1, 2 and 3 meet in no point"));
  EXPECT_THAT(refusal(pipe(), "at", "edge:1,1"), HasSubstr("names no place"));
  EXPECT_THAT(refusal(brick(), "path", "surface:1"), HasSubstr("only an edge"));
  EXPECT_THAT(refusal(brick(), "axis", "corner:2,4,6"), HasSubstr("has no direction"));
  EXPECT_THAT(refusal(brick(), "by", "surface:1"), HasSubstr("it is three numbers"));
  for (const auto* text :
       {"surface:", "surface:1,2", "surface:x", "edge:1", "edge:1,2,3", "corner:1,2", "edge:1,",
        "surface:99999999999999999999999", "edge:1,2 3", "surface:1.5"})
    EXPECT_THAT(refusal(brick(), "at", text), HasSubstr("Write surface:12, edge:3,7")) << text;
  EXPECT_THAT(refusal(brick(), "at", "wall:1"), HasSubstr("it is three numbers"));
  std::string many = "surface:1";
  for (int i = 0; i < 200; ++i)
    many += i % 2 == 0 ? ";surface:2" : ";surface:1";
  EXPECT_THAT(refusal(brick(), "path", many), HasSubstr("more than 100 places"));
}

TEST(Picks, WithoutAPartThereIsNoPlace) {
  const auto values = complete_parameters(placed_by(), {{"at", std::string("surface:1")}});

  ASSERT_FALSE(values);
  EXPECT_THAT(render(values.error()), HasSubstr("there is no part to look at"));
}

/// In half by the plane of its upper inner edge, moved down by half of its length.
TEST_F(PicksForOperations, APlaneIsThatOfARoundEdge) {
  const auto result = run("plane_cut", pipe(), {}, {{"plane", text("edge:1,4")}, {"offset", 0.5}});

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_NEAR(result->volume_change, -(test::polygon(16, 2) - test::polygon(16, 1)) / 2, 1e-9);
}

/// A hole of 0.2 m along z through the pipe, once more half a turn around the pipe's axis.
TEST_F(PicksForOperations, ARingGoesAroundTheAxisOfAWall) {
  const auto drilled = run("drill", pipe(), {}, {{"at", text("1.5, 0, 1")}, {"diameter", 0.2}});
  ASSERT_TRUE(drilled) << render(drilled.error());
  surface_id bore = 0;
  for (const auto& row : drilled->candidate->surfaces())
    if (row.name == "bore")
      bore = row.id;

  const auto ring =
    run("pattern", drilled->candidate, {bore},
        {{"kind", text("ring")}, {"axis", text("surface:1")}, {"count", std::int64_t{2}}});

  ASSERT_TRUE(ring) << render(ring.error());
  EXPECT_NEAR(ring->volume_change, -test::polygon(24, 0.1), 1e-8);
}

/// A square of 0.2 m along the outer edge of the pipe's end takes a ring of 0.1 x 0.1 off.
TEST_F(PicksForOperations, AProfileGoesAlongAnEdge) {
  const auto result =
    run("sweep", pipe(), {4},
        {{"path", text("edge:2,4")}, {"profile", text("rectangle")}, {"size", 0.2}});

  ASSERT_TRUE(result) << render(result.error());
  // A regular polygon of 16 sides by its apothem.
  const auto area = [](double a) { return 16 * a * a * std::tan(std::numbers::pi / 16); };
  const double outer = 2 * std::cos(std::numbers::pi / 16);
  EXPECT_NEAR(result->volume_change, -0.1 * (area(outer) - area(outer - 0.1)), 1e-7);
}

TEST_F(PicksForOperations, WhatIsNotThereIsRefusedBeforeTheOperationRuns) {
  const auto result = run("plane_cut", pipe(), {}, {{"plane", text("surface:9")}});

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::surface_not_found);
}

/// The bores of the real parts, as another program found them by a fit of its own.
TEST(Picks, BoresOfRealPartsHaveTheAxesThatAnotherFitFound) {
  int compared = 0;
  for (const auto* name : {"as1_assembly", "base_so101", "bracket_4040", "ctc01_plate", "foot_cup",
                           "fork_thin", "heatsink_125", "holes_block"}) {
    const auto part = import_mesh(parts_folder / name / (std::string(name) + ".coarse.msh"), "mm");
    ASSERT_TRUE(part) << render(part.error());
    std::ifstream in(parts_folder / name / "features.json");
    const auto features = nlohmann::json::parse(in);
    for (const auto& hole : features.at("holes")) {
      const auto at = hole.at("point").get<std::vector<double>>();
      const auto along = hole.at("axis").get<std::vector<double>>();
      const vec3 point = 1e-3 * vec3{at[0], at[1], at[2]};
      const vec3 axis = normalized({along[0], along[1], along[2]});
      const double radius = 1e-3 * hole.at("radius").get<double>();
      const auto pick = "surface:" + std::to_string(hole.at("surfaces")[0].get<surface_id>());
      const auto values = values_of(part->version, "axis", pick);
      ASSERT_TRUE(values) << name << " " << pick << ": " << render(values.error());
      const auto got = axis_of(*values, "axis");
      const vec3 d = got->point - point;
      EXPECT_LT(norm(cross(got->direction, axis)), 0.01) << name << " " << pick;
      EXPECT_LT(norm(d - dot(d, axis) * axis), 0.02 * radius) << name << " " << pick;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 49);
}

}  // namespace
}  // namespace tedit::ops
