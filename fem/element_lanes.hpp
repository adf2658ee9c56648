// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/element_operator.hpp"
#include "fem/quadratic.hpp"
#include "fem/wide.hpp"

/// Nodal forces of elements, four elements at a time, one in each lane of a vector. All is inlined
/// into a body that exists once for AVX2, without fused products, and once for any machine, so the
/// bits are the same on all of them.
namespace tedit::fem {

using lanes [[gnu::vector_size(32)]] = double;
inline constexpr std::size_t lane_count = sizeof(lanes) / sizeof(double);

/// Three components, each for all lanes.
struct lanes3 {
  lanes x{};
  lanes y{};
  lanes z{};

  [[nodiscard]] TEDIT_INLINE static lanes3 of(vec3 a, vec3 b, vec3 c, vec3 d) {
    return {lanes{a.x, b.x, c.x, d.x}, lanes{a.y, b.y, c.y, d.y}, lanes{a.z, b.z, c.z, d.z}};
  }
  [[nodiscard]] TEDIT_INLINE vec3 get(std::size_t lane) const {
    return {x[lane], y[lane], z[lane]};
  }
};

TEDIT_INLINE lanes3 operator+(const lanes3& a, const lanes3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
TEDIT_INLINE lanes3 operator-(const lanes3& a, const lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
TEDIT_INLINE lanes3 operator*(const lanes& s, const lanes3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
TEDIT_INLINE lanes dot(const lanes3& a, const lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
TEDIT_INLINE lanes3 cross(const lanes3& a, const lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Geometry and material of the elements in the lanes.
struct lane_elements {
  std::array<lanes3, 4> gradient;  ///< Of the linear shape functions, 1/m.
  lanes volume{};                  ///< m^3.
  lanes lambda{};                  ///< Pa.
  lanes mu{};

  /// As `gradients_of`.
  TEDIT_INLINE void set_corners(const std::array<lanes3, 4>& p) {
    const lanes3 u = p[1] - p[0];
    const lanes3 v = p[2] - p[0];
    const lanes3 w = p[3] - p[0];
    const lanes3 vw = cross(v, w);
    const lanes six_volumes = dot(u, vw);
    const lanes inverse = 1.0 / six_volumes;
    volume = six_volumes * (1.0 / 6);
    gradient[1] = inverse * vw;
    gradient[2] = inverse * cross(w, u);
    gradient[3] = inverse * cross(u, v);
    gradient[0] = lanes3{} - (gradient[1] + gradient[2] + gradient[3]);
  }
};

/// A symmetric tensor: xx, yy, zz, xy, yz, zx.
using lanes6 = std::array<lanes, 6>;

/// The stress of the displacement gradient with the rows a, b, c.
TEDIT_INLINE lanes6 stress_of(const lanes3& a, const lanes3& b, const lanes3& c,
                              const lane_elements& e) {
  return stress_of<lanes>(a, b, c, e.lambda, e.mu, e.mu + e.mu);
}

/// s n.
TEDIT_INLINE lanes3 traction_of(const lanes6& s, const lanes3& n) {
  return {s[0] * n.x + s[3] * n.y + s[5] * n.z, s[3] * n.x + s[1] * n.y + s[4] * n.z,
          s[5] * n.x + s[4] * n.y + s[2] * n.z};
}

/// Stress of linear tets. `u`: displacement, m; only differences count, so that rigid translations
/// cancel before they are multiplied.
TEDIT_INLINE lanes6 stress_of(const std::array<lanes3, 4>& u, const lane_elements& e) {
  std::array<lanes3, 3> row{};
  unrolled<3>([&](auto i) TEDIT_INLINED {
    const lanes3 d = u[i + 1] - u[0];
    row[0] = row[0] + d.x * e.gradient[i + 1];
    row[1] = row[1] + d.y * e.gradient[i + 1];
    row[2] = row[2] + d.z * e.gradient[i + 1];
  });
  return stress_of(row[0], row[1], row[2], e);
}

/// Nodal forces of linear tets, N: f_a = V sigma g_a.
TEDIT_INLINE std::array<lanes3, 4> forces_of(const std::array<lanes3, 4>& u,
                                             const lane_elements& e) {
  auto s = stress_of(u, e);
  unrolled<6>([&](auto c) TEDIT_INLINED { s[c] *= e.volume; });
  std::array<lanes3, 4> f;
  unrolled<3>([&](auto i) TEDIT_INLINED { f[i + 1] = traction_of(s, e.gradient[i + 1]); });
  f[0] = lanes3{} - (f[1] + f[2] + f[3]);
  return f;
}

/// Stress at corner k of quadratic tets: see `corner_gradient`.
template <int K>
TEDIT_INLINE lanes6 corner_stress_of(const std::array<lanes3, 10>& u, const lane_elements& e) {
  std::array<lanes3, 3> row{};
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const int b = other_corners[K][i];
    const lanes3 d = lanes{4, 4, 4, 4} * (u[mid_node_of[K][b]] - u[K]) - (u[b] - u[K]);
    row[0] = row[0] + d.x * e.gradient[b];
    row[1] = row[1] + d.y * e.gradient[b];
    row[2] = row[2] + d.z * e.gradient[b];
  }
  return stress_of(row[0], row[1], row[2], e);
}

/// Nodal forces of quadratic tets, N: the integral of sigma grad N_a. Stress is linear between the
/// corners, and the integral of L_k L_l is V/20 (1 + delta_kl), so the integral is the sum over
/// corners k of S_k grad N_a(e_k), S_k = V/20 (sigma_k + sum_l sigma_l). With F_kb = S_k g_b:
/// f_kb += 4 F_kb, f_b -= F_kb, f_k -= 3 F_kb for all b != k.
TEDIT_INLINE std::array<lanes3, 10> forces_of(const std::array<lanes3, 10>& u,
                                              const lane_elements& e) {
  std::array<lanes6, 4> s{corner_stress_of<0>(u, e), corner_stress_of<1>(u, e),
                          corner_stress_of<2>(u, e), corner_stress_of<3>(u, e)};
  const lanes weight = e.volume * (1.0 / 20);
  unrolled<6>([&](auto c) TEDIT_INLINED {
    const lanes sum = s[0][c] + s[1][c] + s[2][c] + s[3][c];
    unrolled<4>([&](auto k) TEDIT_INLINED { s[k][c] = weight * (s[k][c] + sum); });
  });
  std::array<lanes3, 10> f{};
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    lanes3 all{};
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const int b = other_corners[k][i];
      const lanes3 force = traction_of(s[k], e.gradient[b]);
      f[mid_node_of[k][b]] = f[mid_node_of[k][b]] + force;
      f[b] = f[b] - force;
      all = all + force;
    }
    f[k] = f[k] - lanes{3, 3, 3, 3} * all;
  }
  for (int m = 4; m < 10; ++m)
    f[m] = lanes{4, 4, 4, 4} * f[m];
  return f;
}

/// Elements of one chunk, with the positions (m) and displacements (m) of its nodes by their place.
struct chunk_elements {
  const problem& p;
  const std::uint16_t* places;
  std::size_t first, last;
  std::vector<vec3> position;  ///< Of corners.
  std::vector<vec3> value;

  chunk_elements(const problem& of, const element_chunks& chunks, std::size_t chunk,
                 std::size_t begin, std::size_t end, std::span<const double> displacement)
      : p(of), places(chunks.places()), first(begin), last(end) {
    const auto nodes = chunks.nodes_of(chunk);
    position.resize(nodes.size());
    value.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double* u = &displacement[3 * std::size_t{nodes[i]}];
      value[i] = {u[0], u[1], u[2]};
      if (nodes[i] < p.corner_count)
        position[i] = p.nodes[nodes[i]];
    }
  }
};

/// Up to four elements. Where a chunk runs out of them the last one fills the lanes: only the first
/// `count` are to be used.
template <std::size_t Nodes>
struct lane_group {
  const chunk_elements& chunk;
  std::size_t start, count;
  lane_elements elements;
  std::array<lanes3, Nodes> value;  ///< Displacement of the nodes, m.

  [[nodiscard]] TEDIT_INLINE std::size_t element(std::size_t lane) const {
    return std::min(start + lane, chunk.last - 1);
  }
  /// The place of local node a among the chunk's nodes.
  [[nodiscard]] TEDIT_INLINE std::size_t place(std::size_t lane, std::size_t a) const {
    return chunk.places[Nodes * element(lane) + a];
  }
  /// The node itself.
  [[nodiscard]] TEDIT_INLINE std::uint32_t node(std::size_t lane, std::size_t a) const {
    return chunk.p.element_nodes[Nodes * element(lane) + a];
  }
};

/// Calls `visit` for every group of a chunk, in the elements' order.
template <std::size_t Nodes, class Visit>
TEDIT_INLINE void for_each_lanes(const chunk_elements& chunk, const Visit& visit) {
  for (std::size_t start = chunk.first; start < chunk.last; start += lane_count) {
    lane_group<Nodes> group{chunk, start, std::min(lane_count, chunk.last - start), {}, {}};
    const auto gathered = [&](const std::vector<vec3>& x, std::size_t a) TEDIT_INLINED {
      return lanes3::of(x[group.place(0, a)], x[group.place(1, a)], x[group.place(2, a)],
                        x[group.place(3, a)]);
    };
    const auto constants = [&](std::size_t lane) TEDIT_INLINED -> const lame_constants& {
      return chunk.p.constants[chunk.p.element_materials[group.element(lane)]];
    };
    const auto &a = constants(0), &b = constants(1), &c = constants(2), &d = constants(3);
    group.elements.lambda = lanes{a.lambda, b.lambda, c.lambda, d.lambda};
    group.elements.mu = lanes{a.mu, b.mu, c.mu, d.mu};
    std::array<lanes3, 4> corners;
    unrolled<4>([&](auto i) TEDIT_INLINED { corners[i] = gathered(chunk.position, i); });
    group.elements.set_corners(corners);
    unrolled<Nodes>([&](auto i) TEDIT_INLINED { group.value[i] = gathered(chunk.value, i); });
    visit(group);
  }
}

}  // namespace tedit::fem
