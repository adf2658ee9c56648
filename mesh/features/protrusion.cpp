// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/protrusion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/units.hpp"
#include "mesh/features/rims.hpp"
#include "mesh/features/surface_shape.hpp"

namespace tedit {

namespace {

/// Material angles within a degree of 180 are smooth.
constexpr double smooth = degree;

class protrusion_grower {
public:
  protrusion_grower(const mesh_version& mesh, const std::vector<surface_id>& surfaces)
      : mesh_(mesh) {
    for (const auto id : surfaces)
      add(id);
  }

  expected<protrusion> grow(bool exact) {
    protrusion result;
    if (facet_count() == 0)
      return fail(ec::empty_selection,
                  "the selected surfaces have no outer side: they lie between two regions",
                  "Select the sides of a boss, rib or fin");
    while (look_around(), !exact && take_next(result.added)) {
    }
    if (feet_.empty())
      return fail(ec::not_a_protrusion,
                  "the selected surfaces stand on nothing: no inner corner runs around them",
                  "Select the sides of one boss, rib or fin; fill_hole closes holes and pockets");
    for (const auto& [id, shape] : chosen_)
      result.surfaces.push_back(id);
    result.feet = std::move(feet_);
    result.size = size_;
    return result;
  }

private:
  void add(surface_id id) { chosen_.emplace(id, shape_of(mesh_, id)); }

  [[nodiscard]] std::size_t facet_count() const {
    std::size_t count = 0;
    for (const auto& [id, shape] : chosen_)
      count += shape.facets.size();
    return count;
  }

  const surface_shape& neighbour(surface_id id) {
    const auto found = others_.find(id);
    return found != others_.end() ? found->second
                                  : others_.emplace(id, shape_of(mesh_, id)).first->second;
  }

  /// A rounded inner corner at the foot of what is chosen: concave in itself, and small beside it.
  bool is_root_fillet(surface_id id) {
    double area = 0;
    for (const auto& [chosen, shape] : chosen_)
      area += shape.area;
    const auto& shape = neighbour(id);
    return shape.concave() && shape.area < 0.5 * area;
  }

  /// Sorts the selection's edges: feet, and the surfaces across all other edges.
  void look_around() {
    candidates_.clear();
    feet_.clear();
    measure();
    for (const auto& [id, shape] : chosen_) {
      const bool fillet = shape.concave();
      for (const auto f : shape.facets)
        for (int i = 0; i < 3; ++i) {
          const auto across = facet_across(mesh_, f, i);
          const auto other = mesh_.facet(across).surface;
          if (chosen_.contains(other))
            continue;
          const double angle = material_angle(mesh_, f, i) - std::numbers::pi;
          const bool root = angle > -smooth && is_root_fillet(other);
          const bool inner = angle > smooth || (fillet && angle > -smooth);
          if (inner && !root)
            add_to_foot(f, i, across);
          else
            candidates_.insert(other);
        }
    }
    finish_feet();
  }

  void measure() {
    vec3 low{1e300, 1e300, 1e300};
    vec3 high{-1e300, -1e300, -1e300};
    for (const auto& [id, shape] : chosen_)
      for (const auto f : shape.facets)
        for (const auto v : mesh_.facet(f).v) {
          const vec3 p = mesh_.position(v);
          low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
          high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    size_ = norm(high - low);
  }

  void add_to_foot(facet_id f, int edge, facet_id across) {
    const auto& v = mesh_.facet(f).v;
    const double length = norm(mesh_.position(v[(edge + 1) % 3]) - mesh_.position(v[edge]));
    const vec3 area = area_vector(mesh_, mesh_.facet(across));
    auto found = std::ranges::find_if(feet_, [&](const foot& known) {
      return dot(normalized(known.normal), normalized(area)) > 1 - 1e-6 &&
             distance(known, mesh_.facet(across)) < 1e-4 * size_;
    });
    if (found == feet_.end()) {
      found = feet_.insert(feet_.end(), foot{});
      found->point = mesh_.position(mesh_.facet(across).v[0]);
    }
    found->normal += area;  // a unit vector in the end
    found->length += length;
    found->facets.push_back(across);
  }

  [[nodiscard]] double distance(const foot& known, const boundary_facet& f) const {
    const vec3 n = normalized(known.normal);
    double result = 0;
    for (const auto v : f.v)
      result = std::max(result, std::abs(dot(mesh_.position(v) - known.point, n)));
    return result;
  }

  /// Facets of one bent surface are one foot, which is then not flat.
  void join_bent_feet() {
    constexpr double turn = 30 * degree;
    const auto surface = [&](const foot& known) {
      return mesh_.facet(known.facets.front()).surface;
    };
    for (std::size_t i = 0; i < feet_.size(); ++i)
      for (std::size_t j = i + 1; j < feet_.size();) {
        if (surface(feet_[i]) != surface(feet_[j]) ||
            dot(normalized(feet_[i].normal), normalized(feet_[j].normal)) < std::cos(turn)) {
          ++j;
          continue;
        }
        feet_[i].normal += feet_[j].normal;
        feet_[i].length += feet_[j].length;
        feet_[i].facets.insert(feet_[i].facets.end(), feet_[j].facets.begin(),
                               feet_[j].facets.end());
        feet_.erase(feet_.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1;
      }
  }

  void finish_feet() {
    join_bent_feet();
    for (auto& known : feet_) {
      std::ranges::sort(known.facets);
      known.facets.erase(std::ranges::unique(known.facets).begin(), known.facets.end());
      vec3 centre;
      double area = 0;
      for (const auto f : known.facets) {
        const auto& v = mesh_.facet(f).v;
        const double weight = norm(area_vector(mesh_, mesh_.facet(f)));
        for (const auto i : v)
          centre += weight / 3 * mesh_.position(i);
        area += weight;
      }
      known.normal = normalized(known.normal);
      known.point = centre / area;
      for (const auto f : known.facets)
        known.deviation = std::max(known.deviation, distance(known, mesh_.facet(f)));
      known.flat = known.deviation <= 1e-4 * size_;
    }
  }

  /// No corner below a flat foot.
  [[nodiscard]] bool stands_on_feet(const surface_shape& shape) const {
    return std::ranges::all_of(feet_, [&](const foot& known) {
      return !known.flat || std::ranges::all_of(shape.facets, [&](facet_id f) {
        return std::ranges::all_of(mesh_.facet(f).v, [&](vertex_id v) {
          return dot(mesh_.position(v) - known.point, known.normal) >= -1e-4 * size_;
        });
      });
    });
  }

  /// Adds what fits; while no foot is in sight only the smallest neighbour. False when none does.
  bool take_next(std::vector<surface_id>& added) {
    std::vector<std::pair<double, surface_id>> fitting;
    for (const auto id : candidates_)
      if (stands_on_feet(neighbour(id)))
        fitting.emplace_back(neighbour(id).area, id);
    if (feet_.empty() && fitting.size() > 1) {
      std::ranges::sort(fitting);
      fitting.resize(1);
    }
    for (const auto& [area, id] : fitting) {
      chosen_.emplace(id, neighbour(id));
      added.push_back(id);
    }
    return !fitting.empty();
  }

  const mesh_version& mesh_;
  std::map<surface_id, surface_shape> chosen_;
  std::map<surface_id, surface_shape> others_;
  std::set<surface_id> candidates_;
  std::vector<foot> feet_;
  double size_ = 0;
};

}  // namespace

expected<protrusion> complete_protrusion(const mesh_version& mesh,
                                         const std::vector<surface_id>& surfaces, bool exact) {
  return protrusion_grower(mesh, surfaces).grow(exact);
}

}  // namespace tedit
