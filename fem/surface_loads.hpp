// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fem/problem_parts.hpp"

/// How a load that is given in all is spread over its surfaces; internal to fem/.
namespace tedit::fem {

/// A linear traction on a triangle, by its values at the corners, Pa.
using corner_tractions = std::array<vec3, 3>;

/// The surfaces that one load acts on, as triangles of the problem's nodes.
class loaded_patch {
public:
  loaded_patch(const surface_triangles& triangles, const problem& p,
               const std::vector<surface_id>& surfaces);

  [[nodiscard]] double area() const noexcept { return area_; }  ///< m^2.

  /// The first surface between two regions, which has no outer side; or none.
  [[nodiscard]] std::optional<surface_id> interface_surface() const { return interface_; }

  /// Calls with each triangle and its area vector, outward, m^2.
  void for_each(const std::function<void(const surface_triangles::triangle&, vec3)>& visit) const;

  [[nodiscard]] std::array<vec3, 3> corners(const surface_triangles::triangle& t) const;

private:
  const problem& p_;
  std::vector<const surface_triangles::triangle*> triangles_;
  double area_ = 0;
  std::optional<surface_id> interface_;
};

/// Traction by place, Pa. It is linear in the place.
using linear_traction = std::function<vec3(vec3)>;

/// The traction a + b x (x - c) whose resultant is `force_n` and whose moment about `at_m` is
/// `moment_nm`: that of a rigid face, which leaves the part free to deform. On a plane cross
/// section it is Navier's stress of bending, on a circular one Saint-Venant's of torsion.
/// Errors: `invalid_load` when the surfaces are a line or a point, which carries no moment.
[[nodiscard]] expected<linear_traction> spread_evenly(const loaded_patch& patch, vec3 force_n,
                                                      vec3 moment_nm, vec3 at_m,
                                                      const std::string& name);

/// The pressure of a pin on the wall of its bore: it falls with the cosine of the angle to the
/// force and acts where the wall faces it. One traction for each triangle that carries, by area
/// vector.
struct bearing_pressure {
  vec3 direction;  ///< About that of the force; triangles that look against it carry.
  vec3 slope_pa;   ///< The traction is n (n . slope), with the outward unit normal n,
  vec3 rest_pa;    ///< and this, which makes the resultant exact.

  [[nodiscard]] vec3 on(vec3 area_vector) const;
};

/// Errors: `invalid_load` when no wall faces the force, or where part of it is along the bore.
[[nodiscard]] expected<bearing_pressure> press_like_a_pin(const loaded_patch& patch, vec3 force_n,
                                                          const std::string& name);

}  // namespace tedit::fem
