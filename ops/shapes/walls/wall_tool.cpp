// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/wall_tool.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "mesh/features/known_wall.hpp"
#include "mesh/features/rims.hpp"
#include "mesh/place_text.hpp"
#include "ops/shapes/walls/bonded_border.hpp"
#include "ops/shapes/walls/near_boundary.hpp"
#include "ops/shapes/walls/step_geometry.hpp"

namespace tedit::ops {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Exact shapes that meet at less than this run on smoothly; facets of other ones at less than
/// that.
constexpr double smooth_exact = 3 * degree;
constexpr double smooth_facets = 25 * degree;
/// A neighbour within this of a right angle goes up with a wall that is thickened.
constexpr double upright = 30 * degree;
/// How far the end of the part, or its material, is looked for beside a wall: in depths and edges.
constexpr double reach_depths = 12;
constexpr double reach_edges = 4;
/// A depth is no smaller than this share of the edges around.
constexpr double finest = 1.0 / 200;
/// A face between regions that leaves a wall at more than 120 degrees runs on below it: by the
/// sine of what is more than 90.
constexpr double runs_on_below = 0.5;
/// How far beyond it the tool goes, in edges.
constexpr double beyond = 0.3;
/// The same in another region, of which nothing is taken: less, so that the floor stays parallel.
constexpr double beyond_bond = 0.02;
constexpr int tool_newton_steps = 12;
/// Demands that meet at less than this sine are one.
constexpr double least_tool_sine = 0.2;

std::string millimetres(double length) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm", 1e3 * length);
  return text;
}

/// How the tool ends at an edge of the walls' border.
struct side_rule {
  enum class kind { step, prolong, past };
  kind type = kind::step;
  wall_shape shape;   ///< On which the side ends, but for `target`.
  double target = 0;  ///< m.
  surface_id neighbour = 0;
};

/// A vertex of the sheet that goes: a mesh vertex, once for each fan of the walls' facets.
struct sheet_vertex {
  vertex_id v = no_id;
  std::vector<surface_id> walls;
  std::vector<std::size_t> borders;
  vec3 place;
};

struct border_edge {
  std::uint32_t a = 0;  ///< Sheet vertices, in the direction of the wall's facet.
  std::uint32_t b = 0;
  std::size_t inner = 0;  ///< Index of the facet.
  int edge = 0;
  side_rule rule;
};

class wall_tool_maker {
public:
  wall_tool_maker(const mesh_version& mesh, const wall_set& walls, double distance)
      : mesh_(mesh),
        walls_(walls),
        distance_(distance),
        facets_(facets_of_all()),
        edge_(mean_edge()),
        reach_(reach_depths * std::abs(distance) + reach_edges * edge_),
        boundary_(mesh, extent().grown(reach_ + 2 * std::abs(distance))),
        bonds_(bonds_in(mesh, extent().grown(std::abs(distance) + edge_))) {}

  expected<wall_tool> make() {
    if (!(std::abs(distance_) >= finest * edge_))
      return fail(ec::invalid_argument,
                  "a step of " + millimetres(std::abs(distance_)) +
                    " is too small for a mesh whose edges measure " + millimetres(edge_) + " there",
                  "Move the wall further, or together with those that it runs on into");
    join_corners();
    find_borders();
    for (auto& border : borders_)
      border.rule = rule_at(border);
    for (auto& v : vertices_) {
      v.place = place_of(v);
      if (std::ranges::none_of(
            v.borders, [&](auto i) { return borders_[i].rule.type == side_rule::kind::past; }))
        result_.places.push_back(v.place);
    }
    if (auto ok = add_sheets(); !ok)
      return fail(ok.error());
    for (const auto& border : borders_)
      add_side(border);
    if (has_geometries(mesh_))
      say_what_steps_are();
    result_.edge = edge_;
    return std::move(result_);
  }

private:
  std::vector<facet_id> facets_of_all() {
    std::vector<surface_id> ids;
    for (const auto& [id, wall] : walls_)
      ids.push_back(id);
    auto facets = facets_of(mesh_, ids);
    std::ranges::sort(facets);
    return facets;
  }

  [[nodiscard]] std::array<vec3, 3> corners(std::size_t i) const {
    const auto& v = mesh_.facet(facets_[i]).v;
    return {mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])};
  }

  [[nodiscard]] double mean_edge() const {
    double sum = 0;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const auto p = corners(i);
      sum += norm(p[1] - p[0]) + norm(p[2] - p[1]) + norm(p[0] - p[2]);
    }
    return sum / (3 * static_cast<double>(std::max<std::size_t>(1, facets_.size())));
  }

  [[nodiscard]] box extent() const {
    box all;
    for (std::size_t i = 0; i < facets_.size(); ++i)
      for (const auto& p : corners(i))
        all.add(p);
    return all;
  }

  /// Index of a facet of the walls; nothing for another one.
  [[nodiscard]] std::optional<std::size_t> index_of(facet_id f) const {
    const auto at = std::ranges::lower_bound(facets_, f);
    return at != facets_.end() && *at == f ? std::optional<std::size_t>(at - facets_.begin())
                                           : std::nullopt;
  }

  // -- the sheet -------------------------------------------------------------------------------

  std::size_t root(std::size_t corner) {
    while (parent_[corner] != corner)
      corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }

  [[nodiscard]] std::size_t corner_at(std::size_t facet, vertex_id v) const {
    const auto& corners = mesh_.facet(facets_[facet]).v;
    return 3 * facet + static_cast<std::size_t>(std::ranges::find(corners, v) - corners.begin());
  }

  /// Corners of facets that share an edge there are one vertex of the sheet: a mesh vertex at which
  /// walls only touch is two.
  void join_corners() {
    parent_.resize(3 * facets_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    across_.resize(3 * facets_.size());
    for (std::size_t i = 0; i < facets_.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const auto beside = facet_across(mesh_, facets_[i], k);
        across_[3 * i + k] = beside;
        const auto other = index_of(beside);
        if (!other)
          continue;
        const auto& v = mesh_.facet(facets_[i]).v;
        for (const auto end : {v[k], v[(k + 1) % 3]})
          parent_[root(corner_at(i, end))] = root(corner_at(*other, end));
      }
    std::map<std::size_t, std::uint32_t> index;
    sheet_of_.resize(parent_.size());
    for (std::size_t c = 0; c < parent_.size(); ++c) {
      const auto [row, fresh] =
        index.try_emplace(root(c), static_cast<std::uint32_t>(vertices_.size()));
      const auto& facet = mesh_.facet(facets_[c / 3]);
      if (fresh)
        vertices_.push_back({facet.v[c % 3], {}, {}, {}});
      sheet_of_[c] = row->second;
      auto& on = vertices_[row->second].walls;
      if (!std::ranges::count(on, facet.surface))
        on.push_back(facet.surface);
    }
  }

  void find_borders() {
    for (std::size_t i = 0; i < facets_.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        if (index_of(across_[3 * i + k]))
          continue;
        border_edge border;
        border.a = sheet_of_[3 * i + k];
        border.b = sheet_of_[3 * i + (k + 1) % 3];
        border.inner = i;
        border.edge = k;
        vertices_[border.a].borders.push_back(borders_.size());
        vertices_[border.b].borders.push_back(borders_.size());
        borders_.push_back(border);
      }
  }

  // -- where the tool ends ---------------------------------------------------------------------

  const std::optional<wall_shape>& shape_of(surface_id id) {
    if (const auto wall = walls_.find(id); wall != walls_.end())
      return wall->second.exact;
    const auto [row, fresh] = shapes_.try_emplace(id);
    if (fresh)
      row->second = fit_wall(mesh_, facets_of(mesh_, std::vector{id}), round_enough);
    return row->second;
  }

  [[nodiscard]] vec3 normal_of(facet_id f) const {
    return normalized(area_vector(mesh_, mesh_.facet(f)));
  }

  side_rule rule_at(const border_edge& border) {
    const auto& facet = mesh_.facet(facets_[border.inner]);
    const auto outer = across_[3 * border.inner + border.edge];
    const vec3 a = mesh_.position(facet.v[border.edge]);
    const vec3 b = mesh_.position(facet.v[(border.edge + 1) % 3]);
    const vec3 middle = 0.5 * (a + b);
    const auto& wall = shape_of(facet.surface);
    const vec3 n = wall ? wall->normal(middle) : normal_of(facets_[border.inner]);
    side_rule rule;
    rule.neighbour = mesh_.facet(outer).surface;
    rule.shape.point = middle;
    rule.shape.axis = normalized(cross(b - a, n));
    const auto& beside = shape_of(rule.neighbour);
    const auto bond = distance_past_bond(border, n);
    if (bond) {
      rule.type = side_rule::kind::past;
      rule.target = *bond;
    }
    const vec3 other = beside ? beside->normal(middle) : normal_of(outer);
    const double bend = std::atan2(norm(cross(n, other)), dot(n, other));
    if (bend < (wall && beside ? smooth_exact : smooth_facets)) {
      result_.smooth.insert(rule.neighbour);
      return rule;
    }
    if (bond)
      return rule;
    const bool rises = material_angle(mesh_, facets_[border.inner], border.edge) > std::numbers::pi;
    if (distance_ > 0 ? !rises : rises) {
      const bool one_solid = mesh_.region_of(facet.tet) == mesh_.region_of(mesh_.facet(outer).tet);
      if (beside && one_solid && std::abs(bend - 0.5 * std::numbers::pi) < upright)
        return {side_rule::kind::prolong, *beside, 0, rule.neighbour};
      return rule;
    }
    if (const auto past = distance_past(a, b, n, rule.shape.axis)) {
      rule.type = side_rule::kind::past;
      rule.target = *past;
    }
    return rule;
  }

  /// How far a tool that takes off has to go beside the edge a b until it is in another region, of
  /// which it takes nothing; nothing where none begins there, or only below the wall.
  [[nodiscard]] std::optional<double> distance_past_bond(const border_edge& border, vec3 n) const {
    if (distance_ > 0)
      return std::nullopt;
    const auto bond = bonded_border_at(mesh_, facets_[border.inner], border.edge);
    const auto& v = mesh_.facet(facets_[border.inner]).v;
    const vec3 a = mesh_.position(v[border.edge]);
    const vec3 b = mesh_.position(v[(border.edge + 1) % 3]);
    const vec3 away = normalized(cross(b - a, n));
    if (!bond || dot(bond->into, away) > runs_on_below || dot(bond->into, n) > 0)
      return std::nullopt;
    const double leans = std::max(0.0, dot(bond->into, away) / -dot(bond->into, n)) * -distance_;
    const double bulge = bulge_over(bonds_, a, b, -n, -distance_);
    return std::min(std::max(leans, bulge), leans + beyond * edge_) +
           std::min(beyond_bond * edge_, 0.5 * bond->room);
  }

  /// How far the tool has to go beside the wall until it is out of the part, or in its material;
  /// nothing where that is too far.
  [[nodiscard]] std::optional<double> distance_past(vec3 a, vec3 b, vec3 n, vec3 away) const {
    double most = 0;
    double room = 1e300;
    for (const double share : {0.1, 0.5, 0.9}) {
      const vec3 from = a + share * (b - a) + distance_ * n;
      const auto hits = boundary_.along(from, away, reach_);
      const bool wants_out = distance_ < 0;
      if (hits.empty())
        return std::nullopt;
      std::size_t first = 0;
      double gap = 0;
      if (hits.front().leaves == wants_out) {
        gap = hits.front().distance;
        first = 1;
      }
      most = std::max(most, gap);
      if (first < hits.size())
        room = std::min(room, hits[first].distance - gap);
    }
    return most + std::min(beyond * edge_, 0.5 * room);
  }

  /// A shape that a place shall be so far off, m.
  struct demand {
    wall_shape shape;
    double target = 0;
  };

  /// Of the walls that the vertex lies on, then of the sides there; those that lead past the part
  /// come last, as they need not be met exactly.
  [[nodiscard]] std::vector<demand> demands_at(const sheet_vertex& vertex) const {
    const vec3 start = mesh_.position(vertex.v);
    std::vector<demand> demands;
    for (const auto id : vertex.walls) {
      const auto& wall = walls_.at(id);
      if (wall.exact) {
        demands.push_back({*wall.exact, distance_ + wall.exact->distance(start)});
        continue;
      }
      for (const auto& normal : wall.normals.at(vertex.v)) {
        wall_shape plane;
        plane.point = start;
        plane.axis = normal;
        demands.push_back({plane, distance_});
      }
    }
    for (const bool past : {false, true})
      for (const auto i : vertex.borders) {
        const auto& rule = borders_[i].rule;
        if ((rule.type == side_rule::kind::past) != past)
          continue;
        const bool goes_on = rule.type == side_rule::kind::prolong;
        demand side{rule.shape, goes_on ? rule.shape.distance(start) : rule.target};
        if (!goes_on)
          side.shape.point = start;
        demands.push_back(side);
      }
    return demands;
  }

  /// The shortest step that meets the demands to first order, the first ones first.
  [[nodiscard]] static vec3 step_to(const std::vector<demand>& demands, vec3 x) {
    std::vector<vec3> basis;
    vec3 move;
    for (const auto& d : demands) {
      const vec3 slope = d.shape.normal(x);
      const double missing = d.target - d.shape.distance(x) - dot(slope, move);
      vec3 rest = slope;
      for (const auto& b : basis)
        rest = rest - dot(rest, b) * b;
      const double size = norm(rest);
      if (size < least_tool_sine || basis.size() == 3)
        continue;
      basis.push_back(rest / size);
      move += missing / size * basis.back();
    }
    return move;
  }

  [[nodiscard]] vec3 place_of(const sheet_vertex& vertex) const {
    const auto demands = demands_at(vertex);
    const vec3 start = mesh_.position(vertex.v);
    vec3 x = start;
    for (int n = 0; n < tool_newton_steps; ++n) {
      const vec3 move = step_to(demands, x);
      x += move;
      if (norm(move) <= 1e-12 * norm(x - start))
        break;
    }
    return x;
  }

  // -- the tool --------------------------------------------------------------------------------

  std::uint32_t face_named(const std::string& name, std::optional<surface_id> continues) {
    const auto [row, fresh] =
      faces_.try_emplace(name, static_cast<std::uint32_t>(result_.tool.names.size()));
    if (fresh) {
      result_.tool.names.push_back(name);
      result_.continues.push_back(continues);
    }
    return row->second;
  }

  void add_triangle(std::array<std::uint32_t, 3> t, std::uint32_t face) {
    if (distance_ > 0)
      std::swap(t[1], t[2]);
    result_.tool.triangles.push_back(t);
    result_.tool.faces.push_back(face);
  }

  /// Points: the sheet as it is, then where it goes.
  expected<void> add_sheets() {
    const auto count = static_cast<std::uint32_t>(vertices_.size());
    for (const auto& v : vertices_)
      result_.tool.points.push_back(mesh_.position(v.v));
    for (const auto& v : vertices_)
      result_.tool.points.push_back(v.place);
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const std::array t{sheet_of_[3 * i], sheet_of_[3 * i + 1], sheet_of_[3 * i + 2]};
      const auto id = mesh_.facet(facets_[i]).surface;
      const vec3 now =
        area_vector(vertices_[t[0]].place, vertices_[t[1]].place, vertices_[t[2]].place);
      if (!(dot(now, normal_of(facets_[i])) > 0) || !is_finite(now))
        return fail(ec::invalid_argument,
                    "surface " + std::to_string(id) + " bends too sharply at " +
                      place_text(mesh_.position(vertices_[t[0]].v)) + " to be moved so far");
      add_triangle(t, face_named("surface " + std::to_string(id) + " before", {}));
      add_triangle({t[0] + count, t[2] + count, t[1] + count},
                   face_named("surface " + std::to_string(id), id));
    }
    return {};
  }

  void add_side(const border_edge& border) {
    const auto count = static_cast<std::uint32_t>(vertices_.size());
    const auto& rule = border.rule;
    const bool goes_on = rule.type == side_rule::kind::prolong;
    const auto beside = std::to_string(rule.neighbour);
    const auto face = face_named(goes_on ? "surface " + beside + " prolonged"
                                 : rule.type == side_rule::kind::past ? "beyond surface " + beside
                                                                      : "step beside " + beside,
                                 goes_on ? std::optional(rule.neighbour) : std::nullopt);
    if (rule.type == side_rule::kind::step)
      note_step(face, border);
    const auto [a, b] = std::pair(border.a, border.b);
    const auto& p = result_.tool.points;
    if (norm(p[a] - p[b + count]) < norm(p[b] - p[a + count])) {
      add_triangle({b, a, b + count}, face);
      add_triangle({a, a + count, b + count}, face);
    } else {
      add_triangle({b, a, a + count}, face);
      add_triangle({b, a + count, b + count}, face);
    }
  }

  /// Steps at one surface, beside walls that look one way.
  struct steps {
    surface_id beside = 0;
    vec3 way;
    std::vector<vec3> rim;
  };

  void note_step(std::uint32_t face, const border_edge& border) {
    const auto& wall = shape_of(mesh_.facet(facets_[border.inner]).surface);
    // Beside walls of a step that look several ways: one that no axis has.
    const vec3 way = wall && wall->type == wall_shape::kind::plane ? wall->axis : vec3{};
    const auto [row, fresh] = steps_.try_emplace(face, steps{border.rule.neighbour, way, {}});
    if (!fresh && row->second.way != way)
      row->second.way = {};
    for (const auto end : {border.a, border.b})
      row->second.rim.push_back(mesh_.position(vertices_[end].v));
  }

  void say_what_steps_are() {
    result_.tool.geometries.resize(result_.tool.names.size());
    for (const auto& [face, one] : steps_)
      if (one.way != vec3{})
        result_.tool.geometries[face] =
          step_geometry(find_geometry(mesh_, one.beside), one.rim, one.way);
  }

  const mesh_version& mesh_;
  const wall_set& walls_;
  double distance_;
  std::vector<facet_id> facets_;  ///< Of the walls, ascending.
  double edge_;
  double reach_;
  near_boundary boundary_;
  std::vector<bond_triangle> bonds_;
  std::vector<std::size_t> parent_;      ///< By corner.
  std::vector<facet_id> across_;         ///< By corner: beyond the edge that begins there.
  std::vector<std::uint32_t> sheet_of_;  ///< By corner.
  std::vector<sheet_vertex> vertices_;
  std::vector<border_edge> borders_;
  std::map<surface_id, std::optional<wall_shape>> shapes_;
  std::map<std::string, std::uint32_t> faces_;
  std::map<std::uint32_t, steps> steps_;  ///< By face.
  wall_tool result_;
};

}  // namespace

expected<wall_tool> make_wall_tool(const mesh_version& mesh, const wall_set& walls,
                                   double distance) {
  return wall_tool_maker(mesh, walls, distance).make();
}

}  // namespace tedit::ops
