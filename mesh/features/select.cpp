// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/features/select.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/number_range.hpp"
#include "base/units.hpp"
#include "mesh/features/hole.hpp"
#include "mesh/features/protrusion.hpp"
#include "mesh/features/surface_shape.hpp"
#include "mesh/features/wall_shape.hpp"

namespace tedit {

namespace {

std::vector<surface_id> sorted(const std::set<surface_id>& ids) {
  return {ids.begin(), ids.end()};
}

/// A rim's radius when it is round: its vertices lie on a circle within 5 %.
double round_radius(const mesh_version& mesh, const rim& r) {
  double least = 1e300;
  double most = 0;
  double mean = 0;
  for (const auto v : r.loop) {
    const vec3 d = mesh.position(v) - r.centre;
    const double radius = norm(d - dot(d, r.normal) * r.normal);
    least = std::min(least, radius);
    most = std::max(most, radius);
    mean += radius / static_cast<double>(r.loop.size());
  }
  return most - least <= 0.05 * mean ? mean : 0;
}

/// The space between the surfaces and lids over their rims, as a share of their area to the power
/// 3/2: positive where it is material (a boss), negative where it is open (a hole), 0 where flat.
double bulge(const mesh_version& mesh, const std::vector<shell>& shells) {
  double volume = 0;
  double area = 0;
  const vec3 origin = mesh.position(mesh.facet(shells.front().facets.front()).v[0]);
  const auto add = [&](vec3 a, vec3 b, vec3 c) {
    volume += dot(a - origin, cross(b - origin, c - origin)) / 6;
  };
  for (const auto& part : shells) {
    for (const auto f : part.facets) {
      const auto& v = mesh.facet(f).v;
      add(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
      area += norm(area_vector(mesh, mesh.facet(f)));
    }
    for (const auto& r : part.rims)
      for (std::size_t i = 0; i < r.loop.size(); ++i)
        add(r.centre, mesh.position(r.loop[(i + 1) % r.loop.size()]), mesh.position(r.loop[i]));
  }
  return volume / std::pow(area, 1.5);
}

double rim_length(const mesh_version& mesh, const std::vector<shell>& shells) {
  double length = 0;
  for (const auto& part : shells)
    for (const auto& r : part.rims)
      for (std::size_t i = 0; i < r.loop.size(); ++i)
        length += norm(mesh.position(r.loop[(i + 1) % r.loop.size()]) - mesh.position(r.loop[i]));
  return length;
}

/// Next to no space, as a share of area^(3/2): that of a wall 1 m wide with a dent of 10 um.
constexpr double no_space = 1e-5;
/// A boss has one flat surface of at most this share, unless its foot is most of its border: a wall
/// with the roundings at its edges has not.
constexpr double wall_share = 0.8;
constexpr double foot_share = 0.6;

/// Of a hole without what lies behind its caps: a flange with a dent in it is no pocket.
expected<double> bulge_of_walls(const mesh_version& mesh, const completed_selection& hole) {
  if (hole.behind.empty())
    return bulge(mesh, hole.shells);
  auto walls = hole.surfaces;
  std::erase_if(
    walls, [&](surface_id id) { return std::ranges::find(hole.behind, id) != hole.behind.end(); });
  const auto own = complete_hole(mesh, walls, {.exact = true});
  return own ? bulge(mesh, own->shells) : expected<double>(fail(own.error()));
}

class selector {
public:
  selector(const mesh_version& mesh, const execution& run) : mesh_(mesh), run_(run) {}

  /// The wall's other parts first (a bore is often two half cylinders), then what the hole needs.
  expected<found_feature> hole(surface_id wall) {
    std::set<surface_id> walls{wall};
    std::vector<surface_id> open{wall};
    while (!open.empty()) {
      const auto id = open.back();
      open.pop_back();
      for (const auto& [other, joint] : shape(id).joints) {
        const bool inner = joint.angle >= std::numbers::pi - degree;
        const bool alike = shape(other).concave() == shape(wall).concave();
        if (inner && alike && walls.insert(other).second)
          open.push_back(other);
      }
    }
    const auto whole = complete_hole(mesh_, sorted(walls), {});
    if (!whole)
      return fail(whole.error());
    const auto space = bulge_of_walls(mesh_, *whole);
    if (!space)
      return fail(space.error());
    if (*space > -no_space)
      return fail(ec::not_a_hole,
                  "surface " + std::to_string(wall) +
                    " bounds no hole or pocket: it is flat, or bends outwards",
                  "Pick a wall of a hole, or take the surface alone");
    found_feature found;
    found.surfaces = whole->surfaces;
    std::size_t rims = 0;
    std::size_t round = 0;
    for (const auto& part : whole->shells)
      for (const auto& r : part.rims) {
        ++rims;
        const double radius = round_radius(mesh_, r);
        round += radius > 0;
        if (radius > 0 && (found.diameter == 0 || 2 * radius < found.diameter)) {
          found.diameter = 2 * radius;
          found.centre = r.centre;
          found.axis = r.normal;
        }
      }
    // A pocket with one round mouth among others has no diameter.
    if (round < rims)
      found.diameter = 0;
    return found;
  }

  expected<found_feature> boss(const std::vector<surface_id>& surfaces) {
    const auto whole = complete_protrusion(mesh_, surfaces, false);
    if (!whole)
      return fail(whole.error());
    if (is_wall(*whole))
      return fail(ec::not_a_protrusion,
                  "surface " + std::to_string(surfaces.front()) +
                    " is a wall of the part, of no boss, rib or fin",
                  "Pick a surface of a boss, rib or fin, or take the surface alone");
    found_feature found;
    found.kind = feature_kind::protrusion;
    found.surfaces = whole->surfaces;
    return found;
  }

  expected<std::vector<found_feature>> holes(double min_diameter, double max_diameter) {
    std::vector<std::pair<double, found_feature>> found;
    std::set<surface_id> done;
    for (const auto& row : mesh_.surfaces()) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the search was cancelled");
      if (done.contains(row.id) || !shape(row.id).concave())
        continue;
      const auto one = hole(row.id);
      if (!one || one->diameter == 0)
        continue;
      done.insert(one->surfaces.begin(), one->surfaces.end());
      if (one->diameter >= min_diameter && one->diameter <= max_diameter)
        found.emplace_back(-shape(row.id).area, *one);
    }
    std::ranges::stable_sort(found, {}, [](const auto& entry) { return entry.first; });
    std::vector<found_feature> result;
    for (auto& [area, one] : found)
      result.push_back(std::move(one));
    return result;
  }

  found_feature grow(const std::vector<surface_id>& surfaces, double angle, bool far) {
    std::set<surface_id> reached(surfaces.begin(), surfaces.end());
    std::vector<surface_id> open(surfaces);
    while (!open.empty()) {
      std::vector<surface_id> next;
      for (const auto id : open)
        for (const auto& [other, joint] : shape(id).joints)
          if (std::abs(joint.angle - std::numbers::pi) <= angle && reached.insert(other).second)
            next.push_back(other);
      open = far ? std::move(next) : std::vector<surface_id>{};
    }
    found_feature found;
    found.kind = feature_kind::smooth;
    found.surfaces = sorted(reached);
    return found;
  }

private:
  /// Nothing stands out, or it is one flat surface with what rounds its edges.
  bool is_wall(const protrusion& found) {
    const auto shells = find_shells(mesh_, facets_of(mesh_, found.surfaces));
    if (bulge(mesh_, shells) < no_space)
      return true;
    double all = 0;
    double largest = 0;
    for (const auto id : found.surfaces) {
      all += shape(id).area;
      const auto fitted = fit_wall(mesh_, shape(id).facets);
      if (fitted && fitted->type == wall_shape::kind::plane)
        largest = std::max(largest, shape(id).area);
    }
    double feet = 0;
    for (const auto& one : found.feet)
      feet += one.length;
    return largest > wall_share * all && feet < foot_share * rim_length(mesh_, shells);
  }

  const surface_shape& shape(surface_id id) {
    const auto known = shapes_.find(id);
    return known != shapes_.end() ? known->second
                                  : shapes_.emplace(id, shape_of(mesh_, id)).first->second;
  }

  const mesh_version& mesh_;
  const execution& run_;
  std::map<surface_id, surface_shape> shapes_;
};

expected<void> check(const mesh_version& mesh, const selection_query& query) {
  for (const auto id : query.surfaces)
    if (!mesh.find_surface(id))
      return fail(ec::surface_not_found, "there is no surface " + std::to_string(id),
                  "tedit info lists the surfaces");
  const bool one = query.kind == feature_kind::hole;
  const bool none = query.kind == feature_kind::holes;
  if (!none && (query.surfaces.empty() || (one && query.surfaces.size() > 1)))
    return fail(ec::empty_selection,
                one ? "a hole is found from one surface of its wall" : "no surface was picked",
                "Give surface ids");
  if (!(query.angle >= 0 && query.angle <= std::numbers::pi))
    return fail(ec::invalid_argument, "the angle must lie between 0 and 180 degrees");
  for (const auto& [value, name] : {std::pair(query.min_diameter, "the smallest diameter"),
                                    std::pair(query.max_diameter, "the largest diameter")})
    if (auto ok = check_number(value, finite_number("m"), name); !ok)
      return ok;
  if (!(query.min_diameter <= query.max_diameter))
    return fail(ec::invalid_argument, "the smallest diameter is larger than the largest");
  return {};
}

}  // namespace

std::string_view kind_name(feature_kind kind) noexcept {
  switch (kind) {
    case feature_kind::hole:
      return "hole";
    case feature_kind::protrusion:
      return "protrusion";
    case feature_kind::holes:
      return "holes";
    case feature_kind::smooth:
      return "smooth";
    case feature_kind::neighbours:
      return "neighbours";
  }
  return "hole";
}

expected<std::vector<found_feature>> select_surfaces(const mesh_version& mesh,
                                                     const selection_query& query,
                                                     const execution& run) {
  if (auto ok = check(mesh, query); !ok)
    return fail(ok.error());
  selector work(mesh, run);
  expected<found_feature> one = found_feature{};
  switch (query.kind) {
    case feature_kind::holes:
      return work.holes(query.min_diameter, query.max_diameter);
    case feature_kind::hole:
      one = work.hole(query.surfaces.front());
      break;
    case feature_kind::protrusion:
      one = work.boss(query.surfaces);
      break;
    case feature_kind::smooth:
    case feature_kind::neighbours:
      one = work.grow(query.surfaces, query.angle, query.kind == feature_kind::smooth);
      break;
  }
  if (!one)
    return fail(one.error());
  return std::vector{std::move(*one)};
}

}  // namespace tedit
