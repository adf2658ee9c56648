// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/improve_mesh/improve_mesh.hpp"

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/flat.hpp"
#include "ops/services/host_services.hpp"
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

std::size_t flat_tets(const mesh_version& mesh) {
  std::size_t count = 0;
  for (const auto t : test::all_tets(mesh)) {
    const auto corners = mesh.corners(t);
    count += is_flat(corners, signed_volume(corners));
  }
  return count;
}

/// A cube with a tet without volume on its top: a square's two facets have one on the other
/// diagonal before them, so that all four corners lie on the boundary.
version_ptr with_flat_tet() {
  const auto plain = test::box_mesh({2, 2, 2}, {1, 1, 1});
  raw_mesh raw;
  for (vertex_id v = 0; v < plain->vertex_slots(); ++v)
    raw.positions.push_back(plain->position(v));
  for (const auto t : test::all_tets(*plain)) {
    raw.tets.push_back(plain->tet_at(t));
    raw.tet_regions.push_back(1);
  }
  const auto corner = [&](double x, double y) {
    for (vertex_id v = 0; v < plain->vertex_slots(); ++v)
      if (plain->position(v) == vec3{x, y, 1})
        return v;
    return no_id;
  };
  // The facets of the square have its lowest and highest corner in common.
  const auto a = corner(0, 0);
  const auto b = corner(0.5, 0);
  const auto c = corner(0.5, 0.5);
  const auto d = corner(0, 0.5);
  raw.tets.push_back({{a, b, c, d}});
  raw.tet_regions.push_back(1);
  for (facet_id f = 0; f < plain->facet_slots(); ++f) {
    const auto& facet = plain->facet(f);
    const bool of_square = std::ranges::all_of(
      facet.v, [&](vertex_id v) { return v == a || v == b || v == c || v == d; });
    if (!of_square)
      raw.triangles.push_back({facet.v, facet.surface, true});
  }
  raw.triangles.push_back({{a, b, d}, 6, true});
  raw.triangles.push_back({{b, c, d}, 6, true});
  return build_version(std::move(raw), 1)->version;
}

TEST(ImproveMesh, TetsWithoutVolumeAreMeshedAnew) {
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  const auto mesh = with_flat_tet();
  ASSERT_EQ(flat_tets(*mesh), 1U);
  const auto host = make_host_services();
  context ctx;
  ctx.host = host.get();

  const auto edit = improve_mesh(mesh, {}, {}, ctx);

  ASSERT_TRUE(edit.has_value()) << render(edit.error());
  EXPECT_EQ(flat_tets(*edit->candidate), 0U);
  EXPECT_EQ(edit->touched.size(), edit->candidate->tet_count());
  ASSERT_EQ(edit->figures.size(), 1U);
  EXPECT_EQ(edit->figures.front().value, 1);
  EXPECT_NEAR(total_volume(*edit->candidate), 1, 1e-12);
  const auto done = finish_edit(mesh, edit->candidate, claim_of(*edit), edit->improve, {}, {});
  ASSERT_TRUE(done) << render(done.error());
  EXPECT_TRUE(check_version(*done->version).ok());
  // The facets that were before the flat tet are still there.
  EXPECT_EQ(facets_of(*done->version, std::vector<surface_id>{6}).size(), 8U);
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
