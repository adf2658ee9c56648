// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/improve_mesh/improve_mesh.hpp"

#include <gtest/gtest.h>

#include "mesh/finish_edit.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

/// A bar whose inner grid points are out of place, worst at x = 0.5.
version_ptr spoiled() {
  return test::box_mesh({8, 2, 2}, {4, 1, 1}, [](vec3 p) {
    const bool inner = p.y == 0.5 && p.z == 0.5 && p.x > 0 && p.x < 4;
    return inner ? p + vec3{0.3 / p.x, 0.1, -0.2} : p;
  });
}

edit_claim claim_of(const edit_result& edit) {
  edit_claim claim;
  claim.touched = edit.touched;
  claim.volume_change = edit.volume_change;
  return claim;
}

TEST(ImproveMesh, WithoutASelectionTheWholeMeshIsTheRegion) {
  const auto mesh = spoiled();
  context ctx;

  const auto edit = improve_mesh(mesh, {}, {}, ctx);

  ASSERT_TRUE(edit.has_value());
  EXPECT_EQ(edit->candidate->id(), mesh->id());
  EXPECT_EQ(edit->touched.size(), mesh->tet_count());
  EXPECT_EQ(edit->improve, improvement::thorough);
}

TEST(ImproveMesh, ASelectionTakesTheTetsAroundItOnly) {
  const auto mesh = spoiled();
  context ctx;

  const auto edit = improve_mesh(mesh, {{1}}, {}, ctx);

  ASSERT_TRUE(edit.has_value());
  for (const auto t : edit->touched)
    for (const auto& p : mesh->corners(t))
      EXPECT_LT(p.x, 2.5);
  EXPECT_LT(edit->touched.size(), mesh->tet_count() / 2 + 1);
}

TEST(ImproveMesh, TheBoundaryMayNotMoveAcrossThePart) {
  const auto mesh = spoiled();
  context ctx;
  thorough_settings settings;
  const double most = 0.01 * std::sqrt(16.0 + 1 + 1);  // Of the bar's diagonal.

  settings.tolerance.absolute = 0.999 * most;
  EXPECT_TRUE(improve_mesh(mesh, {}, settings, ctx).has_value());
  for (const double far : {1.001 * most, 1e308}) {
    settings.tolerance.absolute = far;
    const auto refused = improve_mesh(mesh, {}, settings, ctx);
    ASSERT_FALSE(refused.has_value()) << far;
    EXPECT_EQ(refused.error().code, ec::invalid_parameter);
    EXPECT_NE(refused.error().remedy.find("0 to 42.43 mm"), std::string::npos);
  }
}

TEST(ImproveMesh, TheHostTakesTheResultAndSaysWhatBecameBetter) {
  const auto mesh = spoiled();
  context ctx;
  const auto edit = improve_mesh(mesh, {}, {}, ctx);
  ASSERT_TRUE(edit.has_value());

  const auto done =
    finish_edit(mesh, edit->candidate, claim_of(*edit), {edit->improve, edit->thorough}, {}, {});

  ASSERT_TRUE(done.has_value()) << render(done.error());
  const auto& report = done->improvement;
  EXPECT_GT(report.min_after, 2 * report.min_before);
  EXPECT_EQ(report.after->min_ratio, radius_ratios(*done->version).min);
  EXPECT_GT(report.after->mean_ratio, report.before->mean_ratio);
  EXPECT_EQ(report.after->tets, done->version->tet_count());
  EXPECT_NEAR(total_volume(*done->version), 4, 1e-12);
  EXPECT_EQ(report.surface_deviation, 0);
}

}  // namespace
}  // namespace tedit::ops
