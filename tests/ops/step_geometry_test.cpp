// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/step_geometry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/builder.hpp"
#include "ops/services/host_services.hpp"
#include "ops/shapes/walls/wall_tool.hpp"
#include "ops/tools/tools.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using kind = surface_geometry::kind;

constexpr vec3 up{0, 0, 1};

/// A ring of 1 around the z axis, so that its fillet of 0.25 touches z = 0.25 there.
surface_geometry torus(vec3 axis = up) {
  surface_geometry result{kind::torus, {}, axis, 1};
  result.tube_radius = 0.25;
  return result;
}

std::vector<vec3> circle(double radius, double height, double off = 0) {
  std::vector<vec3> points;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6;
    const double r = radius + (i == 5 ? off : 0);
    points.push_back({r * std::cos(angle), r * std::sin(angle), height});
  }
  return points;
}

TEST(StepGeometry, BesideAFilletAroundABoreIsACylinder) {
  const auto step = step_geometry(torus(), circle(1, 0.25), up);

  EXPECT_EQ(step.type, kind::cylinder);
  EXPECT_EQ(step.axis, up);
  EXPECT_NEAR(step.radius, 1, 1e-15);
  EXPECT_NEAR(step.tolerance, 0, 1e-15);
}

TEST(StepGeometry, CornersThatHaveSlidAlongASmoothRimAreTold) {
  const auto step = step_geometry(torus(), circle(1, 0.25, 6e-5), up);

  EXPECT_EQ(step.type, kind::cylinder);
  EXPECT_NEAR(step.radius, 1 + 3e-5, 1e-12);
  EXPECT_NEAR(step.tolerance, 3e-5, 1e-12);
}

TEST(StepGeometry, IsNoneWhereTheRimIsNoCircle) {
  auto both = circle(1.25, 0);
  for (const auto& p : circle(0.75, 0))
    both.push_back(p);

  EXPECT_EQ(step_geometry(torus(), both, up).type, kind::none);
  EXPECT_EQ(step_geometry(torus(), circle(1, 0.25, 3e-4), up).type, kind::none);
  EXPECT_EQ(step_geometry(torus(), {}, up).type, kind::none);
}

TEST(StepGeometry, IsNoneBesideAPlaneAndBesideARoundThatGoesAnotherWay) {
  EXPECT_EQ(step_geometry({kind::plane, {}, up}, circle(1, 0.25), up).type, kind::none);
  EXPECT_EQ(step_geometry(torus({0.6, 0, 0.8}), circle(1, 0.25), up).type, kind::none);
  EXPECT_EQ(step_geometry({kind::none}, circle(1, 0.25), up).type, kind::none);
}

/// A block with a countersunk hole of twelve facets: the sink is 0.3 wide at the top.
class StepsOfATool : public ::testing::Test {
protected:
  void SetUp() override {
    auto hole = revolve(
      make_frame({0.5, 0.5, 1}, up),
      {{0, 0.1, ""}, {0.4, 0.1, "lid"}, {0.2, -0.1, "sink"}, {0.2, -1.2, "bore"}, {0, -1.2, "end"}},
      12, 0.12);
    hole.geometries.resize(hole.names.size());
    const auto sink = std::ranges::find(hole.names, "sink") - hole.names.begin();
    hole.geometries[static_cast<std::size_t>(sink)] = {kind::cone, {0.5, 0.5, 1}, up, 0.3, 1};
    const auto host = make_host_services();
    auto cut =
      host->boolean(test::box_mesh({8, 8, 8}, {1, 1, 1}), hole, {boolean_mode::cut, 0}, {});
    ASSERT_TRUE(cut) << render(cut.error());
    part_ = cut->candidate;
  }

  expected<wall_tool> raised_top() const {
    std::vector<surface_id> top;
    for (facet_id f = 0; f < part_->facet_slots() && top.empty(); ++f)
      if (part_->is_live_facet(f) && std::ranges::all_of(part_->facet(f).v, [&](vertex_id v) {
            return part_->position(v).z == 1;
          }))
        top.push_back(part_->facet(f).surface);
    auto walls = fit_walls(*part_, top);
    return walls ? make_wall_tool(*part_, *walls, 0.05) : fail(walls.error());
  }

  version_ptr part_;
};

TEST_F(StepsOfATool, TheOneAboveACountersinkSaysThatItIsRound) {
  const auto made = raised_top();

  ASSERT_TRUE(made) << render(made.error());
  const auto& tool = made->tool;
  int steps = 0;
  for (std::size_t face = 0; face < tool.names.size(); ++face) {
    const bool is_step = tool.names[face].starts_with("step beside");
    EXPECT_EQ(tool.geometry(face).type, is_step ? kind::cylinder : kind::none) << tool.names[face];
    EXPECT_NEAR(tool.geometry(face).radius, is_step ? 0.3 : 0, 1e-12);
    steps += is_step ? 1 : 0;
  }
  EXPECT_EQ(steps, 1);
}

}  // namespace
}  // namespace tedit::ops
