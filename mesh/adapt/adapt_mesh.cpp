// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/adapt_mesh.hpp"

#include <algorithm>

#include "mesh/face_key.hpp"

namespace tedit {

adapt_mesh::adapt_mesh(const mesh_version& mesh)
    : at_(mesh.data().positions.to_vector()),
      tets_(mesh.data().tets.to_vector()),
      regions_(mesh.data().tet_regions.to_vector()),
      stars_(at_.size()),
      skin_at_(at_.size(), 0),
      first_new_vertex_(mesh.vertex_slots()),
      live_(mesh.tet_count()) {
  for (const auto& row : mesh.data().interfaces.to_vector())
    add_skin(row.v, {row.surface, skin_kind::interface, 0});
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      add_skin(mesh.facet(f).v, {mesh.facet(f).surface, skin_kind::outside, 0});
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    for (const auto v : tets_[t].v)
      stars_[v].push_back(t);
    for (int face = 0; face < 4; ++face) {
      const auto behind = mesh.neighbours(t)[face];
      if (is_facet(behind) || behind < t || regions_[behind] == regions_[t])
        continue;
      const auto key = make_face_key(tets_[t], face).v;
      if (!skin_at(key))
        add_skin(key, {0, skin_kind::border, 0});
    }
  }
  first_new_tet_ = mesh.tet_slots();
}

std::array<vec3, 4> adapt_mesh::corners(std::uint32_t t) const {
  const auto& v = tets_[t].v;
  return {at_[v[0]], at_[v[1]], at_[v[2]], at_[v[3]]};
}

void adapt_mesh::ring(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& result) const {
  result.clear();
  for (const auto t : stars_[a])
    if (std::ranges::count(tets_[t].v, b))
      result.push_back(t);
}

const skin* adapt_mesh::skin_at(const std::array<std::uint32_t, 3>& v) const {
  if (skin_at_[v[0]] == 0 || skin_at_[v[1]] == 0 || skin_at_[v[2]] == 0)
    return nullptr;
  const auto found = skin_.find(make_face_key(v).v);
  return found == skin_.end() ? nullptr : &found->second;
}

void adapt_mesh::skin_around(std::uint32_t v, std::vector<skin_triangle>& result) const {
  result.clear();
  if (skin_at_[v] == 0)
    return;
  for (const auto t : stars_[v])
    for (int face = 0; face < 4; ++face) {
      if (tets_[t].v[face] == v)
        continue;
      const auto& order = tet_faces[face];
      std::array<std::uint32_t, 3> c{tets_[t].v[order[0]], tets_[t].v[order[1]],
                                     tets_[t].v[order[2]]};
      std::ranges::rotate(c, std::ranges::find(c, v));
      const auto* what = skin_at(c);
      // Triangles between regions are seen from both sides.
      if (what && std::ranges::none_of(result, [&](const skin_triangle& known) {
            return make_face_key(known.v).v == make_face_key(c).v;
          }))
        result.push_back({c, *what});
    }
}

void adapt_mesh::add_skin(const std::array<std::uint32_t, 3>& v, const skin& what) {
  skin_[make_face_key(v).v] = what;
  for (const auto corner : v)
    ++skin_at_[corner];
  if (first_new_tet_ > 0)
    fresh_skin_.push_back(make_face_key(v).v);
}

std::optional<skin> adapt_mesh::take_skin(const std::array<std::uint32_t, 3>& v) {
  const auto found = skin_.find(make_face_key(v).v);
  if (found == skin_.end())
    return std::nullopt;
  const auto result = found->second;
  skin_.erase(found);
  for (const auto corner : v)
    --skin_at_[corner];
  interfaces_changed_ = interfaces_changed_ || result.kind == skin_kind::interface;
  return result;
}

void adapt_mesh::add_tet(const tet& corners, region_id region) {
  const auto t = static_cast<std::uint32_t>(tets_.size());
  tets_.push_back(corners);
  regions_.push_back(region);
  for (const auto v : corners.v)
    stars_[v].push_back(t);
  ++live_;
}

void adapt_mesh::remove_tet(std::uint32_t t) {
  for (const auto v : tets_[t].v)
    stars_[v].erase(std::ranges::find(stars_[v], t));
  if (t < first_new_tet_)
    removed_.push_back(t);
  tets_[t].v[0] = no_id;
  --live_;
}

std::uint32_t adapt_mesh::split(std::uint32_t a, std::uint32_t b,
                                std::span<const std::uint32_t> ring, vec3 place) {
  const auto fresh = static_cast<std::uint32_t>(at_.size());
  at_.push_back(place);
  stars_.emplace_back();
  skin_at_.push_back(0);
  for (const auto t : ring) {
    const auto whole = tets_[t];
    for (const auto c : whole.v) {
      if (c == a || c == b)
        continue;
      if (const auto what = take_skin({a, b, c})) {
        add_skin({a, fresh, c}, *what);
        add_skin({b, fresh, c}, *what);
      }
    }
    remove_tet(t);
    for (const auto end : {a, b}) {
      auto half = whole;
      std::ranges::replace(half.v, end, fresh);
      add_tet(half, regions_[t]);
    }
  }
  return fresh;
}

void adapt_mesh::contract(std::uint32_t from, std::uint32_t to, double deviation) {
  std::vector<skin_triangle> triangles;
  skin_around(from, triangles);
  for (const auto& triangle : triangles) {
    auto what = *take_skin(triangle.v);
    if (std::ranges::count(triangle.v, to))
      continue;
    auto moved = triangle.v;
    std::ranges::replace(moved, from, to);
    what.deviation = deviation;
    add_skin(moved, what);
  }
  const auto star = stars_[from];
  for (const auto t : star) {
    auto moved = tets_[t];
    const auto region = regions_[t];
    remove_tet(t);
    if (std::ranges::count(moved.v, to))
      continue;
    std::ranges::replace(moved.v, from, to);
    add_tet(moved, region);
  }
}

expected<void> adapt_mesh::write(mesh_builder& mesh) const {
  cavity_change change;
  change.removed = removed_;
  std::vector<vertex_id> ids(at_.size());
  for (std::uint32_t v = 0; v < at_.size(); ++v)
    ids[v] = v < first_new_vertex_ ? v : no_id;
  const auto id_of = [&](std::uint32_t v) {
    if (ids[v] == no_id)
      ids[v] = mesh.add_vertex(at_[v]);
    return ids[v];
  };
  for (auto t = first_new_tet_; t < tets_.size(); ++t) {
    if (!is_live(t))
      continue;
    const auto& v = tets_[t].v;
    change.added.push_back({{{id_of(v[0]), id_of(v[1]), id_of(v[2]), id_of(v[3])}}, regions_[t]});
  }
  // Also faces of tets that stayed, where a neighbour went.
  for (const auto& v : fresh_skin_)
    if (const auto* what = skin_at(v); what && what->kind == skin_kind::outside)
      change.facets.push_back({{id_of(v[0]), id_of(v[1]), id_of(v[2])}, what->surface});
  if (const auto done = mesh.apply(change); !done)
    return fail(done.error());
  if (!interfaces_changed_)
    return {};
  std::vector<interface_facet> rows;
  for (const auto& [v, what] : skin_)
    if (what.kind == skin_kind::interface)
      rows.push_back({{id_of(v[0]), id_of(v[1]), id_of(v[2])}, 0, what.surface});
  // A table of hashes has no order of its own.
  std::ranges::sort(rows, {}, &interface_facet::v);
  mesh.set_interfaces(rows);
  return {};
}

}  // namespace tedit
