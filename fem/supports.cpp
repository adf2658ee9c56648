// SPDX-License-Identifier: AGPL-3.0-or-later
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
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
    // Nodes that no element has are held, and hold nothing.
    auto unused = p.unused.begin();
    result[0].nodes.reserve(p.node_count() - p.unused.size());
    polled_for(p.node_count(), [&](std::size_t n) {
      if (unused != p.unused.end() && *unused == n)
        ++unused;
      else
        result[0].nodes.push_back(static_cast<std::uint32_t>(n));
    });
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

/// Where a body is held: the middle of its held nodes and their mean distance from it.
struct held_place {
  vec3 centre;
  double reach = 0;
};

/// The rigid motion of a column, seen from where the body is held.
std::string describe_motion(const vector6& motion, const held_place& place) {
  const vec3 shift{motion[0], motion[1], motion[2]};
  const vec3 turn = vec3{motion[3], motion[4], motion[5]} / place.reach;
  const auto axis_text = [](vec3 d) {
    char text[64];
    d = normalized(d);
    const auto rounded = [](double v) { return std::round(100 * v) / 100 + 0.0; };
    // One of both directions of an axis: the one that goes up more than down.
    if (rounded(d.x) + rounded(d.y) + rounded(d.z) < 0)
      d = -1 * d;
    std::snprintf(text, sizeof(text), "(%g, %g, %g)", rounded(d.x), rounded(d.y), rounded(d.z));
    return std::string(text);
  };
  if (norm(turn) * place.reach < 0.3 * norm(shift))
    return "translation along " + axis_text(shift);
  const vec3 on_axis = place.centre + cross(turn, shift) / dot(turn, turn);
  return "rotation about the axis " + axis_text(turn) + " through " + place_text(on_axis);
}

/// Motions (columns; about `centre`, turns times `size`) in words. Any mixture of free motions is
/// one, too: told are those that turn most and those that do not turn.
std::string describe_motions(const Eigen::MatrixXd& motions, vec3 centre, double size,
                             const held_place& place) {
  const vec3 arm = (place.centre - centre) / size;
  matrix6 there = matrix6::Identity();
  there.topRightCorner<3, 3>() << 0, arm.z, -arm.y, -arm.z, 0, arm.x, arm.y, -arm.x, 0;
  there.bottomRightCorner<3, 3>() *= place.reach / size;
  const Eigen::MatrixXd seen = there * motions;
  const Eigen::JacobiSVD<Eigen::MatrixXd> turns(seen.bottomRows(3), Eigen::ComputeFullV);
  std::string text;
  for (Eigen::Index i = 0; i < motions.cols(); ++i)
    text += (i > 0 ? "; " : "") + describe_motion(seen * turns.matrixV().col(i), place);
  return text;
}

/// What holds a body, as forms of its rigid motions v (shift, turn x size).
struct support_forms {
  matrix6 exact = matrix6::Zero();  ///< Sum of (d.v)^2 over held directions d that are known.
  matrix6 round = matrix6::Zero();  ///< The same over the normals of round surfaces, and
  matrix6 doubt = matrix6::Zero();  ///< of (u |v|)^2, with u their uncertainty.
  held_place place;
};

/// By how much the directions that hold a node may be off.
double uncertainty_at(const problem& p, std::uint32_t node) {
  double result = 0;
  auto holder = std::ranges::lower_bound(p.holders, node, {}, &node_holder::node);
  for (; holder != p.holders.end() && holder->node == node; ++holder)
    result = std::max(result, holder->uncertainty);
  return result;
}

support_forms forms_of(const problem& p, const body_nodes& body, vec3 centre, double size) {
  support_forms forms;
  std::size_t count = 0;
  double squares = 0;
  polled_for(body.nodes.size(), [&](std::size_t i) {
    const auto node = body.nodes[i];
    const auto& s = p.filter[node];
    Eigen::Matrix3d held;
    held << 1 - s[0], -s[1], -s[2], -s[1], 1 - s[3], -s[4], -s[2], -s[4], 1 - s[5];
    if (held.isZero(0))
      return;
    // v at the node is its shift plus turn x arm.
    const vec3 arm = (p.nodes[node] - centre) / size;
    Eigen::Matrix<double, 3, 6> v;
    v << 1, 0, 0, 0, arm.z, -arm.y, 0, 1, 0, -arm.z, 0, arm.x, 0, 0, 1, arm.y, -arm.x, 0;
    const double u = uncertainty_at(p, node);
    (u > 0 ? forms.round : forms.exact) += v.transpose() * held * v;
    forms.doubt += u * u * v.transpose() * v;
    ++count;
    forms.place.centre += arm;
    squares += dot(arm, arm);
  });
  if (count > 0) {
    const vec3 mean = forms.place.centre / static_cast<double>(count);
    const double spread = squares / static_cast<double>(count) - dot(mean, mean);
    forms.place = {centre + size * mean, size * std::sqrt(std::max(spread, 1e-6))};
  }
  return forms;
}

/// The rigid motions that nothing holds, as columns. Round surfaces are known by their facets only:
/// they hold what moves along their normals by more than these may be off, in the mean.
Eigen::MatrixXd free_motions(const support_forms& forms) {
  // A support of 1e-6 of the part's size leaves an eigenvalue of about 1e-12.
  constexpr double none = 1e-11;
  using solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
  const double largest = solver(forms.exact + forms.round).eigenvalues()[5];
  const auto null_space = [&](const Eigen::MatrixXd& form) -> Eigen::MatrixXd {
    const solver modes(form);
    const auto count = (modes.eigenvalues().array() <= none * largest).count();
    return modes.eigenvectors().leftCols(count);
  };
  Eigen::MatrixXd left = null_space(forms.exact);
  if (left.cols() == 0)
    return left;
  return left * null_space(left.transpose() * (forms.round - forms.doubt) * left);
}

expected<void> check_body(const problem& p, const body_nodes& body, std::size_t bodies) {
  vec3 centre;
  const std::size_t count = body.nodes.size();
  polled_for(count,
             [&](std::size_t i) { centre += p.nodes[body.nodes[i]] / static_cast<double>(count); });
  double size = 0;
  polled_for(count,
             [&](std::size_t i) { size = std::max(size, norm(p.nodes[body.nodes[i]] - centre)); });
  const auto forms = forms_of(p, body, centre, size);
  const auto motions = free_motions(forms);
  if (motions.cols() == 0)
    return {};
  const auto free = motions.cols() == 6 ? "all six rigid-body motions"
                                        : describe_motions(motions, centre, size, forms.place);
  const std::string who = bodies == 1
                            ? "the part"
                            : "one of the " + std::to_string(bodies) + " separate bodies (" +
                                std::to_string(body.tets) + " tets)";
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
