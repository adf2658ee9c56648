// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/fill_hole.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/build_version.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/quality.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

/// n x n x n unit cubes of six tets each; those for which `keep` is false are left out. Surfaces:
/// 1 to 6 for the sides x=0, x=n, y=0, y=n, z=0, z=n; 7 for walls inside.
template <class Keep>
version_ptr blocks(int n, Keep&& keep) {
  raw_mesh raw;
  const auto index = [&](int x, int y, int z) {
    return static_cast<vertex_id>((z * (n + 1) + y) * (n + 1) + x);
  };
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
        raw.positions.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  // Kuhn's subdivision: six tets around the diagonal.
  constexpr std::array<std::array<int, 3>, 6> paths{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        if (!keep(x, y, z))
          continue;
        for (const auto& path : paths) {
          std::array<int, 3> at{x, y, z};
          tet t;
          t.v[0] = index(x, y, z);
          for (int step = 0; step < 3; ++step) {
            ++at[path[step]];
            t.v[step + 1] = index(at[0], at[1], at[2]);
          }
          const auto& p = raw.positions;
          if (signed_volume(p[t.v[0]], p[t.v[1]], p[t.v[2]], p[t.v[3]]) < 0)
            std::swap(t.v[2], t.v[3]);
          raw.tets.push_back(t);
          raw.tet_regions.push_back(1);
        }
      }
  // Name the faces: build once without surfaces, then by position.
  const auto bare = build_version(raw, 1)->version;
  for (facet_id f = 0; f < bare->facet_slots(); ++f) {
    const auto& v = bare->facet(f).v;
    const auto all = [&](double vec3::*c, double value) {
      return std::ranges::all_of(v, [&](vertex_id i) { return bare->position(i).*c == value; });
    };
    surface_id id = 7;
    if (all(&vec3::x, 0))
      id = 1;
    else if (all(&vec3::x, n))
      id = 2;
    else if (all(&vec3::y, 0))
      id = 3;
    else if (all(&vec3::y, n))
      id = 4;
    else if (all(&vec3::z, 0))
      id = 5;
    else if (all(&vec3::z, n))
      id = 6;
    raw_mesh::triangle triangle;
    for (int i = 0; i < 3; ++i) {
      const auto& p = bare->position(v[i]);
      triangle.v[i] = index(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
    }
    triangle.surface = id;
    raw.triangles.push_back(triangle);
  }
  return build_version(std::move(raw), 1)->version;
}

struct filled {
  expected<edit_result> edit;
  expected<finished_edit> finished = fail(ec::internal, "not run");
};

filled fill(const version_ptr& mesh, std::vector<surface_id> surfaces,
            completion_settings settings = {}) {
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();
  filled result{fill_holes(*mesh, surfaces, settings, ctx)};
  if (result.edit) {
    edit_claim claim;
    claim.touched = result.edit->touched;
    claim.volume_change = result.edit->volume_change;
    result.finished = finish_edit(mesh, result.edit->candidate, claim, improvement::local, {}, {});
  }
  return result;
}

TEST(FillHole, ThroughHoleClosesIntoTheSurfacesAroundIt) {
  const auto mesh = blocks(3, [](int x, int y, int) { return x != 1 || y != 1; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.edit.has_value()) << render(result.edit.error());
  EXPECT_DOUBLE_EQ(result.edit->volume_change, 3);
  ASSERT_TRUE(result.finished.has_value()) << render(result.finished.error());
  const auto& after = *result.finished->version;
  EXPECT_NEAR(total_volume(after), 27, 1e-12);
  EXPECT_EQ(after.find_surface(7), nullptr);
  EXPECT_EQ(after.surfaces().size(), 6u);
  EXPECT_TRUE(check_version(after).ok());
  EXPECT_GE(result.finished->touched_min_after, 0.15);
}

TEST(FillHole, BlindHoleClosesWithItsBottom) {
  const auto mesh = blocks(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 2; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value());
  EXPECT_DOUBLE_EQ(result.edit->volume_change, 1);
  EXPECT_NEAR(total_volume(*result.finished->version), 27, 1e-12);
}

TEST(FillHole, ClosedVoidNeedsNoCap) {
  const auto mesh = blocks(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; });

  const auto result = fill(mesh, {7});

  ASSERT_TRUE(result.finished.has_value());
  EXPECT_NEAR(total_volume(*result.finished->version), 27, 1e-12);
  EXPECT_TRUE(check_version(*result.finished->version).ok());
}

TEST(FillHole, TheOuterSkinIsNoHole) {
  const auto mesh = blocks(2, [](int, int, int) { return true; });

  const auto result = fill(mesh, {1, 2, 3, 4, 5, 6}, {true, false});

  ASSERT_FALSE(result.edit.has_value());
  EXPECT_EQ(result.edit.error().code, ec::not_a_hole);
}

TEST(FillHole, AFlatSurfaceIsNoHole) {
  const auto mesh = blocks(2, [](int, int, int) { return true; });

  const auto result = fill(mesh, {1});

  ASSERT_FALSE(result.edit.has_value());
  EXPECT_THAT(render(result.edit.error()), HasSubstr("flat"));
}

TEST(FillHole, CancelStopsTheEdit) {
  const auto mesh = blocks(3, [](int x, int y, int) { return x != 1 || y != 1; });
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();
  ctx.run.cancel.cancel();

  const auto result = fill_holes(*mesh, {7}, {}, ctx);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
}

TEST(FillHole, MissingMesherIsNamed) {
  const auto mesh = blocks(3, [](int x, int y, int) { return x != 1 || y != 1; });
  setenv("TEDIT_LIBEXEC", "/nowhere", 1);
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();

  const auto result = fill_holes(*mesh, {7}, {}, ctx);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::service_unavailable);
  EXPECT_THAT(result.error().message, HasSubstr("/nowhere/tedit-tetgen"));
}

TEST(Rims, AFigureEightGivesTwoSimpleLoops) {
  // Two holes that touch in one vertex of the top: cells (0,0) and (1,1) of a 2 x 2 top layer are
  // open.
  const auto mesh = blocks(
    4, [](int x, int y, int z) { return z < 3 || !((x == 1 && y == 1) || (x == 2 && y == 2)); });
  const boundary_edges edges(*mesh);
  const std::vector<surface_id> walls{7};

  const auto shells = find_shells(*mesh, edges, facets_of(*mesh, walls));

  // The pinched edge below the vertex has four facets: the mesh is not manifold there, and that is
  // said, or two loops of four edges are found.
  if (shells) {
    std::size_t rims = 0;
    for (const auto& part : *shells)
      for (const auto& r : part.rims) {
        EXPECT_EQ(r.loop.size(), 4u);
        ++rims;
      }
    EXPECT_EQ(rims, 2u);
  } else {
    EXPECT_EQ(shells.error().code, ec::non_manifold);
  }
}

}  // namespace
}  // namespace tedit::ops
