// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/file_mesh.hpp"

#include "mesh/io/line_cursor.hpp"
#include "mesh/io/surface_sets.hpp"

namespace tedit {

namespace {

/// Corners of the edges of a quadratic tet, in the order of VTK and Abaqus.
constexpr std::array<std::array<int, 2>, 6> edges_of_tet{
  {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// `place`: an element, for its line is long past; empty where it is the whole file.
[[noreturn]] void refuse(std::string message, std::string remedy, std::string place = {}) {
  throw file_failure{{ec::bad_input, std::move(message), std::move(remedy), std::move(place)}};
}

}  // namespace

void file_mesh::add_node(std::uint64_t number, vec3 at) {
  node_numbers.push_back(number);
  positions.push_back(at);
}

void file_mesh::add_tet(std::uint64_t number, region_id region,
                        const std::vector<std::uint64_t>& nodes) {
  if (nodes.size() == 10) {
    // The class of mid nodes takes them as Gmsh lists them: (2,3) before (1,3).
    const std::array<std::uint64_t, 6> middles{nodes[4], nodes[5], nodes[6],
                                               nodes[7], nodes[9], nodes[8]};
    edges_.add(tets.size(), 1, middles.data());
    for (int e = 0; e < 6; ++e)
      middles_.try_emplace(nodes[4 + static_cast<std::size_t>(e)], middle{tets.size(), e});
  }
  tet_numbers.push_back(number);
  tets.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
  regions.push_back(region);
}

std::optional<std::array<std::uint64_t, 2>> file_mesh::ends_of(std::uint64_t node) const {
  const auto found = middles_.find(node);
  if (found == middles_.end())
    return std::nullopt;
  const auto& [a, b] = edges_of_tet[static_cast<std::size_t>(found->second.edge)];
  const auto& corners = tets[found->second.tet];
  return std::array{corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]};
}

const std::array<std::uint64_t, 4>* file_mesh::find_tet(std::uint64_t number) {
  if (tet_by_number_.empty())
    for (std::size_t t = 0; t < tets.size(); ++t)
      if (!tet_by_number_.emplace(tet_numbers[t], t).second)
        refuse("element " + std::to_string(tet_numbers[t]) + " is listed twice",
               "Number the elements anew, or remove one of the two",
               "element " + std::to_string(tet_numbers[t]));
  const auto found = tet_by_number_.find(number);
  return found == tet_by_number_.end() ? nullptr : &tets[found->second];
}

void file_mesh::index_nodes() {
  by_number_.reserve(node_numbers.size());
  for (std::size_t i = 0; i < node_numbers.size(); ++i)
    if (!by_number_.emplace(node_numbers[i], static_cast<vertex_id>(i)).second)
      refuse("node " + std::to_string(node_numbers[i]) + " is listed twice",
             "Number the nodes anew, or remove one of the two",
             "node " + std::to_string(node_numbers[i]));
}

std::optional<vertex_id> file_mesh::find_node(std::uint64_t number) {
  if (by_number_.empty())
    index_nodes();
  const auto found = by_number_.find(number);
  return found == by_number_.end() ? std::nullopt : std::optional(found->second);
}

void file_mesh::resolve_tets(read_mesh& out) {
  for (std::size_t t = 0; t < tets.size(); ++t) {
    tet corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto node = find_node(tets[t][i]);
      if (!node)
        refuse("tet " + std::to_string(tet_numbers[t]) + " names node " +
                 std::to_string(tets[t][i]) + ", which does not exist",
               "Write the file with all of its nodes", "tet " + std::to_string(tet_numbers[t]));
      corners.v[i] = *node;
    }
    out.mesh.tets.push_back(corners);
  }
}

read_mesh file_mesh::finish() {
  if (positions.empty())
    refuse("the file holds no nodes", "Write the mesh again");
  if (tets.empty())
    refuse("the mesh has no volume elements (tets)",
           "Mesh the volume with tetrahedra and write them, too");
  (void)find_tet(tet_numbers.front());  // No number twice.
  read_mesh out;
  resolve_tets(out);
  if (edges_.tets() > 0)
    out.notices.push_back(edges_.describe(out.mesh.tets, positions,
                                          [&](std::uint64_t node) { return find_node(node); }));
  out.mesh.positions = positions;
  out.mesh.tet_regions = regions;
  out.mesh.region_names = region_names;
  out.mesh.node_numbers = node_numbers;
  out.mesh.tet_numbers = tet_numbers;
  give_surfaces(*this, out);
  return out;
}

}  // namespace tedit
