// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solve_session.hpp"

#include <algorithm>
#include <map>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"
#include "fem/problem_parts.hpp"

namespace tedit::fem {

namespace {

vec3 value_at(std::span<const double> u, std::size_t n) {
  return {u[3 * n], u[3 * n + 1], u[3 * n + 2]};
}

void put(vec3 value, std::size_t n, std::vector<double>& u) {
  u[3 * n] = value.x;
  u[3 * n + 1] = value.y;
  u[3 * n + 2] = value.z;
}

/// The node of `from` that is the same point as each corner of `to`.
std::vector<std::uint32_t> same_corners(const problem& from, const problem& to) {
  vertex_id last = 0;
  for (const auto v : from.node_vertices)
    if (v != no_id)
      last = std::max(last, v);
  std::vector<std::uint32_t> node_of(std::size_t{last} + 1, no_id);
  for (std::uint32_t n = 0; n < from.node_vertices.size(); ++n)
    if (from.node_vertices[n] != no_id)
      node_of[from.node_vertices[n]] = n;
  std::vector<std::uint32_t> same(to.corner_count, no_id);
  for (std::size_t n = 0; n < same.size(); ++n) {
    const auto v = to.node_vertices[n];
    // A slot may have been given to another point meanwhile.
    if (v <= last && node_of[v] != no_id && from.nodes[node_of[v]] == to.nodes[n])
      same[n] = node_of[v];
  }
  return same;
}

/// Unknown corners take the mean of their known neighbours, layer by layer.
void fill_corners(const problem& p, std::vector<std::uint8_t>& known, std::vector<double>& u) {
  const auto open = [&](std::size_t e) {
    const auto* n = &p.element_nodes[p.nodes_per_element * e];
    return std::any_of(n, n + 4, [&](std::uint32_t i) { return known[i] == 0; });
  };
  std::vector<std::size_t> elements;
  for (std::size_t e = 0; e < p.element_count(); ++e)
    if (open(e))
      elements.push_back(e);
  std::vector<vec3> sum(p.corner_count);
  std::vector<int> count(p.corner_count, 0);
  while (!elements.empty()) {
    std::vector<std::uint32_t> reached;
    for (const auto e : elements) {
      const auto* n = &p.element_nodes[p.nodes_per_element * e];
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
          if (known[n[a]] == 0 && known[n[b]] != 0) {
            if (count[n[a]]++ == 0)
              reached.push_back(n[a]);
            sum[n[a]] += value_at(u, n[b]);
          }
    }
    if (reached.empty())
      return;  // A piece without any known point stays at zero.
    for (const auto n : reached) {
      put(sum[n] / count[n], n, u);
      known[n] = 1;
    }
    std::erase_if(elements, [&](std::size_t e) { return !open(e); });
  }
}

}  // namespace

std::vector<double> carry_over(const problem& from, std::span<const double> displacement,
                               const problem& to) {
  std::vector<double> u(to.dofs(), 0);
  const auto same = same_corners(from, to);
  std::vector<std::uint8_t> known(to.corner_count, 0);
  for (std::size_t n = 0; n < same.size(); ++n)
    if (same[n] != no_id) {
      known[n] = 1;
      put(value_at(displacement, same[n]), n, u);
    }
  fill_corners(to, known, u);
  for (std::size_t i = 0; i < to.edge_ends.size(); ++i) {
    const auto [a, b] = to.edge_ends[i];
    auto old = no_id;
    if (from.element_order == 2 && same[a] != no_id && same[b] != no_id)
      old = mid_node(from, same[a], same[b]);
    if (std::ranges::binary_search(from.unused, old))
      old = no_id;
    put(old != no_id ? value_at(displacement, old) : 0.5 * (value_at(u, a) + value_at(u, b)),
        to.corner_count + i, u);
  }
  return u;
}

void fill_fresh(const problem& p, const problem_change& change, const incidence& corners,
                std::vector<double>& u) {
  u.resize(p.dofs(), 0);
  for (const auto n : p.unused)
    put({}, n, u);
  const auto per = static_cast<std::uint32_t>(p.nodes_per_element);
  std::vector<std::uint32_t> open;
  for (const auto n : change.fresh)
    if (n < p.corner_count)
      open.push_back(n);
  while (!open.empty()) {
    std::vector<std::pair<std::uint32_t, vec3>> reached;
    for (const auto n : open) {
      vec3 sum;
      int count = 0;
      for (const auto corner : corners.of_node(n))
        for (int a = 0; a < 4; ++a)
          if (const auto other = p.element_nodes[per * std::size_t{corner / per} + a];
              !std::ranges::binary_search(open, other)) {
            sum += value_at(u, other);
            ++count;
          }
      if (count > 0)
        reached.emplace_back(n, sum / count);
    }
    if (reached.empty())
      break;  // A piece without any known point stays as it is.
    for (const auto& [n, value] : reached)
      put(value, n, u);
    std::erase_if(open, [&](std::uint32_t n) {
      return std::ranges::binary_search(reached, n, {}, &std::pair<std::uint32_t, vec3>::first);
    });
  }
  for (const auto n : change.fresh)
    if (n >= p.corner_count) {
      const auto [low, high] = p.edge_ends[n - p.corner_count];
      put(0.5 * (value_at(u, low) + value_at(u, high)), n, u);
    }
}

bool solve_session::fits(const load_case& loads, int element_order, const backend& device) const {
  return system_ && device_ == &device && problem_->element_order == element_order &&
         materials_ == loads.materials;
}

/// Carries problem and system on to the next version. False when they must be built anew.
expected<bool> solve_session::follow(const version_ptr& mesh, const load_case& loads) {
  const stopwatch clock;
  std::map<std::uint32_t, std::array<double, 6>> held;
  for (const auto& h : problem_->holders)
    held[h.node] = problem_->filter[h.node];
  auto change = updater_->apply(*mesh_, *mesh, loads, *problem_);
  if (!change)
    return fail(change.error());
  if (!*change)
    return false;
  auto& changed = **change;
  mesh_ = mesh;
  if (auto ok = place_conditions(*mesh, loads, *problem_); !ok)
    return fail(ok.error());
  bool checked = hangs_together(*mesh, *problem_, updater_->corners(), changed.nodes);
  // A filter may change away from the edit: a roller's normals, another load case's supports.
  for (const auto& h : problem_->holders)
    held.try_emplace(h.node, std::array<double, 6>{1, 0, 0, 1, 0, 1});
  for (const auto& [node, filter] : held)
    if (problem_->filter[node] != filter) {
      changed.nodes.push_back(node);
      checked = false;
    } else if (std::ranges::binary_search(changed.fresh, node)) {
      checked = false;
    }
  if (!checked)
    if (auto ok = check_supports(*mesh, *problem_); !ok)
      return fail(ok.error());
  sort_unique(changed.nodes);
  if (!displacement_.empty())
    fill_fresh(*problem_, changed, updater_->corners(), displacement_);
  setup_ms_ = clock.milliseconds();
  auto updated = system_->update(changed, updater_->corners());
  if (!updated || !*updated)
    return updated;
  operator_->update(changed.elements);
  renewed_rows_ = changed.nodes.size();
  assembly_ms_ = clock.milliseconds() - setup_ms_;
  return true;
}

expected<void> solve_session::renew_conditions(const load_case& loads) {
  const auto filter = problem_->filter;
  if (auto ok = set_conditions(*mesh_, loads, *problem_); !ok)
    return ok;
  assembly_ms_ = 0;
  setup_ms_ = 0;
  if (problem_->filter == filter)
    return {};
  const stopwatch clock;
  auto set = system_->set_filter(problem_->filter);
  setup_ms_ = clock.milliseconds();
  return set;
}

expected<void> solve_session::assemble(const version_ptr& mesh, const load_case& loads,
                                       int element_order, backend& device, const execution& run) {
  stopwatch clock;
  // The old system goes first: two of them may not fit.
  system_.reset();
  operator_.reset();
  updater_.reset();
  const auto spare = static_cast<std::uint32_t>(256 + mesh->vertex_count() / 50);
  auto made = make_problem(*mesh, loads, element_order, spare);
  if (!made)
    return fail(made.error());
  auto next = std::make_unique<problem>(std::move(*made));
  if (problem_ && !displacement_.empty())
    displacement_ = carry_over(*problem_, displacement_, *next);
  problem_ = std::move(next);
  setup_ms_ = clock.restart();
  run.report(0.02, "assembling");
  auto system = device.assemble(*problem_, run);
  if (!system)
    return fail(system.error());
  assembly_ms_ = clock.restart();
  operator_ = std::make_unique<element_operator>(*problem_);
  updater_ = std::make_unique<problem_updater>(*problem_);
  setup_ms_ += clock.restart();
  system_ = std::move(*system);
  mesh_ = mesh;
  materials_ = loads.materials;
  device_ = &device;
  return {};
}

/// A system for the mesh and the conditions: the one that there is, carried on where it can be.
expected<void> solve_session::prepare(const version_ptr& mesh, const load_case& loads,
                                      int element_order, backend& device, const execution& run) {
  renewed_rows_ = 0;
  assembled_ = false;
  if (fits(loads, element_order, device)) {
    if (mesh_->id() == mesh->id())
      return renew_conditions(loads);
    // Not to be cancelled: it is short, and half of it would be of no use.
    const cancel_token never;
    const cancel_scope scope(never);
    const auto followed = follow(mesh, loads);
    if (!followed) {
      displacement_.clear();  // Who knows which version it is of.
      return fail(followed.error());
    }
    if (*followed)
      return {};
  }
  assembled_ = true;
  return assemble(mesh, loads, element_order, device, run);
}

expected<solve_session::result> solve_session::solve(
  const version_ptr& mesh, const load_case& loads, int element_order, backend& device,
  const solve_settings& settings, const execution& run, const frame_callback& on_frame) {
  auto ready = guarded(run, [&] { return prepare(mesh, loads, element_order, device, run); });
  if (!ready) {
    system_.reset();
    if (problem_ && displacement_.size() != problem_->dofs())
      displacement_.clear();
    return fail(ready.error());
  }
  auto started = settings;
  if (started.start.empty())
    started.start = displacement_;
  auto solved =
    fem::solve(*problem_, *operator_, *system_, device.info().name, started, run, on_frame);
  if (!solved) {
    if (const auto code = solved.error().code; code == ec::device_lost || code == ec::out_of_memory)
      system_.reset();  // It may be incomplete, or stand on a device that is gone.
    return fail(solved.error());
  }
  solved->assembly_ms = assembly_ms_;
  solved->setup_ms = setup_ms_;
  displacement_ = solved->displacement;
  return result{std::move(*solved), assembled_, renewed_rows_};
}

}  // namespace tedit::fem
