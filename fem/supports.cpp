// SPDX-License-Identifier: AGPL-3.0-or-later
#include <Eigen/Dense>

#include <numeric>

#include "base/guard.hpp"
#include "base/parallel.hpp"
#include "fem/polled.hpp"
#include "fem/problem_parts.hpp"
#include "mesh/place_text.hpp"

namespace tedit::fem {

namespace {

using vector6 = Eigen::Matrix<double, 6, 1>;
using matrix6 = Eigen::Matrix<double, 6, 6>;

/// Bodies whose tets hang together over faces; hinges at edges and vertices do not join.
std::vector<std::uint32_t> body_of_tets(const mesh_version& mesh, std::uint32_t& count) {
  std::vector<std::uint32_t> body(mesh.tet_slots(), no_id);
  std::vector<tet_id>
    open;  // A queue: its next tets are known, so that their cache misses overlap.
  count = 0;
  for (tet_id seed = 0; seed < mesh.tet_slots(); ++seed) {
    if (!mesh.is_live_tet(seed) || body[seed] != no_id)
      continue;
    body[seed] = count;
    open.assign(1, seed);
    for (std::size_t done = 0; done < open.size(); ++done) {
      if (done % parallel_chunk == 0)
        check_cancelled();
      for (const auto behind : mesh.neighbours(open[done]))
        if (!is_facet(behind) && body[behind] == no_id) {
          body[behind] = count;
          open.push_back(behind);
        }
    }
    ++count;
  }
  return body;
}

struct body_nodes {
  std::vector<std::uint32_t> nodes;
  std::size_t tets = 0;
};

std::vector<body_nodes> nodes_of_bodies(const mesh_version& mesh, const problem& p) {
  std::uint32_t count = 0;
  const auto body = body_of_tets(mesh, count);
  std::vector<body_nodes> result(count);
  if (count == 1) {
    result[0].nodes.resize(p.node_count());
    std::iota(result[0].nodes.begin(), result[0].nodes.end(), 0u);
    result[0].tets = p.element_count();
    return result;
  }
  std::vector<std::uint32_t> seen_by(p.node_count(), no_id);
  // A node on a hinge belongs to each of its bodies: visit the bodies one after the other.
  std::vector<std::uint32_t> order(p.element_count());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t e) { return body[p.element_tets[e]]; });
  polled_for(order.size(), [&](std::size_t i) {
    const auto e = order[i];
    const auto b = body[p.element_tets[e]];
    ++result[b].tets;
    for (int a = 0; a < p.nodes_per_element; ++a) {
      const auto node = p.element_nodes[p.nodes_per_element * e + a];
      if (std::exchange(seen_by[node], b) != b)
        result[b].nodes.push_back(node);
    }
  });
  return result;
}

std::string describe_mode(const vector6& mode, vec3 centre, double size) {
  const vec3 shift{mode[0], mode[1], mode[2]};
  const vec3 turn = vec3{mode[3], mode[4], mode[5]} / size;
  const auto axis_text = [](vec3 d) {
    char text[64];
    d = normalized(d);
    std::snprintf(text, sizeof(text), "(%.2g, %.2g, %.2g)", d.x + 0.0, d.y + 0.0, d.z + 0.0);
    return std::string(text);
  };
  if (norm(turn) * size < 1e-6 * norm(shift))
    return "translation along " + axis_text(shift);
  const vec3 on_axis = centre + cross(turn, shift) / dot(turn, turn);
  return "rotation about the axis " + axis_text(turn) + " through " + place_text(on_axis);
}

/// The sum over held directions d at x of w w^T, w = (d, (x-c) x d / size): its null vectors are
/// the free rigid modes.
matrix6 support_matrix(const problem& p, const body_nodes& body, vec3 centre, double size) {
  matrix6 sum = matrix6::Zero();
  polled_for(body.nodes.size(), [&](std::size_t i) {
    const auto node = body.nodes[i];
    const auto& s = p.filter[node];
    const std::array<vec3, 3> held{
      {{1 - s[0], -s[1], -s[2]}, {-s[1], 1 - s[3], -s[4]}, {-s[2], -s[4], 1 - s[5]}}};
    for (const auto& d : held) {
      if (dot(d, d) == 0)
        continue;
      const vec3 moment = cross((p.nodes[node] - centre) / size, d);
      vector6 w;
      w << d.x, d.y, d.z, moment.x, moment.y, moment.z;
      sum += w * w.transpose();
    }
  });
  return sum;
}

expected<void> check_body(const problem& p, const body_nodes& body, std::size_t bodies) {
  vec3 centre;
  const std::size_t count = body.nodes.size();
  polled_for(count,
             [&](std::size_t i) { centre += p.nodes[body.nodes[i]] / static_cast<double>(count); });
  double size = 0;
  polled_for(count,
             [&](std::size_t i) { size = std::max(size, norm(p.nodes[body.nodes[i]] - centre)); });
  const matrix6 support = support_matrix(p, body, centre, size);
  const Eigen::SelfAdjointEigenSolver<matrix6> modes(support);
  const double largest = modes.eigenvalues()[5];
  std::string free;
  int free_modes = 0;
  for (int i = 0; i < 6; ++i) {
    // A support of 1e-6 of the part's size leaves an eigenvalue of about 1e-12.
    if (modes.eigenvalues()[i] > 1e-11 * largest)
      continue;
    ++free_modes;
    free += (free.empty() ? "" : "; ") + describe_mode(modes.eigenvectors().col(i), centre, size);
  }
  if (free_modes == 0)
    return {};
  const std::string who = bodies == 1
                            ? "the part"
                            : "one of the " + std::to_string(bodies) + " separate bodies (" +
                                std::to_string(body.tets) + " tets)";
  if (largest == 0)
    free = "all six rigid-body motions";
  return fail(ec::under_constrained, who + " is not held: free are " + free,
              "Fix or support more surfaces of it", "around " + place_text(centre));
}

}  // namespace

bool hangs_together(const mesh_version& mesh, const problem& p, const incidence& corners,
                    std::span<const std::uint32_t> nodes) {
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  std::vector<tet_id> around;
  for (const auto n : nodes) {
    if (n >= p.corner_count)
      break;
    for (const auto corner : corners.of_node(n))
      around.push_back(p.element_tets[corner / per]);
  }
  sort_unique(around);
  if (around.empty())
    return true;
  std::vector<std::uint8_t> reached(around.size(), 0);
  std::vector<std::size_t> open{0};
  reached[0] = 1;
  std::size_t count = 0;
  while (!open.empty()) {
    const auto t = around[open.back()];
    open.pop_back();
    ++count;
    for (const auto behind : mesh.neighbours(t)) {
      const auto at =
        static_cast<std::size_t>(std::ranges::lower_bound(around, behind) - around.begin());
      if (is_facet(behind) || at == around.size() || around[at] != behind || reached[at] != 0)
        continue;
      reached[at] = 1;
      open.push_back(at);
    }
  }
  return count == around.size();
}

expected<void> check_supports(const mesh_version& mesh, const problem& p) {
  const auto bodies = nodes_of_bodies(mesh, p);
  for (const auto& body : bodies)
    if (auto ok = check_body(p, body, bodies.size()); !ok)
      return ok;
  return {};
}

}  // namespace tedit::fem
