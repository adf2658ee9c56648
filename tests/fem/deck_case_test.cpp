// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/deck_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// 2 x 2 x 2 cells of 1 m; surfaces 1 to 6: x = 0, x = 2, y = 0, ...
version_ptr block() {
  return test::box_mesh({2, 2, 2}, {2, 2, 2});
}

template <class Add>
void at_x(const mesh_version& mesh, double x, const Add& add) {
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.position(v).x == x)
      add(v);
}

TEST(DeckCase, AHeldFaceIsFixedAndItsNeighboursAreNot) {
  const auto mesh = block();
  deck from;
  at_x(*mesh, 0, [&](vertex_id v) {
    for (int c = 0; c < 3; ++c)
      from.supports.push_back({v, c, 0});
  });

  const auto found = load_case_of_deck(*mesh, from);

  ASSERT_EQ(found.loads.constraints.size(), 1U);
  EXPECT_THAT(found.loads.constraints[0].surfaces, ElementsAre(1));
  EXPECT_TRUE(std::holds_alternative<fixed>(found.loads.constraints[0].kind));
  EXPECT_THAT(found.remarks, IsEmpty());
}

TEST(DeckCase, ComponentsWithValuesAreAPrescribedDisplacement) {
  const auto mesh = block();
  deck from;
  at_x(*mesh, 2, [&](vertex_id v) { from.supports.push_back({v, 0, 1e-3}); });
  from.supports.push_back({0, 2, 0});  // A corner alone.

  const auto found = load_case_of_deck(*mesh, from);

  ASSERT_EQ(found.loads.constraints.size(), 1U);
  EXPECT_THAT(found.loads.constraints[0].surfaces, ElementsAre(2));
  EXPECT_EQ(std::get<prescribed_displacement>(found.loads.constraints[0].kind),
            (prescribed_displacement{1e-3, {}, {}}));
  EXPECT_THAT(found.remarks,
              ElementsAre("supports of 1 nodal component make up no whole surface and are left "
                          "out"));
}

/// The share of a vertex of the face x = 2, whose area is 4: a third of each triangle around.
double share_of(const mesh_version& mesh, vertex_id v) {
  double area = 0;
  for (const auto f : facets_of(mesh, std::array<surface_id, 1>{2}))
    for (const auto corner : mesh.facet(f).v)
      area += corner == v ? norm(area_vector(mesh, mesh.facet(f))) / 3 : 0;
  return area / 4;
}

TEST(DeckCase, EvenNodalForcesAreAForceWithoutARemark) {
  const auto mesh = block();
  deck from;
  at_x(*mesh, 2, [&](vertex_id v) {
    from.forces.push_back({v, share_of(*mesh, v) * vec3{0, 0, -80}});
  });

  const auto found = load_case_of_deck(*mesh, from);

  ASSERT_EQ(found.loads.loads.size(), 1U);
  EXPECT_THAT(found.loads.loads[0].surfaces, ElementsAre(2));
  EXPECT_NEAR(std::get<force>(found.loads.loads[0].kind).total_n.z, -80, 1e-12);
  EXPECT_THAT(found.remarks, IsEmpty());
}

TEST(DeckCase, UnevenNodalForcesAreTheirSumAndThatIsSaid) {
  const auto mesh = block();
  deck from;
  at_x(*mesh, 2, [&](vertex_id v) { from.forces.push_back({v, {0, 0, -1}}); });
  from.forces.push_back({0, {5, 0, 0}});

  const auto found = load_case_of_deck(*mesh, from);

  ASSERT_EQ(found.loads.loads.size(), 1U);
  EXPECT_NEAR(std::get<force>(found.loads.loads[0].kind).total_n.z, -9, 1e-12);
  EXPECT_THAT(found.remarks,
              ElementsAre("nodal forces on surface 2 are not spread evenly: read is their sum, (0, "
                          "0, -9) N, spread evenly",
                          "forces on 1 node, (5, 0, 0) N together, make up no whole surface and "
                          "are left out"));
}

TEST(DeckCase, APressureIsThatOfAWholeSurface) {
  const auto mesh = block();
  deck from;
  for (const auto f : facets_of(*mesh, std::array<surface_id, 1>{6}))
    from.pressures.push_back({mesh->facet(f).v, 2e5});
  from.pressures.push_back({mesh->facet(facets_of(*mesh, std::array<surface_id, 1>{5})[0]).v, 1e5});

  const auto found = load_case_of_deck(*mesh, from);

  ASSERT_EQ(found.loads.loads.size(), 1U);
  EXPECT_THAT(found.loads.loads[0].surfaces, ElementsAre(6));
  EXPECT_EQ(std::get<pressure>(found.loads.loads[0].kind).pa, 2e5);
  EXPECT_THAT(found.remarks,
              ElementsAre(HasSubstr("pressures on 1 face make up no whole surface")));
}

TEST(DeckCase, MaterialsKeepWhatTheyAreMadeOf) {
  const auto mesh = block();
  deck from;
  from.materials = {{"Steel", 2.1e11, 0.3, 7850, {1}}, {"Rubber", 0, 0, 0, {1}}};
  from.gravity = vec3{0, 0, -9.81};

  const auto found = load_case_of_deck(*mesh, from);

  ASSERT_EQ(found.loads.materials.size(), 1U);
  EXPECT_EQ(found.loads.materials[0].name, "Steel");
  EXPECT_THAT(found.loads.materials[0].regions, IsEmpty());  // All of the part.
  EXPECT_EQ(std::get<gravity>(found.loads.loads[0].kind).m_s2.z, -9.81);
  EXPECT_THAT(found.remarks, ElementsAre(HasSubstr("material \"Rubber\" has no isotropic")));
}

}  // namespace
}  // namespace tedit::fem
