// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/incidence.hpp"
#include "fem/polled.hpp"
#include "fem/solver.hpp"

namespace tedit::fem {

/// A flux (here: stress, 6 components) at the corners of all elements. Over a linear tet it is
/// constant and stored once; over a quadratic one it is linear between its corner values.
struct corner_flux {
  std::size_t per_element = 1;     ///< 1 or 4.
  std::span<const double> values;  ///< 6 * per_element per element.
  std::vector<double> storage;     ///< Of the values, until it is moved elsewhere.

  corner_flux(std::size_t each, std::size_t elements) : per_element(each) {
    polled_resize(storage, 6 * each * elements);
    values = storage;
  }
  // A copy's values would be the other's.
  corner_flux(corner_flux&&) = default;
  corner_flux& operator=(corner_flux&&) = default;

  [[nodiscard]] const double* at(std::size_t e, std::size_t corner) const {
    return &values[6 * (per_element * e + (per_element == 1 ? 0 : corner))];
  }
};

/// Stress at the corners, Pa, in fp64 from the displacement (m, 3 per node). Cost: O(elements), on
/// all cores.
[[nodiscard]] corner_flux corner_stress(const problem& p, std::span<const double> displacement);

/// The corner nodes, divided by the material of the elements around: a flux that jumps from one
/// material to the next is averaged within each one only. A patch is a node and a material.
class nodal_patches {
public:
  /// `p` must outlive the patches. Cost: O(elements), on all cores.
  explicit nodal_patches(const problem& p);

  /// Elements around corner nodes; only corner nodes have entries.
  [[nodiscard]] const incidence& corners() const { return corners_; }
  [[nodiscard]] double volume_of(std::size_t element) const { return volumes_[element]; }  ///< m^3.
  [[nodiscard]] double volume() const;  ///< m^3, all elements.

  [[nodiscard]] std::size_t count() const { return material_.size(); }
  [[nodiscard]] std::size_t first_of(std::size_t node) const { return first_[node]; }
  [[nodiscard]] std::size_t end_of(std::size_t node) const { return first_[node + 1]; }
  [[nodiscard]] std::uint32_t material_of(std::size_t patch) const { return material_[patch]; }
  /// Volume of the patch's elements over that of all elements around the node.
  [[nodiscard]] double share_of(std::size_t patch) const { return share_[patch]; }

  /// The patch of a node in an element that has the node.
  [[nodiscard]] std::size_t patch_in(std::size_t node, std::size_t element) const {
    std::size_t patch = first_[node];
    while (material_[patch] != problem_.element_materials[element])
      ++patch;
    return patch;
  }

  /// Volume-weighted mean of the corner values, 6 per patch. Cost: O(elements), on all cores.
  [[nodiscard]] std::vector<double> means_of(const corner_flux& flux) const;

private:
  const problem& problem_;
  incidence corners_;
  std::vector<double> volumes_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> material_;
  std::vector<double> share_;
};

/// Eigenvalues of a stress in Voigt order, descending, Pa. In closed form: values that coincide
/// come out apart by up to 1e-8 of the largest one.
[[nodiscard]] std::array<double, 3> principal_values(const double* stress);

/// Divides the reactions among the surfaces that hold each node. A node's reaction r is shared as
/// if every surface held it by springs along the directions that it constrains, as stiff as its
/// area around the node is large: r_h = P_h y with (sum P_h) y = r. So a direction that one surface
/// alone holds is all its own, one that several hold is shared by area, and the sums add up to the
/// total. Ascending by surface. Cost: O(held nodes).
[[nodiscard]] std::vector<surface_reaction> reactions_by_surface(const problem& p,
                                                                 std::span<const double> reactions);

/// Fills everything of `out` that follows from its displacement, in fp64 on the host. Cost:
/// O(mesh), on all cores.
void recover(const problem& p, const element_operator& k, solution& out);

}  // namespace tedit::fem
