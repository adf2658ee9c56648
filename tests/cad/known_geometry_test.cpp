// SPDX-License-Identifier: AGPL-3.0-or-later
// What a CAD file says of each face comes with the mesh, and tools use it. domed_block.step, in mm:
// 40 x 30 around the z axis, flat at z = 0; its top is z = 10 + 3 (1 - (x/25)^2) (1 - (y/20)^2), a
// spline; below a pin of 10 around (8, 0), 8 long, with a fillet of 1.5 where it stands.
#include <map>
#include <set>

#include "mesh/features/known_wall.hpp"
#include "tests/cad/replayed_part.hpp"

namespace tedit::test {
namespace {

using kind = surface_geometry::kind;

constexpr surface_id pin = 1;
constexpr surface_id fillet = 2;
constexpr surface_id side = 8;  ///< x = 20.
constexpr surface_id dome = 9;

/// m, above the dome.
double off_dome(vec3 p) {
  const double x = p.x / 0.025;
  const double y = p.y / 0.020;
  return p.z - 0.010 - 0.003 * (1 - x * x) * (1 - y * y);
}

class KnownGeometry : public replayed_part {
protected:
  void SetUp() override {
    TEDIT_NEEDS_CAD();
    open("domed_block.step");
  }

  [[nodiscard]] static std::set<vertex_id> vertices_of(const mesh_version& mesh, surface_id id) {
    std::set<vertex_id> result;
    for (const auto f : facets_of(mesh, std::array{id}))
      result.insert(mesh.facet(f).v.begin(), mesh.facet(f).v.end());
    return result;
  }

  [[nodiscard]] std::optional<exact_wall> wall_of(surface_id id) const {
    return find_exact(*mesh_, facets_of(*mesh_, std::array{id}));
  }

  /// The same on mesh and model; m: the furthest that a vertex of the dome is off it.
  double furthest_off_dome_after(const edit_request& wanted) {
    const auto made = edit(wanted);
    const auto result = replay(wanted, made);
    EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
    double furthest = 0;
    for (const auto v : vertices_of(*made.version, dome))
      furthest = std::max(furthest, std::abs(off_dome(made.version->position(v))));
    EXPECT_GT(vertices_of(*made.version, dome).size(), vertices_of(*mesh_, dome).size());
    return furthest;
  }
};

TEST_F(KnownGeometry, IsWhatTheFileSaysOfEachFaceInMetres) {
  std::map<kind, int> count;
  for (const auto& row : mesh_->surfaces())
    ++count[row.geometry.type];
  EXPECT_EQ(count, (std::map<kind, int>{
                     {kind::plane, 6}, {kind::cylinder, 1}, {kind::torus, 1}, {kind::spline, 1}}));

  const auto& tube = mesh_->find_surface(fillet)->geometry;
  EXPECT_NEAR(tube.radius, 0.0065, 1e-12);
  EXPECT_NEAR(tube.tube_radius, 0.0015, 1e-12);
  EXPECT_NEAR(norm(tube.point - vec3{0.008, 0, -0.0015}), 0, 1e-12);
  EXPECT_NEAR(mesh_->find_surface(pin)->geometry.radius, 0.005, 1e-12);
  const auto& spline = *mesh_->find_surface(dome)->geometry.spline;
  for (const double u : {0.1, 0.5, 0.8}) {
    const auto& [from, to] = std::pair(spline.knots[0].front(), spline.knots[0].back());
    EXPECT_NEAR(off_dome(spline(from + u * (to - from), spline.knots[1].back()).at), 0, 1e-12);
  }
}

TEST_F(KnownGeometry, WallsKnowOnWhichSideTheMaterialIs) {
  for (const auto& [id, p] : {std::pair<surface_id, vec3>{dome, {0, 0, 0.0135}},
                              {pin, {0.0135, 0, -0.005}},
                              {fillet, {0.0145, 0, -0.0015}}}) {
    const auto wall = wall_of(id);
    ASSERT_TRUE(wall) << id;
    EXPECT_TRUE(wall->is_known) << id;
    EXPECT_GT(wall->distance(p), 0) << id;
  }
  EXPECT_NEAR(wall_of(dome)->distance({0, 0, 0.0135}), 0.0005, 1e-12);
  EXPECT_NEAR(wall_of(fillet)->distance({0.0145, 0, -0.0015}), 0.0015, 1e-12);
}

TEST_F(KnownGeometry, AHoleThroughFreeFormHasItsRimThere) {
  EXPECT_LT(
    furthest_off_dome_after(
      {"drill", {dome}, {{"at", std::string("-0.008,0.004,0.012")}, {"diameter", 0.004}}, {}}),
    1e-11);
}

/// Its upper edge comes down along the dome.
TEST_F(KnownGeometry, AWallBesideFreeFormIsLoweredAlongIt) {
  const edit_request wanted{"erode", {side}, {{"depth", 0.002}}, {}};
  const auto made = edit(wanted);
  const auto result = replay(wanted, made);

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
  for (const auto v : vertices_of(*made.version, dome))
    EXPECT_NEAR(off_dome(made.version->position(v)), 0, 1e-11);
  for (const auto v : vertices_of(*made.version, side))
    EXPECT_NEAR(made.version->position(v).x, 0.018, 1e-15);
}

TEST_F(KnownGeometry, ABossStandsOnFreeForm) {
  EXPECT_LT(furthest_off_dome_after({"boss",
                                     {dome},
                                     {{"at", std::string("-0.008,0.004,0.012")},
                                      {"direction", std::string("0,0,1")},
                                      {"size", 0.004},
                                      {"height", 0.003}},
                                     {}}),
            1e-11);
}

TEST_F(KnownGeometry, AHoleBesideThePinGoesThroughItsFillet) {
  // Its axis is 6.2 mm off the pin's; the fillet ends at 6.5 mm.
  const edit_request wanted{"drill",
                            {fillet},
                            {{"at", std::string("0.0142,0,-0.001")},
                             {"direction", std::string("0,0,1")},
                             {"diameter", 0.0015}},
                            {}};
  const auto made = edit(wanted);
  const auto result = replay(wanted, made);

  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
  const auto wall = wall_of(fillet);
  const auto before = vertices_of(*mesh_, fillet);
  const auto after = vertices_of(*made.version, fillet);
  EXPECT_GT(after.size(), before.size());
  for (const auto v : after)
    EXPECT_NEAR(wall->distance(made.version->position(v)), 0, 1e-11);
}

TEST_F(KnownGeometry, IsKeptInADocumentAndComesBackThroughStep) {
  const auto document = scratch("domed.tedit").string();
  const auto step = scratch("domed.step").string();
  const auto again = scratch("again.tedit").string();
  for (const auto& file : {document, step, again})
    std::filesystem::remove(file);
  EXPECT_EQ(run("import " + cad_parts + "domed_block.step --size coarse -o " + document).status, 0);
  EXPECT_EQ(run("export " + document + " -o " + step).status, 0);
  EXPECT_EQ(run("import " + step + " --size coarse -o " + again).status, 0);

  for (const auto& file : {document, again})
    EXPECT_EQ(run("info --json " + file).parsed()["surfaces"][fillet - 1]["tube_radius_m"], 0.0015)
      << file;
}

}  // namespace
}  // namespace tedit::test
