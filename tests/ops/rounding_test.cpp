// SPDX-License-Identifier: AGPL-3.0-or-later
#include <random>

#include "mesh/features/rims.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/rounding.hpp"

namespace tedit::test {
namespace {

class RoundedParts : public rounding {
protected:
  static version_ptr part(const std::string& name) {
    const auto folder = std::filesystem::path(TEDIT_TEST_DATA "/parts") / name;
    auto imported = import_mesh(folder / (name + ".coarse.msh"), "mm");
    EXPECT_TRUE(imported);
    return imported ? imported->version : nullptr;
  }
};

/// The blind hole 8, 9 of inch_block: radius 3.175 mm, axis x through (y, z) = (33.682, 25.4) mm.
TEST_F(RoundedParts, AHolesEntryBecomesATorus) {
  const auto base = part("inch_block");
  ASSERT_TRUE(base);
  constexpr double hole = 3.175e-3;
  constexpr double r = 1e-3;

  const auto result = round(base, {2, 8}, -1, r);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  // The other half of the wall goes on smoothly: it is rounded with it, as one surface.
  EXPECT_EQ(result->surfaces_used, (std::vector<surface_id>{2, 8, 9}));
  const auto made = fresh(*base, *after);
  ASSERT_EQ(made.size(), 1u);
  const auto shape = fit_wall(*base, facets_of(*base, std::vector<surface_id>{8}));
  ASSERT_TRUE(shape);
  EXPECT_NEAR(shape->radius, hole, 1e-8);
  for (const auto p : points_of(*after, made.front())) {
    const double rho = norm(vec3{0, p.y - shape->point.y, p.z - shape->point.z});
    EXPECT_NEAR(std::hypot(rho - shape->radius - r, p.x - 25.4e-3 + r), r, 1e-9);
  }
}

TEST_F(RoundedParts, RandomEdgesAndRadiiGiveGoodEditsOrNamedRefusals) {
  std::mt19937 random(7);
  int done = 0;
  for (const auto* name : {"inch_block", "ctc01_plate"}) {
    const auto base = part(name);
    ASSERT_TRUE(base);
    const auto id = base->id();
    std::vector<std::pair<facet_id, int>> edges;
    for (facet_id f = 0; f < base->facet_slots(); ++f)
      for (int i = 0; i < 3; ++i)
        if (std::abs(material_angle(*base, f, i) - std::numbers::pi) > 0.3)
          edges.emplace_back(f, i);
    for (int trial = 0; trial < 12; ++trial) {
      const auto [f, i] = edges[random() % edges.size()];
      const auto& facet = base->facet(f);
      const surface_id a = facet.surface;
      const surface_id b = base->facet(facet_across(*base, f, i)).surface;
      const double side = material_angle(*base, f, i) > std::numbers::pi ? 1 : -1;
      const double length = norm(base->position(facet.v[i]) - base->position(facet.v[(i + 1) % 3]));
      const double r = length * std::exp2(-2 + 3 * (random() % 1000) / 1000.0);
      SCOPED_TRACE(std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(r));

      const auto result = round(base, {a, b}, side, r, 3);

      EXPECT_EQ(base->id(), id);
      if (!result) {
        EXPECT_FALSE(result.error().message.empty());
        EXPECT_FALSE(result.error().remedy.empty());
        continue;
      }
      const auto finished = try_finish(base, *result);
      if (!finished) {
        EXPECT_EQ(finished.error().code, ec::postcondition_failed);
        continue;
      }
      ++done;
      EXPECT_TRUE(check_version(**finished).ok());
      EXPECT_EQ(side > 0, total_volume(**finished) > total_volume(*base));
    }
  }
  EXPECT_GE(done, 8);
}

}  // namespace
}  // namespace tedit::test
