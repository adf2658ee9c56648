// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/quadratic_operator.hpp"

#include <algorithm>

#include "fem/element.hpp"

namespace tedit::fem {

namespace {

constexpr std::uint32_t elements_per_patch = 256;

/// The middle node of the edge between two corners, in VTK's order.
constexpr std::uint8_t none = 0;
constexpr std::array<std::array<std::uint8_t, 4>, 4> middle{
  {{none, 4, 6, 7}, {4, none, 5, 8}, {6, 5, none, 9}, {7, 8, 9, none}}};

/// A symmetric 3x3 tensor or a displacement gradient by columns.
struct columns {
  float4 x, y, z;
};

inline columns operator+(const columns& a, const columns& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// lambda tr(G) I + mu (G + G^T), G by columns.
inline columns stress(const columns& g, float lambda, float mu) {
  const float trace = lambda * (g.x[0] + g.y[1] + g.z[2]);
  const float4 m = splat(mu);
  const float4 row_x{g.x[0], g.y[0], g.z[0], 0};
  const float4 row_y{g.x[1], g.y[1], g.z[1], 0};
  const float4 row_z{g.x[2], g.y[2], g.z[2], 0};
  return {m * (g.x + row_x) + float4{trace, 0, 0, 0}, m * (g.y + row_y) + float4{0, trace, 0, 0},
          m * (g.z + row_z) + float4{0, 0, trace, 0}};
}

}  // namespace

quadratic_operator::quadratic_operator(const problem& p) {
  elements_.resize(p.element_count());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) {
      const auto* n = &p.element_nodes[10 * e];
      const auto g = gradients_of({p.nodes[n[0]], p.nodes[n[1]], p.nodes[n[2]], p.nodes[n[3]]});
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
  });
  make_patches(p);
  make_shares(p.node_count());
}

void quadratic_operator::make_patches(const problem& p) {
  std::vector<std::uint32_t> place(p.node_count(), no_id);
  const auto count = static_cast<std::uint32_t>(p.element_count());
  for (std::uint32_t first = 0; first < count; first += elements_per_patch) {
    patch part{first, std::min(count, first + elements_per_patch),
               static_cast<std::uint32_t>(patch_nodes_.size()), 0};
    const auto nodes =
      std::span(p.element_nodes)
        .subspan(10 * std::size_t{first}, 10 * std::size_t{part.last_element - part.first_element});
    for (const auto node : nodes)
      if (place[node] == no_id) {
        place[node] = 0;
        patch_nodes_.push_back(node);
      }
    part.last_node = static_cast<std::uint32_t>(patch_nodes_.size());
    std::sort(patch_nodes_.begin() + part.first_node, patch_nodes_.end());
    for (auto i = part.first_node; i < part.last_node; ++i)
      place[patch_nodes_[i]] = i - part.first_node;
    for (auto e = part.first_element; e < part.last_element; ++e)
      for (int a = 0; a < 10; ++a)
        elements_[e].node[a] =
          static_cast<std::uint16_t>(place[p.element_nodes[10 * std::size_t{e} + a]]);
    for (auto i = part.first_node; i < part.last_node; ++i)
      place[patch_nodes_[i]] = no_id;
    patches_.push_back(part);
  }
  shares_.resize(patch_nodes_.size());
}

void quadratic_operator::make_shares(std::size_t nodes) {
  share_first_.assign(nodes + 1, 0);
  for (const auto node : patch_nodes_)
    ++share_first_[node + 1];
  for (std::size_t n = 0; n < nodes; ++n)
    share_first_[n + 1] += share_first_[n];
  share_.resize(patch_nodes_.size());
  auto next = share_first_;
  for (std::uint32_t i = 0; i < patch_nodes_.size(); ++i)
    share_[next[patch_nodes_[i]]++] = i;
}

std::uint64_t quadratic_operator::bytes() const {
  return elements_.size() * sizeof(element) + patch_nodes_.size() * (8 + sizeof(float4)) +
         share_first_.size() * 4;
}

void quadratic_operator::sum_patches(const float* x) const {
  parallel_for(
    patches_.size(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      std::vector<float4> local;
      for (std::size_t i = first; i < last; ++i)
        sum_patch(patches_[i], x, local);
    },
    8);
}

void quadratic_operator::sum_patch(const patch& part, const float* x,
                                   std::vector<float4>& local) const {
  const std::size_t count = part.last_node - part.first_node;
  local.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    local[i] = load4(x + 3 * std::size_t{patch_nodes_[part.first_node + i]});
  float4* sums = &shares_[part.first_node];
  std::fill_n(sums, count, float4{});
  for (auto e = part.first_element; e < part.last_element; ++e) {
    const auto& now = elements_[e];
    const auto& at = now.node;
    const float4* g = nullptr;
    std::array<float4, 4> gradient{};
    for (int b = 1; b < 4; ++b) {
      const float* d = &now.gradient[3 * (b - 1)];
      gradient[b] = float4{d[0], d[1], d[2], 0};
      gradient[0] -= gradient[b];
    }
    g = gradient.data();
    std::array<columns, 4> s;
    for (int k = 0; k < 4; ++k) {
      const float4 own = local[at[k]];
      columns grad{};
      for (int b = 0; b < 4; ++b) {
        if (b == k)
          continue;
        const float4 d = splat(4) * (local[at[middle[k][b]]] - own) - (local[at[b]] - own);
        grad.x += d * splat(g[b][0]);
        grad.y += d * splat(g[b][1]);
        grad.z += d * splat(g[b][2]);
      }
      s[k] = stress(grad, now.lambda, now.mu);
    }
    const columns all = (s[0] + s[1]) + (s[2] + s[3]);
    for (int k = 0; k < 4; ++k) {
      const columns mean = s[k] + all;
      float4 back{};
      for (int b = 0; b < 4; ++b) {
        if (b == k)
          continue;
        const float4 f =
          mean.x * splat(g[b][0]) + mean.y * splat(g[b][1]) + mean.z * splat(g[b][2]);
        sums[at[middle[k][b]]] += splat(4) * f;
        sums[at[b]] -= f;
        back += f;
      }
      sums[at[k]] -= splat(3) * back;
    }
  }
}

}  // namespace tedit::fem
