// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "mesh/io/edge_nodes.hpp"
#include "mesh/io/read_mesh.hpp"

namespace tedit {

/// A mesh as decks have it: numbered nodes and tets, sets of faces and of nodes. A reader fills it,
/// `finish` makes a raw mesh of it.
struct file_mesh {
  struct face_set {
    std::string name;
    std::optional<surface_id> id = {};  ///< Where the file says it.
    std::vector<std::array<std::uint64_t, 3>> faces = {};
  };
  struct node_set {
    std::string name;
    std::vector<std::uint64_t> nodes = {};
  };

  std::vector<std::uint64_t> node_numbers;
  std::vector<vec3> positions;
  std::vector<std::uint64_t> tet_numbers;
  std::vector<std::array<std::uint64_t, 4>> tets;  ///< Corners, by their numbers.
  std::vector<region_id> regions;                  ///< One for each tet.
  std::vector<region_info> region_names;
  std::vector<face_set> face_sets;
  std::vector<node_set> node_sets;  ///< Surfaces only where no set of faces names a face.

  void add_node(std::uint64_t number, vec3 at);

  /// Four nodes, or ten with the middles of (0,1), (1,2), (2,0), (0,3), (1,3), (2,3).
  void add_tet(std::uint64_t number, region_id region, const std::vector<std::uint64_t>& nodes);

  /// The ends of the edge in whose middle a node of a quadratic tet lies.
  [[nodiscard]] std::optional<std::array<std::uint64_t, 2>> ends_of(std::uint64_t node) const;

  /// Corners of each tet, by node numbers, found by its number. Null where there is none. The
  /// first call makes an index.
  [[nodiscard]] const std::array<std::uint64_t, 4>* find_tet(std::uint64_t number);

  /// The place of a node among `positions`.
  [[nodiscard]] std::optional<vertex_id> find_node(std::uint64_t number);

  /// Sets of faces become surfaces: with their ids, with the numbers at the end of their names
  /// where these are distinct, else numbered. A face that two sets name stays with the smaller one,
  /// which is said. Sets of nodes give surfaces to boundary faces, all of whose corners they hold,
  /// that no set of faces has. Throws `file_failure` for no nodes or tets, a number twice, a node
  /// that is not there. Cost: O(n log n). Indices for `find_node` stay valid.
  [[nodiscard]] read_mesh finish();

private:
  void index_nodes();
  void resolve_tets(read_mesh& out);

  struct middle {
    std::size_t tet;
    int edge;
  };

  edge_nodes edges_;
  std::unordered_map<std::uint64_t, middle> middles_;
  std::unordered_map<std::uint64_t, vertex_id> by_number_;
  std::unordered_map<std::uint64_t, std::size_t> tet_by_number_;
};

}  // namespace tedit
