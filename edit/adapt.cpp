// SPDX-License-Identifier: AGPL-3.0-or-later
#include "edit/adapt.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/adapt/size_field.hpp"
#include "mesh/adapt/split_edges.hpp"
#include "mesh/pieces.hpp"

namespace tedit {

namespace {

/// Of its size: an element becomes no smaller than that in one round, as its error is estimated on
/// a mesh that is too coarse there.
constexpr double smallest_share = 0.5;
/// Halved edges measure between half of what is allowed and all of it: so much more than the size
/// that is wanted in the mean is allowed.
constexpr double allowed_share = 1.35;
constexpr double quality_floor = 0.1;
/// Where too many tets would come out all sizes grow by the one, where none would they shrink by
/// the other; so often.
constexpr double coarser = 1.3;
constexpr double finer = 0.85;
constexpr int most_tries = 8;
/// Of the shortest edge: how far vertices of flat walls may go where thin facets are mended.
constexpr double mend_share = 1e-6;

double longest_edge_of(const std::array<vec3, 4>& p) {
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      longest = std::max(longest, norm(p[i] - p[j]));
  return longest;
}

/// The share of its size that an element should have.
double share_of(double error, double target, int order) {
  if (!(error > target))
    return 1;
  return std::max(smallest_share, std::pow(target / error, 2.0 / (2 * order + 3)));
}

/// How long edges may be at each vertex, m.
std::vector<double> wanted_sizes(const mesh_version& mesh, const fem::problem& problem,
                                 std::span<const case_error> cases, double error) {
  std::vector<double> sizes(mesh.vertex_slots(), 1e300);
  for (std::size_t e = 0; e < problem.element_count(); ++e) {
    double share = 1;
    for (const auto& c : cases) {
      const double target =
        error * std::sqrt(c.energy_j / static_cast<double>(problem.element_count()));
      share = std::min(share, share_of(c.elements[e], target, problem.element_order));
    }
    if (share == 1)
      continue;
    const auto t = problem.element_tets[e];
    const double size = allowed_share * share * longest_edge_of(mesh.corners(t));
    for (const auto v : mesh.tet_at(t).v)
      sizes[v] = std::min(sizes[v], size);
  }
  return sizes;
}

/// Sizes grow from vertex to vertex by no more than over any edge between them.
void grade(const mesh_version& mesh, std::vector<double>& sizes) {
  for (bool changed = true; changed;) {
    changed = false;
    for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
      if (!mesh.is_live_tet(t))
        continue;
      const auto& v = mesh.tet_at(t).v;
      for (const auto a : v)
        for (const auto b : v) {
          const double most = sizes[b] + size_growth * norm(mesh.position(a) - mesh.position(b));
          if (sizes[a] > most * (1 + 1e-9)) {
            sizes[a] = most;
            changed = true;
          }
        }
    }
  }
}

expected<finished_edit> finish(const version_ptr& mesh, const adapt_mesh& work, double shortest,
                               const execution& run) {
  mesh_builder builder(mesh);
  if (auto written = work.write(builder); !written)
    return fail(written.error());
  if (auto mended = mend_split(builder, mend_share * shortest, run); !mended)
    return fail(mended.error());
  edit_claim claim;
  claim.touched = builder.touched();
  const auto candidate = builder.freeze();
  claim.volume_change = boundary_volume_change(*mesh, *candidate);
  claim.quality_floor = quality_floor;
  return finish_edit(mesh, candidate, claim, improvement::local, {}, run);
}

}  // namespace

expected<finished_edit> refine_by_error(const version_ptr& mesh, const fem::problem& problem,
                                        std::span<const case_error> cases, const adapt_goal& goal,
                                        const execution& run) {
  auto sizes = wanted_sizes(*mesh, problem, cases, goal.error);
  grade(*mesh, sizes);
  bool too_many = false;
  for (int n = 0; n < most_tries; ++n) {
    adapt_mesh work(*mesh);
    const auto made = split_edges(*mesh, work, sizes, goal.most_tets, run);
    if (made && made->vertices > 0)
      return finish(mesh, work, *std::ranges::min_element(sizes), run);
    if (!made && made.error().code != ec::invalid_parameter)
      return fail(made.error());
    if (made && too_many)
      break;
    too_many = !made;
    for (auto& size : sizes)
      size *= too_many ? coarser : finer;
  }
  return fail(ec::invalid_parameter, "no tet can become smaller within the limit of tets",
              "Allow more tets, or a larger error");
}

}  // namespace tedit
