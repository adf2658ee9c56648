// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "fem/incidence.hpp"

namespace tedit::fem {

/// What an update changed in a problem; all that stands on the problem follows from these lists.
struct problem_change {
  /// Slots of elements whose nodes, shape or material changed, ascending; slots beyond the
  /// problem's element count went.
  std::vector<std::uint32_t> elements;
  /// Every node that such an element had or has, ascending, unused ones included: rows of these
  /// nodes changed, no others.
  std::vector<std::uint32_t> nodes;
  /// Nodes that are new or stand elsewhere than before, ascending.
  std::vector<std::uint32_t> fresh;
};

/// Carries a problem from one version of a mesh to the next where they differ, so that an edit
/// costs what it touches. Nodes and elements keep their numbers: new vertices take unused corner
/// nodes, new edges are added at the end, new elements take the places of old ones, and the last
/// elements fill what places remain.
class problem_updater {
public:
  /// Cost: O(elements).
  explicit problem_updater(const problem& p);

  /// `p` belongs to `from` and then to `to`, loads and constraints excepted: call `set_conditions`
  /// next. The materials are those that
  /// `p` was made with. Returns nothing, and leaves `p` alone, when
  /// more than a twentieth of the mesh changed, or too little room is left: then build anew.
  /// Errors: `inverted_tet`, `degenerate_tet`; then `p` is not to be used. Cost: O(pages of the
  /// mesh + change).
  [[nodiscard]] expected<std::optional<problem_change>> apply(const mesh_version& from,
                                                              const mesh_version& to,
                                                              const load_case& loads, problem& p);

  /// The corners of elements at each corner node.
  [[nodiscard]] const incidence& corners() const { return corners_; }

private:
  struct difference;

  [[nodiscard]] static difference compare(const mesh_version& from, const mesh_version& to);
  [[nodiscard]] bool fits(const difference& d, const problem& p) const;
  void touch(std::uint32_t element, const problem& p, problem_change& change) const;
  void place_vertices(const difference& d, const mesh_version& to, problem& p,
                      problem_change& change);
  void place_elements(const difference& d, problem& p, problem_change& change);
  void fill_element(const mesh_version& to, std::uint32_t element, problem& p);
  void find_unused(std::size_t old_nodes, problem& p, problem_change& change) const;

  incidence corners_;
  std::vector<std::uint32_t> element_of_;  ///< By tet slot.
  std::vector<std::uint32_t> node_of_;     ///< By vertex slot.
};

}  // namespace tedit::fem
