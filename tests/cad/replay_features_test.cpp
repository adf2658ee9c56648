// SPDX-License-Identifier: AGPL-3.0-or-later
// Letters, ribs, shells, copies of features and shapes of files on the CAD model.
#include <numbers>
#include <numeric>
#include <set>

#include "base/attachment.hpp"
#include "cad/edited_surface.hpp"
#include "tests/cad/replayed_part.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

double volume_of(const cad::cad_model& model) {
  return std::accumulate(model.facts.solids.begin(), model.facts.solids.end(), 0.0,
                         [](double sum, const auto& solid) { return sum + solid.volume_mm3; });
}

std::set<surface_id> ids_of(const mesh_version& mesh) {
  std::set<surface_id> ids;
  for (const auto& row : mesh.surfaces())
    if (!facets_of(mesh, std::array{row.id}).empty())
      ids.insert(row.id);
  return ids;
}

std::set<surface_id> ids_of(const cad::cad_model& model) {
  std::set<surface_id> ids;
  for (const auto& face : model.facts.faces)
    ids.insert(face.ids.begin(), face.ids.end());
  return ids;
}

edit_request text_on_top(const std::string& text, double height_mm) {
  return {"emboss",
          {},
          {{"at", std::string("0.005,0.01,0.03")},
           {"direction", std::string("0,0,1")},
           {"text", text},
           {"size", 0.003},
           {"height", 1e-3 * height_mm}},
          {}};
}

std::string file_text(const std::string& name, const std::string& bytes) {
  return attachment_text({name, bytes});
}

/// A box by its corners, mm, as an OBJ of 12 triangles.
std::string box_obj(std::array<double, 3> low, std::array<double, 3> high) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    text += "v";
    for (std::size_t k = 0; k < 3; ++k)
      text += " " + std::to_string((i >> k & 1) != 0 ? high[k] : low[k]);
    text += "\n";
  }
  return text +
         "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\n"
         "f 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";
}

edit_request combination(const std::string& mode, const std::string& obj) {
  return {"combine", {}, {{"file", file_text("shape.obj", obj)}, {"mode", mode}}, {}};
}

constexpr double box_mm3 = 10.0 * 20 * 30;

class ReplayFeatures : public Replay {
protected:
  /// On the mesh and on the model: the same shape, with the same surfaces.
  cad::replayed_edit same(const edit_request& wanted) {
    last_ = edit(wanted);
    auto result = replay(wanted, last_);
    EXPECT_TRUE(result.verdict.is_same) << wanted.operation << ": " << result.verdict.reason;
    if (result.verdict.is_same) {
      EXPECT_EQ(ids_of(result.model), ids_of(*last_.version));
      EXPECT_LT(result.ms, 20'000);
    }
    return result;
  }

  /// The same, and the part goes on so.
  cad::replayed_edit go(const edit_request& wanted) {
    auto result = same(wanted);
    go_on(last_, result);
    return result;
  }

  /// The surface all of whose corners have one coordinate (m).
  [[nodiscard]] surface_id surface_in_plane(int axis, double at) const {
    for (const auto& row : mesh_->surfaces())
      if (std::ranges::all_of(facets_of(*mesh_, std::array{row.id}), [&](facet_id f) {
            return std::ranges::all_of(mesh_->facet(f).v, [&](vertex_id v) {
              const vec3 p = mesh_->position(v);
              return std::abs((axis == 0 ? p.x : axis == 1 ? p.y : p.z) - at) < 1e-9;
            });
          }))
        return row.id;
    ADD_FAILURE() << "no surface is there";
    return 0;
  }

  checked_edit last_;
};

/// Letters are polygons in the mesh: the model has the same volume up to rounding.
TEST_F(ReplayFeatures, LettersAndTheirHolesAreRaisedAndSunk) {
  for (const double height : {0.5, -0.5}) {
    const auto result = same(text_on_top("A8", height));

    EXPECT_NEAR(volume_of(result.model), 1e9 * total_volume(*last_.version), 1e-7);
    EXPECT_GT(std::abs(volume_of(result.model) - box_mm3), 1);
    EXPECT_GT(result.model.facts.faces.size(), 40U);
  }
}

/// 6 x 6 mm with a hole of 3 x 3 mm, and a square of 1 x 1 mm in that.
TEST_F(ReplayFeatures, OutlinesInEachOtherAreRingsAndIslands) {
  const std::string squares =
    "<svg xmlns='http://www.w3.org/2000/svg'><rect width='6' height='6'/>"
    "<rect x='1.5' y='1.5' width='3' height='3'/><rect x='2.5' y='2.5' width='1' "
    "height='1'/></svg>";
  for (const std::string operation : {"pocket", "boss"}) {
    const auto result = same({operation,
                              {},
                              {{"at", std::string("0.005,0.01,0.03")},
                               {"direction", std::string("0,0,1")},
                               {"profile", std::string("file")},
                               {"file", file_text("squares.svg", squares)},
                               {"size", 0.006},
                               {"height", 0.002}},
                              {}});

    const double change = (36 - 9 + 1) * 2;
    EXPECT_NEAR(volume_of(result.model), box_mm3 + (operation == "boss" ? change : -change), 1e-7);
  }
}

/// The corners (2, 2), (8, 2), (2, 14) mm, 2 mm deep; a plane at 12 mm; a groove of 2 x 2 mm over
/// the whole top.
TEST_F(ReplayFeatures, AnOutlineAPlaneAndAPathAreMadeOnTheModel) {
  const auto corners = std::string("0.002,0.002,0.03; 0.008,0.002,0.03; 0.002,0.014,0.03");
  const auto pocket = same({"pocket",
                            {},
                            {{"profile", std::string("points")},
                             {"points", corners},
                             {"direction", std::string("0,0,1")},
                             {"height", 0.002}},
                            {}});
  const auto cut = same({"plane_cut", {}, {{"plane", std::string("0, 0, 0.012; 0, 0, 1")}}, {}});
  const auto groove = same({"sweep",
                            {},
                            {{"path", std::string("0.005,-0.002,0.03; 0.005,0.022,0.03")},
                             {"profile", std::string("rectangle")},
                             {"size", 0.002},
                             {"height", 0.004}},
                            {}});

  EXPECT_NEAR(volume_of(pocket.model), box_mm3 - 0.5 * 6 * 12 * 2, 1e-7);
  EXPECT_NEAR(volume_of(cut.model), 10 * 20 * 12, 1e-7);
  EXPECT_NEAR(volume_of(groove.model), box_mm3 - 2 * 2 * 20, 1e-7);
}

/// Two holes of 2 mm and three squares of 1 mm, 3 mm deep, each as one edit.
TEST_F(ReplayFeatures, AToolAtSeveralPlacesIsOneEdit) {
  const auto holes = same({"drill",
                           {},
                           {{"places", std::string("0.003,0.005,0.03; 0.007,0.015,0.03")},
                            {"direction", std::string("0,0,1")},
                            {"diameter", 0.002},
                            {"depth", 0.003}},
                           {}});
  const auto squares = same({"boss",
                             {},
                             {{"profile", std::string("rectangle")},
                              {"at", std::string("0.002,0.004,0.03")},
                              {"places", std::string("0.005,0.01,0.03; 0.008,0.016,0.03")},
                              {"direction", std::string("0,0,1")},
                              {"size", 0.001},
                              {"height", 0.003}},
                             {}});

  EXPECT_NEAR(volume_of(holes.model), box_mm3 - 2 * 3 * std::numbers::pi, 1e-6);
  EXPECT_NEAR(volume_of(squares.model), box_mm3 + 3 * 3, 1e-7);
}

/// A boss of 8 x 8 x 2 mm on the wall x = 0 whose side y = 14 has a fillet of 1.2 mm at its foot:
/// what is left of the side is smaller than the fillet, which stays, and is run into.
TEST_F(ReplayFeatures, AWallThatIsThickenedRunsIntoAFilletThatStays) {
  (void)go({"boss",
            {1},
            {{"profile", std::string("rectangle")},
             {"at", std::string("0,0.01,0.015")},
             {"size", 0.008},
             {"width", 0.008},
             {"height", 0.002}},
            {}});
  const auto side = surface_in_plane(1, 0.014);
  (void)go({"close", {1, side}, {{"radius", 0.0012}}, {}});
  const auto fillet = mesh_->surfaces().back().id;

  const auto result = go({"thicken", {side}, {{"depth", 0.0005}}, {}});

  EXPECT_THAT(result.verdict.how, ::testing::StartsWith("slab"));
  // Between the arc of the fillet and its upper edge, from 0.7 to 1.2 mm before its axis.
  const double filled =
    0.72 * (std::numbers::pi / 2 - std::asin(0.7 / 1.2)) - 0.35 * std::sqrt(1.44 - 0.49);
  EXPECT_NEAR(
    volume_of(result.model),
    box_mm3 + 8 * 8 * 2 + 8 * 1.44 * (1 - std::numbers::pi / 4) + 8 * (0.8 * 0.5 + filled), 1e-6);
  for (const auto f : facets_of(*mesh_, std::array{fillet}))
    for (const auto v : mesh_->facet(f).v) {
      const vec3 p = mesh_->position(v);
      EXPECT_NEAR(std::hypot(p.x + 0.0012, p.y - 0.0152), 0.0012, 1e-12);
    }
}

/// Rounds of 2 mm go along with the wall between; what they end at leans by 2.3 degrees, so that
/// their corners come to lie 0.04 mm higher, and nowhere beside the edge where both run on
/// smoothly.
TEST_F(ReplayFeatures, ARoundThatGoesAlongEndsAtAPlaneThatLeans) {
  (void)go({"open", {1, 3}, {{"radius", 0.002}}, {}});
  (void)go({"plane_cut",
            {},
            {{"at", std::string("0,0.01,0.028")}, {"normal", std::string("0.04,0,1")}},
            {}});
  const double before = volume_of(model_);

  const auto result = go({"thicken", {1}, {{"depth", 0.001}}, {}});

  EXPECT_EQ(result.verdict.how, "in place");
  // 1 mm by 20 mm, 28.02 mm high in the mean; the corner that the round leaves out is higher, too.
  const double corner = 4 * (1 - std::numbers::pi / 4);
  EXPECT_NEAR(volume_of(result.model) - before, 20 * 28.02 - 0.04 * corner, 1e-6);
}

/// A step of 4 mm on the box, and a triangle of 3 x 3 mm, 1 mm thick, in its corner.
TEST_F(ReplayFeatures, ARibStandsInACorner) {
  const auto step = same(combination("add", box_obj({0, 0, 30}, {10, 8, 34})));
  EXPECT_NEAR(volume_of(step.model), box_mm3 + 10 * 8 * 4, 1e-7);
  surface_id side = 0;
  surface_id top = 0;
  for (const auto& face : step.model.facts.faces) {
    if (std::abs(face.area_mm2 - 10 * 12) < 1e-6)
      top = face.ids.at(0);
    if (std::abs(face.area_mm2 - 10 * 4) < 1e-6)
      side = face.ids.at(0);
  }
  go_on(last_, step);

  const auto result =
    same({"rib",
          {side, top},
          {{"thickness", 0.001}, {"size", 0.003}, {"at", std::string("0.005,0.008,0.03")}},
          {}});

  EXPECT_NEAR(volume_of(result.model), box_mm3 + 10 * 8 * 4 + 0.5 * 3 * 3 * 1, 1e-7);
}

TEST_F(ReplayFeatures, AShapeOfAFileIsAddedCutAndIntersected) {
  const auto corner = box_obj({5, 5, 25}, {15, 15, 35});
  EXPECT_NEAR(volume_of(same(combination("add", corner)).model), box_mm3 + 1000 - 5 * 10 * 5, 1e-7);
  EXPECT_NEAR(volume_of(same(combination("cut", corner)).model), box_mm3 - 5 * 10 * 5, 1e-7);
  EXPECT_NEAR(volume_of(same(combination("intersect", corner)).model), 5 * 10 * 5, 1e-7);
}

TEST_F(ReplayFeatures, AFileOfMoreTrianglesThanACadModelTakesIsSaid) {
  // A pyramid with a foot of 1200 corners.
  std::string obj = "v 5 10 32\nv 5 10 28\n";
  constexpr int corners = 1200;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    obj += "v " + std::to_string(5 + 2 * std::cos(angle)) + " " +
           std::to_string(10 + 2 * std::sin(angle)) + " 29\n";
  }
  for (int i = 0; i < corners; ++i) {
    const auto a = std::to_string(3 + i);
    const auto b = std::to_string(3 + (i + 1) % corners);
    obj += "f 1 " + a + " " + b + "\nf 2 " + b + " " + a + "\n";
  }
  const auto wanted = combination("add", obj);
  checked_edit made;
  made.version = mesh_;

  const auto result = replay(wanted, made);

  EXPECT_FALSE(result.verdict.is_same);
  EXPECT_THAT(result.verdict.reason, HasSubstr("2400 triangles"));
}

TEST_F(ReplayFeatures, AShellWithAVoidOrWithAnOpenWall) {
  const edit_request closed{"hollow", {}, {{"thickness", 0.002}}, {}};
  EXPECT_NEAR(volume_of(same(closed).model), box_mm3 - 6 * 16 * 26, 1e-6);
  const edit_request open{"hollow", {1}, {{"thickness", 0.002}}, {}};
  EXPECT_NEAR(volume_of(same(open).model), box_mm3 - 8 * 16 * 26, 1e-6);
  const edit_request drained{"hollow", {1}, {{"thickness", 0.002}, {"drain_diameter", 0.003}}, {}};
  EXPECT_NEAR(volume_of(same(drained).model),
              box_mm3 - 6 * 16 * 26 - std::numbers::pi * 1.5 * 1.5 * 2, 1e-6);
}

TEST_F(ReplayFeatures, ACutThatKeepsBothSidesMakesTwoSolids) {
  const edit_request wanted{"plane_cut",
                            {},
                            {{"at", std::string("0.005,0.01,0.01")},
                             {"normal", std::string("0,0,1")},
                             {"keep", std::string("both")}},
                            {}};
  const auto result = same(wanted);

  ASSERT_EQ(result.model.facts.solids.size(), 2U);
  std::set<int> volumes;
  for (const auto& solid : result.model.facts.solids)
    volumes.insert(static_cast<int>(std::lround(solid.volume_mm3)));
  EXPECT_EQ(volumes, (std::set<int>{2000, 4000}));
  // The two faces in the cut are a surface each, the four walls around belong to both.
  for (const auto& face : result.model.facts.faces)
    EXPECT_EQ(face.ids.size(), 1U);
  EXPECT_EQ(result.model.facts.faces.size(), 12U);
}

/// The half above has other vertices then, in the same places.
TEST_F(ReplayFeatures, WhatACutDoesNotMeetIsNothingThatItHasMade) {
  const auto made = edit({"plane_cut",
                          {},
                          {{"at", std::string("0.005,0.01,0.01")},
                           {"normal", std::string("0,0,1")},
                           {"keep", std::string("both")}},
                          {}});
  const auto surface = cad::surface_after(*mesh_, *made.version);
  std::size_t far = 0;
  for (const auto& t : surface.triangles) {
    double low = 30;
    for (int k = 0; k < 3; ++k)
      low = std::min(low, surface.points[static_cast<std::size_t>(t[k])][2]);
    if (low > 28) {
      ++far;
      EXPECT_EQ(t[4], cad::triangle_kept) << t[3];
    }
  }
  EXPECT_GT(far, 10u);
  EXPECT_LT(surface.fresh, surface.points.size() / 2);
}

TEST_F(ReplayFeatures, AnotherShapeThanTheMeshIsRefused) {
  const auto corner = combination("add", box_obj({5, 5, 25}, {15, 15, 35}));
  const auto beside = combination("add", box_obj({5, 5, 25}, {15, 15.01, 35}));
  const auto cut = combination("cut", box_obj({5, 5, 25}, {15, 15, 35}));
  const edit_request thin{"hollow", {}, {{"thickness", 0.002}}, {}};
  const edit_request thick{"hollow", {}, {{"thickness", 0.00201}}, {}};
  const edit_request open{"hollow", {1}, {{"thickness", 0.002}}, {}};
  auto plane = edit_request{"plane_cut",
                            {},
                            {{"at", std::string("0.005,0.01,0.01")},
                             {"normal", std::string("0,0,1")},
                             {"keep", std::string("both")}},
                            {}};
  auto higher = plane;
  higher.parameters["at"] = std::string("0.005,0.01,0.01001");
  for (const auto& [asked, is] : {std::pair{text_on_top("A8", 0.5), text_on_top("A8", 0.501)},
                                  {text_on_top("A8", 0.5), text_on_top("A3", 0.5)},
                                  {text_on_top("I", 0.5), text_on_top("I", -0.5)},
                                  {corner, beside},
                                  {cut, corner},
                                  {thin, thick},
                                  {open, thin},
                                  {plane, higher}}) {
    const auto result = replay(asked, edit(is));
    EXPECT_FALSE(result.verdict.is_same) << asked.operation << " for " << is.operation;
    EXPECT_NE(result.verdict.reason, "");
    EXPECT_TRUE(result.model.shape == nullptr);
  }
}

/// 25.4 x 50.8 x 76.2 mm with a blind hole: walls 8 and 9, bottom 1.
class ReplayCopies : public ReplayFeatures {
protected:
  void SetUp() override {
    TEDIT_NEEDS_CAD();
    open("inch_block.stp");
  }

  static edit_request moved(const std::string& by, bool copy = false) {
    return {"move", {8}, {{"by", by}, {"copy", copy}}, {}};
  }
};

TEST_F(ReplayCopies, AHoleThatMovesLeavesTheBlockAsLarge) {
  const double before = volume_of(model_);
  const auto faces = model_.facts.faces.size();

  const auto result = same(moved("0,0.003,0.002"));

  EXPECT_EQ(result.model.facts.faces.size(), faces);  // Both halves of its wall, too.
  EXPECT_NEAR(volume_of(result.model), before, 1e-4);
}

TEST_F(ReplayCopies, ACopyAndARowOfHolesTakeAsMuchEach) {
  const double before = volume_of(model_);
  const double hole = 25.4 * 50.8 * 76.2 - before;

  EXPECT_NEAR(volume_of(same(moved("0,0.009,0", true)).model), before - hole, 1e-4);
  const auto row = same({"pattern",
                         {8},
                         {{"count", std::int64_t{2}},
                          {"step", std::string("0,0.009,0")},
                          {"rows", std::int64_t{2}},
                          {"row_step", std::string("0,0,0.015")}},
                         {}});
  EXPECT_NEAR(volume_of(row.model), before - 3 * hole, 1e-4);
}

TEST_F(ReplayCopies, AnotherPlaceIsRefused) {
  for (const auto& [asked, is] : {std::pair{moved("0,0.009,0"), moved("0,0.00901,0")},
                                  {moved("0,0.009,0", true), moved("0,0.009,0")}}) {
    const auto result = replay(asked, edit(is));
    EXPECT_FALSE(result.verdict.is_same);
    EXPECT_NE(result.verdict.reason, "");
  }
}

/// As docs/cad.md tells it: from a STEP file to a STEP file.
class BracketStory : public ::testing::Test {
protected:
  void SetUp() override { TEDIT_NEEDS_CAD(); }

  static json done(const std::string& arguments) {
    const auto result = run(arguments + " --json");
    EXPECT_EQ(result.status, 0) << arguments << "\n" << result.out;
    return result.parsed();
  }

  /// The document after it.
  std::string same(const std::string& edit) {
    const auto next = scratch("p" + std::to_string(++count_) + ".tedit").string();
    std::filesystem::remove(next);
    const auto made = done("edit " + now_ + " --op " + edit + " -o " + next);
    EXPECT_EQ(made["cad"]["status"], "same") << edit << "\n" << made["cad"];
    EXPECT_LT(made["cad"]["deviation_m"].get<double>(), 1e-6 * 0.127);
    change_ = made["volume_change_m3"].get<double>();
    return now_ = next;
  }

  std::string now_;
  int count_ = 0;
  double change_ = 0;
};

TEST_F(BracketStory, ANameTwoMovedHolesAndARibComeBackAsStep) {
  now_ = scratch("p0.tedit").string();
  std::filesystem::remove(now_);
  const auto part = done("import " + cad_parts + "l_bracket.stp --size coarse -o " + now_);
  same(
    "emboss --surfaces 8 --param text=TEdit --param size_mm=6 --param height_mm=0.6 "
    "--param at_mm=0,53,10 --param up=0,1,0");
  const double letters = change_;
  same("move --surfaces 13 --param by_mm=-25,-5,0");
  same("move --surfaces 15 --param by_mm=25,0,5");
  same("rib --surfaces 5,8 --param thickness_mm=6 --param size_mm=15 --param at_mm=0,10,10");
  const auto step = scratch("p.step").string();
  done("export " + now_ + " -o " + step);
  const auto again = import_part(step + " --size coarse");

  EXPECT_GT(letters, 1e-8);
  const double rib = 1e-9 * 15 * 15 / 2 * 6;
  EXPECT_NEAR(again["cad_volume_m3"].get<double>(),
              part["cad_volume_m3"].get<double>() + letters + rib, 1e-13);
  std::set<int> ids;
  for (const auto& surface : again["surfaces"])
    ids.insert(surface["id"].get<int>());
  EXPECT_EQ(ids.size(), 21U);
  EXPECT_EQ(*ids.begin(), 1);
  EXPECT_EQ(*ids.rbegin(), 21);
  std::set<std::string> names;
  for (const auto& surface : again["surfaces"])
    names.insert(surface["name"].get<std::string>());
  EXPECT_TRUE(names.contains("text side") && names.contains("text top") &&
              names.contains("rib top"))
    << again["surfaces"];
}

}  // namespace
}  // namespace tedit::test
