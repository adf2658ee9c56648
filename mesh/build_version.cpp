// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/build_version.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <set>

#include "base/erase_places.hpp"
#include "mesh/boundary_patches.hpp"
#include "mesh/face_table.hpp"
#include "mesh/place_text.hpp"
#include "mesh/quality.hpp"
#include "mesh/segment/divide_boundary.hpp"

namespace tedit {

namespace {

constexpr const char* write_again = "The file is damaged: write it again";

/// Builds one version; the members are filled step by step in the order of `run`.
class version_assembler {
public:
  explicit version_assembler(raw_mesh raw) : raw_(std::move(raw)) {}

  expected<built_version> run(double metres_per_unit, slot_order order) {
    if (auto ok = check_input(); !ok)
      return fail(ok.error());
    if (auto ok = drop_unused_vertices(); !ok)
      return fail(ok.error());
    for (auto& p : raw_.positions)
      p = metres_per_unit * p;
    if (auto ok = check_extent(); !ok)
      return fail(ok.error());
    drop_flat_extras();
    if (auto ok = drop_unused_vertices(); !ok)  // Those that only a dropped tet had.
      return fail(ok.error());
    if (auto ok = orient(); !ok)
      return fail(ok.error());
    if (order == slot_order::along_curve && raw_.tets.size() > paged_array<tet>::items_per_page)
      std::tie(vertex_order_, tet_order_) = sort_along_curve(raw_);
    if (auto ok = link(); !ok)
      return fail(ok.error());
    if (auto ok = match_triangles(); !ok)
      return fail(ok.error());
    name_missing_surfaces();
    for (auto& sentence : describe_boundary(facets_, raw_.tets, neighbours_, raw_.positions))
      warnings_.push_back(std::move(sentence));
    return built_version{mesh_version::create(freeze()), std::move(warnings_)};
  }

private:
  [[nodiscard]] std::string tet_name(std::size_t t) const {
    const auto given = t < tet_order_.size() ? tet_order_[t] : t;
    return "tet " +
           std::to_string(given < raw_.tet_numbers.size() ? raw_.tet_numbers[given] : given + 1);
  }

  [[nodiscard]] std::string node_name(std::size_t v) const {
    const auto given = v < vertex_order_.size() ? vertex_order_[v] : v;
    return std::to_string(given < raw_.node_numbers.size() ? raw_.node_numbers[given] : given + 1);
  }

  [[nodiscard]] std::string triangle_name(const raw_mesh::triangle& triangle) const {
    return "triangle " + node_name(triangle.v[0]) + "-" + node_name(triangle.v[1]) + "-" +
           node_name(triangle.v[2]);
  }

  /// "tet 3, tet 7, ... (12 in all)".
  [[nodiscard]] std::string list_tets(const std::vector<tet_id>& tets) const {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(tets.size(), 5); ++i)
      text += (i ? ", " : "") + tet_name(tets[i]);
    return tets.size() > 5 ? text + ", ... (" + std::to_string(tets.size()) + " in all)" : text;
  }

  expected<void> check_input() {
    if (raw_.tets.empty())
      return fail(ec::bad_input, "the mesh has no volume elements (tets)",
                  "Mesh the volume, not only its surface");
    if (raw_.tets.size() > max_slots / 4 || raw_.positions.size() > max_slots)
      return fail(ec::bad_input, "the mesh is too large: at most 2^29 tets are supported",
                  "Mesh the part coarser");
    raw_.tet_regions.resize(raw_.tets.size(), 0);
    const auto count = raw_.positions.size();
    for (std::size_t v = 0; v < count; ++v)
      if (!is_finite(raw_.positions[v]))
        return fail(ec::bad_input, "node " + node_name(v) + " has a coordinate that is no number",
                    write_again, "node " + node_name(v));
    for (std::size_t t = 0; t < raw_.tets.size(); ++t) {
      const auto& v = raw_.tets[t].v;
      if (std::ranges::any_of(v, [&](vertex_id i) { return i >= count; }))
        return fail(ec::bad_input, tet_name(t) + " names a node that does not exist", write_again,
                    tet_name(t));
      if (v[0] == v[1] || v[0] == v[2] || v[0] == v[3] || v[1] == v[2] || v[1] == v[3] ||
          v[2] == v[3])
        return fail(ec::bad_input, tet_name(t) + " names the same node twice",
                    "Remove it, or mesh the part again", tet_name(t));
    }
    for (const auto& triangle : raw_.triangles)
      if (std::ranges::any_of(triangle.v, [&](vertex_id i) { return i >= count; }))
        return fail(ec::bad_input, "a triangle names a node that does not exist", write_again);
    return {};
  }

  [[nodiscard]] static error no_face(const std::string& triangle) {
    return {ec::bad_input, triangle + " is no face of any tet",
            "Surface and volume mesh must fit together: mesh the part again", triangle};
  }

  /// Volumes, areas and stiffnesses are products of up to eight lengths: they must not overflow.
  expected<void> check_extent() {
    constexpr double largest = 1e30;
    for (std::size_t v = 0; v < raw_.positions.size(); ++v) {
      const auto& p = raw_.positions[v];
      const double far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      if (far > largest)
        return fail(ec::bad_input,
                    "node " + node_name(v) + " lies " +
                      std::to_string(static_cast<int>(std::log10(far))) +
                      " powers of ten metres away; at most 30 are supported",
                    "Check its coordinates and the length unit", "node " + node_name(v));
    }
    return {};
  }

  expected<void> drop_unused_vertices() {
    std::vector<bool> is_used(raw_.positions.size());
    for (const auto& t : raw_.tets)
      for (const auto v : t.v)
        is_used[v] = true;
    for (const auto& triangle : raw_.triangles)
      for (const auto v : triangle.v)
        if (!is_used[v])
          return fail(no_face(triangle_name(triangle)));
    keep_vertices(raw_, is_used);
    return {};
  }

  [[nodiscard]] double volume(tet_id t) const {
    const auto& v = raw_.tets[t].v;
    const auto& p = raw_.positions;
    return signed_volume(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
  }

  /// Removes flat tets that lie on faces which two other tets share already.
  void drop_flat_extras() {
    std::vector<tet_id> flat;
    for (tet_id t = 0; t < raw_.tets.size(); ++t)
      if (!sign_is_sound(t))
        flat.push_back(t);
    if (flat.empty())
      return;
    const face_table table(raw_.tets, raw_.positions.size());
    std::erase_if(flat, [&](tet_id t) {
      for (int face = 0; face < 4; ++face)
        if (table.find(make_face_key(raw_.tets[t], face)).size() > 2)
          return false;
      return true;
    });
    if (flat.empty())
      return;
    warnings_.push_back(std::to_string(flat.size()) +
                        " tets of zero volume lie on faces that other tets share and were left "
                        "out: " +
                        list_tets(flat));
    erase_places(raw_.tets, flat);
    erase_places(raw_.tet_regions, flat);
    erase_places(raw_.tet_numbers, flat);
  }

  /// The sign of a tet's volume means nothing when rounding alone can turn it.
  [[nodiscard]] bool sign_is_sound(tet_id t) const {
    const auto& v = raw_.tets[t].v;
    double longest = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        longest = std::max(longest, norm(raw_.positions[v[i]] - raw_.positions[v[j]]));
    return std::abs(volume(t)) > 1e-10 * longest * longest * longest;
  }

  /// Turns tets whose corners are listed the wrong way round. A tet that is inverted by the place
  /// of its vertices fits its neighbours combinatorially and is left as it is: only moving a vertex
  /// can mend it. Flat tets take the orientation that fits their neighbours.
  expected<void> orient() {
    std::size_t negative = 0;
    for (tet_id t = 0; t < raw_.tets.size(); ++t) {
      const double v = volume(t);
      if (!std::isfinite(v))
        return fail(ec::bad_input, "the volume of " + tet_name(t) + " is too large for a number",
                    "Check the coordinates of its nodes", tet_name(t));
      negative += v < 0;
    }
    if (negative * 2 > raw_.tets.size()) {
      for (auto& t : raw_.tets)
        std::swap(t.v[2], t.v[3]);
      warnings_.push_back("the file lists tets in the opposite orientation; all were turned");
    }
    std::vector<tet_id> doubtful;
    for (tet_id t = 0; t < raw_.tets.size(); ++t)
      if (!(volume(t) > 0) || !sign_is_sound(t))
        doubtful.push_back(t);
    if (!doubtful.empty()) {
      turn_misfits(doubtful);
      warn_of_unsolvable(doubtful);
    }
    return {};
  }

  /// Decides doubtful tets from the decided ones around them, until nothing changes.
  void turn_misfits(std::vector<tet_id> doubtful) {
    const face_table table(raw_.tets, raw_.positions.size());
    const auto all = doubtful;
    std::vector<bool> decided(raw_.tets.size(), true);
    for (const auto t : doubtful)
      decided[t] = false;
    std::vector<bool> swapped(raw_.tets.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<tet_id> left;
      for (const auto t : doubtful) {
        const auto [fits, misfits] = count_fits(table, t, decided, swapped);
        if (fits + misfits == 0) {
          left.push_back(t);
          continue;
        }
        decided[t] = changed = true;
        swapped[t] = misfits > fits;
      }
      doubtful = std::move(left);
    }
    apply_turns(all, swapped);
  }

  [[nodiscard]] std::pair<int, int> count_fits(const face_table& table, tet_id t,
                                               const std::vector<bool>& decided,
                                               const std::vector<bool>& swapped) const {
    std::pair<int, int> result{0, 0};
    for (int face = 0; face < 4; ++face) {
      const auto group = table.find(make_face_key(raw_.tets[t], face));
      if (group.size() != 2)
        continue;
      const auto& other = group[group[0].tet() == t];
      if (!decided[other.tet()])
        continue;
      const bool same = group[0].odd() == group[1].odd();
      ++(same == swapped[other.tet()] ? result.first : result.second);
    }
    return result;
  }

  void apply_turns(std::vector<tet_id> turned, const std::vector<bool>& swapped) {
    std::erase_if(turned, [&](tet_id t) { return !swapped[t]; });
    for (const auto t : turned)
      std::swap(raw_.tets[t].v[2], raw_.tets[t].v[3]);
    std::erase_if(turned, [&](tet_id t) { return !sign_is_sound(t); });
    if (!turned.empty())
      warnings_.push_back(
        std::to_string(turned.size()) +
        " tets listed their nodes the wrong way round and were turned: " + list_tets(turned));
  }

  /// What `fem` refuses, in the same words. Cost: only over tets that may be bad.
  void warn_of_unsolvable(const std::vector<tet_id>& doubtful) {
    std::vector<tet_id> flat, inverted;
    for (const auto t : doubtful)
      if (!sign_is_sound(t) || volume(t) < 0)
        (sign_is_sound(t) ? inverted : flat).push_back(t);
    warn_of(flat, "zero volume (flat within rounding)",
            "the mesh is improved (operation improve_mesh) or the part is remeshed");
    warn_of(inverted, "negative volume (inverted)", "the part is repaired or remeshed");
  }

  void warn_of(const std::vector<tet_id>& bad, const char* what, const std::string& until) {
    if (bad.empty())
      return;
    vec3 at{};
    for (const auto v : raw_.tets[bad.front()].v)
      at = at + 0.25 * raw_.positions[v];
    const auto count = bad.size() == 1 ? "1 tet has " : std::to_string(bad.size()) + " tets have ";
    warnings_.push_back(count + what + ", the first at " + place_text(at) +
                        ": no stress can be computed until " + until + " there (" + list_tets(bad) +
                        ")");
  }

  expected<void> link() {
    const face_table table(raw_.tets, raw_.positions.size());
    neighbours_.assign(raw_.tets.size(), {no_id, no_id, no_id, no_id});
    std::optional<error> failure;
    table.for_each_face([&](vertex_id, std::span<const face_table::entry> group) {
      if (failure)
        return;
      if (group.size() == 1) {
        add_boundary(group[0]);
      } else if (group.size() == 2 && group[0].odd() != group[1].odd()) {
        neighbours_[group[0].tet()][group[0].face()] = group[1].tet();
        neighbours_[group[1].tet()][group[1].face()] = group[0].tet();
      } else {
        failure = overlap_error(group);
      }
    });
    return failure ? fail(*failure) : expected<void>();
  }

  void add_boundary(const face_table::entry& side) {
    const auto& order = tet_faces[side.face()];
    const auto& v = raw_.tets[side.tet()].v;
    neighbours_[side.tet()][side.face()] = facet_flag | static_cast<facet_id>(facets_.size());
    facets_.push_back({{v[order[0]], v[order[1]], v[order[2]]}, side.tet(), 0});
  }

  [[nodiscard]] error overlap_error(std::span<const face_table::entry> group) const {
    auto sorted = [&](std::uint32_t t) {
      auto v = raw_.tets[t].v;
      std::ranges::sort(v);
      return v;
    };
    for (std::size_t i = 1; i < group.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (sorted(group[i].tet()) == sorted(group[j].tet()))
          return {ec::bad_input,
                  tet_name(group[j].tet()) + " and " + tet_name(group[i].tet()) +
                    " are the same tet twice",
                  "Remove one of them: its stiffness would count double", tet_name(group[i].tet())};
    const auto a = group[0].tet();
    const auto b = group[1].tet();
    const auto& order = tet_faces[group[0].face()];
    const auto& v = raw_.tets[a].v;
    const auto face =
      node_name(v[order[0]]) + "-" + node_name(v[order[1]]) + "-" + node_name(v[order[2]]);
    if (group.size() > 2)
      return {ec::bad_input,
              "face " + face + " belongs to " + std::to_string(group.size()) + " tets (" +
                tet_name(a) + ", " + tet_name(b) + ", " + tet_name(group[2].tet()) +
                "): tets overlap",
              "Mesh the part again", "face " + face};
    return {ec::bad_input,
            tet_name(a) + " and " + tet_name(b) + " lie on the same side of face " + face +
              ": tets overlap",
            "Mesh the part again", "face " + face};
  }

  expected<void> match_triangles() {
    has_surface_.assign(facets_.size(), false);
    for (const auto& triangle : raw_.triangles)
      if (auto ok = match_triangle(triangle); !ok)
        return ok;
    if (inner_triangles_ > 0)
      warnings_.push_back(std::to_string(inner_triangles_) +
                          " triangles lie inside one region and are left out");
    if (repeated_triangles_ > 0)
      warnings_.push_back(std::to_string(repeated_triangles_) +
                          " triangles are listed twice and counted once");
    return {};
  }

  expected<void> match_triangle(const raw_mesh::triangle& triangle) {
    const auto f = boundary_facet_at(triangle.v);
    if (!f)
      return match_inner(triangle);
    if (!triangle.has_surface)
      return {};
    if (has_surface_[*f] && facets_[*f].surface != triangle.surface)
      return fail(ec::bad_input,
                  triangle_name(triangle) + " is claimed by surface " +
                    std::to_string(facets_[*f].surface) + " and by surface " +
                    std::to_string(triangle.surface),
                  "Give each boundary triangle one surface", triangle_name(triangle));
    repeated_triangles_ += has_surface_[*f];
    facets_[*f].surface = triangle.surface;
    has_surface_[*f] = true;
    return {};
  }

  /// The boundary facet with these corners; found through the facets around the smallest corner.
  [[nodiscard]] std::optional<facet_id> boundary_facet_at(std::array<vertex_id, 3> v) {
    if (first_facet_.empty())
      index_facets();
    const auto key = make_face_key(v);
    for (auto i = first_facet_[key.v[0]]; i < first_facet_[key.v[0] + 1]; ++i)
      if (make_face_key(facets_[facet_order_[i]].v).v == key.v)
        return facet_order_[i];
    return std::nullopt;
  }

  void index_facets() {
    first_facet_.assign(raw_.positions.size() + 1, 0);
    const auto smallest = [](const boundary_facet& f) { return std::ranges::min(f.v); };
    for (const auto& f : facets_)
      ++first_facet_[smallest(f) + 1];
    for (std::size_t v = 1; v < first_facet_.size(); ++v)
      first_facet_[v] += first_facet_[v - 1];
    facet_order_.resize(facets_.size());
    std::vector<std::uint32_t> next(first_facet_.begin(), first_facet_.end() - 1);
    for (facet_id f = 0; f < facets_.size(); ++f)
      facet_order_[next[smallest(facets_[f])]++] = f;
  }

  /// A triangle inside the volume: between two regions it is an interface, else it is left out.
  expected<void> match_inner(const raw_mesh::triangle& triangle) {
    if (!inner_faces_)
      inner_faces_.emplace(raw_.tets, raw_.positions.size());
    const auto key = make_face_key(triangle.v);
    const auto group = inner_faces_->find(key);
    if (group.size() != 2)
      return fail(no_face(triangle_name(triangle)));
    if (raw_.tet_regions[group[0].tet()] == raw_.tet_regions[group[1].tet()]) {
      ++inner_triangles_;
    } else if (triangle.has_surface) {
      interfaces_.push_back({key.v, 0, triangle.surface});
    }
    return {};
  }

  void name_missing_surfaces() {
    if (auto said = give_missing_surfaces(raw_, facets_, has_surface_); !said.empty())
      warnings_.push_back(std::move(said));
  }

  mesh_data freeze() {
    mesh_data data;
    std::vector<std::uint32_t> vertex_tet(raw_.positions.size(), no_id);
    for (tet_id t = 0; t < raw_.tets.size(); ++t)
      for (const auto v : raw_.tets[t].v)
        if (vertex_tet[v] == no_id)
          vertex_tet[v] = t;
    data.vertices = static_cast<std::uint32_t>(raw_.positions.size());
    data.live_tets = static_cast<std::uint32_t>(raw_.tets.size());
    data.live_facets = static_cast<std::uint32_t>(facets_.size());
    data.positions = paged_array<vec3>::from(raw_.positions);
    data.vertex_tet = paged_array<std::uint32_t>::from(vertex_tet);
    data.tets = paged_array<tet>::from(raw_.tets);
    data.tet_regions = paged_array<region_id>::from(raw_.tet_regions);
    data.neighbours = paged_array<adjacency>::from(neighbours_);
    data.facets = paged_array<boundary_facet>::from(facets_);
    data.interfaces = paged_array<interface_facet>::from(interfaces_);
    data.vertex_order = paged_array<std::uint32_t>::from(vertex_order_);
    data.tet_order = paged_array<std::uint32_t>::from(tet_order_);
    fill_tables(data);
    return data;
  }

  void fill_tables(mesh_data& data) const {
    std::set<surface_id> surfaces;
    for (const auto& f : facets_)
      surfaces.insert(f.surface);
    for (const auto& f : interfaces_)
      surfaces.insert(f.surface);
    const std::set<region_id> regions(raw_.tet_regions.begin(), raw_.tet_regions.end());
    const auto fill = []<class Row>(const auto& ids, const std::vector<Row>& known,
                                    std::vector<Row>& rows) {
      std::map<decltype(Row::id), const Row*> by_id;
      for (const auto& row : known)
        by_id.try_emplace(row.id, &row);
      for (const auto id : ids) {
        const auto found = by_id.find(id);
        rows.push_back(found == by_id.end() ? Row{.id = id, .name = {}} : *found->second);
      }
    };
    fill(surfaces, raw_.surface_names, data.surfaces);
    fill(regions, raw_.region_names, data.regions);
  }

  raw_mesh raw_;
  std::vector<std::uint32_t> vertex_order_;  ///< As in `mesh_data`.
  std::vector<std::uint32_t> tet_order_;
  std::vector<adjacency> neighbours_;
  std::vector<boundary_facet> facets_;
  std::vector<interface_facet> interfaces_;
  std::vector<bool> has_surface_;
  std::vector<std::uint32_t> first_facet_;
  std::vector<facet_id> facet_order_;
  std::optional<face_table> inner_faces_;
  std::size_t inner_triangles_ = 0;
  std::size_t repeated_triangles_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace

expected<built_version> build_version(raw_mesh raw, double metres_per_unit, slot_order order) {
  return version_assembler(std::move(raw)).run(metres_per_unit, order);
}

}  // namespace tedit
