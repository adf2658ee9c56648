// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/finish_edit.hpp"
#include "ops/services/host_services.hpp"
#include "ops/shapes/rounding/round_edges.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::test {

/// What `close` and `open` share in their tests: the edit, with all postconditions and the host's
/// improvement.
class rounding : public ::testing::Test {
protected:
  expected<ops::edit_result> round(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                   double side, double radius, int segments = 4) {
    return ops::round_edges(mesh, surfaces, side, {radius, segments}, ctx_);
  }

  /// The version that the host would keep. Errors: those of the postconditions.
  static expected<version_ptr> try_finish(const version_ptr& base, const ops::edit_result& result) {
    edit_claim claim;
    claim.touched = result.touched;
    claim.volume_change = result.volume_change;
    claim.quality_floor = result.quality_floor;
    auto done = finish_edit(base, result.candidate, claim, result.improve, finish_settings{}, {});
    if (!done)
      return fail(done.error());
    return done->version;
  }

  static version_ptr finish(const version_ptr& base, const expected<ops::edit_result>& result) {
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return nullptr;
    const auto done = try_finish(base, *result);
    EXPECT_TRUE(done) << render(done.error());
    if (!done)
      return nullptr;
    EXPECT_TRUE(check_version(**done).ok());
    return *done;
  }

  /// Surfaces that `after` has and `before` has not.
  static std::vector<surface_id> fresh(const mesh_version& before, const mesh_version& after) {
    std::vector<surface_id> result;
    for (const auto& row : after.surfaces())
      if (!before.find_surface(row.id))
        result.push_back(row.id);
    return result;
  }

  static std::vector<vec3> points_of(const mesh_version& mesh, surface_id id) {
    std::vector<vec3> result;
    for (const auto f : facets_of(mesh, std::vector{id}))
      for (const auto v : mesh.facet(f).v)
        result.push_back(mesh.position(v));
    return result;
  }

  static double area(const mesh_version& mesh, surface_id id) {
    double sum = 0;
    for (const auto f : facets_of(mesh, std::vector{id}))
      sum += norm(area_vector(mesh, mesh.facet(f)));
    return sum;
  }

  /// Cross-section between two walls at right angles and an inscribed arc of n segments, per r^2:
  /// the square less the polygon over the arc; tends to 1 - pi/4.
  static double spandrel(int n) { return 1 - 0.5 * n * std::sin(std::numbers::pi / (2 * n)); }

  std::unique_ptr<ops::services> host_ = ops::make_host_services();
  ops::context ctx_{{}, host_.get(), {}, 1e9};
};

}  // namespace tedit::test
