// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit::fem {

/// An isotropic, linear elastic material. SI units.
struct material {
  std::string name;
  double young_modulus_pa = 0;     ///< E > 0.
  double poisson_ratio = 0;        ///< -1 < nu < 0.5.
  double density_kg_m3 = 0;        ///< >= 0; must be > 0 when gravity acts.
  double yield_strength_pa = 0;    ///< 0 when unknown.
  std::vector<region_id> regions;  ///< Empty: every region that no other material names.

  friend bool operator==(const material&, const material&) = default;
};

/// All displacement components are zero (a clamp).
struct fixed {
  friend bool operator==(const fixed&, const fixed&) = default;
};

/// Components with a value are prescribed, the others are free.
struct prescribed_displacement {
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> z_m;

  friend bool operator==(const prescribed_displacement&, const prescribed_displacement&) = default;
};

/// The displacement along the surface normal is zero; sliding is free.
struct roller {
  friend bool operator==(const roller&, const roller&) = default;
};

/// A Dirichlet condition on surfaces.
struct constraint {
  std::vector<surface_id> surfaces;
  std::variant<fixed, prescribed_displacement, roller> kind;
  /// What should be looked at before a result is believed, set by `carry_over`; mostly empty.
  std::string warning = {};

  friend bool operator==(const constraint&, const constraint&) = default;
};

/// A total force, spread evenly over the area of all surfaces together.
struct force {
  vec3 total_n;

  friend bool operator==(const force&, const force&) = default;
};

/// A force per area.
struct traction {
  vec3 pa;

  friend bool operator==(const traction&, const traction&) = default;
};

/// A force per area along the inward normal; positive pushes on the part. With a gradient it is
/// pa + gradient_pa_m . (x - at_m): that of a liquid, say, which grows with the depth.
struct pressure {
  double pa = 0;
  vec3 gradient_pa_m = {};
  vec3 at_m = {};  ///< Where it is `pa`; of no meaning without a gradient.

  friend bool operator==(const pressure&, const pressure&) = default;
};

/// An acceleration of all mass; needs no surfaces.
struct gravity {
  vec3 m_s2;

  friend bool operator==(const gravity&, const gravity&) = default;
};

/// A pressure whose size is given as N on the area of all surfaces together: on a flat face a force
/// along its inward normal; positive pushes on the part.
struct normal_force {
  double total_n = 0;

  friend bool operator==(const normal_force&, const normal_force&) = default;
};

/// A couple, spread over the surfaces as over a rigid face that leaves the part free to deform:
/// linear tractions, on a plane section Navier's of bending, on a circular one Saint-Venant's of
/// torsion.
struct moment {
  vec3 total_nm;

  friend bool operator==(const moment&, const moment&) = default;
};

/// A force at a place apart from its surfaces, and a moment, spread as `moment` is: what a lever or
/// a mass that is not in the mesh does.
struct remote_force {
  vec3 total_n;
  vec3 at_m;
  vec3 moment_nm = {};

  friend bool operator==(const remote_force&, const remote_force&) = default;
};

/// The force of a pin on its bore: a pressure on that half of the wall that faces it, which falls
/// with the cosine of the angle to the force. It pulls nowhere.
struct bearing_force {
  vec3 total_n;

  friend bool operator==(const bearing_force&, const bearing_force&) = default;
};

/// A Neumann condition on surfaces, or a body force.
struct load {
  std::vector<surface_id> surfaces;
  std::variant<force, traction, pressure, gravity, normal_force, moment, remote_force,
               bearing_force>
    kind;
  std::string warning = {};  ///< As of a constraint.

  friend bool operator==(const load&, const load&) = default;
};

/// One set of materials, supports and loads. Its file form is the canonical JSON of the protocol's
/// message `tedit.v1.LoadCase` (see protocol/convert.hpp).
struct load_case {
  std::string name;
  std::vector<material> materials;
  std::vector<constraint> constraints;
  std::vector<load> loads;

  friend bool operator==(const load_case&, const load_case&) = default;
};

}  // namespace tedit::fem
