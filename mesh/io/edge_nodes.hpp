// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// The nodes on edges of quadratic and cubic tets, as a file numbers them. They are left out of the
/// mesh; what is kept of them says how much is lost.
class edge_nodes {
public:
  /// Nodes of one tet on its edges in Gmsh's order: `per_edge` on each, 1 or 2.
  void add(std::size_t tet, int per_edge, const std::uint64_t* numbers);

  [[nodiscard]] std::size_t tets() const { return rows_.size(); }

  /// "3 tets have nodes on their edges; they are read as ...", with how many of the nodes lie off
  /// the straight edge, how far and where, in the file's unit. Numbers that `find` does not know
  /// are passed over. Cost: O(tets).
  [[nodiscard]] std::string describe(
    const std::vector<tet>& tets, const std::vector<vec3>& positions,
    const std::function<std::optional<vertex_id>(std::uint64_t)>& find) const;

private:
  struct row {
    std::uint32_t tet;
    std::uint32_t per_edge;
  };

  std::vector<row> rows_;
  std::vector<std::uint64_t> numbers_;  ///< Six or twelve for each row.
};

}  // namespace tedit
