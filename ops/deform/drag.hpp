// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/shapes/deform/deform_zone.hpp"
#include "ops/shapes/deform/moved_boundary.hpp"

namespace tedit::ops {

class smooth_field;

/// A handle that is dragged along one direction: all that does not depend on how far.
class drag {
public:
  /// `keep_volume`: also how free vertices give way. Errors: those of `smooth_field`;
  /// `invalid_parameter` where the volume is to be kept and nothing can give way. Cost: the
  /// field's.
  [[nodiscard]] static expected<drag> prepare(const version_ptr& mesh, const drag_handle& handle,
                                              deform_zone zone, vec3 direction, bool keep_volume,
                                              const execution& run);

  /// The version with the handle `distance` (m) along the direction. Errors: `inverted_tet`,
  /// `invalid_argument`, both without a remedy; `cancelled`. Cost: O(zone).
  [[nodiscard]] expected<edit_result> by(double distance, const execution& run) const;

  /// Is there nothing within the zone's reach that stays?
  [[nodiscard]] bool moves_all() const { return moves_all_; }

private:
  drag(version_ptr mesh, std::vector<vertex_id> moved)
      : mesh_(std::move(mesh)), moved_(std::move(moved)), boundary_(*mesh_, moved_) {}

  [[nodiscard]] expected<void> find_shares(const smooth_field& field,
                                           const std::vector<vertex_id>& vertices,
                                           const execution& run);
  [[nodiscard]] expected<void> find_give_way(const smooth_field& field,
                                             const std::vector<vertex_id>& vertices,
                                             const execution& run);
  [[nodiscard]] double boundary_change(const std::vector<vec3>& places) const;
  [[nodiscard]] expected<std::vector<vec3>> places_at(double distance) const;
  [[nodiscard]] expected<void> check_tets(const std::vector<vec3>& places) const;
  [[nodiscard]] vec3 place_of(vertex_id v, const std::vector<vec3>& places) const;

  version_ptr mesh_;
  std::vector<vertex_id> moved_;  ///< Ascending.
  moved_boundary boundary_;
  std::vector<tet_id> tets_;
  std::vector<std::uint32_t> number_;  ///< Of a vertex slot among the moved; `no_id` of others.
  std::vector<facet_id> facets_;       ///< With a moved vertex.
  vec3 direction_;
  std::vector<double> share_;   ///< Of the handle's way, by moved vertex.
  std::vector<vec3> give_way_;  ///< By moved vertex; empty: the volume is not kept.
  double worst_before_ = 1;
  bool moves_all_ = false;
};

}  // namespace tedit::ops
