// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/select.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/builder.hpp"
#include "tests/support/blocks.hpp"

namespace tedit {
namespace {

using test::blocks;
using ::testing::ElementsAre;

/// A plate of 5 x 5 x 2 with a square hole, whose four walls are surfaces 8 (x < 2.5) and 7.
version_ptr plate_with_hole() {
  const auto mesh = blocks({5, 5, 2}, [](int x, int y, int) { return x != 2 || y != 2; });
  mesh_builder builder(mesh);
  const auto id = builder.add_surface("half");
  for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
    const auto& v = mesh->facet(f).v;
    const double x = (mesh->position(v[0]).x + mesh->position(v[1]).x + mesh->position(v[2]).x) / 3;
    if (mesh->facet(f).surface == 7 && x < 2.5)
      builder.set_surface(f, id);
  }
  return builder.freeze();
}

TEST(Select, OneWallGivesTheWholeHole) {
  const auto found = select_surfaces(*plate_with_hole(), {feature_kind::hole, {8}}, {});

  ASSERT_TRUE(found.has_value()) << render(found.error());
  ASSERT_EQ(found->size(), 1u);
  EXPECT_THAT(found->front().surfaces, ElementsAre(7, 8));
  EXPECT_EQ(found->front().kind, feature_kind::hole);
}

TEST(Select, SurfacesHangTogetherUpToTheAngle) {
  const auto mesh = blocks(2, [](int, int, int) { return true; });

  selection_query query{feature_kind::smooth, {1}};
  EXPECT_THAT(select_surfaces(*mesh, query, {})->front().surfaces, ElementsAre(1));
  query.angle = 91 * std::numbers::pi / 180;
  EXPECT_THAT(select_surfaces(*mesh, query, {})->front().surfaces, ElementsAre(1, 2, 3, 4, 5, 6));
  query.kind = feature_kind::neighbours;
  EXPECT_THAT(select_surfaces(*mesh, query, {})->front().surfaces, ElementsAre(1, 3, 4, 5, 6))
    << "2 lies opposite";
}

TEST(Select, QuestionsWithoutSenseAreRefused) {
  const auto mesh = blocks(1, [](int, int, int) { return true; });
  const auto code = [&](selection_query query) {
    return select_surfaces(*mesh, query, {}).error().code;
  };

  EXPECT_EQ(code({feature_kind::hole, {99}}), ec::surface_not_found);
  EXPECT_EQ(code({feature_kind::hole, {}}), ec::empty_selection);
  EXPECT_EQ(code({feature_kind::hole, {1, 2}}), ec::empty_selection);
  EXPECT_EQ(code({feature_kind::smooth, {1}, std::nan("")}), ec::invalid_argument);
  EXPECT_EQ(code({feature_kind::holes, {}, 0.3, 2, 1}), ec::invalid_argument);
  EXPECT_EQ(code({feature_kind::protrusion, {1}}), ec::not_a_protrusion);
}

}  // namespace
}  // namespace tedit
