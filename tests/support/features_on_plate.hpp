// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "ops/tools/tools.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::test {

/// A plate of 1 x 1 x 0.2 m with round holes of 0.2 m through it and rectangular bosses on it.
class features_on_plate : public tool_edits {
protected:
  static constexpr double diameter = 0.2;
  static constexpr int segments = 24;

  /// Of a hole of that length: a prism.
  static double hole_volume(double length) {
    return length * 0.5 * segments * std::pow(diameter / 2, 2) *
           std::sin(2 * std::numbers::pi / segments);
  }

  version_ptr combined(const version_ptr& mesh, const ops::tool_surface& tool,
                       ops::boolean_mode mode) {
    const auto made = host_->boolean(mesh, tool, {mode, 0}, {});
    EXPECT_TRUE(made) << render(made.error());
    return made ? made->candidate : mesh;
  }

  /// Its mouth is at `at`, it goes down through the plate.
  version_ptr with_hole(vec3 at) { return with_hole_in(plate_, at); }
  version_ptr with_hole_in(const version_ptr& mesh, vec3 at) {
    const double r = diameter / 2;
    return combined(
      mesh,
      ops::revolve(ops::make_frame(at, {0, 0, 1}),
                   {{0, 0.1, ""}, {r, 0.1, "top"}, {r, -0.3, "bore"}, {0, -0.3, "bottom"}},
                   segments, 0.04),
      ops::boolean_mode::cut);
  }

  version_ptr with_boss(const version_ptr& mesh, vec3 low, vec3 high) {
    const vec3 middle{(low.x + high.x) / 2, (low.y + high.y) / 2, low.z};
    const auto tool = ops::extrude(ops::make_frame(middle, {0, 0, 1}, {0, 1, 0}),
                                   ops::rectangle(high.x - low.x, high.y - low.y), 0,
                                   high.z - low.z, 0.1, "boss", *host_);
    EXPECT_TRUE(tool);
    return combined(mesh, *tool, ops::boolean_mode::add);
  }

  static surface_id surface_named(const mesh_version& mesh, const std::string& name) {
    for (const auto& row : mesh.surfaces())
      if (row.name == name)
        return row.id;
    ADD_FAILURE() << "there is no surface " << name;
    return 0;
  }

  /// Centroid of its facets, by area.
  static vec3 middle_of_surface(const mesh_version& mesh, surface_id id) {
    vec3 sum;
    double area = 0;
    for (const auto f : facets_of(mesh, std::array{id})) {
      const auto& v = mesh.facet(f).v;
      const double a = norm(area_vector(mesh, mesh.facet(f)));
      sum += a / 3 * (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2]));
      area += a;
    }
    return sum / area;
  }

  version_ptr plate_ = box_mesh({10, 10, 2}, {1, 1, 0.2});
};

}  // namespace tedit::test
