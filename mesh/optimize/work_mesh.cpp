// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/work_mesh.hpp"

#include <algorithm>

#include "mesh/face_key.hpp"
#include "mesh/optimize/star_quality.hpp"
#include "mesh/predicates.hpp"

namespace tedit {

// -- copying -----------------------------------------------------------------------

work_mesh::work_mesh(const mesh_builder& mesh, std::span<const tet_id> tets, bool keep_boundary) {
  sparse_numbers tet_number(mesh.tet_slots());
  sparse_numbers vertex_number(mesh.vertex_slots());
  for (const auto t : tets) {
    if (t >= mesh.tet_slots() || !mesh.is_live_tet(t) || tet_number[t] != sparse_numbers::none)
      continue;
    const auto n = tet_slots();
    tet_number.set(t, n);
    auto corner = mesh.tet_at(t).v;
    for (auto& v : corner) {
      if (vertex_number[v] == sparse_numbers::none) {
        vertex_number.set(v, vertices());
        at_.push_back(mesh.position(v));
        vertex_ids_.push_back(v);
        vertex_tet_.push_back(n);
        changed_.push_back(0);
      }
      v = vertex_number[v];
    }
    tets_.push_back(corner);
    region_.push_back(mesh.region_of(t));
    copied_.push_back(t);
  }
  original_ = copied_;
  for (const auto& corner : tets_)
    quality_.push_back(quality_of(corner));
  mark_.assign(tets_.size(), 0);
  link_copied(mesh, tet_number);
  find_kinds(mesh, keep_boundary);
}

void work_mesh::link_copied(const mesh_builder& mesh, const sparse_numbers& number) {
  for (std::uint32_t n = 0; n < tet_slots(); ++n) {
    auto row = mesh.neighbours(copied_[n]);
    for (auto& beyond : row) {
      if (is_facet(beyond)) {
        surface_.push_back(mesh.facet(beyond & ~facet_flag).surface);
        deviation_.push_back(0);
        beyond = facet_flag | static_cast<std::uint32_t>(surface_.size() - 1);
      } else {
        beyond = number[beyond];
        if (beyond != wall && region_[beyond] != region_[n])
          beyond = wall;
      }
    }
    behind_.push_back(row);
  }
}

void work_mesh::find_kinds(const mesh_builder& mesh, bool keep_boundary) {
  kind_.assign(at_.size(), vertex_kind::interior);
  const auto on_boundary = keep_boundary ? vertex_kind::fixed : vertex_kind::boundary;
  for (std::uint32_t t = 0; t < tet_slots(); ++t)
    for (int face = 0; face < 4; ++face) {
      const auto beyond = behind_[t][face];
      if (!is_facet(beyond))
        continue;
      for (const int i : tet_faces[face]) {
        auto& kind = kind_[tets_[t][i]];
        kind = beyond == wall ? vertex_kind::fixed : std::max(kind, on_boundary);
      }
    }
  if (keep_boundary)
    return;
  // A boundary vertex where several fans meet, here or beyond the copy, must not move.
  std::vector<std::uint32_t> incident(mesh.vertex_slots(), 0);
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t))
      for (const auto v : mesh.tet_at(t).v)
        ++incident[v];
  std::vector<std::uint32_t> fan;
  for (std::uint32_t v = 0; v < vertices(); ++v) {
    if (kind_[v] != vertex_kind::boundary)
      continue;
    star(v, fan);
    if (fan.size() != incident[vertex_ids_[v]])
      kind_[v] = vertex_kind::fixed;
  }
}

// -- reading -------------------------------------------------------------------------

double work_mesh::quality_of(const std::array<std::uint32_t, 4>& c) const {
  return quick_ratio(at_[c[0]], at_[c[1]], at_[c[2]], at_[c[3]]);
}

bool work_mesh::positive(const std::array<std::uint32_t, 4>& c) const {
  return orient3d(at_[c[0]], at_[c[1]], at_[c[2]], at_[c[3]]) > 0;
}

double work_mesh::worst(std::span<const std::uint32_t> tets) const {
  double result = 1;
  for (const auto t : tets)
    result = std::min(result, quality_[t]);
  return result;
}

double work_mesh::largest_deviation() const {
  double result = 0;
  for (std::uint32_t t = 0; t < tet_slots(); ++t)
    if (is_live(t))
      for (const auto beyond : behind_[t])
        if (is_facet(beyond) && beyond != wall)
          result = std::max(result, deviation_[beyond & ~facet_flag]);
  return result;
}

void work_mesh::star(std::uint32_t v, std::vector<std::uint32_t>& result) const {
  result.clear();
  if (vertex_tet_[v] == no_id)
    return;
  const auto seen = ++generation_;
  result.push_back(vertex_tet_[v]);
  mark_[vertex_tet_[v]] = seen;
  for (std::size_t next = 0; next < result.size(); ++next) {
    const auto& corner = tets_[result[next]];
    const auto& row = behind_[result[next]];
    for (int i = 0; i < 4; ++i) {
      if (corner[i] == v || is_facet(row[i]) || mark_[row[i]] == seen)
        continue;
      mark_[row[i]] = seen;
      result.push_back(row[i]);
    }
  }
}

bool work_mesh::ring(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::size_t longest,
                     work_ring& result) const {
  result.tets.clear();
  result.link.clear();
  // The two corners of a tet that are not a or b, in the order in which the ring turns.
  const auto others = [&](std::uint32_t of) {
    std::array<int, 2> place{};
    int n = 0;
    for (int i = 0; i < 4; ++i)
      if (tets_[of][i] != a && tets_[of][i] != b)
        place[n++] = i;
    return place;
  };
  const auto [i, j] = others(t);
  std::uint32_t from = tets_[t][i];
  std::uint32_t to = tets_[t][j];
  {
    // (a, b, from, to) is an even permutation of a positive tet, or its link corners change places.
    const auto& c = tets_[t];
    std::array<int, 4> order{};
    order[0] = static_cast<int>(std::ranges::find(c, a) - c.begin());
    order[1] = static_cast<int>(std::ranges::find(c, b) - c.begin());
    order[2] = i;
    order[3] = j;
    int inversions = 0;
    for (int x = 0; x < 4; ++x)
      for (int y = x + 1; y < 4; ++y)
        inversions += order[x] > order[y];
    if (inversions % 2 == 1)
      std::swap(from, to);
  }
  const auto first = from;
  // Forward: leave each tet by the face opposite the link corner it was entered by.
  const auto walk = [&](std::uint32_t start, std::uint32_t enter, std::uint32_t leave,
                        auto&& visit) {
    for (auto at = start;;) {
      const auto& c = tets_[at];
      const auto beyond = behind_[at][std::ranges::find(c, enter) - c.begin()];
      if (is_facet(beyond) || beyond == t)
        return beyond;
      if (result.tets.size() >= longest)
        return wall;
      const auto [x, y] = others(beyond);
      enter = leave;
      leave = tets_[beyond][x] == enter ? tets_[beyond][y] : tets_[beyond][x];
      at = beyond;
      visit(at, leave);
    }
  };
  result.tets.push_back(t);
  result.link = {first, to};
  const auto end = walk(t, from, to, [&](std::uint32_t at, std::uint32_t vertex) {
    result.tets.push_back(at);
    result.link.push_back(vertex);
  });
  if (end == wall)
    return false;
  result.closed = end == t;
  if (result.closed) {
    result.link.pop_back();  // The first one again.
    return true;
  }
  result.last_facet = end & ~facet_flag;
  std::ranges::reverse(result.tets);
  std::ranges::reverse(result.link);
  const auto other_end = walk(t, to, from, [&](std::uint32_t at, std::uint32_t vertex) {
    result.tets.push_back(at);
    result.link.push_back(vertex);
  });
  if (other_end == wall)
    return false;
  result.first_facet = other_end & ~facet_flag;
  std::ranges::reverse(result.tets);
  std::ranges::reverse(result.link);
  return true;
}

// -- changing --------------------------------------------------------------------------

std::uint32_t work_mesh::add_vertex(vec3 at, vertex_kind kind) {
  at_.push_back(at);
  vertex_ids_.push_back(no_id);
  kind_.push_back(kind);
  vertex_tet_.push_back(no_id);
  changed_.push_back(now_);
  return vertices() - 1;
}

void work_mesh::drop_vertex() {
  at_.pop_back();
  vertex_ids_.pop_back();
  kind_.pop_back();
  vertex_tet_.pop_back();
  changed_.pop_back();
}

void work_mesh::move(std::uint32_t v, vec3 at, std::span<const std::uint32_t> star) {
  at_[v] = at;
  for (const auto t : star)
    quality_[t] = quality_of(tets_[t]);
}

std::uint64_t work_mesh::changed_at(std::uint32_t t) const {
  std::uint64_t result = 0;
  for (const auto v : tets_[t])
    result = std::max(result, changed_[v]);
  return result;
}

void work_mesh::note_change(std::span<const std::uint32_t> tets) {
  ++now_;
  for (const auto t : tets)
    for (const auto v : tets_[t])
      changed_[v] = now_;
}

std::uint32_t work_mesh::take_slot() {
  if (free_.empty()) {
    tets_.emplace_back();
    behind_.emplace_back();
    quality_.push_back(0);
    region_.push_back(0);
    original_.push_back(no_id);
    mark_.push_back(0);
    return tet_slots() - 1;
  }
  const auto t = free_.back();
  free_.pop_back();
  return t;
}

void work_mesh::gather_faces(const work_change& change) {
  faces_.clear();
  const auto gone = ++generation_;
  for (const auto t : change.removed)
    mark_[t] = gone;
  for (const auto t : change.removed)
    for (std::uint8_t i = 0; i < 4; ++i) {
      const auto beyond = behind_[t][i];
      if (is_facet(beyond)) {
        faces_.push_back({make_face_key(tet{tets_[t]}, i), face_entry::held, i, beyond});
      } else if (mark_[beyond] != gone) {
        const auto& back = behind_[beyond];
        const auto face = static_cast<std::uint8_t>(std::ranges::find(back, t) - back.begin());
        faces_.push_back({make_face_key(tet{tets_[beyond]}, face), face_entry::kept, face, beyond});
      }
    }
  for (std::uint32_t n = 0; n < change.added.size(); ++n)
    for (std::uint8_t i = 0; i < 4; ++i)
      faces_.push_back({make_face_key(tet{change.added[n]}, i), face_entry::fresh, i, n});
  for (std::uint32_t h = 0; h < change.facets.size(); ++h)
    faces_.push_back({make_face_key(change.facets[h].v), face_entry::hint, 0, h});
  std::sort(faces_.begin(), faces_.end());
}

bool work_mesh::plan(const work_change& change) {
  gather_faces(change);
  pairs_.clear();
  outer_.clear();
  kept_facets_.clear();
  new_facets_.clear();
  bared_.clear();
  for (std::size_t first = 0, last = 0; first < faces_.size(); first = last) {
    while (last < faces_.size() && faces_[last].key.v == faces_[first].key.v)
      ++last;
    const face_entry* hint = nullptr;
    auto end = last;
    if (faces_[last - 1].what == face_entry::hint)
      hint = &faces_[--end];
    if (end == first)
      continue;
    if (end - first > 2)
      return false;
    const auto& a = faces_[first];
    const auto& b = faces_[end - 1];
    const bool alone = end - first == 1;
    if (alone && a.what == face_entry::held) {
      if (a.index == wall)
        return false;  // A wall must be covered; a facet may vanish.
    } else if (alone) {
      if (!hint)
        return false;
      if (a.what == face_entry::kept)
        bared_.push_back({a.index, a.face, hint->index});
      else
        new_facets_.push_back({a.index, a.face, hint->index});
    } else if (b.what != face_entry::fresh) {
      return false;
    } else if (a.what == face_entry::held) {
      if (a.key.odd != b.key.odd)
        return false;
      kept_facets_.push_back({b.index, b.face, a.index});
    } else {
      if (a.key.odd == b.key.odd)
        return false;
      auto& list = a.what == face_entry::fresh ? pairs_ : outer_;
      list.push_back({b.index, b.face, a.index, a.face});
    }
  }
  return true;
}

bool work_mesh::replace(const work_change& change, std::vector<std::uint32_t>& fresh) {
  const auto positive_one = [&](const auto& c) { return positive(c); };
  if (!std::ranges::all_of(change.added, positive_one) || !plan(change))
    return false;
  const auto region = region_[change.removed.front()];
  std::vector<std::uint32_t> corners;
  for (auto t = change.removed.rbegin(); t != change.removed.rend(); ++t) {
    corners.insert(corners.end(), tets_[*t].begin(), tets_[*t].end());
    tets_[*t] = {no_id, no_id, no_id, no_id};
    original_[*t] = no_id;
    free_.push_back(*t);
  }
  for (const auto v : corners)
    vertex_tet_[v] = no_id;
  // What is left of vertices that the added tets do not use hangs on the faces beyond.
  const auto claim = [&](std::uint32_t t) {
    for (const auto v : tets_[t])
      vertex_tet_[v] = t;
  };
  for (const auto& link : bared_)
    claim(link[0]);
  for (const auto& link : outer_)
    claim(link[2]);
  fresh.clear();
  for (const auto& corner : change.added) {
    const auto t = take_slot();
    fresh.push_back(t);
    tets_[t] = corner;
    quality_[t] = quality_of(corner);
    region_[t] = region;
    for (const auto v : corner)
      vertex_tet_[v] = t;
  }
  for (const auto& [a, face_a, b, face_b] : pairs_) {
    behind_[fresh[a]][face_a] = fresh[b];
    behind_[fresh[b]][face_b] = fresh[a];
  }
  for (const auto& [n, face, kept, back] : outer_) {
    behind_[fresh[n]][face] = kept;
    behind_[kept][back] = fresh[n];
  }
  for (const auto& [n, face, beyond] : kept_facets_)
    behind_[fresh[n]][face] = beyond;
  const auto make_facet = [&](std::uint32_t hint) {
    surface_.push_back(change.facets[hint].surface);
    deviation_.push_back(change.deviation);
    return facet_flag | static_cast<std::uint32_t>(surface_.size() - 1);
  };
  for (const auto& [n, face, hint] : new_facets_)
    behind_[fresh[n]][face] = make_facet(hint);
  for (const auto& [kept, face, hint] : bared_) {
    behind_[kept][face] = make_facet(hint);
    original_[kept] = no_id;  // Its facet is new: the builder must see the tet in its change.
    note_change({&kept, 1});
  }
  note_change(fresh);
  return true;
}

expected<void> work_mesh::write(mesh_builder& mesh) const {
  auto ids = vertex_ids_;
  for (std::uint32_t v = 0; v < vertices(); ++v)
    if (ids[v] == no_id && is_live_vertex(v))
      ids[v] = mesh.add_vertex(at_[v]);
  cavity_change change;
  for (std::uint32_t t = 0; t < copied_.size(); ++t)
    if (original_[t] != copied_[t])
      change.removed.push_back(copied_[t]);
  for (std::uint32_t t = 0; t < tet_slots(); ++t) {
    if (!is_live(t) || original_[t] != no_id)
      continue;
    auto corner = tets_[t];
    for (auto& v : corner)
      v = ids[v];
    change.added.push_back({{corner}, region_[t]});
    for (int face = 0; face < 4; ++face) {
      const auto beyond = behind_[t][face];
      if (!is_facet(beyond) || beyond == wall)
        continue;
      const auto& order = tet_faces[face];
      change.facets.push_back(
        {{corner[order[0]], corner[order[1]], corner[order[2]]}, surface_[beyond & ~facet_flag]});
    }
  }
  if (!change.removed.empty() || !change.added.empty())
    if (const auto applied = mesh.apply(change); !applied)
      return fail(applied.error());
  for (std::uint32_t v = 0; v < vertices(); ++v)
    if (vertex_ids_[v] != no_id && is_live_vertex(v) && mesh.position(ids[v]) != at_[v])
      mesh.set_position(ids[v], at_[v]);
  return {};
}

}  // namespace tedit
