// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "mesh/pieces.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// Which surface a face belongs to that a removal lays bare.
using surface_of_face = std::function<surface_id(const std::array<vertex_id, 3>& face)>;

/// Takes the tets out; every face laid bare gets its surface from `name`, but one between regions
/// that has an id keeps it. Errors: those of `mesh_builder::apply`. Cost: also O(interface facets).
[[nodiscard]] expected<void> take_off(mesh_builder& mesh, const std::unordered_set<tet_id>& removed,
                                      const surface_of_face& name);

/// What the steps of an erosion add up to.
struct erosion_sum {
  piece_policy policy = piece_policy::refuse;
  removal_report removal;         ///< Counts summed up; bodies and pieces of the last step.
  std::size_t bodies_added = 0;   ///< Pieces that bodies fell into beyond one each, in all steps.
  std::vector<surface_id> fresh;  ///< Surfaces that the edit made.
  std::vector<std::string> notices;
  std::vector<figure> figures;

  void add(const removal_report& step);
};

}  // namespace tedit::ops
