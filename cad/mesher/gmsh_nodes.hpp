// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <gmsh.h>

namespace tedit::cad {

// Gmsh's numbers of element types.
inline constexpr int gmsh_triangle = 2;
inline constexpr int gmsh_tet = 4;

/// The nodes of the current model, by their places.
class nodes_of_mesh {
public:
  nodes_of_mesh() {
    std::vector<std::size_t> tags;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, at, parameters, -1, -1, false, false);
    for (std::size_t i = 0; i < tags.size(); ++i)
      index_[tags[i]] = static_cast<std::int32_t>(i);
  }

  /// The corners of each element of this type on an entity.
  template <std::size_t Corners>
  [[nodiscard]] std::vector<std::array<std::int32_t, Corners>> of_elements(int type,
                                                                           int entity) const {
    std::vector<std::size_t> elements;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
    std::vector<std::array<std::int32_t, Corners>> result(elements.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      result[i / Corners][i % Corners] = index_.at(nodes[i]);
    return result;
  }

  std::vector<double> at;  ///< Three for each node.

private:
  std::map<std::size_t, std::int32_t> index_;
};

}  // namespace tedit::cad
