// SPDX-License-Identifier: AGPL-3.0-or-later
// What must be the same by whichever way operations with tools come to it, on real parts. Volumes
// are by the tets, not by what the operations say of them.
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/attachment.hpp"
#include "base/number_range.hpp"
#include "fem/solver.hpp"
#include "mesh/facet_pages.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
#include "ops/tools/local_size.hpp"
#include "protocol/convert.hpp"
#include "tests/support/parts.hpp"

namespace tedit::ops {
namespace {

constexpr double mm3 = 1e-9;

class Identities : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
  }

  static version_ptr part(const std::string& name) {
    const auto imported = import_mesh(test::parts_folder / name / (name + ".coarse.msh"), "mm");
    EXPECT_TRUE(imported.has_value());
    return imported ? imported->version : nullptr;
  }

  /// The version that the host takes of it; the same one where it was refused, which fails the
  /// test.
  version_ptr after(const version_ptr& mesh, const std::string& operation, parameters values,
                    const std::vector<surface_id>& picked = {}) {
    context ctx;
    ctx.host = host_.get();
    const auto made = run_operation(plugins_, operation, mesh, {picked}, values, ctx);
    EXPECT_TRUE(made) << operation << ": " << (made ? "" : render(made.error()));
    if (!made)
      return mesh;
    edit_claim claim;
    claim.touched = made->touched;
    claim.volume_change = made->volume_change;
    claim.quality_floor = made->quality_floor;
    claim.bodies_added = made->bodies_added;
    const auto taken = finish_edit(mesh, made->candidate, claim, made->improve, {}, {});
    EXPECT_TRUE(taken) << operation << ": " << (taken ? "" : render(taken.error()));
    return taken ? taken->version : mesh;
  }

  static double area(const mesh_version& mesh) {
    double sum = 0;
    for (const auto& [id, size] : surface_sizes(mesh))
      sum += size.area_m2;
    return sum;
  }

  /// The same space: what both bound is as large, and so is what bounds them.
  static void expect_same_shape(const version_ptr& one, const version_ptr& other) {
    EXPECT_NEAR(total_volume(*one), total_volume(*other), 1e-9 * total_volume(*one));
    EXPECT_NEAR(area(*one), area(*other), 1e-9 * area(*one));
  }

  static parameters wedge(const std::string& mode, const std::string& at, double scale = 1) {
    return {{"file", *attach_file(TEDIT_TEST_DATA "/../../ops/combine/tests/wedge.stl")},
            {"mode", mode},
            {"at_mm", at},
            {"scale", scale}};
  }

  catalogue plugins_;
  std::unique_ptr<services> host_ = make_host_services();
};

parameters block(const std::string& at, double height_mm) {
  return {{"profile", std::string("rectangle")},
          {"size_mm", 20.0},
          {"width_mm", 14.0},
          {"height_mm", height_mm},
          {"at_mm", at},
          {"direction", std::string("0,0,1")}};
}

/// 20 x 14 x 6 mm on the top of the plate, and one as deep that is filled from its floor.
TEST_F(Identities, ABossFillsThePocketOfItsSize) {
  const auto plate = part("ctc01_plate");
  const auto cut = after(plate, "pocket", block("130,0,0", 6), {98});
  const auto back = after(cut, "boss", block("130,0,-6", 6));

  EXPECT_NEAR(total_volume(*cut), total_volume(*plate) - 20 * 14 * 6 * mm3, 1e-6 * mm3);
  expect_same_shape(back, plate);
}

TEST_F(Identities, APocketTakesOffTheBossOfItsSize) {
  const auto plate = part("ctc01_plate");
  const auto raised = after(plate, "boss", block("130,0,0", 6), {98});
  const auto back = after(raised, "pocket", block("130,0,6", 6));

  EXPECT_NEAR(total_volume(*raised), total_volume(*plate) + 20 * 14 * 6 * mm3, 1e-6 * mm3);
  expect_same_shape(back, plate);
}

TEST_F(Identities, HolesApartAreTheSameInAnyOrderAndAtOnce) {
  const auto plate = part("ctc01_plate");
  const auto hole = [](const std::string& at) {
    return parameters{{"diameter_mm", 12.0}, {"depth_mm", 8.0}, {"at_mm", at}};
  };
  const auto ab =
    after(after(plate, "drill", hole("100,0,0"), {98}), "drill", hole("150,0,0"), {98});
  const auto ba =
    after(after(plate, "drill", hole("150,0,0"), {98}), "drill", hole("100,0,0"), {98});
  auto both = hole("100,0,0");
  both["places_mm"] = std::string("150,0,0");
  const auto once = after(plate, "drill", both, {98});

  expect_same_shape(ab, ba);
  expect_same_shape(ab, once);
  EXPECT_EQ(ab->surfaces().size(), once->surfaces().size());
}

TEST_F(Identities, APocketAndABossApartAreTheSameInAnyOrder) {
  const auto plate = part("ctc01_plate");
  const auto one =
    after(after(plate, "pocket", block("100,0,0", 5), {98}), "boss", block("150,0,0", 5), {98});
  const auto other =
    after(after(plate, "boss", block("150,0,0", 5), {98}), "pocket", block("100,0,0", 5), {98});

  expect_same_shape(one, other);
  // What the one takes off the other puts on; each has walls of 2 x (20 + 14) x 5 mm2.
  EXPECT_NEAR(total_volume(*one), total_volume(*plate), 1e-6 * mm3);
  EXPECT_NEAR(area(*one), area(*plate) + 2 * 2 * (20 + 14) * 5 * 1e-6, 1e-12);
}

/// Cut and kept are all there was; cut and put back is the same as put on. The wedge is a corner of
/// a box of 20 x 25 x 30 mm: a sixth of it.
TEST_F(Identities, AShapeOfAFileIsCutKeptAndUnited) {
  const auto inch = part("inch_block");
  const std::string at = "0,0,20";
  const auto cut = after(inch, "combine", wedge("cut", at));
  const auto kept = after(inch, "combine", wedge("intersect", at));
  const auto added = after(inch, "combine", wedge("add", at));
  const auto back = after(cut, "combine", wedge("add", at));

  EXPECT_NEAR(total_volume(*cut) + total_volume(*kept), total_volume(*inch), 1e-6 * mm3);
  EXPECT_NEAR(total_volume(*added) + total_volume(*kept),
              total_volume(*inch) + 20 * 25 * 30 / 6.0 * mm3, 1e-6 * mm3);
  expect_same_shape(back, added);
}

TEST_F(Identities, BothSidesOfACutAreAllThereWas) {
  const auto whole = part("inch_block");
  const auto extent = extent_of(*whole);
  const vec3 m = 0.47 * extent.low + 0.53 * extent.high;
  const auto side = [&](const char* keep) {
    return after(whole, "plane_cut",
                 {{"at", number_text(m.x) + "," + number_text(m.y) + "," + number_text(m.z)},
                  {"normal", std::string("0.1,0.2,1")},
                  {"keep", std::string(keep)}});
  };

  EXPECT_NEAR(total_volume(*side("below")) + total_volume(*side("above")), total_volume(*whole),
              1e-6 * mm3);
  EXPECT_NEAR(total_volume(*side("both")), total_volume(*whole), 1e-6 * mm3);
}

/// A groove, half of which lies in the material, and the bead of its size.
TEST_F(Identities, ABeadFillsItsGroove) {
  const auto plate = part("ctc01_plate");
  const auto along = [](const char* mode) {
    return parameters{{"path_mm", std::string("100,-15,0; 150,-15,0; 150,15,0")},
                      {"profile", std::string("rectangle")},
                      {"size_mm", 8.0},
                      {"mode", std::string(mode)}};
  };
  const auto groove = after(plate, "sweep", along("cut"), {98});
  const auto bead = after(plate, "sweep", along("add"), {98});
  const auto both = after(groove, "sweep", along("add"), {98});

  // Its area of 8 x 8 mm times the path's 80 mm: half below the wall, half above it.
  EXPECT_NEAR(total_volume(*groove), total_volume(*plate) - 8 * 4 * 80 * mm3, 1e-6 * mm3);
  EXPECT_NEAR(total_volume(*bead), total_volume(*plate) + 8 * 4 * 80 * mm3, 1e-6 * mm3);
  expect_same_shape(both, bead);
}

/// Two ribs in the corner between the walls 5 and 10 of bracket_4040, 14 mm apart.
class Ribs : public Identities {
protected:
  void SetUp() override {
    Identities::SetUp();
    const auto base = middle_of(*bracket_, 5);
    const auto upright = middle_of(*bracket_, 10);
    ASSERT_TRUE(base && upright);
    middle_ = 0.5 * (base->point + upright->point);
    along_ = normalized(cross(base->normal, upright->normal));
  }

  static std::string text(vec3 p) {
    return number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z);
  }

  [[nodiscard]] parameters rib(double off_mm) const {
    return {
      {"thickness_mm", 3.0}, {"size_mm", 8.0}, {"at", text(middle_ + 1e-3 * off_mm * along_)}};
  }

  version_ptr bracket_ = part("bracket_4040");
  vec3 middle_;
  vec3 along_;
};

TEST_F(Ribs, ApartAreTheSameInAnyOrder) {
  const auto one = after(after(bracket_, "rib", rib(-7), {5, 10}), "rib", rib(7), {5, 10});
  const auto other = after(after(bracket_, "rib", rib(7), {5, 10}), "rib", rib(-7), {5, 10});

  expect_same_shape(one, other);
}

/// Where the fillet is fine, so that its chords are its arc.
TEST_F(Ribs, AreTrianglesLessWhatTheFilletHasAlready) {
  const auto fine =
    after(bracket_, "refine", {{"at", text(middle_)}, {"radius_mm", 18.0}, {"size_mm", 1.0}});
  const auto ribs = after(after(fine, "rib", rib(-7), {5, 10}), "rib", rib(7), {5, 10});

  // Of 8 x 8 mm, 3 mm thick; a fillet of 4 mm.
  const double each = 3 * (8 * 8 / 2.0 - (1 - std::numbers::pi / 4) * 4 * 4);
  EXPECT_NEAR(total_volume(*ribs), total_volume(*fine) + 2 * each * mm3, 0.02 * 2 * each * mm3);
}

/// Improvement moved vertices of tets that stay as they are otherwise: those are touched, too.
TEST_F(Identities, HolesAtSeveralPlacesTellAllThatTheyTouch) {
  const auto plate = part("ctc01_plate");
  const parameters holes{
    {"diameter_mm", 10.0}, {"depth_mm", 8.0}, {"places_mm", std::string("60,0,0; 100,0,0")}};

  const auto drilled = after(plate, "drill", holes, {98});

  EXPECT_LT(total_volume(*drilled), total_volume(*plate) - 2 * 600 * mm3);
}

/// Corners of the drawing's round holes came to lie beside the wall by a rounding error, and what
/// the mesher was given passed through itself.
TEST_F(Identities, APlateOfADrawingIsTheSameOnAnyWall) {
  const auto cube = part("inch_block");
  const parameters plate{{"profile", std::string("file")},
                         {"file", *attach_file(TEDIT_TEST_DATA "/drawings/plate_r12.dxf")},
                         {"scale", 0.5},
                         {"height_mm", 3.0}};

  for (const surface_id wall : {2, 4})
    EXPECT_NEAR(total_volume(*after(cube, "boss", plate, {wall})) - total_volume(*cube),
                669.28 * mm3, 0.01 * mm3)
      << wall;
}

/// The plate under its own weight, so that no wall of a tool is one that is loaded.
class Fields : public Identities {
protected:
  struct field {
    version_ptr mesh;
    fem::solution values;
    std::map<vertex_id, std::size_t> nodes;
  };

  void SetUp() override {
    Identities::SetUp();
    auto read = protocol::load_case_from_file(test::parts_folder / "ctc01_plate/load_case.json");
    ASSERT_TRUE(read) << render(read.error());
    loads_ = std::move(*read);
    loads_.loads = {{{}, fem::gravity{{0, 0, -9.81}}}};
  }

  field of(const version_ptr& mesh) {
    const auto problem = fem::make_problem(*mesh, loads_, 2);
    EXPECT_TRUE(problem) << render(problem.error());
    const auto device = fem::open_backend("cpu");
    auto solved = fem::solve(*problem, **device, {.tolerance = 1e-9}, {});
    EXPECT_TRUE(solved) << render(solved.error());
    field result{mesh, std::move(*solved), {}};
    for (std::size_t i = 0; i < problem->corner_count; ++i)
      result.nodes.emplace(problem->node_vertices[i], i);
    return result;
  }

  /// How far two fields are apart at the vertices that both meshes have, as shares of the largest
  /// displacement, and of the largest stress where it is further than that from a place.
  static std::array<double, 2> apart(const field& one, const field& other, vec3 from, double near) {
    double displacement = 0;
    double stress = 0;
    std::size_t count = 0;
    for (const auto& [v, a] : one.nodes) {
      const auto found = other.nodes.find(v);
      if (found == other.nodes.end() || one.mesh->position(v) != other.mesh->position(v))
        continue;
      ++count;
      const auto b = found->second;
      for (int k = 0; k < 3; ++k)
        displacement = std::max(displacement, std::abs(one.values.displacement[3 * a + k] -
                                                       other.values.displacement[3 * b + k]));
      if (norm(one.mesh->position(v) - from) > near)
        stress = std::max(stress, std::abs(one.values.von_mises[a] - other.values.von_mises[b]));
    }
    EXPECT_GT(count, one.nodes.size() / 2);
    return {displacement / one.values.max_displacement_m,
            stress / *std::ranges::max_element(one.values.von_mises)};
  }

  version_ptr plate_ = part("ctc01_plate");
  fem::load_case loads_;
};

TEST_F(Fields, AreWhatTheyWereWhenAPocketIsFilledAgain) {
  const auto before = of(plate_);
  const auto cut = after(plate_, "pocket", block("130,0,0", 20), {98});
  const auto back = after(cut, "boss", block("130,0,-20", 20));

  const vec3 place{0.13, 0, -0.01};
  const auto pocket = apart(before, of(cut), place, 0.03);
  const auto filled = apart(before, of(back), place, 0.03);

  // What is left is how coarse the mesh is where it was made anew.
  EXPECT_GT(pocket[0], 2e-3);
  EXPECT_LT(filled[0], 5e-4);
  EXPECT_LT(filled[1], 0.02);
}

TEST_F(Fields, DoNotDependOnTheOrderOfHoles) {
  const auto hole = [](const std::string& at) {
    return parameters{{"diameter_mm", 12.0}, {"depth_mm", 0.0}, {"at_mm", at}};
  };
  const auto drilled = [&](const char* first, const char* second) {
    return of(after(after(plate_, "drill", hole(first), {98}), "drill", hole(second), {98}));
  };

  const auto one = drilled("100,0,0", "150,0,0");
  const auto other = drilled("150,0,0", "100,0,0");

  const auto off = apart(one, other, {}, 0);
  EXPECT_NEAR(one.values.compliance_j, other.values.compliance_j, 5e-6 * one.values.compliance_j);
  EXPECT_LT(off[0], 5e-4);
  EXPECT_LT(off[1], 0.03);
}

}  // namespace
}  // namespace tedit::ops
