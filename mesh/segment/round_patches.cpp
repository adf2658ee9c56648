// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/segment/round_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/units.hpp"

namespace tedit {

namespace {

constexpr double least_facing = 0.788;  ///< Cosine of 38 degrees: facet and shape, at a corner.
constexpr double least_bend = 0.26;     ///< Cosine of 75 degrees, between neighbours.
constexpr double widest_gap = 50;       ///< Degrees between corners around an axis.
constexpr double wide_gap = 25;         ///< Degrees: from here on gaps must be alike ...
constexpr double most_unlike = 1.6;     ///< ... the widest in terms of the median.
constexpr double least_turn = 0.0872;   ///< Sine of 5 degrees, between any two normals.
constexpr double area_ratio = 8;        ///< Between facets of a first guess.
constexpr std::size_t most_links = 4;
constexpr std::size_t large_guess = 14;  ///< Facets that say more than a cylinder.
constexpr double share_of_sag = 0.1;   ///< Of how far facets are off the shape, for their corners.
constexpr double smooth_bend = 0.766;  ///< Cosine of 40 degrees.
constexpr double alike = 4;            ///< Area of neighbours that may be of the same tessellation.
/// Boundary that goes over into facets of the same kind: a row of a torus is a cone, too.
constexpr double most_leak = 0.5;
constexpr double most_leak_if_loose = 0.35;

/// More corners than any surface of the form meets by itself.
std::size_t least_corners(surface_form form) {
  return form == surface_form::cylinder ? 8 : 9;
}

/// Corners of a square with its corners cut lie on a circle, too: there the gaps between them
/// differ.
bool goes_round_evenly(const wall_shape& wall, const std::vector<vec3>& points) {
  const vec3 helper = std::abs(wall.axis.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  const vec3 u = normalized(cross(helper, wall.axis));
  const vec3 w = cross(wall.axis, u);
  constexpr double turn = 2 * std::numbers::pi;
  constexpr double same_place = 1e-3;
  std::vector<double> angles;
  for (const auto& p : points)
    if (const vec3 d = p - wall.point; norm(d - dot(d, wall.axis) * wall.axis) > 1e-6 * wall.radius)
      angles.push_back(std::atan2(dot(d, w), dot(d, u)));
  if (angles.size() < 3)
    return false;
  std::ranges::sort(angles);
  std::vector<double> gaps;
  const auto note = [&](double gap) {
    if (gap > same_place)
      gaps.push_back(gap * 180 / std::numbers::pi);
  };
  note(angles.front() + turn - angles.back());
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    note(angles[i + 1] - angles[i]);
  std::ranges::sort(gaps);
  if (gaps.size() >= 2 && gaps.back() > widest_gap)
    gaps.pop_back();  // The open side.
  if (gaps.size() < 2 || gaps.back() > widest_gap)
    return false;
  // A plane between two strips is a chord, too; a single wide facet among others is none of them.
  constexpr std::size_t few = 4;
  const double second = gaps.size() <= few ? gaps.front() : gaps[gaps.size() - 2];
  if (gaps.back() > most_unlike * second)
    return false;
  // A mesh has corners at many places around; a polygon that is no circle has few.
  constexpr std::size_t many = 10;
  return gaps.back() <= wide_gap || gaps.size() >= many ||
         gaps.back() <= most_unlike * gaps[(gaps.size() - 1) / 2];
}

}  // namespace

round_finder::round_finder(const triangle_surface& surface, const facet_net& net, double tolerance,
                           const std::vector<std::uint32_t>& groups,
                           const std::vector<std::uint32_t>& patch_of)
    : surface_(surface), net_(net), tolerance_(tolerance), groups_(groups), patch_of_(patch_of) {}

bool round_finder::may_join(std::uint32_t seed, std::uint32_t facet) const {
  const auto& facets = net_.facets();
  return patch_of_[facet] == no_id &&
         (groups_.empty() ||
          groups_[facets[seed].triangles.front()] == groups_[facets[facet].triangles.front()]);
}

double round_finder::exact_tolerance(const fitted_shape& shape) const {
  return std::max(2 * tolerance_, 2e-5 * shape.wall.radius);
}

/// How far a facet of the shape is off it in its middle, if its corners are on it.
double round_finder::sag_of(const fitted_shape& shape, std::uint32_t facet) const {
  const auto& corners = net_.facets()[facet].corners;
  double least = 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const vec3 a = shape.normal(surface_.points[corners[i]]);
    const vec3 b = shape.normal(surface_.points[corners[(i + 1) % corners.size()]]);
    if (norm(a) > 0.999 && norm(b) > 0.999)
      least = std::min(least, dot(a, b));
  }
  // 1 - cos(w / 2) of the widest.
  return shape.wall.radius * (1 - std::sqrt(std::max(0.0, 0.5 * (1 + least))));
}

/// Corners that are nearer than facets can say the shape: an improved mesh has its vertices a
/// little off.
double round_finder::loose_tolerance(const fitted_shape& shape, const facet_list& facets) const {
  std::vector<double> sags;
  for (const auto f : facets)
    sags.push_back(sag_of(shape, f));
  const auto middle = sags.begin() + static_cast<std::ptrdiff_t>(sags.size() / 2);
  std::ranges::nth_element(sags, middle);
  return std::max(exact_tolerance(shape), share_of_sag * *middle);
}

std::vector<std::uint32_t> round_finder::corners_of(const facet_list& facets) const {
  std::vector<std::uint32_t> result;
  for (const auto f : facets)
    result.insert(result.end(), net_.facets()[f].corners.begin(), net_.facets()[f].corners.end());
  std::ranges::sort(result);
  result.erase(std::ranges::unique(result).begin(), result.end());
  return result;
}

round_finder::facet_list round_finder::near(std::uint32_t seed, std::size_t most,
                                            double bend) const {
  const auto& facets = net_.facets();
  const double area = norm(facets[seed].area);
  facet_list found{seed};
  for (std::size_t i = 0; i < found.size() && found.size() < most; ++i)
    for (const auto& link : facets[found[i]].links) {
      const double other = norm(facets[link.other].area);
      if (found.size() < most && link.cosine >= bend && may_join(seed, link.other) &&
          other < area_ratio * area && area < area_ratio * other &&
          std::ranges::find(found, link.other) == found.end())
        found.push_back(link.other);
    }
  return found;
}

/// A strip with both its neighbours; triangles with some around: more facets may be on another
/// surface already.
std::vector<round_finder::facet_list> round_finder::first_guesses(std::uint32_t seed) const {
  const auto& facets = net_.facets();
  std::vector<facet_link> links;
  for (const auto& link : facets[seed].links)
    if (link.cosine >= least_bend && may_join(seed, link.other))
      links.push_back(link);
  std::ranges::stable_sort(links, std::greater{}, &facet_link::length);
  links.resize(std::min(links.size(), most_links));
  std::vector<facet_list> guesses;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t j = i + 1; j < links.size(); ++j)
      if (facets[seed].corners.size() > 3 && facets[links[i].other].corners.size() > 3 &&
          facets[links[j].other].corners.size() > 3)
        guesses.push_back({seed, links[i].other, links[j].other});
  for (const double bend : {smooth_bend, least_bend})
    for (const std::size_t most : {std::size_t{6}, large_guess})
      if (auto around = near(seed, most, bend);
          around.size() >= 3 && std::ranges::find(guesses, around) == guesses.end())
        guesses.push_back(std::move(around));
  return guesses;
}

std::optional<fitted_shape> round_finder::fit(surface_form form, const facet_list& to) const {
  std::vector<vec3> points;
  std::vector<fit_facet> facets;
  for (const auto v : corners_of(to))
    points.push_back(surface_.points[v]);
  for (const auto f : to)
    facets.push_back({net_.facets()[f].middle, net_.facets()[f].area});
  const auto shape = fit_shape(form, {points, facets});
  if (!shape)
    return std::nullopt;
  const double most = loose_tolerance(*shape, to);
  return std::ranges::all_of(points, [&](vec3 p) { return shape->distance(p) <= most; })
           ? shape
           : std::nullopt;
}

bool round_finder::lies_on(const fitted_shape& shape, std::uint32_t facet, double tolerance) const {
  const auto& one = net_.facets()[facet];
  const vec3 n = normalized(one.area);
  double side = 0;
  for (const auto v : one.corners) {
    const vec3 p = surface_.points[v];
    if (shape.distance(p) > tolerance)
      return false;
    const vec3 out = shape.normal(p);
    if (norm(out) < 0.999)
      continue;  // On the axis, where it has none.
    const double facing = dot(n, out);
    side = side == 0 ? facing : side;
    if (std::abs(facing) < least_facing || facing * side < 0)
      return false;
  }
  return true;
}

round_finder::facet_list round_finder::grow(const fitted_shape& shape, std::uint32_t seed,
                                            double most) const {
  if (!lies_on(shape, seed, most))
    return {};
  facet_list found{seed};
  std::set<std::uint32_t> seen{seed};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const auto& link : net_.facets()[found[i]].links)
      if (link.cosine >= least_bend && may_join(seed, link.other) &&
          seen.insert(link.other).second && lies_on(shape, link.other, most))
        found.push_back(link.other);
  return found;
}

/// Whether so much of a patch's boundary goes over into facets of the same kind that it is but a
/// part of something else.
bool round_finder::leaks(const round_patch& patch) const {
  const auto& facets = net_.facets();
  const std::set<std::uint32_t> inside(patch.facets.begin(), patch.facets.end());
  double boundary = 0;
  double leak = 0;
  std::size_t thin = 0;
  for (const auto f : patch.facets) {
    bool touches = false;
    for (const auto& link : facets[f].links) {
      if (inside.contains(link.other))
        continue;
      boundary += link.length;
      const double ratio = norm(facets[link.other].area) / norm(facets[f].area);
      if (link.cosine < smooth_bend || !may_join(f, link.other) || ratio > alike ||
          ratio < 1 / alike)
        continue;
      leak += link.length;
      touches = true;
    }
    thin += touches;
  }
  if (!patch.is_exact)
    return leak > most_leak_if_loose * boundary;
  return leak > most_leak * boundary && 2 * thin > patch.facets.size();
}

/// All corners of a short prism lie on a sphere, too: there the normals lie in a plane, or facets
/// are wide.
bool round_finder::is_ball(const round_patch& patch) const {
  constexpr double least_volume = 0.02;  ///< Of three normals.
  const double most_sag = patch.shape.wall.radius * (1 - std::cos(0.5 * widest_gap * degree));
  const auto normal = [&](std::uint32_t f) { return normalized(net_.facets()[f].area); };
  const vec3 first = normal(patch.facets.front());
  vec3 across;
  double deepest = 0;
  for (const auto f : patch.facets) {
    if (sag_of(patch.shape, f) > most_sag)
      return false;
    if (const vec3 other = cross(first, normal(f)); norm(other) > norm(across))
      across = other;
  }
  for (const auto f : patch.facets)
    deepest = std::max(deepest, std::abs(dot(normalized(across), normal(f))));
  return norm(across) * deepest > least_volume;
}

bool round_finder::is_proper(const round_patch& patch) const {
  if (patch.facets.size() < 3)
    return false;
  const auto corners = corners_of(patch.facets);
  const std::size_t least = least_corners(patch.shape.form);
  if (corners.size() < (patch.is_exact ? least : 2 * least))
    return false;
  const vec3 first = normalized(net_.facets()[patch.facets.front()].area);
  if (std::ranges::none_of(patch.facets, [&](auto f) {
        return norm(cross(first, normalized(net_.facets()[f].area))) > least_turn;
      }))
    return false;
  if (patch.shape.form == surface_form::sphere)
    return patch.facets.size() >= 6 && is_ball(patch);
  std::vector<vec3> points;
  for (const auto v : corners)
    points.push_back(surface_.points[v]);
  return goes_round_evenly(patch.shape.wall, points);
}

/// What grows from the guess is fitted once more, as few facets say a surface only roughly.
std::optional<round_patch> round_finder::tried(surface_form form, const facet_list& guess,
                                               std::uint32_t seed) const {
  const auto shape = fit(form, guess);
  if (!shape)
    return std::nullopt;
  round_patch patch{*shape, grow(*shape, seed, loose_tolerance(*shape, guess))};
  if (patch.facets.size() < 3)
    return std::nullopt;
  if (const auto truer = fit(form, patch.facets)) {
    patch.shape = *truer;
    patch.facets = grow(*truer, seed, loose_tolerance(*truer, patch.facets));
  }
  for (const auto f : patch.facets) {
    patch.area += norm(net_.facets()[f].area);
    patch.is_exact = patch.is_exact && lies_on(patch.shape, f, exact_tolerance(patch.shape));
  }
  return is_proper(patch) && !leaks(patch) ? std::optional(std::move(patch)) : std::nullopt;
}

std::optional<round_patch> round_finder::around(std::uint32_t seed) const {
  std::optional<round_patch> best;
  const auto guesses = first_guesses(seed);
  // A cylinder is a cone, and a strip of a sphere nearly one: the simpler form goes first.
  for (const auto form : {surface_form::cylinder, surface_form::cone, surface_form::sphere}) {
    for (const auto& guess : guesses) {
      const bool of_strips = guess.size() == 3;
      if (form == surface_form::cone ? !of_strips && guess.size() < large_guess
                                     : form == surface_form::sphere && guess.size() < 6)
        continue;
      if (auto patch = tried(form, guess, seed); patch && (!best || patch->area > 1.2 * best->area))
        best = std::move(patch);
    }
  }
  return best;
}

}  // namespace tedit
