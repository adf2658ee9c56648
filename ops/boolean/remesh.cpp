// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/remesh.hpp"

#include <algorithm>
#include <map>

#include "mesh/box_tree.hpp"
#include "mesh/distances.hpp"
#include "mesh/level_set_tidy.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/pieces.hpp"
#include "ops/boolean/thin_remains.hpp"
#include "ops/mesher/mesher.hpp"

namespace tedit::ops {

namespace {

constexpr auto damaged = "what the tool cuts could not be taken out of the part";

/// Mean length of the edges at each point.
std::vector<double> mean_edges(const std::vector<vec3>& points,
                               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<double> sum(points.size());
  std::vector<int> count(points.size());
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const auto a = t[k];
      const auto b = t[(k + 1) % 3];
      const double length = norm(points[a] - points[b]);
      sum[a] += length;
      sum[b] += length;
      ++count[a];
      ++count[b];
    }
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = count[i] > 0 ? sum[i] / count[i] : 0;
  return sum;
}

class surface_labeller {
public:
  surface_labeller(const mesh_version& mesh, const cavity& hollow, const tool_surface& tool,
                   const std::vector<std::optional<surface_id>>& continues, const corefined& cut,
                   boolean_mode mode, double size, int free_steps, bool thin)
      : mesh_(mesh),
        hollow_(hollow),
        tool_(tool),
        continues_(continues),
        cut_(cut),
        mode_(mode),
        size_(size),
        free_steps_(free_steps),
        thin_(thin) {}

  expected<labelled_surface> label() {
    add_faces();
    if (!shell_fits())
      return fail(ec::mesher_failed, damaged);
    set_sizes();
    freeze_far();
    result_.mesh.connect();
    return std::move(result_);
  }

private:
  [[nodiscard]] vec3 normal_of(const closed_surface& s, std::size_t i) const {
    const auto& t = s.triangles[i];
    return normalized(area_vector(s.points[t[0]], s.points[t[1]], s.points[t[2]]));
  }

  std::int32_t label_of(const surface_labels::part_surface& row) {
    auto& part = result_.labels.part;
    const auto found = std::ranges::find(part, row);
    if (found == part.end())
      part.push_back(row);
    return static_cast<std::int32_t>(std::ranges::find(part, row) - part.begin());
  }

  std::int32_t label_of(std::uint32_t side_index, bool between) {
    const auto& side = hollow_.sides[side_index];
    if (side.behind != no_id)
      return surface_labels::shell;
    if (side.twin == no_id)
      return label_of({mesh_.facet(side.facet).surface, between, {}});
    if (side.bond != no_id)
      return label_of({mesh_.data().interfaces[side.bond].surface, between, {}});
    return label_of({std::nullopt, between, bare_name(side_index, side.twin)});
  }

  [[nodiscard]] std::string bare_name(std::uint32_t one, std::uint32_t other) const {
    std::array both{hollow_.shares[hollow_.share_of(one)].region,
                    hollow_.shares[hollow_.share_of(other)].region};
    std::ranges::sort(both);
    const auto name_of = [&](region_id id) {
      const auto found = std::ranges::find(mesh_.regions(), id, &region_info::id);
      return found == mesh_.regions().end() || found->name.empty() ? "region " + std::to_string(id)
                                                                   : found->name;
    };
    return "between " + name_of(both[0]) + " and " + name_of(both[1]);
  }

  void add_faces() {
    auto& mesh = result_.mesh;
    for (std::size_t i = 0; i < cut_.points.size(); ++i)
      mesh.vertices.push_back({cut_.points[i], size_, cut_.origin[i], false});
    // The part's labels first, so that those of the tool stand behind them.
    for (std::uint32_t i = 0; i < hollow_.sides.size(); ++i)
      (void)label_of(i, false);
    for (std::size_t i = 0; i < cut_.sides.size(); ++i)
      if (cut_.sides[i][1] >= 0)
        (void)label_of(static_cast<std::uint32_t>(cut_.parent[i]), true);
    for (const auto& id : continues_)
      if (id)
        (void)label_of({*id, false, {}});
    result_.labels.tool_faces = tool_.names.size();
    const auto first_of_tool = static_cast<std::int32_t>(result_.labels.part.size());
    for (std::size_t i = 0; i < cut_.triangles.size(); ++i) {
      surface_mesh::face f;
      f.v = cut_.triangles[i];
      f.sides = cut_.sides[i];
      if (const auto parent = cut_.parent[i]; parent < 0) {
        const auto of = static_cast<std::size_t>(-1 - static_cast<std::int64_t>(parent));
        const auto& t = tool_.triangles[of];
        const vec3 normal =
          normalized(area_vector(tool_.points[t[0]], tool_.points[t[1]], tool_.points[t[2]]));
        f.normal = mode_ == boolean_mode::cut ? -normal : normal;
        const auto face = tool_.faces[of];
        f.label = face < continues_.size() && continues_[face]
                    ? label_of({*continues_[face], false, {}})
                    : first_of_tool + static_cast<std::int32_t>(face);
      } else {
        const auto& side = hollow_.sides[parent];
        // What was added to one share may lie against another one's surface.
        const double way = hollow_.share_of(parent) == f.sides[0] ? 1 : -1;
        f.normal = way * normal_of(hollow_.surface, parent);
        f.frozen = side.behind != no_id;
        f.label = label_of(static_cast<std::uint32_t>(parent), f.sides[1] >= 0);
      }
      mesh.faces.push_back(f);
    }
  }

  /// Triangles against other tets are there as they were, or gone as that tet is.
  [[nodiscard]] bool shell_fits() const {
    std::vector<int> pieces(hollow_.sides.size());
    for (std::size_t i = 0; i < cut_.triangles.size(); ++i) {
      const auto parent = cut_.parent[i];
      if (parent < 0 || hollow_.sides[parent].behind == no_id)
        continue;
      ++pieces[parent];
      auto now = cut_.triangles[i];
      for (auto& v : now)
        v = cut_.origin[v] < 0 ? no_id : static_cast<std::uint32_t>(cut_.origin[v]);
      auto was = hollow_.surface.triangles[parent];
      std::ranges::sort(now);
      std::ranges::sort(was);
      if (now != was)
        return false;
    }
    auto gone = hollow_.gone;
    std::ranges::sort(gone);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto behind = hollow_.sides[i].behind;
      if (behind == no_id)
        continue;
      const bool goes = std::ranges::binary_search(gone, behind);
      if (pieces[i] != (goes ? 0 : 1))
        return false;
    }
    return true;
  }

  /// Points of the part want edges as they have; new ones what is less, that of the part's triangle
  /// that they are in or that of the tool's. What is added stands in the air, so that its triangles
  /// may be as large as the tool's; what is cut lies among the part's tets.
  void set_sizes() {
    const auto part = mean_edges(hollow_.surface.points, hollow_.surface.triangles);
    const auto tool = mean_edges(tool_.points, tool_.triangles);
    const bool in_air = mode_ == boolean_mode::add;
    auto& mesh = result_.mesh;
    std::vector<double> least(mesh.vertices.size(), 1e300);
    for (std::size_t i = 0; i < cut_.triangles.size(); ++i) {
      const auto parent = cut_.parent[i];
      const bool of_part = parent >= 0;
      const auto& t = of_part ? hollow_.surface.triangles[parent] : tool_.triangles[-1 - parent];
      const auto& lengths = of_part ? part : tool;
      const double mean = (lengths[t[0]] + lengths[t[1]] + lengths[t[2]]) / 3;
      for (const auto v : cut_.triangles[i])
        least[v] = std::min(least[v], of_part || in_air ? mean : std::min(mean, size_));
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      auto& vertex = mesh.vertices[v];
      vertex.size = vertex.origin >= 0 ? part[vertex.origin] : least[v];
      vertex.size = std::max(vertex.size, 1e-3 * size_);
    }
  }

  void freeze_far() {
    auto& mesh = result_.mesh;
    std::vector<int> steps(mesh.vertices.size(), free_steps_);
    for (std::size_t v = 0; v < steps.size(); ++v)
      if (mesh.vertices[v].origin < 0)
        steps[v] = 0;
    if (thin_) {
      mesh.connect();
      for (const auto& place : thin_places(mesh))
        for (const auto v : mesh.faces[place.face].v)
          steps[v] = 0;
    }
    for (int round = 0; round < free_steps_; ++round) {
      auto next = steps;
      for (const auto& f : mesh.faces)
        for (const auto v : f.v)
          next[v] = std::min({next[v], steps[f.v[0]] + 1, steps[f.v[1]] + 1, steps[f.v[2]] + 1});
      steps = next;
    }
    for (auto& f : mesh.faces)
      if (!result_.labels.is_tool(f.label) &&
          std::ranges::all_of(f.v, [&](auto v) { return steps[v] >= free_steps_; }))
        f.frozen = true;
  }

  const mesh_version& mesh_;
  const cavity& hollow_;
  const tool_surface& tool_;
  const std::vector<std::optional<surface_id>>& continues_;
  const corefined& cut_;
  boolean_mode mode_;
  double size_;
  int free_steps_;
  bool thin_;
  labelled_surface result_;
};

/// What bounds one share: the live triangles, outward, with their own points.
struct share_surface {
  closed_surface surface;
  std::vector<std::uint32_t> vertex;  ///< Of the surface's points: that of the whole.
};

share_surface surface_of_share(const surface_mesh& mesh, std::int32_t share) {
  share_surface result;
  std::vector<std::uint32_t> place(mesh.vertices.size(), no_id);
  for (const auto& f : mesh.faces) {
    if (!f.alive || (f.sides[0] != share && f.sides[1] != share))
      continue;
    std::array<std::uint32_t, 3> t{};
    for (int k = 0; k < 3; ++k) {
      auto& at = place[f.v[k]];
      if (at == no_id) {
        at = static_cast<std::uint32_t>(result.vertex.size());
        result.surface.points.push_back(mesh.vertices[f.v[k]].position);
        result.vertex.push_back(f.v[k]);
      }
      t[k] = at;
    }
    if (f.sides[0] != share)
      std::swap(t[0], t[1]);
    result.surface.triangles.push_back(t);
  }
  return result;
}

/// A tet from each triangle to the middle of the points.
tet_filling fan_of(const closed_surface& shell) {
  tet_filling result{shell.points, {}};
  vec3 middle;
  for (const auto& p : shell.points)
    middle += p / static_cast<double>(shell.points.size());
  result.points.push_back(middle);
  const auto apex = static_cast<std::uint32_t>(shell.points.size());
  for (const auto& t : shell.triangles)
    result.tets.push_back({t[0], t[2], t[1], apex});
  return result;
}

/// Fills the shares of a cavity, and says what has become of its surface.
class cavity_filler {
public:
  cavity_filler(mesh_builder& builder, const cavity& hollow, const labelled_surface& surface,
                const tool_surface& tool, filling how)
      : builder_(builder),
        hollow_(hollow),
        surface_(surface),
        tool_(tool),
        how_(how),
        vertices_(surface.mesh.vertices.size(), no_id) {
    result_.surfaces.resize(tool.names.size());
    change_.removed = hollow.tets;
    change_.removed.insert(change_.removed.end(), hollow.gone.begin(), hollow.gone.end());
  }

  expected<replaced> replace(const execution& run) {
    for (std::size_t i = 0; i < hollow_.shares.size(); ++i)
      if (auto ok = fill(static_cast<std::int32_t>(i), run); !ok)
        return fail(ok.error());
    for (const auto& f : surface_.mesh.faces)
      if (f.alive && f.label != surface_labels::shell)
        add_facet(f);
    auto added = builder_.apply(change_);
    if (!added)
      return fail(ec::mesher_failed, added.error().message);
    if (hollow_.shares.size() > 1)
      renew_interfaces();
    drop_bare_interfaces(builder_);
    result_.tets = std::move(*added);
    return std::move(result_);
  }

private:
  vertex_id vertex_of(std::uint32_t v) {
    if (vertices_[v] == no_id) {
      const auto& vertex = surface_.mesh.vertices[v];
      vertices_[v] =
        vertex.origin >= 0 ? hollow_.vertices[vertex.origin] : builder_.add_vertex(vertex.position);
    }
    return vertices_[v];
  }

  expected<void> fill(std::int32_t share, const execution& run) {
    const auto shell = surface_of_share(surface_.mesh, share);
    if (shell.surface.triangles.empty())
      return {};
    const auto made = how_ == filling::fan ? expected<tet_filling>(fan_of(shell.surface))
                                           : tetrahedralise_surface(shell.surface, run, 0);
    if (!made)
      return fail(made.error());
    std::vector<vertex_id> vertices(made->points.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] =
        i < shell.vertex.size() ? vertex_of(shell.vertex[i]) : builder_.add_vertex(made->points[i]);
    for (const auto& t : made->tets)
      change_.added.push_back({{{vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}},
                               hollow_.shares[share].region});
    return {};
  }

  void add_facet(const surface_mesh::face& f) {
    const auto& labels = surface_.labels;
    const std::array corners{vertex_of(f.v[0]), vertex_of(f.v[1]), vertex_of(f.v[2])};
    if (labels.is_tool(f.label)) {
      auto& made = result_.surfaces[labels.tool_face(f.label)];
      if (!made)
        made = builder_.add_surface(tool_.names[labels.tool_face(f.label)],
                                    tool_.geometry(labels.tool_face(f.label)));
      change_.facets.push_back({corners, *made});
      return;
    }
    const auto& row = labels.part[f.label];
    if (!row.between)
      change_.facets.push_back({corners, row.id ? *row.id : bare_surface(row.bare_name)});
    else if (row.id)
      interfaces_.push_back({corners, 0, *row.id});
  }

  /// What an interface without an id becomes as a wall.
  surface_id bare_surface(const std::string& name) {
    const auto [row, fresh] = bare_.try_emplace(name, surface_id{});
    if (fresh)
      row->second = builder_.add_surface(name);
    return row->second;
  }

  void renew_interfaces() {
    std::vector<std::uint8_t> is_old(builder_.interfaces().size());
    for (const auto& side : hollow_.sides)
      if (side.twin != no_id && side.bond != no_id)
        is_old[side.bond] = 1;
    std::vector<interface_facet> next;
    for (std::size_t i = 0; i < is_old.size(); ++i)
      if (!is_old[i])
        next.push_back(builder_.interfaces()[i]);
    next.insert(next.end(), interfaces_.begin(), interfaces_.end());
    builder_.set_interfaces(next);
  }

  mesh_builder& builder_;
  const cavity& hollow_;
  const labelled_surface& surface_;
  const tool_surface& tool_;
  filling how_;
  std::vector<vertex_id> vertices_;
  cavity_change change_;
  std::vector<interface_facet> interfaces_;
  std::map<std::string, surface_id> bare_;
  replaced result_;
};

}  // namespace

expected<labelled_surface> label_surface(const mesh_version& mesh, const cavity& hollow,
                                         const tool_surface& tool,
                                         const std::vector<std::optional<surface_id>>& continues,
                                         const corefined& cut, boolean_mode mode, double size,
                                         int free_steps, bool thin) {
  return surface_labeller(mesh, hollow, tool, continues, cut, mode, size, free_steps, thin).label();
}

double deviation_of(const surface_mesh& before, const surface_mesh& after) {
  std::vector<std::array<vec3, 3>> triangles;
  std::vector<box> boxes;
  for (const auto& f : after.faces) {
    if (!f.alive || f.frozen)
      continue;
    triangles.push_back({after.vertices[f.v[0]].position, after.vertices[f.v[1]].position,
                         after.vertices[f.v[2]].position});
    boxes.push_back(box_of(triangles.back()));
  }
  if (triangles.empty())
    return 0;
  const box_tree tree(boxes);
  double most = 0;
  for (std::uint32_t v = 0; v < before.vertices.size(); ++v) {
    const auto& at = before.faces_at(v);
    if (before.vertices[v].fixed || at.empty() ||
        std::ranges::any_of(at, [&](auto f) { return before.faces[f].slack > 0; }))
      continue;
    const vec3 p = before.vertices[v].position;
    double least = 1e300;
    for (double reach = 1e-3 * before.vertices[v].size; least > reach; reach *= 8) {
      (void)tree.any_meeting(box_of(std::array{p}).grown(reach), [&](std::size_t i) {
        const auto& t = triangles[i];
        least = std::min(least, point_to_triangle(p, t[0], t[1], t[2]));
        return false;
      });
      if (reach > 10 * before.vertices[v].size)
        break;
    }
    most = std::max(most, least);
  }
  return most;
}

expected<replaced> replace_cavity(mesh_builder& builder, const cavity& hollow,
                                  const labelled_surface& surface, const tool_surface& tool,
                                  filling how, const execution& run) {
  return cavity_filler(builder, hollow, surface, tool, how).replace(run);
}

expected<void> tidy_filling(mesh_builder& builder, const execution& run) {
  tidy_settings settings;
  settings.tolerance = 0;
  if (auto ok = tidy_cut(builder, builder.touched(), settings, run.part(0, 0.5)); !ok)
    return fail(ok.error());
  if (const auto improved = improve(builder, builder.touched(), {}, run.part(0.5, 1)); !improved)
    return fail(improved.error());
  return {};
}

}  // namespace tedit::ops
