// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/builder.hpp"

#include <algorithm>
#include <functional>

#include "mesh/face_key.hpp"

namespace tedit {

namespace {

constexpr std::uint32_t end_of_list = ~facet_flag;

/// What stands on one side of a face while a change is linked up.
enum class side : std::uint8_t {
  wall,   ///< A kept tet at the cavity's wall; index = tet, face = its local face.
  own,    ///< A boundary facet of a removed tet; index = facet.
  glued,  ///< A boundary facet that an added tet covers; index = facet.
  fresh,  ///< A face of an added tet; index = position in `added`.
  hint    ///< The surface for a new facet; index = position in `facets`.
};

std::string face_text(const face_key& key) {
  return "face " + std::to_string(key.v[0]) + "-" + std::to_string(key.v[1]) + "-" +
         std::to_string(key.v[2]);
}

}  // namespace

struct mesh_builder::face_entry {
  face_key key;
  side kind;
  std::uint8_t face;
  std::uint32_t index;

  friend bool operator<(const face_entry& a, const face_entry& b) {
    if (a.key.v != b.key.v)
      return a.key.v < b.key.v;
    return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
  }
};

/// The entries of one face, by kind.
class mesh_builder::face_group {
public:
  explicit face_group(std::span<const face_entry> entries) {
    for (const auto& entry : entries) {
      const auto kind = static_cast<std::size_t>(entry.kind);
      if (counts_[kind] < 2)
        found_[kind][counts_[kind]] = &entry;
      ++counts_[kind];
    }
  }

  [[nodiscard]] int count(side kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] const face_entry* first(side kind) const {
    return found_[static_cast<std::size_t>(kind)][0];
  }
  [[nodiscard]] const face_entry* second(side kind) const {
    return found_[static_cast<std::size_t>(kind)][1];
  }

private:
  std::array<std::array<const face_entry*, 2>, 5> found_{};
  std::array<int, 5> counts_{};
};

/// The links that a change makes, worked out before anything is written.
struct mesh_builder::link_plan {
  struct pair {  // added tet's face against another added tet's face
    std::uint32_t tet_a, tet_b;
    std::uint8_t face_a, face_b;
  };
  struct wall_link {  // added tet's face against a kept tet's face
    std::uint32_t added;
    tet_id kept;
    std::uint8_t added_face, kept_face;
  };
  struct facet_link {  // a boundary facet on an added tet; facet == no_id makes a new one
    std::uint32_t added;
    std::uint8_t face;
    facet_id facet;
    surface_id surface;
  };
  struct bared_face {  // a kept tet's face that becomes boundary
    tet_id kept;
    std::uint8_t face;
    surface_id surface;
  };

  std::vector<pair> pairs;
  std::vector<wall_link> walls;
  std::vector<facet_link> on_added;
  std::vector<bared_face> bared;
  std::vector<facet_id> vanished;
};

mesh_builder::mesh_builder(version_ptr base)
    : base_(std::move(base)),
      positions_(base_->data().positions),
      vertex_tet_(base_->data().vertex_tet),
      tets_(base_->data().tets),
      tet_regions_(base_->data().tet_regions),
      neighbours_(base_->data().neighbours),
      facets_(base_->data().facets),
      vertex_order_(base_->data().vertex_order),
      tet_order_(base_->data().tet_order) {
  const auto& data = base_->data();
  counts_.interfaces = data.interfaces;
  counts_.surfaces = data.surfaces;
  counts_.regions = data.regions;
  counts_.vertices = data.vertices;
  counts_.live_tets = data.live_tets;
  counts_.live_facets = data.live_facets;
  counts_.free_vertex = data.free_vertex;
  counts_.free_tet = data.free_tet;
  counts_.free_facet = data.free_facet;
  if (!data.surfaces.empty())
    largest_surface_ = std::max<surface_id>(0, data.surfaces.back().id);
}

// -- reading -------------------------------------------------------------------

std::array<vec3, 4> mesh_builder::corners(tet_id t) const {
  const auto& v = tets_[t].v;
  return {positions_[v[0]], positions_[v[1]], positions_[v[2]], positions_[v[3]]};
}

std::vector<tet_id> mesh_builder::star(vertex_id v) const {
  std::vector<tet_id> result;
  if (!is_live_vertex(v))
    return result;
  std::unordered_set<tet_id> seen;
  const auto visit = [&](tet_id t) {
    if (seen.insert(t).second)
      result.push_back(t);
  };
  visit(vertex_tet_[v]);
  for (std::size_t next = 0; next < result.size(); ++next) {
    const auto& corner = tets_[result[next]].v;
    for (int i = 0; i < 4; ++i) {
      const auto behind = neighbours_[result[next]][i];
      if (corner[i] != v && !is_facet(behind))
        visit(behind);
    }
  }
  return result;
}

std::vector<tet_id> mesh_builder::edge_ring(vertex_id a, vertex_id b) const {
  auto ring = star(a);
  std::erase_if(ring, [&](tet_id t) { return !std::ranges::count(tets_[t].v, b); });
  return ring;
}

bool mesh_builder::is_boundary_vertex(vertex_id v) const {
  for (const auto t : star(v))
    for (int i = 0; i < 4; ++i)
      if (tets_[t].v[i] != v && is_facet(neighbours_[t][i]))
        return true;
  return false;
}

std::vector<tet_id> mesh_builder::touched() const {
  std::vector<tet_id> result(touched_.begin(), touched_.end());
  std::ranges::sort(result);
  return result;
}

// -- slots ---------------------------------------------------------------------

vertex_id mesh_builder::add_vertex(vec3 position) {
  vertex_id v = counts_.free_vertex;
  if (v == no_id) {
    v = static_cast<vertex_id>(positions_.push_back(position));
    vertex_tet_.push_back(no_id);
    if (vertex_order_.size() > 0)
      vertex_order_.push_back(v);
  } else {
    const auto next = vertex_tet_[v] & ~facet_flag;
    counts_.free_vertex = next == end_of_list ? no_id : next;
    positions_.write(v) = position;
    vertex_tet_.write(v) = no_id;
  }
  ++counts_.vertices;
  loose_vertices_.insert(v);
  return v;
}

void mesh_builder::free_vertex_slot(vertex_id v) {
  const auto next = counts_.free_vertex == no_id ? end_of_list : counts_.free_vertex;
  positions_.write(v) = vec3{};
  vertex_tet_.write(v) = facet_flag | next;
  counts_.free_vertex = v;
  --counts_.vertices;
  loose_vertices_.erase(v);
}

tet_id mesh_builder::take_tet_slot() {
  ++counts_.live_tets;
  const tet_id t = counts_.free_tet;
  if (t == no_id) {
    tet_regions_.push_back(0);
    neighbours_.push_back({no_id, no_id, no_id, no_id});
    const auto fresh = static_cast<tet_id>(tets_.push_back({}));
    if (tet_order_.size() > 0)
      tet_order_.push_back(fresh);
    return fresh;
  }
  counts_.free_tet = tets_[t].v[1];
  return t;
}

void mesh_builder::free_tet_slot(tet_id t) {
  tet tombstone;
  tombstone.v[1] = counts_.free_tet;
  tets_.write(t) = tombstone;
  tet_regions_.write(t) = 0;
  neighbours_.write(t) = {no_id, no_id, no_id, no_id};
  counts_.free_tet = t;
  --counts_.live_tets;
  touched_.erase(t);
}

facet_id mesh_builder::take_facet_slot() {
  ++counts_.live_facets;
  const facet_id f = counts_.free_facet;
  if (f == no_id)
    return static_cast<facet_id>(facets_.push_back({}));
  counts_.free_facet = facets_[f].v[0];
  return f;
}

void mesh_builder::free_facet_slot(facet_id f) {
  boundary_facet tombstone;
  tombstone.v[0] = counts_.free_facet;
  facets_.write(f) = tombstone;
  counts_.free_facet = f;
  --counts_.live_facets;
}

// -- changing ------------------------------------------------------------------

void mesh_builder::set_position(vertex_id v, vec3 position) {
  positions_.write(v) = position;
  for (const auto t : star(v))
    touched_.insert(t);
}

void mesh_builder::set_surface(facet_id f, surface_id surface) {
  facets_.write(f).surface = surface;
}

void mesh_builder::set_interfaces(const std::vector<interface_facet>& facets) {
  counts_.interfaces = paged_array<interface_facet>::from(facets);
}

surface_id mesh_builder::add_surface(std::string name, surface_geometry geometry) {
  const surface_id id = ++largest_surface_;
  counts_.surfaces.push_back({id, std::move(name), std::move(geometry)});
  return id;
}

void mesh_builder::restore_surface(surface_id id, std::string name, surface_geometry geometry) {
  auto& rows = counts_.surfaces;
  const auto at = std::ranges::lower_bound(rows, id, {}, &surface_info::id);
  if (at != rows.end() && at->id == id)
    return;
  rows.insert(at, {id, std::move(name), std::move(geometry)});
  largest_surface_ = std::max(largest_surface_, id);
}

expected<std::vector<mesh_builder::face_entry>> mesh_builder::faces_of_change(
  const cavity_change& change) const {
  const std::unordered_set<tet_id> removed(change.removed.begin(), change.removed.end());
  std::vector<face_entry> entries;
  entries.reserve(4 * (change.removed.size() + change.added.size()) + change.glued.size() +
                  change.facets.size());
  for (const auto t : removed) {
    if (t >= tets_.size() || !is_live_tet(t))
      return fail(ec::invalid_mesh, "tet " + std::to_string(t) + " to remove does not exist");
    for (const auto behind : neighbours_[t]) {
      if (is_facet(behind)) {
        const auto f = behind & ~facet_flag;
        entries.push_back({make_face_key(facets_[f].v), side::own, 0, f});
      } else if (!removed.contains(behind)) {
        const auto back = local_face(behind, t);
        entries.push_back({make_face_key(tets_[behind], back), side::wall, back, behind});
      }
    }
  }
  for (const auto f : change.glued) {
    if (f >= facets_.size() || !is_live_facet(f) || removed.contains(facets_[f].tet))
      return fail(ec::invalid_mesh, "facet " + std::to_string(f) + " to cover does not exist");
    entries.push_back({make_face_key(facets_[f].v), side::glued, 0, f});
  }
  for (std::uint32_t n = 0; n < change.added.size(); ++n) {
    for (const auto v : change.added[n].corners.v)
      if (v >= vertex_tet_.size() || !(is_live_vertex(v) || loose_vertices_.contains(v)))
        return fail(ec::invalid_mesh,
                    "vertex " + std::to_string(v) + " of a new tet does not exist");
    for (std::uint8_t i = 0; i < 4; ++i)
      entries.push_back({make_face_key(change.added[n].corners, i), side::fresh, i, n});
  }
  for (std::uint32_t h = 0; h < change.facets.size(); ++h)
    entries.push_back({make_face_key(change.facets[h].v), side::hint, 0, h});
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::uint8_t mesh_builder::local_face(tet_id t, std::uint32_t behind) const {
  const auto& row = neighbours_[t];
  return static_cast<std::uint8_t>(std::ranges::find(row, behind) - row.begin());
}

expected<void> mesh_builder::link_face(std::span<const face_entry> entries,
                                       const cavity_change& change, link_plan& links) const {
  const face_group group(entries);
  const auto refuse = [&](const char* why) {
    return fail(ec::invalid_mesh, face_text(entries.front().key) + why);
  };
  const int walls = group.count(side::wall);
  const int own = group.count(side::own);
  const int glued = group.count(side::glued);
  const int fresh = group.count(side::fresh);
  if (fresh > 2 || fresh + walls + glued > 2 || walls + own + glued > 1)
    return refuse(" would lie in more than two tets");
  const auto* add = group.first(side::fresh);
  const auto* opposite = fresh == 2 ? group.second(side::fresh)
                         : walls    ? group.first(side::wall)
                                    : group.first(side::glued);
  if (add && opposite && add->key.odd == opposite->key.odd)
    return refuse(" has both its tets on one side");
  const auto* facet = group.first(side::own);
  if (fresh == 1 && facet && add->key.odd != facet->key.odd)
    return refuse(" would turn the boundary inside out");
  if (fresh == 2) {
    links.pairs.push_back({add->index, opposite->index, add->face, opposite->face});
    if (facet)
      links.vanished.push_back(facet->index);
  } else if (add && walls) {
    links.walls.push_back({add->index, opposite->index, add->face, opposite->face});
  } else if (add && glued) {
    const auto kept = facets_[opposite->index].tet;
    links.walls.push_back(
      {add->index, kept, add->face, local_face(kept, facet_flag | opposite->index)});
    links.vanished.push_back(opposite->index);
  } else if (add && facet) {
    links.on_added.push_back({add->index, add->face, facet->index, 0});
  } else if (glued) {
    return refuse(" was to be covered, but no new tet has it");
  } else if (facet) {
    links.vanished.push_back(facet->index);
  } else if (add || walls) {
    const auto* hint = group.first(side::hint);
    if (!hint)
      return refuse(" would be boundary without a surface");
    const auto surface = change.facets[hint->index].surface;
    if (add)
      links.on_added.push_back({add->index, add->face, no_id, surface});
    else
      links.bared.push_back({opposite->index, opposite->face, surface});
  }
  return {};
}

expected<mesh_builder::link_plan> mesh_builder::plan(const cavity_change& change) const {
  const auto faces = faces_of_change(change);
  if (!faces)
    return fail(faces.error());
  link_plan links;
  for (std::size_t first = 0, last = 0; first < faces->size(); first = last) {
    while (last < faces->size() && (*faces)[last].key.v == (*faces)[first].key.v)
      ++last;
    const auto group = std::span(*faces).subspan(first, last - first);
    if (auto linked = link_face(group, change, links); !linked)
      return fail(linked.error());
  }
  return links;
}

void mesh_builder::detach(const cavity_change& change, const link_plan& links) {
  // Highest slots are freed first, so that the lowest are reused first.
  auto facets = links.vanished;
  std::ranges::sort(facets, std::greater{});
  for (const auto f : facets)
    free_facet_slot(f);
  auto removed = change.removed;
  std::ranges::sort(removed, std::greater{});
  const auto repeated = std::ranges::unique(removed);
  removed.erase(repeated.begin(), repeated.end());
  for (const auto t : removed)
    free_tet_slot(t);
}

std::vector<tet_id> mesh_builder::attach(const cavity_change& change, const link_plan& links) {
  std::vector<tet_id> ids;
  ids.reserve(change.added.size());
  for (const auto& fresh : change.added) {
    const tet_id t = take_tet_slot();
    tets_.write(t) = fresh.corners;
    tet_regions_.write(t) = fresh.region;
    touched_.insert(t);
    ids.push_back(t);
  }
  for (const auto& link : links.pairs) {
    neighbours_.write(ids[link.tet_a])[link.face_a] = ids[link.tet_b];
    neighbours_.write(ids[link.tet_b])[link.face_b] = ids[link.tet_a];
  }
  for (const auto& link : links.walls) {
    neighbours_.write(ids[link.added])[link.added_face] = link.kept;
    neighbours_.write(link.kept)[link.kept_face] = ids[link.added];
  }
  const auto put_facet = [this](facet_id f, tet_id t, int face, surface_id surface) {
    const auto& corner = tets_[t].v;
    const auto& order = tet_faces[face];
    facets_.write(f) = {{corner[order[0]], corner[order[1]], corner[order[2]]}, t, surface};
    neighbours_.write(t)[face] = facet_flag | f;
  };
  for (const auto& link : links.on_added) {
    const bool reused = link.facet != no_id;
    const auto surface = reused ? facets_[link.facet].surface : link.surface;
    put_facet(reused ? link.facet : take_facet_slot(), ids[link.added], link.face, surface);
  }
  for (const auto& link : links.bared)
    put_facet(take_facet_slot(), link.kept, link.face, link.surface);
  return ids;
}

expected<std::vector<tet_id>> mesh_builder::apply(const cavity_change& change) {
  auto links = plan(change);
  if (!links)
    return fail(links.error());
  if (tets_.size() + change.added.size() > max_slots)
    return fail(ec::out_of_memory, "a mesh holds at most 2^31 tets");
  std::vector<vertex_id> suspects;
  const std::unordered_set<tet_id> removed(change.removed.begin(), change.removed.end());
  for (const auto t : change.removed)
    for (const auto v : tets_[t].v)
      if (removed.contains(vertex_tet_[v]))
        suspects.push_back(v);
  if (!tets_at_.empty()) {
    for (const auto t : change.removed)
      count_tets(tets_[t], -1);
    for (const auto& t : change.added)
      count_tets(t.corners, 1);
  }
  detach(change, *links);
  auto ids = attach(change, *links);
  auto candidates = ids;
  for (const auto& link : links->walls)
    candidates.push_back(link.kept);
  for (const auto& link : links->bared)
    candidates.push_back(link.kept);
  repair_vertices(suspects, candidates);
  return ids;
}

version_ptr mesh_builder::freeze() {
  std::vector<vertex_id> unused(loose_vertices_.begin(), loose_vertices_.end());
  std::ranges::sort(unused, std::greater{});
  for (const auto v : unused)
    free_vertex_slot(v);
  std::unordered_set<surface_id> used;
  surface_id last = 0;
  for (facet_id f = 0; f < facets_.size(); ++f) {
    if (!is_live_facet(f) || (facets_[f].surface == last && !used.empty()))
      continue;
    last = facets_[f].surface;
    used.insert(last);
  }
  for (std::size_t i = 0; i < counts_.interfaces.size(); ++i)
    used.insert(counts_.interfaces[i].surface);
  mesh_data data = counts_;
  std::erase_if(data.surfaces, [&](const surface_info& row) { return !used.contains(row.id); });
  data.positions = positions_.freeze();
  data.vertex_tet = vertex_tet_.freeze();
  data.tets = tets_.freeze();
  data.tet_regions = tet_regions_.freeze();
  data.neighbours = neighbours_.freeze();
  data.facets = facets_.freeze();
  data.vertex_order = vertex_order_.freeze();
  data.tet_order = tet_order_.freeze();
  return mesh_version::create(std::move(data));
}

}  // namespace tedit
