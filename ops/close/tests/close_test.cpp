// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/support/rounding.hpp"

namespace tedit::test {
namespace {

using Close = rounding;

/// 4 x 3 x 4 with a step: the quarter x > 2, z > 2 is left out. Walls 7: x = 2 and z = 2 there.
version_ptr step() {
  auto mesh = blocks({4, 3, 4}, [](int x, int, int z) { return x < 2 || z < 2; });
  mesh_builder builder(mesh);
  const auto riser = builder.add_surface("riser");
  for (facet_id f = 0; f < builder.facet_slots(); ++f)
    if (builder.facet(f).surface == 7 && std::ranges::all_of(builder.facet(f).v, [&](vertex_id v) {
          return builder.position(v).x == 2;
        }))
      builder.set_surface(f, riser);
  return builder.freeze();
}

TEST_F(Close, AnInnerCornerGetsTheExactVolumeOfItsPolygon) {
  const auto base = step();
  for (const double r : {0.3, 0.7, 1.2}) {
    SCOPED_TRACE(r);

    const auto result = round(base, {7, 8}, +1, r);

    const auto after = finish(base, result);
    ASSERT_TRUE(after);
    const auto made = fresh(*base, *after);
    ASSERT_EQ(made.size(), 1u);
    for (const auto p : points_of(*after, made.front()))
      EXPECT_NEAR(std::hypot(p.x - 2 - r, p.z - 2 - r), r, 1e-12);
    EXPECT_NEAR(total_volume(*after) - total_volume(*base), spandrel(r > 1 ? 4 : 4) * r * r * 3,
                1e-11);
  }
}

}  // namespace
}  // namespace tedit::test
