// SPDX-License-Identifier: AGPL-3.0-or-later
// Edits of the mesh that are made on the CAD model, too: only where both are the same.
#include <map>
#include <numbers>
#include <set>

#include "mesh/features/exact_wall.hpp"
#include "tests/cad/replayed_part.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

/// 4 x 4 mm and 3 mm deep, in the wall z = 30.
const edit_request pocket{"pocket",
                          {},
                          {{"at", std::string("0.005,0.01,0.03")},
                           {"direction", std::string("0,0,1")},
                           {"profile", std::string("rectangle")},
                           {"size", 0.004},
                           {"height", 0.003}},
                          {}};

TEST_F(Replay, APocketHasItsFacesInTheModelWithTheIdsThatTheyHaveInTheMesh) {
  const auto made = edit(pocket);

  const auto result = replay(pocket, made);

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
  EXPECT_LT(result.verdict.deviation_mm, 1e-6 * std::hypot(10, 20, 30));
  std::map<int, double> areas;
  for (const auto& face : result.model.facts.faces) {
    ASSERT_EQ(face.ids.size(), 1U);
    areas[face.ids.front()] += face.area_mm2;
  }
  ASSERT_EQ(areas.size(), 11U);
  for (const auto& change : made.report.surface_map) {
    EXPECT_NEAR(areas[static_cast<int>(change.id)], 1e6 * change.area_after, 1e-9) << change.id;
  }
  EXPECT_EQ(result.model.facts.faces[0].name, "left wall");
}

TEST_F(Replay, AWallThatMovesTakesItsNeighboursAlong) {
  const edit_request wanted{"thicken", {1}, {{"depth", 0.001}}, {}};

  const auto result = replay(wanted, edit(wanted));

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
  ASSERT_EQ(result.model.facts.faces.size(), 6U);  // No strips beside the box that was there.
  double area = 0;
  for (const auto& face : result.model.facts.faces) {
    area += face.area_mm2;
    EXPECT_EQ(face.ids.size(), 1U);
  }
  EXPECT_NEAR(area, 2 * (11 * 20 + 20 * 30 + 11 * 30), 1e-6);
}

TEST_F(Replay, ARoundedEdgeIsAFillet) {
  const edit_request wanted{"open", {1, 3}, {{"radius", 0.002}}, {}};
  const auto made = edit(wanted);

  const auto result = replay(wanted, made);

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
  EXPECT_EQ(result.verdict.how, "fillet");
  EXPECT_EQ(result.model.facts.faces.size(), 7U);
}

/// mm2 of all faces of a model, each of which has one id.
double area_of(const cad::cad_model& model) {
  double area = 0;
  for (const auto& face : model.facts.faces) {
    area += face.area_mm2;
    EXPECT_EQ(face.ids.size(), 1U);
  }
  return area;
}

TEST_F(Replay, AFilletGoesAlongWithItsWall) {
  const edit_request round{"open", {1, 3}, {{"radius", 0.002}}, {}};
  const auto rounded = edit(round);
  go_on(rounded, replay(round, rounded));
  const auto fillet = static_cast<surface_id>(mesh_->surfaces().back().id);
  for (const auto& [operation, width] : {std::pair{"thicken", 11.0}, {"erode", 9.0}}) {
    const edit_request wanted{operation, {1}, {{"depth", 0.001}}, {}};
    const auto made = edit(wanted);

    const auto result = replay(wanted, made);

    EXPECT_TRUE(result.verdict.is_same) << operation << ": " << result.verdict.reason;
    EXPECT_EQ(result.verdict.how, "in place");
    ASSERT_EQ(result.model.facts.faces.size(), 7U);
    // Of a box; at its rounded edge of 30 mm a quarter of a cylinder instead of two strips.
    const double box = 2 * (width * 20 + 20 * 30 + width * 30);
    const double pi = std::numbers::pi;
    EXPECT_NEAR(area_of(result.model), box + 30 * (pi - 4) - 2 * (4 - pi), 1e-6) << operation;
    const auto shape =
      fit_exact(corners_of(*made.version, facets_of(*made.version, std::array{fillet})));
    ASSERT_TRUE(shape) << operation;
    EXPECT_NEAR(shape->shape.radius, 0.002, 1e-9) << operation << ": the fillet was bent";
  }
}

TEST_F(Replay, AWallAndABoreMoveWhereTheyAre) {
  const edit_request drilled{
    "drill",
    {},
    {{"at", std::string("0,0.01,0.015")}, {"direction", std::string("1,0,0")}, {"diameter", 0.006}},
    {}};
  const auto hole = edit(drilled);
  go_on(hole, replay(drilled, hole));
  const auto bore = static_cast<surface_id>(mesh_->surfaces().back().id);
  const double pi = std::numbers::pi;
  const auto area = [&](double width, double d) {
    return 2 * (width * 20 + 20 * 30 + width * 30 - pi * d * d / 4) + pi * d * width;
  };
  const edit_request thicker{"thicken", {1}, {{"depth", 0.001}}, {}};
  const auto longer = replay(thicker, edit(thicker));
  EXPECT_EQ(longer.verdict.how, "in place") << longer.verdict.reason;
  EXPECT_EQ(longer.model.facts.faces.size(), 7U);
  EXPECT_NEAR(area_of(longer.model), area(11, 6), 1e-6);

  const edit_request resized{"resize_bore", {bore}, {{"diameter", 0.007}}, {}};
  const auto wider = replay(resized, edit(resized));
  EXPECT_EQ(wider.verdict.how, "in place") << wider.verdict.reason;
  EXPECT_NEAR(area_of(wider.model), area(10, 7), 1e-6);
}

TEST_F(Replay, AShapeThatIsNotTheMeshIsNotTaken) {
  // Each is a valid solid, and another one than the mesh.
  const edit_request one{"erode", {1}, {{"depth", 0.001}}, {}};
  const edit_request two{"erode", {1}, {{"depth", 0.002}}, {}};
  auto beside = pocket;
  beside.parameters["at"] = std::string("0.0051,0.01,0.03");
  auto wider = pocket;
  wider.parameters["size"] = 0.00401;
  auto deeper = pocket;
  deeper.parameters["height"] = 0.00301;
  const edit_request outward{"thicken", {1}, {{"depth", 0.001}}, {}};
  for (const auto& [asked, is] : {std::pair{one, two},
                                  {two, one},
                                  {beside, pocket},
                                  {pocket, beside},
                                  {wider, pocket},
                                  {pocket, wider},
                                  {deeper, pocket},
                                  {outward, one},
                                  {pocket, one}}) {
    const auto made = edit(is);
    const auto result = replay(asked, made);
    EXPECT_FALSE(result.verdict.is_same) << asked.operation << " for " << is.operation;
    EXPECT_NE(result.verdict.reason, "");
    EXPECT_TRUE(result.model.shape == nullptr);
  }
}

TEST(ReasonOfWays, HasEachFaultOnceAndNoWayThatCouldNotBeginWhereAnotherSaysMore) {
  EXPECT_EQ(cad::reason_of({{"in place", ""}, {"layer", "a"}, {"slab", "b"}, {"plug", "a"}}),
            "layer, plug: a; slab: b");
  EXPECT_EQ(cad::reason_of({{"in place", ""}, {"layer", ""}}),
            "in place, layer: it cannot be done so");
  EXPECT_EQ(cad::reason_of({{"layer", "a"}}), "layer: a");
}

TEST_F(Replay, WhatNoOneKnowsToDoOnAModelIsSaid) {
  const edit_request wanted{"deform", {1}, {{"distance", 0.0005}}, {}};

  const auto result = replay(wanted, edit(wanted));

  EXPECT_FALSE(result.verdict.is_same);
  EXPECT_EQ(
    result.verdict.reason,
    "deform bends walls point by point: there is no plane, cylinder or other surface of CAD "
    "that they would be");
}

TEST_F(Replay, AMeshThatIsOnlyFinerHasTheSameModel) {
  const edit_request wanted{"refine", {1}, {}, {}};

  const auto result = replay(wanted, edit(wanted));

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
  EXPECT_EQ(result.model.facts.faces.size(), 6U);
}

TEST_F(Replay, APieceOfATorusWhoseAnglesBeginBelowZeroIsWhereItIs) {
  // OpenCASCADE 7.6 takes the box of its surface to have no height.
  open("torus_piece.brep");
  const edit_request wanted{"refine", {1}, {}, {}};

  const auto result = replay(wanted, edit(wanted));

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
}

TEST_F(Replay, ADamagedModelCostsNothingButItself) {
  auto broken = model_;
  broken.shape = std::make_shared<const std::string>("DBRep_DrawableShape\nrubbish");
  const auto made = edit(pocket);
  const auto offered = plugins_.find("pocket");

  const auto result = cad::replay_edit(
    {broken, (*offered)->description, mesh_, made.version, pocket, made.report}, {});

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_FALSE(result->verdict.is_same);
  EXPECT_THAT(result->verdict.reason, HasSubstr("CAD"));
}

/// From file to file, as a person does it.
class CadDocument : public ::testing::Test {
protected:
  void SetUp() override { TEDIT_NEEDS_CAD(); }

  static std::string fresh(const std::string& name) {
    const auto file = scratch(name);
    std::filesystem::remove(file);
    return file.string();
  }

  static json done(const std::string& arguments) {
    const auto result = run(arguments + " --json");
    EXPECT_EQ(result.status, 0) << arguments << "\n" << result.out;
    return result.parsed();
  }

  static json refused(const std::string& arguments) {
    const auto result = run(arguments + " --json");
    EXPECT_NE(result.status, 0) << arguments;
    return result.parsed()["error"];
  }
};

/// 25.4 x 50.8 x 76.2 mm with a blind hole: walls 8 and 9, bottom 1.
TEST_F(CadDocument, AChainOfEditsComesBackAsStep) {
  const auto block = fresh("block.tedit");
  const auto filled = fresh("filled.tedit");
  const auto thicker = fresh("thicker.tedit");
  const auto step = fresh("thicker.step");
  done("import " + cad_parts + "inch_block.stp --size coarse -o " + block);

  const auto first = done("edit " + block + " --op fill_hole --surfaces 8,9 -o " + filled);
  const auto second =
    done("edit " + filled + " --op thicken --surfaces 3 --param depth_mm=1 -o " + thicker);
  EXPECT_EQ(first["cad"]["status"], "same") << first["cad"];
  EXPECT_EQ(first["cad"]["how"], "outlines dropped");
  EXPECT_EQ(second["cad"]["status"], "same") << second["cad"];
  EXPECT_LT(second["cad"]["deviation_m"].get<double>(), 1e-7);
  EXPECT_EQ(done("export " + thicker + " -o " + step)["faces"], 6);
  const auto again = import_part(step + " --size coarse");

  EXPECT_NEAR(again["cad_volume_m3"].get<double>(), 1e-9 * (25.4 * 50.8 * 76.2 + 25.4 * 50.8 * 1),
              1e-13);
  EXPECT_NEAR(again["volume_m3"].get<double>(), again["cad_volume_m3"].get<double>(), 1e-13);
  // Ids of before, with a gap where the hole was; names of the file.
  std::set<int> ids;
  for (const auto& surface : again["surfaces"]) {
    ids.insert(surface["id"].get<int>());
    EXPECT_EQ(surface["name"], "PartBody");
  }
  EXPECT_THAT(ids, ::testing::ElementsAre(2, 3, 4, 5, 6, 7));
  // A document that another program goes on with: the edit is found in its log.
  EXPECT_EQ(done("doc check " + thicker)["versions"], 3);
}

TEST_F(CadDocument, AnEditInTheMeshOnlyIsSaidAndEarlierVersionsStayAvailable) {
  const auto box = fresh("box.tedit");
  const auto bent = fresh("bent.tedit");
  const auto more = fresh("more.tedit");
  const auto step = fresh("bent.step");
  done("import " + cad_parts + "box.step --size coarse -o " + box);

  const auto first =
    done("edit " + box + " --op deform --surfaces 1 --param distance_mm=0.5 -o " + bent);
  const auto second =
    done("edit " + bent + " --op thicken --surfaces 2 --param depth_mm=1 -o " + more);

  EXPECT_EQ(first["cad"]["status"], "mesh_only");
  EXPECT_EQ(second["cad"]["status"], "mesh_only");
  EXPECT_THAT(second["cad"]["reason"].get<std::string>(), HasSubstr("deform"));
  const auto why = refused("export " + more + " -o " + step);
  EXPECT_THAT(why["message"].get<std::string>(), HasSubstr("older than version 2"));
  EXPECT_FALSE(std::filesystem::exists(step));
  EXPECT_EQ(done("export " + more + " -o " + step + " --version 0")["faces"], 6);
}

TEST_F(CadDocument, AMeshHasNoModelAndADocumentIsNotWrittenOver) {
  const auto box = fresh("box.tedit");
  done("import " + cad_parts + "box.step --size coarse -o " + box);

  EXPECT_THAT(refused("import " + cad_parts + "box.step -o " + box)["message"].get<std::string>(),
              HasSubstr("already"));
  EXPECT_THAT(refused("export " TEDIT_TEST_DATA
                      "/parts/inch_block/inch_block.coarse.msh -o x.step")["message"]
                .get<std::string>(),
              HasSubstr("no document"));
}

}  // namespace
}  // namespace tedit::test
