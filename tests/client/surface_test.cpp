// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tedit::client {
namespace {

/// A unit corner tetrahedron: three facets on surface 1, the slanted one on surface -7. Slots lie
/// on two pages of the table.
surface_update tetrahedron() {
  surface_update update;
  update.version_id = "a";
  update.surfaces = {{1, "walls", 3, 1.5}, {-7, "slope", 1, std::sqrt(3.0) / 2}};
  update.vertices = {0, 1, 2, 5000};
  update.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  update.facets = {0, 1, 2, 3000};
  update.facet_vertices = {0, 2, 1, 0, 1, 5000, 0, 5000, 2, 1, 2, 5000};
  update.facet_surfaces = {1, 1, 1, -7};
  return update;
}

/// The slope is folded outwards over a new vertex.
surface_update folded() {
  surface_update update;
  update.version_id = "b";
  update.base_version_id = "a";
  update.surfaces = {{9, "fold", 3, 0}};
  update.removed = {-7};
  update.removed_facets = {3000};
  update.vertices = {7};
  update.positions = {1, 1, 1};
  update.facets = {3, 4, 5};
  update.facet_vertices = {1, 2, 7, 2, 5000, 7, 5000, 1, 7};
  update.facet_surfaces = {9, 9, 9};
  return update;
}

void expect_refused(surface_model& model, const surface_update& update) {
  const auto before = model.version_id();
  const auto facets = model.total_facets();
  const auto vertices = model.positions().size();
  const auto result = model.apply(update);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::protocol_error) << render(result.error());
  EXPECT_EQ(model.version_id(), before);
  EXPECT_EQ(model.total_facets(), facets);
  EXPECT_EQ(model.positions().size(), vertices);
}

TEST(surface_model, holds_a_whole_surface) {
  surface_model model;
  EXPECT_EQ(model.version_id(), "");
  ASSERT_TRUE(model.apply(tetrahedron()));
  EXPECT_EQ(model.version_id(), "a");
  EXPECT_EQ(model.total_facets(), 4u);
  EXPECT_EQ(model.positions().size(), 4u);
  EXPECT_EQ(*model.positions().find(5000), (vec3{0, 0, 1}));
  EXPECT_EQ(*model.facets().find(3000), (surface_facet{{1, 2, 5000}, -7}));
  EXPECT_EQ(model.facets().find(3), nullptr);
  EXPECT_EQ(model.facets().find(no_id), nullptr);
  EXPECT_EQ(model.surfaces().at(1).name, "walls");
  EXPECT_DOUBLE_EQ(model.area(1), 1.5);
  EXPECT_DOUBLE_EQ(model.area(-7), std::sqrt(3.0) / 2);
  EXPECT_EQ(model.area(2), 0);
}

TEST(surface_model, visits_slots_in_order) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  std::vector<std::uint32_t> slots;
  model.facets().for_each([&](std::uint32_t slot, const surface_facet&) { slots.push_back(slot); });
  EXPECT_EQ(slots, (std::vector<std::uint32_t>{0, 1, 2, 3000}));
}

TEST(surface_model, applies_a_difference) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  ASSERT_TRUE(model.apply(folded()));
  EXPECT_EQ(model.version_id(), "b");
  EXPECT_EQ(model.total_facets(), 6u);
  EXPECT_EQ(model.facets().find(3000), nullptr);
  EXPECT_EQ(model.surfaces().count(-7), 0u);
  EXPECT_EQ(model.surfaces().count(9), 1u);
  EXPECT_EQ(model.area(-7), 0);
  EXPECT_NEAR(model.area(9), 3 * std::sqrt(3.0) / 2, 1e-15);
}

TEST(surface_model, replaces_one_facet_and_moves_a_vertex) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  surface_update update;
  update.version_id = "b";
  update.base_version_id = "a";
  update.vertices = {5000};
  update.positions = {0, 0, 2};
  update.facets = {3000};
  update.facet_vertices = {1, 2, 5000};
  update.facet_surfaces = {1};
  ASSERT_TRUE(model.apply(update));
  EXPECT_EQ(model.total_facets(), 4u);
  EXPECT_EQ(model.positions().size(), 4u);
  EXPECT_DOUBLE_EQ(model.area(1), 0.5 + 1 + 1 + 1.5);
  EXPECT_EQ(model.area(-7), 0);
}

TEST(surface_model, a_slot_may_be_emptied_and_filled_in_one_update) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  auto update = folded();
  update.facets[0] = 3000;
  update.removed_facets.push_back(77);  // Held by nobody.
  ASSERT_TRUE(model.apply(update));
  EXPECT_EQ(model.total_facets(), 6u);
  EXPECT_EQ(model.facets().find(3000)->surface, 9);
}

TEST(surface_model, copies_keep_their_values) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  const surface_model copy = model;
  ASSERT_TRUE(model.apply(folded()));
  EXPECT_EQ(copy.version_id(), "a");
  EXPECT_EQ(copy.total_facets(), 4u);
  EXPECT_DOUBLE_EQ(copy.area(-7), std::sqrt(3.0) / 2);
}

TEST(surface_model, a_whole_surface_replaces_all) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  ASSERT_TRUE(model.apply(folded()));
  ASSERT_TRUE(model.apply(tetrahedron()));
  EXPECT_EQ(model.total_facets(), 4u);
  EXPECT_EQ(model.positions().find(7), nullptr);
  EXPECT_EQ(model.surfaces().count(9), 0u);
}

TEST(surface_model, refuses_a_difference_to_another_version) {
  surface_model model;
  expect_refused(model, folded());
  ASSERT_TRUE(model.apply(tetrahedron()));
  auto update = folded();
  update.base_version_id = "c";
  expect_refused(model, update);
  update = folded();
  update.version_id.clear();
  expect_refused(model, update);
}

TEST(surface_model, refuses_an_unknown_vertex) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  auto update = folded();
  update.facet_vertices[4] = 6;
  expect_refused(model, update);
  update.facet_vertices[4] = no_id;
  expect_refused(model, update);
  EXPECT_EQ(model.surfaces().count(-7), 1u);
  EXPECT_NE(model.facets().find(3000), nullptr);
}

TEST(surface_model, a_whole_surface_may_not_use_earlier_vertices) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  auto update = folded();
  update.base_version_id.clear();
  expect_refused(model, update);
}

TEST(surface_model, refuses_arrays_that_do_not_match) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  auto update = folded();
  update.positions.pop_back();
  expect_refused(model, update);
  update = folded();
  update.facet_vertices.push_back(0);
  expect_refused(model, update);
  update = folded();
  update.facet_surfaces.pop_back();
  expect_refused(model, update);
}

TEST(surface_model, refuses_slots_that_no_mesh_has) {
  surface_model model;
  ASSERT_TRUE(model.apply(tetrahedron()));
  auto update = folded();
  update.vertices[0] = max_slots;
  expect_refused(model, update);
  update = folded();
  update.facets[0] = no_id;
  expect_refused(model, update);
}

}  // namespace
}  // namespace tedit::client
