// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/carried_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/features/rims.hpp"
#include "mesh/features/surface_shape.hpp"

namespace tedit::ops {

namespace {

/// Exact shapes that meet at less than this sine run on smoothly.
constexpr double smooth_sine = 0.05;
/// Where a shape is not known: a quarter circle may be a single facet, at 45 degrees to its ends.
constexpr double smooth_angle = 50 * std::numbers::pi / 180;
/// Ways that differ by less than this share are one.
constexpr double same_way = 1e-6;
/// A longer way than so many times the wall's is none: a rounded tip between the sides of a fin
/// would sink by its whole height.
constexpr double longest_way = 3;

bool flat(const std::optional<wall_shape>& shape) {
  return shape && shape->type == wall_shape::kind::plane;
}

class carrier {
public:
  carrier(const mesh_version& mesh, wall_set& walls, double distance)
      : mesh_(mesh), walls_(walls), distance_(distance) {}

  carried_set find() {
    release_fillets();
    std::vector<surface_id> open;
    for (const auto& [id, wall] : walls_)
      if (wall.is(wall_shape::kind::plane))
        open.push_back(id);
    while (!open.empty()) {
      const auto from = open.back();
      open.pop_back();
      const auto joints = shape(from).whole.joints;
      for (const auto& [other, joint] : joints)
        if (follows(other, from, joint))
          open.push_back(other);
    }
    return std::move(carried_);
  }

private:
  struct known {
    surface_shape whole;
    std::optional<wall_shape> exact;
  };

  const known& shape(surface_id id) {
    const auto [row, fresh] = known_.try_emplace(id);
    if (fresh) {
      row->second.whole = shape_of(mesh_, id);
      row->second.exact = fit_wall(mesh_, row->second.whole.facets, round_enough);
    }
    return row->second;
  }

  /// Round surfaces of the selection that end at a plane which stays, tangent to it.
  void release_fillets() {
    std::vector<surface_id> released;
    for (const auto& [id, wall] : walls_) {
      if (!wall.is(wall_shape::kind::cylinder))
        continue;
      bool at_wall = false;
      bool at_rest = false;
      const auto joints = shape(id).whole.joints;
      for (const auto& [other, joint] : joints) {
        if (!flat(shape(other).exact) || !smooth(id, other, joint))
          continue;
        (walls_.contains(other) ? at_wall : at_rest) = true;
      }
      if (at_wall && at_rest)
        released.push_back(id);
    }
    for (const auto id : released)
      walls_.erase(id);
  }

  bool follows(surface_id id, surface_id from, const surface_joint& joint) {
    if (walls_.contains(id) || carried_.contains(id) || flat(shape(id).exact) ||
        !smooth(from, id, joint))
      return false;
    const auto led = carried_.find(from);
    if (led != carried_.end() && stays_put(id, led->second))
      return false;
    const auto way = way_of(id, led == carried_.end() ? std::nullopt : std::optional(led->second));
    if (!way)
      return false;
    carried_.emplace(id, *way);
    return true;
  }

  /// A cylinder that is moved along its axis is where it was.
  bool stays_put(surface_id id, vec3 way) {
    const auto& exact = shape(id).exact;
    return exact && exact->type == wall_shape::kind::cylinder &&
           norm(cross(exact->axis, way)) <= smooth_sine * norm(way);
  }

  /// The shortest way that keeps the surface at the planes that it runs into; of a surface at no
  /// moving plane the way of what leads it. Nothing where the planes leave none.
  std::optional<vec3> way_of(surface_id id, std::optional<vec3> lead) {
    std::vector<std::pair<vec3, double>> planes;
    const auto joints = shape(id).whole.joints;
    bool led_by_wall = false;
    for (const auto& [other, joint] : joints) {
      const auto& exact = shape(other).exact;
      if (!flat(exact) || !smooth(id, other, joint))
        continue;
      const bool moves = walls_.contains(other);
      led_by_wall = led_by_wall || moves;
      planes.emplace_back(exact->axis, moves ? distance_ : 0.0);
    }
    vec3 way;
    std::vector<vec3> basis;
    if (!led_by_wall && lead) {
      way = *lead;
    } else {
      for (const auto& [normal, wanted] : planes) {
        vec3 rest = normal;
        for (const auto& b : basis)
          rest = rest - dot(rest, b) * b;
        if (norm(rest) < smooth_sine)
          continue;
        const vec3 unit = normalized(rest);
        way += (wanted - dot(way, normal)) / dot(unit, normal) * unit;
        basis.push_back(unit);
      }
    }
    for (const auto& [normal, wanted] : planes)
      if (std::abs(dot(way, normal) - wanted) > same_way * std::abs(distance_))
        return std::nullopt;
    return norm(way) <= longest_way * std::abs(distance_) ? std::optional(way) : std::nullopt;
  }

  bool smooth(surface_id a, surface_id b, const surface_joint& joint) {
    const auto& one = shape(a).exact;
    const auto& two = shape(b).exact;
    if (!one || !two)
      return std::abs(joint.angle - std::numbers::pi) < smooth_angle;
    // In the middle of an edge between them, seen on the exact shapes.
    for (const auto f : shape(a).whole.facets) {
      const auto& v = mesh_.facet(f).v;
      for (int i = 0; i < 3; ++i)
        if (mesh_.facet(facet_across(mesh_, f, i)).surface == b) {
          const vec3 p = mesh_.position(v[i]);
          const vec3 n = one->normal(p);
          if (norm(cross(n, two->normal(p))) > smooth_sine || dot(n, two->normal(p)) < 0)
            return false;
        }
    }
    return true;
  }

  const mesh_version& mesh_;
  wall_set& walls_;
  double distance_;
  std::map<surface_id, known> known_;
  carried_set carried_;
};

}  // namespace

carried_set find_carried(const mesh_version& mesh, wall_set& walls, double distance) {
  return carrier(mesh, walls, distance).find();
}

}  // namespace tedit::ops
