// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "mesh/io/import.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/quality.hpp"

namespace tedit {
namespace {

/// q of all live tets, worst first.
std::vector<double> ratios(const mesh_version& mesh) {
  std::vector<double> result;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      result.push_back(radius_ratio(mesh.corners(t)));
  std::ranges::sort(result);
  return result;
}

/// Thin boundary triangles spoil tets that nothing inside can help: trading them for others must
/// not spread them.
TEST(LocalPass, LeavesFewBadTetsOnAPartWithSliverTriangles) {
  const auto imported =
    import_mesh(TEDIT_TEST_DATA "/parts/bracket_4040/bracket_4040.coarse.msh", "mm");
  ASSERT_TRUE(imported.has_value());
  const auto mesh = imported->version;
  std::vector<tet_id> all(mesh->tet_slots());
  for (tet_id t = 0; t < mesh->tet_slots(); ++t)
    all[t] = t;
  mesh_builder builder(mesh);

  const auto report = improve(builder, all, {}, {});

  ASSERT_TRUE(report.has_value());
  const auto after = builder.freeze();
  const auto before = ratios(*mesh);
  const auto now = ratios(*after);
  EXPECT_GE(now.front(), before.front() * (1 - 1e-12));
  // The 1 % quantile.
  EXPECT_GT(now[now.size() / 100], before[before.size() / 100]);
  EXPECT_LT(std::ranges::lower_bound(now, 0.1) - now.begin(),
            std::ranges::lower_bound(before, 0.1) - before.begin());
  EXPECT_EQ(after->facet_count(), mesh->facet_count());
  EXPECT_LE(check_version(*after).total, check_version(*mesh).total);
}

}  // namespace
}  // namespace tedit
