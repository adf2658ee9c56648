// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/new_triangles.hpp"

#include <gtest/gtest.h>

namespace tedit::ops {
namespace {

/// A triangle that was there, at z = -1, and a new one in the plane z = 0; its first point is
/// vertex 7 of the mesh.
class NewTriangles : public testing::Test {
protected:
  closed_surface surface{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, -1}, {2, 0, -1}, {0, 2, -1}},
                         {{3, 4, 5}, {0, 1, 2}}};
  std::vector<vertex_id> vertices{7, no_id, no_id, 3, 4, 5};
  new_triangles made{surface, vertices, 1};
};

TEST_F(NewTriangles, AFacetThatPassesThroughOneMeetsIt) {
  EXPECT_TRUE(made.meet({10, 11, 12}, {vec3{0.5, 0.5, -1}, {0.5, 0.5, 1}, {0.6, 0.5, 1}}));
}

TEST_F(NewTriangles, OneThatEndsBelowOrLiesBesideDoesNot) {
  EXPECT_FALSE(made.meet({10, 11, 12}, {vec3{0.5, 0.5, -1}, {0.5, 0.5, -0.1}, {0.6, 0.5, -1}}));
  EXPECT_FALSE(made.meet({10, 11, 12}, {vec3{1.5, 1.5, -1}, {1.5, 1.5, 1}, {1.6, 1.5, 1}}));
}

TEST_F(NewTriangles, OneThatHasACornerInCommonDoesNot) {
  EXPECT_FALSE(made.meet({7, 11, 12}, {vec3{0, 0, 0}, {0.5, 0.5, -1}, {0.6, 0.5, 1}}));
}

TEST_F(NewTriangles, WhatWasThereBeforeIsNoneOfThem) {
  EXPECT_FALSE(made.meet({10, 11, 12}, {vec3{0.5, 0.5, -2}, {0.5, 0.5, -0.5}, {0.6, 0.5, -0.5}}));
  EXPECT_EQ(made.extent(), (box{{0, 0, 0}, {2, 2, 0}}));
}

}  // namespace
}  // namespace tedit::ops
