// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/spline_surface.hpp"

#include <algorithm>
#include <limits>

namespace tedit {

namespace {

/// Points of the grid: so many a span between knots, and in each direction at most and at least.
constexpr std::size_t samples_a_span = 3;
constexpr std::size_t least_samples = 9;
constexpr std::size_t most_samples = 40;
constexpr int most_steps = 40;
/// Of the extent: a shorter step changes nothing.
constexpr double last_step = 1e-16;
/// Of the extent: nearer points of the grid do not say how it bends.
constexpr double least_way_share = 1e-3;

using basis = std::array<double, spline_surface::most_degree + 1>;

/// The basis functions of a span that are not 0, and their derivatives (Piegl and Tiller, The NURBS
/// Book, A2.1 and A2.2).
struct local_basis {
  std::size_t first = 0;  ///< Of the poles that count.
  basis value{};
  basis slope{};
};

std::size_t span_of(const std::vector<double>& knots, std::uint32_t degree, double t) {
  const auto begin = knots.begin() + degree;
  const auto end = knots.end() - degree - 1;
  const auto next = std::upper_bound(begin, end, t);
  return static_cast<std::size_t>(next - knots.begin()) - 1;
}

void fill(const std::vector<double>& knots, std::uint32_t degree, std::size_t span, double t,
          basis& n) {
  basis left{};
  basis right{};
  n[0] = 1;
  for (std::uint32_t j = 1; j <= degree; ++j) {
    left[j] = t - knots[span + 1 - j];
    right[j] = knots[span + j] - t;
    double saved = 0;
    for (std::uint32_t r = 0; r < j; ++r) {
      const double share = n[r] / (right[r + 1] + left[j - r]);
      n[r] = saved + right[r + 1] * share;
      saved = left[j - r] * share;
    }
    n[j] = saved;
  }
}

local_basis basis_at(const std::vector<double>& knots, std::uint32_t degree, double t) {
  t = std::clamp(t, knots[degree], knots[knots.size() - degree - 1]);
  const auto span = span_of(knots, degree, t);
  local_basis result;
  result.first = span - degree;
  fill(knots, degree, span, t, result.value);
  basis lower{};
  fill(knots, degree - 1, span, t, lower);
  // The derivative is a difference of the basis of one degree less.
  for (std::uint32_t k = 0; k <= degree; ++k) {
    const std::size_t i = result.first + k;
    if (k > 0)
      result.slope[k] += degree * lower[k - 1] / (knots[i + degree] - knots[i]);
    if (k < degree)
      result.slope[k] -= degree * lower[k] / (knots[i + degree + 1] - knots[i + 1]);
  }
  return result;
}

struct weighted {
  vec3 sum;
  double weight = 0;

  void add(double factor, const vec3& pole, double w) {
    sum += factor * w * pole;
    weight += factor * w;
  }
};

bool is_ascending(const std::vector<double>& knots, std::uint32_t degree) {
  if (!std::ranges::all_of(knots, [](double k) { return std::isfinite(k); }) ||
      !std::ranges::is_sorted(knots))
    return false;
  // What lies between them must be some way; no knot counts more often than the degree inside, or
  // once more at the ends.
  if (!(knots[degree] < knots[knots.size() - degree - 1]))
    return false;
  for (std::size_t i = 0; i + degree + 1 < knots.size(); ++i)
    if (!(knots[i] < knots[i + degree + 1]))
      return false;
  return true;
}

std::vector<double> parameters_of(const std::vector<double>& knots, std::uint32_t degree) {
  std::size_t spans = 0;
  for (std::size_t i = degree; i + degree + 1 < knots.size(); ++i)
    spans += knots[i] < knots[i + 1] ? 1 : 0;
  const auto wanted = std::clamp(samples_a_span * spans, least_samples, most_samples);
  const double from = knots[degree];
  const double to = knots[knots.size() - degree - 1];
  std::vector<double> result;
  for (std::size_t i = 0; i < wanted; ++i)
    result.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(wanted - 1));
  return result;
}

}  // namespace

spline_surface::point spline_surface::operator()(double u, double v) const {
  const auto across = basis_at(knots[0], degree[0], u);
  const auto down = basis_at(knots[1], degree[1], v);
  const auto columns = count(1);
  weighted at;
  weighted by_u;
  weighted by_v;
  for (std::uint32_t i = 0; i <= degree[0]; ++i)
    for (std::uint32_t j = 0; j <= degree[1]; ++j) {
      const auto k = (across.first + i) * columns + down.first + j;
      const double w = weights.empty() ? 1 : weights[k];
      at.add(across.value[i] * down.value[j], poles[k], w);
      by_u.add(across.slope[i] * down.value[j], poles[k], w);
      by_v.add(across.value[i] * down.slope[j], poles[k], w);
    }
  point result;
  result.at = at.sum / at.weight;
  result.along_u = (by_u.sum - by_u.weight * result.at) / at.weight;
  result.along_v = (by_v.sum - by_v.weight * result.at) / at.weight;
  return result;
}

bool is_possible(const spline_surface& s) {
  for (int d = 0; d < 2; ++d)
    if (s.degree[d] < 1 || s.degree[d] > spline_surface::most_degree ||
        s.knots[d].size() < 2 * (std::size_t{s.degree[d]} + 1) ||
        !is_ascending(s.knots[d], s.degree[d]))
      return false;
  // Each is at most what is there: the product cannot run over.
  if (s.poles.size() > spline_surface::most_poles || s.count(0) > s.poles.size() ||
      s.count(1) > s.poles.size() || s.count(0) * s.count(1) != s.poles.size())
    return false;
  return std::ranges::all_of(s.poles, is_finite) &&
         (s.weights.empty() || s.weights.size() == s.poles.size()) &&
         std::ranges::all_of(s.weights, [](double w) { return std::isfinite(w) && w > 0; });
}

spline_projection::spline_projection(const spline_surface& surface) : surface_(surface) {
  const auto us = parameters_of(surface_.knots[0], surface_.degree[0]);
  const auto vs = parameters_of(surface_.knots[1], surface_.degree[1]);
  vec3 low{1e300, 1e300, 1e300};
  vec3 high = -low;
  std::vector<vec3> normals;
  for (const double u : us)
    for (const double v : vs) {
      const auto here = surface_(u, v);
      grid_.push_back({here.at, u, v});
      normals.push_back(normalized(cross(here.along_u, here.along_v)));
      low = {std::min(low.x, here.at.x), std::min(low.y, here.at.y), std::min(low.z, here.at.z)};
      high = {std::max(high.x, here.at.x), std::max(high.y, here.at.y),
              std::max(high.z, here.at.z)};
    }
  least_radius_ = norm(high - low);
  // Where a rim is drawn together to a point normals say nothing.
  const double least_way = least_way_share * least_radius_;
  const auto bends = [&](std::size_t a, std::size_t b) {
    const double way = norm(grid_[b].at - grid_[a].at);
    const double turn = norm(normals[b] - normals[a]);
    if (way > least_way && turn > 0)
      least_radius_ = std::min(least_radius_, way / turn);
  };
  for (std::size_t i = 0; i < us.size(); ++i)
    for (std::size_t j = 0; j < vs.size(); ++j) {
      const auto k = i * vs.size() + j;
      if (j > 0)
        bends(k - 1, k);
      if (i > 0)
        bends(k - vs.size(), k);
    }
}

surface_foot spline_projection::operator()(vec3 p) const {
  const auto nearest = std::ranges::min_element(grid_, {}, [&](const sample& s) {
    const vec3 d = s.at - p;
    return dot(d, d);
  });
  double u = nearest->u;
  double v = nearest->v;
  const auto inside = [&](int direction, double t) {
    const auto& knots = surface_.knots[direction];
    const auto degree = surface_.degree[direction];
    return std::clamp(t, knots[degree], knots[knots.size() - degree - 1]);
  };
  auto here = surface_(u, v);
  for (int i = 0; i < most_steps; ++i) {
    const vec3 off = p - here.at;
    const double uu = dot(here.along_u, here.along_u);
    const double uv = dot(here.along_u, here.along_v);
    const double vv = dot(here.along_v, here.along_v);
    const double det = uu * vv - uv * uv;
    if (!(det > 0))
      break;
    const double down_u = dot(off, here.along_u);
    const double down_v = dot(off, here.along_v);
    double next_u = inside(0, u + (vv * down_u - uv * down_v) / det);
    double next_v = inside(1, v + (uu * down_v - uv * down_u) / det);
    // Along the rim it goes by the other parameter alone.
    if (next_u == u)
      next_v = inside(1, v + down_v / vv);
    else if (next_v == v)
      next_u = inside(0, u + down_u / uu);
    const vec3 step = (next_u - u) * here.along_u + (next_v - v) * here.along_v;
    u = next_u;
    v = next_v;
    here = surface_(u, v);
    if (norm(step) <= last_step * least_radius_)
      break;
  }
  return {here.at, normalized(cross(here.along_u, here.along_v))};
}

}  // namespace tedit
