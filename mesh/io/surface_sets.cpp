// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/surface_sets.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "mesh/face_key.hpp"
#include "mesh/face_table.hpp"
#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

using corners = std::array<vertex_id, 3>;

/// Gives each face to one surface, and keeps who lost some.
class face_claims {
public:
  explicit face_claims(read_mesh& out) : out_(out) {}

  /// False where another surface has the face.
  bool claim(const corners& face, std::size_t set, surface_id id) {
    const auto [at, fresh] = owner_.try_emplace(make_face_key(face).v, set);
    if (!fresh)
      return at->second == set;
    out_.mesh.triangles.push_back({face, id});
    return true;
  }

  [[nodiscard]] bool has(const corners& face) const {
    return owner_.contains(make_face_key(face).v);
  }

  void say_lost(const std::string& name, std::size_t lost, std::size_t all) {
    if (lost > 0)
      out_.notices.push_back(std::to_string(lost) + " of the " + std::to_string(all) +
                             " faces of \"" + shown(name) +
                             "\" belong to smaller surfaces, too, and stay with those: a face has "
                             "one surface");
  }

private:
  read_mesh& out_;
  std::map<corners, std::size_t> owner_;
};

/// Places of the sets, the smallest first: so a part of a wall keeps what a whole wall also has.
template <class Sets, class Size>
std::vector<std::size_t> smallest_first(const Sets& sets, const Size& size) {
  std::vector<std::size_t> order(sets.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return size(sets[i]); });
  return order;
}

corners resolve(file_mesh& file, const std::array<std::uint64_t, 3>& face,
                const std::string& name) {
  corners result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto node = file.find_node(face[i]);
    if (!node)
      throw file_failure{{ec::bad_input,
                          "a face of \"" + shown(name) + "\" names node " +
                            std::to_string(face[i]) + ", which does not exist",
                          "Write the file with all of its nodes",
                          "surface \"" + shown(name) + "\""}};
    result[i] = *node;
  }
  return result;
}

void claim_face_sets(file_mesh& file, read_mesh& out, face_claims& claims) {
  const auto size = [](const file_mesh::face_set& set) { return set.faces.size(); };
  for (const auto s : smallest_first(file.face_sets, size)) {
    const auto& set = file.face_sets[s];
    std::size_t lost = 0;
    for (const auto& face : set.faces)
      lost += !claims.claim(resolve(file, face, set.name), s, *set.id);
    claims.say_lost(set.name, lost, set.faces.size());
    if (lost < set.faces.size())
      out.mesh.surface_names.push_back({*set.id, set.name});
  }
}

/// The faces of one tet alone that no set of faces has.
std::vector<corners> open_faces(const read_mesh& out, const face_claims& claims) {
  std::vector<corners> result;
  const face_table table(out.mesh.tets, out.mesh.positions.size());
  table.for_each_face([&](vertex_id smallest, std::span<const face_table::entry> group) {
    const corners face{smallest, group[0].middle, group[0].largest};
    if (group.size() == 1 && !claims.has(face))
      result.push_back(face);
  });
  return result;
}

/// Of each node set the open faces that it holds whole.
std::vector<file_mesh::face_set> faces_of_nodes(file_mesh& file, const std::vector<corners>& open) {
  std::vector<file_mesh::face_set> result;
  std::vector<bool> inside(file.positions.size());
  // A vertex' faces, so that a small set costs little.
  std::vector<std::size_t> first(file.positions.size() + 1);
  for (const auto& face : open)
    ++first[face[0] + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  for (const auto& set : file.node_sets) {
    std::vector<vertex_id> members;
    for (const auto number : set.nodes)
      if (const auto node = file.find_node(number); node && !inside[*node]) {
        members.push_back(*node);
        inside[*node] = true;
      }
    file_mesh::face_set faces{set.name};
    for (const auto v : members)
      for (auto i = first[v]; i < first[v + 1]; ++i)
        if (inside[open[i][1]] && inside[open[i][2]])
          faces.faces.push_back({open[i][0], open[i][1], open[i][2]});
    for (const auto v : members)
      inside[v] = false;
    // What holds the whole boundary, as a set of all nodes does, divides nothing.
    if (!faces.faces.empty() && faces.faces.size() < open.size())
      result.push_back(std::move(faces));
  }
  return result;
}

void claim_node_sets(file_mesh& file, read_mesh& out, face_claims& claims) {
  if (file.node_sets.empty())
    return;
  auto sets = faces_of_nodes(file, open_faces(out, claims));
  surface_id largest = 0;
  for (const auto& set : file.face_sets)
    largest = std::max(largest, *set.id);
  number_sets(sets);
  const auto size = [](const file_mesh::face_set& set) { return set.faces.size(); };
  for (const auto s : smallest_first(sets, size)) {
    const auto id = *sets[s].id + (largest > 0 ? largest : 0);
    std::size_t lost = 0;
    for (const auto& face : sets[s].faces)
      lost += !claims.claim({static_cast<vertex_id>(face[0]), static_cast<vertex_id>(face[1]),
                             static_cast<vertex_id>(face[2])},
                            file.face_sets.size() + s, id);
    claims.say_lost(sets[s].name, lost, sets[s].faces.size());
    if (lost < sets[s].faces.size())
      out.mesh.surface_names.push_back({id, sets[s].name});
  }
}

}  // namespace

void number_sets(std::vector<file_mesh::face_set>& sets) {
  std::set<surface_id> taken;
  for (const auto& set : sets)
    if (set.id)
      taken.insert(*set.id);
  std::set<surface_id> named;
  bool distinct = true;
  for (const auto& set : sets)
    if (!set.id) {
      const auto number = number_at_end(set.name);
      distinct = distinct && number && !taken.contains(*number) && named.insert(*number).second;
    }
  surface_id next = taken.empty() ? 0 : std::max<surface_id>(0, *taken.rbegin());
  for (auto& set : sets)
    if (!set.id)
      set.id = distinct ? *number_at_end(set.name) : ++next;
}

void give_surfaces(file_mesh& file, read_mesh& out) {
  number_sets(file.face_sets);
  face_claims claims(out);
  claim_face_sets(file, out, claims);
  claim_node_sets(file, out, claims);
}

}  // namespace tedit
