// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/star_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/optimize/star_quality.hpp"
#include "mesh/types.hpp"

namespace tedit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// N, V and their first derivatives for one tet.
struct tet_terms {
  double squares = 0;  ///< N: sum of the squared areas, m^4.
  double volume = 0;
  vec3 d_squares;
  vec3 d_volume;
};

tet_terms terms_of(const std::array<vec3, 3>& face, vec3 x) {
  const vec3 twice = cross(face[1] - face[0], face[2] - face[0]);
  tet_terms t;
  t.d_volume = twice / 6;
  t.volume = dot(t.d_volume, x - face[0]);
  t.squares = 0.25 * dot(twice, twice);
  for (int i = 0; i < 3; ++i) {
    const vec3 e = face[(i + 1) % 3] - face[i];
    const vec3 a = x - face[i];
    const vec3 area = cross(a, e);
    t.squares += 0.25 * dot(area, area);
    t.d_squares += 0.5 * (dot(e, e) * a - dot(a, e) * e);
  }
  return t;
}

/// m += s (a b^T + b a^T).
void add_symmetric(sym3& m, double s, vec3 a, vec3 b) {
  m.m[0] += 2 * s * a.x * b.x;
  m.m[1] += 2 * s * a.y * b.y;
  m.m[2] += 2 * s * a.z * b.z;
  m.m[3] += s * (a.x * b.y + a.y * b.x);
  m.m[4] += s * (a.y * b.z + a.z * b.y);
  m.m[5] += s * (a.z * b.x + a.x * b.z);
}

}  // namespace

// Cholesky's factors, written out.
std::optional<vec3> solve(const sym3& h, vec3 b) {
  const auto& [xx, yy, zz, xy, yz, zx] = h.m;
  if (!(xx > 0))
    return std::nullopt;
  const double l00 = std::sqrt(xx);
  const double l10 = xy / l00;
  const double l20 = zx / l00;
  const double d1 = yy - l10 * l10;
  if (!(d1 > 0))
    return std::nullopt;
  const double l11 = std::sqrt(d1);
  const double l21 = (yz - l20 * l10) / l11;
  const double d2 = zz - l20 * l20 - l21 * l21;
  if (!(d2 > 0))
    return std::nullopt;
  const double y0 = b.x / l00;
  const double y1 = (b.y - l10 * y0) / l11;
  const double z = (b.z - l20 * y0 - l21 * y1) / d2;
  const double y = (y1 - l21 * z) / l11;
  return vec3{(y0 - l10 * y - l20 * z) / l00, y, z};
}

void vertex_star::add(const std::array<vec3, 4>& corners, int at) {
  const auto& order = tet_faces[at];
  faces.push_back({corners[order[0]], corners[order[2]], corners[order[1]]});
}

double star_energy(const vertex_star& star, vec3 x) {
  double sum = 0;
  for (const auto& face : star.faces) {
    const auto t = terms_of(face, x);
    if (!(t.volume > 0))
      return infinity;
    sum += t.squares / t.volume;
  }
  return sum;
}

vec3 star_gradient(const vertex_star& star, vec3 x) {
  vec3 sum;
  for (const auto& face : star.faces) {
    const auto t = terms_of(face, x);
    sum += (t.d_squares - (t.squares / t.volume) * t.d_volume) / t.volume;
  }
  return sum;
}

sym3 star_hessian(const vertex_star& star, vec3 x) {
  sym3 sum;
  for (const auto& face : star.faces) {
    const auto t = terms_of(face, x);
    const vec3 gradient = (t.d_squares - (t.squares / t.volume) * t.d_volume) / t.volume;
    for (int i = 0; i < 3; ++i) {
      const vec3 e = face[(i + 1) % 3] - face[i];
      const double s = 0.5 / t.volume;
      for (int axis = 0; axis < 3; ++axis)
        sum.m[axis] += s * dot(e, e);
      add_symmetric(sum, -0.5 * s, e, e);
    }
    add_symmetric(sum, -1 / t.volume, gradient, t.d_volume);
  }
  return sum;
}

double longest_step(const vertex_star& star, vec3 x, vec3 along) {
  double result = infinity;
  for (const auto& face : star.faces) {
    const vec3 normal = cross(face[1] - face[0], face[2] - face[0]);
    const double fall = -dot(normal, along);
    if (fall > 0)
      result = std::min(result, dot(normal, x - face[0]) / fall);
  }
  return result;
}

vec3 star_minimum(const vertex_star& star, vec3 x, int steps) {
  double energy = star_energy(star, x);
  for (int n = 0; n < steps; ++n) {
    const vec3 gradient = star_gradient(star, x);
    const auto newton = solve(star_hessian(star, x), -gradient);
    if (!newton)
      return x;
    const double slope = dot(gradient, *newton);
    double length = std::min(1.0, 0.9 * longest_step(star, x, *newton));
    vec3 next = x;
    double lower = energy;
    for (int halving = 0; halving < 12; ++halving, length *= 0.5) {
      next = x + length * *newton;
      lower = star_energy(star, next);
      if (lower <= energy + 1e-4 * length * slope)
        break;
    }
    // At the minimum rounding decides: no lower point is the end.
    if (!(lower < energy))
      return x;
    const bool settled = energy - lower < 1e-12 * energy;
    x = next;
    energy = lower;
    if (settled)
      break;
  }
  return x;
}

double star_worst(const vertex_star& star, vec3 x, double enough) {
  double result = 1;
  for (const auto& face : star.faces) {
    result = std::min(result, quick_ratio(face[0], face[1], face[2], x));
    if (result < enough)
      break;
  }
  return result;
}

double flip_weight(const std::array<vec3, 3>& rim, vec3 d, vec3 e, double& scale) {
  double sum = 0;
  scale = 0;
  for (int i = 0; i < 3; ++i) {
    const vec3 a = rim[i];
    const vec3 ab = rim[(i + 1) % 3] - a;
    // Twice the outward areas of the faces opposite d and e of tet (a, b, d, e).
    const vec3 opposite_d = cross(e - a, ab);
    const vec3 opposite_e = cross(ab, d - a);
    const double volume = std::abs(dot(opposite_e, e - a)) / 6;
    const double term = -0.25 * dot(opposite_d, opposite_e) / (9 * volume);
    sum += term;
    scale += std::abs(term);
  }
  return sum;
}

}  // namespace tedit
