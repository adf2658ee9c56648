// SPDX-License-Identifier: AGPL-3.0-or-later
// Handles of a form: which there are, where they lie, what a drag makes of a value. All numbers by
// hand: a pixel of these lenses is a tenth of a millimetre.
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "client-qt/model/catalogue.hpp"
#include "client-qt/model/handle_drag.hpp"
#include "client-qt/model/tool_ghost.hpp"

namespace tedit::desktop {

void PrintTo(const handle::kind& what, std::ostream* out) {
  *out << static_cast<int>(what);
}

namespace {

using enum ops::parameter_type;
using kind = handle::kind;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double per_metre = 1e4;

/// From above: x to the right, y up.
lens from_above() {
  lens by;
  by.to_screen = [](const vec3& p) {
    return QPointF(400 + per_metre * p.x, 300 - per_metre * p.y);
  };
  by.ray = [](QPointF at) {
    const double x = (at.x() - 400) / per_metre;
    const double y = (300 - at.y()) / per_metre;
    return std::array{vec3{x, y, 1}, vec3{x, y, -1}};
  };
  return by;
}

/// From the front: x to the right, z up.
lens from_front() {
  lens by;
  by.to_screen = [](const vec3& p) {
    return QPointF(400 + per_metre * p.x, 300 - per_metre * p.z);
  };
  by.ray = [](QPointF at) {
    const double x = (at.x() - 400) / per_metre;
    const double z = (300 - at.y()) / per_metre;
    return std::array{vec3{x, -1, z}, vec3{x, 1, z}};
  };
  by.up = {0, 0, 1};
  return by;
}

ops::parameter_description parameter(const char* id, const char* name, ops::parameter_type type,
                                     const char* unit = "") {
  ops::parameter_description p;
  p.id = id;
  p.name = name;
  p.type = type;
  p.unit = unit;
  if (type == real) {
    p.min = 0;
    p.max = 0.1;
  }
  return p;
}

/// What a plugin that nobody knows may say of itself.
ops::operation_description burr_tool() {
  ops::operation_description d;
  d.id = "try_burr";
  d.selection.minimum = 0;
  d.parameters = {parameter("start", "Start", point, "m"),
                  parameter("axis", "Tool axis", direction),
                  parameter("tool_diameter", "Tool", real, "m"),
                  parameter("tool_depth", "Depth", real, "m"),
                  parameter("relief_diameter", "Relief", real, "m"),
                  parameter("relief_depth", "Relief depth", real, "m"),
                  parameter("wall", "Wall", real, "m"),
                  parameter("speed", "Speed", real, "m/s2")};
  return d;
}

ops::parameters burr_values(double diameter, double depth) {
  return {{"start", std::string("0, 0, 0")},
          {"axis", std::string()},
          {"tool_diameter", diameter},
          {"tool_depth", depth},
          {"relief_diameter", 0.0},
          {"relief_depth", 0.0},
          {"wall", 0.001}};
}

/// On the top of a plate 20 mm thick that is 200 mm long and wide.
handle_pose on_top() {
  handle_pose pose;
  pose.bounds = {-0.1, 0.1, -0.1, 0.1, -0.02, 0};
  return pose;
}

std::vector<kind> kinds_of(const handle_plan& plan) {
  std::vector<kind> result;
  for (const auto& one : plan.all)
    result.push_back(one.what);
  return result;
}

laid_handle laid(const std::vector<laid_handle>& all, const std::string& parameter) {
  for (const auto& one : all)
    if (one.of->parameter == parameter)
      return one;
  ADD_FAILURE() << "no handle " << parameter;
  return {};
}

handle_drag drag_of(const std::vector<laid_handle>& all, const std::string& parameter,
                    const lens& by, const handle_pose& pose = on_top()) {
  const auto one = laid(all, parameter);
  return {one, pose, one.knob, by};
}

double length_of(const dragged_value& found) {
  return std::get<double>(found.value);
}

std::string vector_of(const dragged_value& found) {
  return std::get<std::string>(found.value);
}

// -- which there are ---------------------------------------------------------------------

TEST(HandlePlan, ComesFromTheDescriptionOfAnyPlugin) {
  const auto plan = plan_of(burr_tool());

  EXPECT_THAT(kinds_of(plan), ElementsAre(kind::place, kind::direction, kind::ring, kind::length,
                                          kind::ring, kind::length));
  EXPECT_TRUE(plan.find("tool_depth")->inward);
  EXPECT_TRUE(plan.find("tool_depth")->first);
  EXPECT_FALSE(plan.find("relief_depth")->first);
  EXPECT_EQ(plan.find("tool_diameter")->half, 0.5);
  EXPECT_TRUE(plan.find("axis")->either_way);
  EXPECT_EQ(plan.find("wall"), nullptr) << "nothing says which way a wall grows";
  EXPECT_FALSE(plan.is_plane);
  EXPECT_TRUE(plan.takes_wall);
}

/// As of `drill`: several places are typed or picked, one is dragged.
TEST(HandlePlan, IsTheSameWithMorePlaces) {
  auto several = burr_tool();
  several.parameters.push_back(parameter("places", "More places", polyline, "m"));

  EXPECT_THAT(kinds_of(plan_of(several)), ElementsAre(kind::place, kind::direction, kind::ring,
                                                      kind::length, kind::ring, kind::length));
}

TEST(HandlePlan, TheNameSaysWhichWayALengthGrowsBeforeTheId) {
  ops::operation_description d;
  d.parameters = {parameter("depth", "Thickness", real, "m")};
  EXPECT_FALSE(plan_of(d).find("depth")->inward);
  d.parameters = {parameter("height", "Depth", real, "m")};
  EXPECT_TRUE(plan_of(d).find("height")->inward);
  d.parameters = {parameter("offset", "By", real, "m")};
  EXPECT_TRUE(plan_of(d).find("offset")->inward);
  d.parameters = {parameter("fillet_radius", "Fillet", real, "m")};
  EXPECT_EQ(plan_of(d).find("fillet_radius")->half, 1);
}

TEST(HandlePlan, IsMadeBeforeTheNamesAreTranslated) {
  const auto all = translated({{{burr_tool(), "burr 1.0.0"}}, {}});

  ASSERT_TRUE(all.handles.contains("try_burr"));
  EXPECT_EQ(all.handles.at("try_burr").find("tool_depth")->name, "Depth");
}

// -- where they lie ----------------------------------------------------------------------

TEST(HandleLayout, KnobsStandBeyondTheEndsAndApart) {
  const auto plan = plan_of(burr_tool());
  const auto values = burr_values(0.01, 0.005);
  const auto all = lay_out(plan, values, on_top(), from_front());

  // 5 mm are 50 pixels, and the knob is 22 beyond.
  EXPECT_EQ(laid(all, "tool_depth").knob, QPointF(400, 372));
  EXPECT_EQ(laid(all, "tool_diameter").knob, QPointF(450, 300));
  EXPECT_EQ(laid(all, "axis").knob, QPointF(400, 226));
  EXPECT_EQ(laid(all, "start").knob, QPointF(400, 300));
  EXPECT_EQ(all.size(), 4U) << "a relief of 0 is left out";
  EXPECT_EQ(all.back().of->what, kind::place) << "grabbed where nothing else is";

  EXPECT_EQ(handle_at(all, {400, 383})->of->parameter, "tool_depth") << "11 pixels off";
  EXPECT_EQ(handle_at(all, {400, 385}), nullptr);
  EXPECT_EQ(words_of(laid(all, "tool_depth"), values), "Depth 5 mm");
}

TEST(HandleLayout, AnAxisIsShorterWhereTheViewEnds) {
  const auto plan = plan_of(burr_tool());
  auto by = from_front();
  by.room = {800, 600};
  auto pose = on_top();
  pose.frame.at = {0, 0, 0.024};  // 60 pixels below the upper edge.

  EXPECT_EQ(laid(lay_out(plan, burr_values(0.01, 0.005), pose, by), "axis").knob, QPointF(400, 24));
}

TEST(HandleLayout, AnArrowThatLooksAtTheViewerCanBeGrabbedAndDraggedUpward) {
  const auto plan = plan_of(burr_tool());
  const auto all = lay_out(plan, burr_values(0.01, 0.005), on_top(), from_above());

  EXPECT_EQ(laid(all, "tool_depth").knob, QPointF(400, 278));
  const auto drag = drag_of(all, "tool_depth", from_above());
  EXPECT_NEAR(length_of(drag_to(drag, {400, 258}, false)), 0.007, 1e-12);
}

// -- what a drag makes -------------------------------------------------------------------

TEST(HandleDrag, ALengthGoesByRoundSteps) {
  const auto plan = plan_of(burr_tool());
  const auto all = lay_out(plan, burr_values(0.01, 0.005), on_top(), from_front());
  const auto drag = drag_of(all, "tool_depth", from_front());

  EXPECT_NEAR(length_of(drag_to(drag, {400, 412}, false)), 0.009, 1e-12);
  EXPECT_NEAR(length_of(drag_to(drag, {460, 412.4}, false)), 0.009, 1e-12) << "only along it";
  EXPECT_NEAR(length_of(drag_to(drag, {400, 412.4}, true)), 0.00904, 1e-12);
  EXPECT_EQ(length_of(drag_to(drag, {400, 200}, false)), 0) << "its least value";
  EXPECT_EQ(length_of(drag_to(drag, {400, 2000}, false)), 0.1) << "its largest";
}

TEST(HandleDrag, ARingFollowsThePointersDistance) {
  const auto plan = plan_of(burr_tool());
  const auto all = lay_out(plan, burr_values(0.01, 0.005), on_top(), from_above());
  const auto drag = drag_of(all, "tool_diameter", from_above());

  EXPECT_NEAR(length_of(drag_to(drag, {480, 300}, false)), 0.016, 1e-12);
  EXPECT_NEAR(length_of(drag_to(drag, {400, 220}, false)), 0.016, 1e-12) << "all around";
}

TEST(HandleDrag, ADirectionLocksInOnAxesAndOnTheWall) {
  const auto plan = plan_of(burr_tool());
  const auto all = lay_out(plan, burr_values(0.01, 0.005), on_top(), from_front());
  const auto drag = drag_of(all, "axis", from_front());  // 74 pixels above.

  EXPECT_EQ(vector_of(drag_to(drag, {500, 303}, false)), "1, 0, 0");
  EXPECT_EQ(drag_to(drag, {500, 303}, false).snapped, "along x");
  EXPECT_EQ(vector_of(drag_to(drag, {500, 200}, false)), "0.707, 0, 0.707");
  EXPECT_EQ(vector_of(drag_to(drag, {402, 200}, false)), "")
    << "across the wall, as if never given";
  EXPECT_EQ(vector_of(drag_to(drag, {500, 300}, true)), "1, 0, 0");
  EXPECT_EQ(drag_to(drag, {500, 300}, true).snapped, "");
}

TEST(HandleDrag, AWayLocksInOnAxes) {
  ops::operation_description d;
  d.parameters = {parameter("by", "By", vector, "m")};
  const auto plan = plan_of(d);
  const ops::parameters values{{"by", std::string("0, 0, 0")}};
  const auto all = lay_out(plan, values, on_top(), from_above());
  EXPECT_EQ(laid(all, "by").knob, QPointF(430, 300)) << "beside what it moves";
  const auto drag = drag_of(all, "by", from_above());

  EXPECT_EQ(vector_of(drag_to(drag, {480, 280}, false)), "0.005, 0.002, 0");
  EXPECT_EQ(vector_of(drag_to(drag, {480, 297}, false)), "0.005, 0, 0");
  EXPECT_EQ(drag_to(drag, {480, 297}, false).snapped, "along x");
  EXPECT_EQ(vector_of(drag_to(drag, {480, 297}, true)), "0.005, 0.0003, 0");
}

/// From 45 degrees above: a pixel upward on the screen is 1.41 tenths of a millimetre of the wall.
TEST(HandleDrag, ABoreIsMovedOverItsWall) {
  ops::operation_description d;
  d.parameters = {parameter("by", "By", vector, "m")};
  const auto plan = plan_of(d);
  const double c = std::sqrt(0.5);
  lens by;
  by.to_screen = [c](const vec3& p) {
    return QPointF(400 + per_metre * p.x, 300 - per_metre * c * (p.y + p.z));
  };
  by.up = {0, c, c};
  by.ray = [c](QPointF at) {
    const vec3 on =
      (at.x() - 400) / per_metre * vec3{1, 0, 0} + (300 - at.y()) / per_metre * vec3{0, c, c};
    return std::array{on + vec3{0, -c, c}, on + vec3{0, c, -c}};
  };
  auto pose = on_top();
  pose.axis = vec3{0, 0, 1};
  const auto drag =
    drag_of(lay_out(plan, {{"by", std::string("0, 0, 0")}}, pose, by), "by", by, pose);

  EXPECT_EQ(vector_of(drag_to(drag, {480, 300 - 100 * c}, false)), "0.005, 0.01, 0");
}

TEST(HandleDrag, AProfileIsTurnedAndStretched) {
  ops::operation_description d;
  auto profile = parameter("profile", "Profile", choice);
  profile.choices = {"circle", "rectangle"};
  d.parameters = {parameter("at", "Place", point, "m"), profile,
                  parameter("size", "Size", real, "m"), parameter("width", "Width", real, "m"),
                  parameter("along", "Along", direction)};
  const auto plan = plan_of(d);
  const ops::parameters values{{"at", std::string("0, 0, 0")},
                               {"profile", std::string("rectangle")},
                               {"size", 0.02},
                               {"width", 0.008},
                               {"along", std::string()}};
  handle_pose pose = on_top();
  const auto all = lay_out(plan, values, pose, from_above());

  EXPECT_EQ(laid(all, "size").knob, QPointF(500, 300));
  EXPECT_EQ(laid(all, "width").knob, QPointF(400, 260));
  EXPECT_EQ(laid(all, "along").knob, QPointF(530, 300)) << "beyond the size's";
  EXPECT_NEAR(length_of(drag_to(drag_of(all, "size", from_above()), {520, 300}, false)), 0.024,
              1e-12);
  EXPECT_NEAR(length_of(drag_to(drag_of(all, "width", from_above()), {400, 250}, false)), 0.01,
              1e-12);
  const auto turn = drag_of(all, "along", from_above());
  EXPECT_EQ(vector_of(drag_to(turn, {402, 200}, false)), "0, 1, 0");
  EXPECT_EQ(vector_of(drag_to(turn, {500, 200}, false)), "0.707, 0.707, 0");
}

// -- the geometry under it ---------------------------------------------------------------

TEST(HandleLens, MeetsAxesPlanesAndSpheres) {
  const std::array across{vec3{3, -1, 5}, vec3{3, 1, 5}};
  EXPECT_NEAR(*along_axis(across, {0, 0, 1}, {0, 0, 1}), 4, 1e-12);
  EXPECT_FALSE(along_axis(across, {0, 0, 0}, {0, 1, 0})) << "it looks along the axis";
  EXPECT_EQ(*on_plane(across, {0, 0.5, 0}, {0, 1, 0}), (vec3{3, 0.5, 5}));
  EXPECT_FALSE(on_plane(across, {0, 0, 0}, {1, 0, 0}));
  EXPECT_EQ(on_sphere(across, {3, 10, 5}, 2, true), (vec3{3, 8, 5}));
  EXPECT_EQ(on_sphere(across, {3, 10, 5}, 2, false), (vec3{3, 12, 5}));
  EXPECT_EQ(on_sphere(across, {0, 0, 5}, 2, true), (vec3{2, 0, 5})) << "beside it";
}

TEST(HandleLens, StepsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(drag_step(1e-4), 1e-4);
  EXPECT_DOUBLE_EQ(drag_step(1.1e-4), 2e-4);
  EXPECT_DOUBLE_EQ(drag_step(3e-4), 5e-4);
  EXPECT_DOUBLE_EQ(drag_step(6e-4), 1e-3);
}

// -- the ghost ---------------------------------------------------------------------------

TEST(ToolGhost, IsACylinderOfDiameterAndDepth) {
  auto values = burr_values(0.01, 0.005);
  const auto bodies = ghost_of(plan_of(burr_tool()), values, on_top());

  ASSERT_EQ(bodies.size(), 1U);
  ASSERT_EQ(bodies[0].bottom.size(), 48U);
  EXPECT_NEAR(bodies[0].bottom[0].x, 0.005, 1e-12);
  EXPECT_NEAR(bodies[0].bottom[12].y, 0.005, 1e-12);
  EXPECT_NEAR(bodies[0].top[0].z, -0.005, 1e-12);

  values["tool_depth"] = 0.0;
  EXPECT_NEAR(ghost_of(plan_of(burr_tool()), values, on_top())[0].top[0].z, -0.02, 1e-12)
    << "through all there is";
  values["relief_diameter"] = 0.02;
  values["relief_depth"] = 0.001;
  EXPECT_EQ(ghost_of(plan_of(burr_tool()), values, on_top()).size(), 2U);
}

/// The 48-gon's area at radius 1.
const double gon = 24 * std::sin(std::numbers::pi / 24);

/// Of a body between two regular polygons of 48 corners, or a polygon and a point: the
/// prismatoid's.
double volume_of(const ghost_body& body) {
  const auto radius = [](const std::vector<vec3>& rim) {
    return rim.size() == 1 ? 0 : std::hypot(rim[0].x, rim[0].y);
  };
  const double a = radius(body.bottom);
  const double b = radius(body.top);
  const double height = std::abs(body.top[0].z - body.bottom[0].z);
  return gon * height * (a * a + a * b + b * b) / 3;
}

double volume_of(const std::vector<ghost_body>& bodies) {
  double sum = 0;
  for (const auto& body : bodies)
    sum += volume_of(body);
  return sum;
}

ops::parameter_description angle_parameter(const char* id) {
  return parameter(id, id, real, "rad");
}

TEST(ToolGhost, OfACountersunkHoleWithATipHasItsVolume) {
  auto about = burr_tool();
  about.parameters.push_back(parameter("sink_diameter", "Sink", real, "m"));
  about.parameters.push_back(angle_parameter("sink_angle"));
  about.parameters.push_back(angle_parameter("tip_angle"));
  const auto plan = plan_of(about);
  // 6 mm and 12 mm deep, a sink of 12 mm and 90 degrees, a tip of 2 atan(3/2): 2 mm high.
  auto values = burr_values(0.006, 0.012);
  values["sink_diameter"] = 0.012;
  values["sink_angle"] = std::numbers::pi / 2;
  values["tip_angle"] = 2 * std::atan(1.5);
  const auto bodies = ghost_of(plan, values, on_top());

  ASSERT_EQ(bodies.size(), 3U) << "the sink, the bore below it, the tip";
  // In mm: a frustum of radii 6 and 3 and 3 high, a cylinder of 9, a cone of 2.
  EXPECT_NEAR(1e9 * volume_of(bodies), gon * (63 + 81 + 6), 1e-9);
  EXPECT_NEAR(bodies[0].top[0].z, -0.003, 1e-15);
  ASSERT_EQ(bodies[2].top.size(), 1U);
  EXPECT_NEAR(bodies[2].top[0].z, -0.014, 1e-15);

  values["tool_depth"] = 0.0;
  EXPECT_EQ(ghost_of(plan, values, on_top()).size(), 2U) << "a hole through has no tip";
}

TEST(ToolGhost, OfACounterboreIsAStepAndOfAThreadItsCore) {
  auto about = burr_tool();
  auto thread = parameter("thread", "For a thread", choice);
  thread.choices = {"none", "M5", "M6"};
  about.parameters.push_back(thread);
  auto values = burr_values(0.02, 0.010);
  values["relief_diameter"] = 0.010;
  values["relief_depth"] = 0.004;
  values["thread"] = std::string("M6");
  const auto bodies = ghost_of(plan_of(about), values, on_top());

  // M6 is drilled with 5 mm. 4 mm of radius 5, 6 mm of 2.5.
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_NEAR(1e9 * volume_of(bodies), gon * (100 + 37.5), 1e-9);
  values["thread"] = std::string("none");
  EXPECT_NEAR(ghost_of(plan_of(about), values, on_top())[0].bottom[0].x, 0.01, 1e-12);
}

TEST(ToolGhost, OfATextIsABoxOfItsLength) {
  ops::operation_description d;
  d.parameters = {parameter("at", "Place", point, "m"), parameter("text", "Text", text),
                  parameter("size", "Letter height", real, "m"),
                  parameter("height", "Height", real, "m")};
  const auto plan = plan_of(d);
  ops::parameters values{{"text", std::string("TEdit")}, {"size", 0.01}, {"height", -0.001}};
  const auto bodies = ghost_of(plan, values, on_top());

  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_NEAR(bodies[0].bottom[2].x, 0.0215, 1e-12) << "half of five letters of 8.6 mm";
  EXPECT_NEAR(bodies[0].bottom[2].y, 0.005, 1e-12);
  EXPECT_NEAR(bodies[0].top[0].z, -0.001, 1e-12) << "sunk";
  values["file"] = std::string("a logo");
  EXPECT_THAT(ghost_of(plan, values, on_top()), IsEmpty());
}

TEST(ToolGhost, OfAPlaneIsASquareThatIsMovedAgainstItsNormal) {
  ops::operation_description d;
  auto offset = parameter("offset", "Offset", real, "m");
  offset.min = -1;
  d.parameters = {parameter("at", "Place", point, "m"), parameter("normal", "Normal", direction),
                  offset};
  const auto plan = plan_of(d);
  ASSERT_TRUE(plan.is_plane);

  const auto bodies = ghost_of(plan, {{"offset", 0.003}}, on_top());

  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_THAT(bodies[0].top, IsEmpty());
  ASSERT_EQ(bodies[0].bottom.size(), 4U);
  for (const auto& p : bodies[0].bottom)
    EXPECT_NEAR(p.z, -0.003, 1e-12);
}

TEST(ToolGhost, OfAProfileIsAPrism) {
  ops::operation_description d;
  auto profile = parameter("profile", "Profile", choice);
  d.parameters = {parameter("at", "Place", point, "m"), profile,
                  parameter("size", "Size", real, "m"), parameter("height", "Height", real, "m")};
  const auto plan = plan_of(d);
  ops::parameters values{{"profile", std::string("slot")}, {"size", 0.02}, {"height", 0.003}};

  const auto slot = ghost_of(plan, values, on_top());
  ASSERT_EQ(slot.size(), 1U);
  EXPECT_NEAR(slot[0].top[0].z, 0.003, 1e-12);
  EXPECT_NEAR(slot[0].bottom[0].x, 0.005, 1e-12);  // Half as wide as long: arcs of 5 mm.
  EXPECT_NEAR(slot[0].bottom[12].x, 0.01, 1e-12);
  values["profile"] = std::string("polygon");
  values["corners"] = std::int64_t{6};
  EXPECT_EQ(ghost_of(plan, values, on_top())[0].bottom.size(), 6U);
  values["profile"] = std::string("file");
  EXPECT_THAT(ghost_of(plan, values, on_top()), IsEmpty());
}

}  // namespace
}  // namespace tedit::desktop
