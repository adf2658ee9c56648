// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/quadratic.hpp"

#include <algorithm>
#include <utility>

#include "fem/element.hpp"
#include "fem/node_numbering.hpp"
#include "fem/polled.hpp"

namespace tedit::fem::native {

namespace {

constexpr std::uint32_t elements_per_patch = 256;
constexpr std::uint32_t numbering_bits = 12;
static_assert(10 * elements_per_patch < (1U << numbering_bits));

/// The ends of the edge with middle node 4 + i, in VTK's order.
constexpr std::array<std::array<std::uint8_t, 2>, 6> ends{
  {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

using fem::each;

/// The same number for all cases.
template <int i>
TEDIT_INLINE float each(const std::array<float, 3>& g) {
  return g[i];
}

/// A tensor by columns: of each of two elements, or of each case in one.
template <class Vector>
struct columns {
  Vector x, y, z;
};

template <class Vector>
TEDIT_INLINE columns<Vector> add(const columns<Vector>& a, const columns<Vector>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Vector>
TEDIT_INLINE columns<Vector> subtract(const columns<Vector>& a, const columns<Vector>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Vector>
TEDIT_INLINE columns<Vector> scaled(float factor, const columns<Vector>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}

/// lambda tr(G) I + mu (G + G^T), G by columns.
TEDIT_INLINE columns<float8> stress(const columns<float8>& g, float8 lambda, float8 mu) {
  const float8 low = __builtin_shufflevector(g.x, g.y, 0, 8, 1, 9, 4, 12, 5, 13);
  const float8 high = __builtin_shufflevector(g.x, g.y, 2, 10, 3, 11, 6, 14, 7, 15);
  const float8 row_x = __builtin_shufflevector(low, g.z, 0, 1, 8, 8, 4, 5, 12, 12);
  const float8 row_y = __builtin_shufflevector(low, g.z, 2, 3, 9, 9, 6, 7, 13, 13);
  const float8 row_z = __builtin_shufflevector(high, g.z, 0, 1, 10, 10, 4, 5, 14, 14);
  const float8 pressure = lambda * (each<0>(g.x) + each<1>(g.y) + each<2>(g.z));
  constexpr float8 unit_x{1, 0, 0, 0, 1, 0, 0, 0};
  constexpr float8 unit_y{0, 1, 0, 0, 0, 1, 0, 0};
  constexpr float8 unit_z{0, 0, 1, 0, 0, 0, 1, 0};
  return {mu * (g.x + row_x) + pressure * unit_x, mu * (g.y + row_y) + pressure * unit_y,
          mu * (g.z + row_z) + pressure * unit_z};
}

template <std::size_t W>
TEDIT_INLINE columns<node_lanes<W>> stress(const columns<node_lanes<W>>& g, float lambda,
                                           float mu) {
  const auto s = stress_of<typename node_lanes<W>::scalar>(g.x, g.y, g.z, lambda, mu, 2 * mu);
  return {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
}

/// sum_j column_j g_j: a tensor times a vector.
template <class Vector, class Gradient>
TEDIT_INLINE Vector times(const columns<Vector>& t, const Gradient& g) {
  return t.x * each<0>(g) + t.y * each<1>(g) + t.z * each<2>(g);
}

/// The ten nodal forces from the nodal displacements, of two elements side by side or of one and
/// several cases, with V/20 in lambda and mu. With the sum A of the corner stresses s, those of
/// corner k are (4 s_k - A) g_k, those in the middle of a and b 4 (s_a + A) g_b + 4 (s_b + A) g_a.
template <class Vector, class Gradient, class Constant>
TEDIT_INLINE void element_forces(const std::array<Vector, 10>& u,
                                 const std::array<Gradient, 4>& gradient, Constant lambda,
                                 Constant mu, std::array<Vector, 10>& force) {
  // Seen from corner a, along the edge to b: 4 (u_ab - u_a) - (u_b - u_a).
  std::array<std::array<Vector, 4>, 4> along;
#pragma GCC unroll 6
  for (int i = 0; i < 6; ++i) {
    const auto [a, b] = ends[i];
    const Vector edge = u[b] - u[a];
    along[a][b] = 4.0F * (u[4 + i] - u[a]) - edge;
    along[b][a] = along[a][b] - 2.0F * edge;
  }
  std::array<columns<Vector>, 4> s;
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    columns<Vector> grad{};
#pragma GCC unroll 4
    for (int b = 0; b < 4; ++b) {
      if (b == k)
        continue;
      grad.x += along[k][b] * each<0>(gradient[b]);
      grad.y += along[k][b] * each<1>(gradient[b]);
      grad.z += along[k][b] * each<2>(gradient[b]);
    }
    s[k] = stress(grad, lambda, mu);
  }
  const auto all = add(add(s[0], s[1]), add(s[2], s[3]));
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    s[k] = scaled(4.0F, s[k]);
    force[k] = times(subtract(s[k], all), gradient[k]);
    s[k] = add(s[k], scaled(4.0F, all));
  }
#pragma GCC unroll 6
  for (int i = 0; i < 6; ++i) {
    const auto [a, b] = ends[i];
    force[4 + i] = times(s[a], gradient[b]) + times(s[b], gradient[a]);
  }
}

/// Adds the forces of `count` elements of a patch to `sums`; `local` has the patch's nodes. The
/// elements' sums enter one after the other, so that pairs change no bits. `ahead(e)` is called
/// with every element, or with every second one.
template <class Element, class Ahead>
TEDIT_INLINE void add_elements(const Element* elements, std::size_t count, const float4* local,
                               float4* sums, const Ahead& ahead) {
  for (std::size_t e = 0; e < count; e += 2) {
    ahead(e);
    const auto& one = elements[e];
    const bool both = e + 1 < count;
    const auto& two = elements[both ? e + 1 : e];
    std::array<float8, 10> u;
#pragma GCC unroll 10
    for (int a = 0; a < 10; ++a)
      u[a] = pair(local[one.node[a]], local[two.node[a]]);
    std::array<float8, 4> gradient{};
#pragma GCC unroll 4
    for (int b = 1; b < 4; ++b) {
      gradient[b] = pair(load4(&one.gradient[3 * (b - 1)]), load4(&two.gradient[3 * (b - 1)]));
      gradient[0] -= gradient[b];
    }
    const float8 lambda = pair(splat(one.lambda), splat(two.lambda));
    const float8 mu = pair(splat(one.mu), splat(two.mu));
    std::array<float8, 10> force;
    element_forces(u, gradient, lambda, mu, force);
#pragma GCC unroll 10
    for (int a = 0; a < 10; ++a)
      sums[one.node[a]] += first_of(force[a]);
    if (both)
#pragma GCC unroll 10
      for (int a = 0; a < 10; ++a)
        sums[two.node[a]] += second_of(force[a]);
  }
}

/// The same for several cases: element by element.
template <class Element, std::size_t W, class Ahead>
TEDIT_INLINE void add_elements(const Element* elements, std::size_t count,
                               const node_lanes<W>* local, node_lanes<W>* sums,
                               const Ahead& ahead) {
  for (std::size_t e = 0; e < count; ++e) {
    ahead(e);
    const auto& one = elements[e];
    std::array<node_lanes<W>, 10> u;
#pragma GCC unroll 10
    for (int a = 0; a < 10; ++a)
      u[a] = local[one.node[a]];
    std::array<std::array<float, 3>, 4> gradient{};
#pragma GCC unroll 4
    for (int b = 1; b < 4; ++b)
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) {
        gradient[b][i] = one.gradient[3 * (b - 1) + i];
        gradient[0][i] -= gradient[b][i];
      }
    std::array<node_lanes<W>, 10> force;
    element_forces(u, gradient, one.lambda, one.mu, force);
#pragma GCC unroll 10
    for (int a = 0; a < 10; ++a)
      sums[one.node[a]] += force[a];
  }
}

}  // namespace

quadratic_operator::quadratic_operator(const problem& p) {
  elements_.resize(p.element_count());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e)
      set_element(p, e);
  });
  make_patches(p);
  make_shares(p.node_count());
}

void quadratic_operator::set_element(const problem& p, std::size_t e) {
  const auto g = gradients_of(p, e);
  const auto& c = p.constants[p.element_materials[e]];
  auto& to = elements_[e];
  for (int b = 1; b < 4; ++b)
    for (int i = 0; i < 3; ++i) {
      const vec3 d = g.gradient[b];
      to.gradient[3 * (b - 1) + i] = static_cast<float>(i == 0 ? d.x : i == 1 ? d.y : d.z);
    }
  to.lambda = static_cast<float>(c.lambda * g.volume / 20);
  to.mu = static_cast<float>(c.mu * g.volume / 20);
}

void quadratic_operator::update(const problem& p, std::span<const std::uint32_t> elements) {
  const auto count = static_cast<std::uint32_t>(p.element_count());
  elements_.resize(count);
  std::vector<std::uint32_t> dirty;
  for (const auto e : elements) {
    if (e < count)
      set_element(p, e);
    if (dirty.empty() || dirty.back() != e / elements_per_patch)
      dirty.push_back(e / elements_per_patch);
  }
  const auto old_patches = std::exchange(patches_, {});
  const auto old_nodes = std::exchange(patch_nodes_, {});
  patch_nodes_.reserve(old_nodes.size() + 64);
  node_numbering numbering(numbering_bits);
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i * elements_per_patch < count; ++i) {
    if (i % 64 == 0)
      check_cancelled();
    const auto first = i * elements_per_patch;
    patch part{first, std::min(count, first + elements_per_patch),
               static_cast<std::uint32_t>(patch_nodes_.size()), 0};
    if (std::ranges::binary_search(dirty, i)) {
      number_patch(p, part, numbering, nodes);
      patch_nodes_.insert(patch_nodes_.end(), nodes.begin(), nodes.end());
    } else {
      const auto old = std::span(old_nodes).subspan(
        old_patches[i].first_node, old_patches[i].last_node - old_patches[i].first_node);
      patch_nodes_.insert(patch_nodes_.end(), old.begin(), old.end());
    }
    part.last_node = static_cast<std::uint32_t>(patch_nodes_.size());
    patches_.push_back(part);
  }
  make_shares(p.node_count());
}

/// Makes `nodes` those of a patch's elements, ascending, and numbers them in the elements.
void quadratic_operator::number_patch(const problem& p, const patch& part,
                                      node_numbering& numbering,
                                      std::vector<std::uint32_t>& nodes) {
  const auto all = std::span(p.element_nodes)
                     .subspan(10 * std::size_t{part.first_element},
                              10 * std::size_t{part.last_element - part.first_element});
  numbering.number(all, nodes, [&](std::size_t i, std::uint16_t at) {
    elements_[part.first_element + i / 10].node[i % 10] = at;
  });
}

void quadratic_operator::make_patches(const problem& p) {
  constexpr std::size_t patches_per_chunk = 32;
  const auto count = static_cast<std::uint32_t>(p.element_count());
  patches_.resize((count + elements_per_patch - 1) / elements_per_patch);
  std::vector<std::vector<std::uint32_t>> found((patches_.size() + patches_per_chunk - 1) /
                                                patches_per_chunk);
  parallel_for(
    patches_.size(),
    [&](std::size_t first, std::size_t last, std::size_t chunk) {
      node_numbering numbering(numbering_bits);
      std::vector<std::uint32_t> nodes;
      for (std::size_t i = first; i < last; ++i) {
        const auto begin = static_cast<std::uint32_t>(i) * elements_per_patch;
        patches_[i] = {begin, std::min(count, begin + elements_per_patch), 0, 0};
        number_patch(p, patches_[i], numbering, nodes);
        patches_[i].last_node = static_cast<std::uint32_t>(nodes.size());
        found[chunk].insert(found[chunk].end(), nodes.begin(), nodes.end());
      }
    },
    patches_per_chunk);
  std::uint32_t next = 0;
  for (auto& part : patches_) {
    part.first_node = next;
    next = part.last_node += next;
  }
  patch_nodes_.reserve(next);
  for (const auto& nodes : found)
    patch_nodes_.insert(patch_nodes_.end(), nodes.begin(), nodes.end());
}

void quadratic_operator::make_shares(std::size_t nodes) {
  share_first_.assign(nodes + 1, 0);
  polled_for(patch_nodes_.size(), [&](std::size_t i) { ++share_first_[patch_nodes_[i] + 1]; });
  for (std::size_t n = 0; n < nodes; ++n)
    share_first_[n + 1] += share_first_[n];
  share_.resize(patch_nodes_.size());
  auto next = share_first_;
  polled_for(patch_nodes_.size(), [&](std::size_t i) {
    share_[next[patch_nodes_[i]]++] = static_cast<std::uint32_t>(i);
  });
}

std::uint64_t quadratic_operator::bytes() const {
  const auto shares = std::apply(
    [](const auto&... by_lanes) { return ((by_lanes.size() * sizeof(by_lanes[0])) + ...); },
    shares_);
  return elements_.size() * sizeof(element) + patch_nodes_.size() * 8 + shares +
         share_first_.size() * 4;
}

template <class L>
void quadratic_operator::sum_patches(const float* x) const {
  using node = typename L::node;
  auto& all = shares<L>();
  if (all.size() != patch_nodes_.size())
    polled_resize(all, patch_nodes_.size());
  parallel_for(
    patches_.size(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      run_widest([&]() TEDIT_INLINED {
        std::vector<node> local;
        for (std::size_t i = first; i < last; ++i) {
          const auto& part = patches_[i];
          const std::size_t count = part.last_node - part.first_node;
          local.resize(count);
          for (std::size_t n = 0; n < count; ++n)
            local[n] = L::load(x, patch_nodes_[part.first_node + n]);
          node* sums = &all[part.first_node];
          std::fill_n(sums, count, node{});
          const std::size_t elements = part.last_element - part.first_element;
          const auto next = i + 1 < last ? patches_[i + 1] : patch{};
          add_elements(&elements_[part.first_element], elements, local.data(), sums,
                       [&](std::size_t e) TEDIT_INLINED { prefetch<L>(x, next, e); });
        }
      });
    },
    8);
}

/// Asks for some of the nodes that a patch will read and write, with element e of the one before
/// it: they lie scattered, and its elements cannot start before all are there.
template <class L>
TEDIT_INLINE void quadratic_operator::prefetch(const float* x, const patch& part,
                                               std::size_t e) const {
  constexpr std::size_t nodes = L::width == 1 ? 6 : 3;
  constexpr std::size_t line = 64 / sizeof(float);
  const auto first = part.first_node + nodes * (L::width == 1 ? e / 2 : e);
  const auto& all = shares<L>();
  for (auto n = first, end = std::min<std::size_t>(first + nodes, part.last_node); n < end; ++n)
    for (std::size_t at = 0; at < 3 * L::width; at += line) {
      __builtin_prefetch(x + 3 * L::width * patch_nodes_[n] + at, 0);
      __builtin_prefetch(reinterpret_cast<const float*>(&all[n]) + at, 1);
    }
}

template void quadratic_operator::sum_patches<one_case>(const float*) const;
template void quadratic_operator::sum_patches<cases_of<4>>(const float*) const;
template void quadratic_operator::sum_patches<cases_of<8>>(const float*) const;

}  // namespace tedit::fem::native
