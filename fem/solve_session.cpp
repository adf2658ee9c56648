// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solve_session.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"
#include "fem/node_values.hpp"
#include "fem/polled.hpp"
#include "fem/problem_parts.hpp"

namespace tedit::fem {

namespace {

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
  polled_for(same.size(), [&](std::size_t n) {
    const auto v = to.node_vertices[n];
    // A slot may have been given to another point meanwhile.
    if (v <= last && node_of[v] != no_id && from.nodes[node_of[v]] == to.nodes[n])
      same[n] = node_of[v];
  });
  return same;
}

/// Unknown corners take the mean of their known neighbours, layer by layer.
void fill_corners(const problem& p, std::vector<std::uint8_t>& known, std::vector<double>& u) {
  const auto open = [&](std::size_t e) {
    const auto* n = &p.element_nodes[p.nodes_per_element * e];
    return std::any_of(n, n + 4, [&](std::uint32_t i) { return known[i] == 0; });
  };
  std::vector<std::size_t> elements;
  polled_for(p.element_count(), [&](std::size_t e) {
    if (open(e))
      elements.push_back(e);
  });
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

/// Nodes whose filter is not what it was; all others were free. It may change away from an edit: a
/// roller's normals, another load case's supports.
std::vector<std::uint32_t> changed_filters(const problem& p,
                                           std::map<std::uint32_t, std::array<double, 6>> before) {
  for (const auto& h : p.holders)
    before.try_emplace(h.node, std::array<double, 6>{1, 0, 0, 1, 0, 1});
  std::vector<std::uint32_t> changed;
  for (const auto& [node, filter] : before)
    if (p.filter[node] != filter)
      changed.push_back(node);
  return changed;
}

/// Whether one of the nodes, ascending, is held.
bool any_held(const problem& p, std::span<const std::uint32_t> nodes) {
  return std::ranges::any_of(
    p.holders, [&](const node_holder& h) { return std::ranges::binary_search(nodes, h.node); });
}

}  // namespace

std::vector<double> carry_over(const problem& from, std::span<const double> displacement,
                               const problem& to) {
  std::vector<double> u(to.dofs(), 0);
  const auto same = same_corners(from, to);
  std::vector<std::uint8_t> known(to.corner_count, 0);
  polled_for(same.size(), [&](std::size_t n) {
    if (same[n] != no_id) {
      known[n] = 1;
      put(value_at(displacement, same[n]), n, u);
    }
  });
  fill_corners(to, known, u);
  polled_for(to.edge_ends.size(), [&](std::size_t i) {
    const auto [a, b] = to.edge_ends[i];
    auto old = no_id;
    if (from.element_order == 2 && same[a] != no_id && same[b] != no_id)
      old = mid_node(from, same[a], same[b]);
    if (std::ranges::binary_search(from.unused, old))
      old = no_id;
    put(old != no_id ? value_at(displacement, old) : 0.5 * (value_at(u, a) + value_at(u, b)),
        to.corner_count + i, u);
  });
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

bool solve_session::fits(case_list loads, int element_order, const backend& device) const {
  return system_ && device_ == &device && set_->problem.element_order == element_order &&
         materials_ == loads.front().materials;
}

/// Of each case.
std::vector<solve_session::held_nodes> solve_session::held() const {
  std::vector<held_nodes> nodes(set_->cases.size());
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    const auto& filter = set_->filter_of(c);
    const auto& holders = c == set_->standing ? set_->problem.holders : set_->cases[c].holders;
    for (const auto& h : holders)
      nodes[c][h.node] = filter[h.node];
  }
  return nodes;
}

/// Places all cases on the carried-on problem; the one that stood still does, if it is there. Adds
/// the nodes where the system's filter changes.
expected<void> solve_session::follow_conditions(case_list loads,
                                                const std::vector<held_nodes>& before,
                                                problem_change& changed) {
  auto& p = set_->problem;
  const auto stood = set_->standing;
  const auto stands = stood < loads.size() ? stood : 0;
  const bool whole = hangs_together(*mesh_, p, updater_->corners(), changed.nodes);
  std::vector<conditions> cases;
  for (std::size_t c = 0; c < loads.size(); ++c) {
    if (auto ok = place_conditions(*mesh_, loads[c], p); !ok)
      return fail_in_case(loads, c, ok.error());
    const auto old = c == stands ? stood : c;
    const bool known = old < before.size();
    const auto moved = changed_filters(p, known ? before[old] : held_nodes{});
    if (c == stands)
      changed.nodes.insert(changed.nodes.end(), moved.begin(), moved.end());
    // Supports that were checked before, on nodes that were there before, still hold.
    const bool checked = whole && known && moved.empty() && !any_held(p, changed.fresh);
    if (!checked)
      if (auto ok = check_supports(*mesh_, p); !ok)
        return fail_in_case(loads, c, ok.error());
    cases.push_back(take_conditions(p, loads[c]));
  }
  set_->cases = std::move(cases);
  set_->let_stand(stands);
  sort_unique(changed.nodes);
  return {};
}

/// Carries problem and system on to the next version. False when they must be built anew.
expected<bool> solve_session::follow(const version_ptr& mesh, case_list loads) {
  const stopwatch clock;
  auto& p = set_->problem;
  const auto before = held();
  auto change = updater_->apply(*mesh_, *mesh, loads.front(), p);
  if (!change)
    return fail(change.error());
  if (!*change)
    return false;
  auto& changed = **change;
  mesh_ = mesh;
  if (auto ok = follow_conditions(loads, before, changed); !ok)
    return fail(ok.error());
  for (auto& start : starts_)
    fill_fresh(p, changed, updater_->corners(), start.displacement);
  setup_ms_ = clock.milliseconds();
  auto updated = system_->update(changed, updater_->corners());
  if (!updated || !*updated)
    return updated;
  operator_->update(changed.elements);
  renewed_rows_ = changed.nodes.size();
  assembly_ms_ = clock.milliseconds() - setup_ms_;
  return true;
}

expected<void> solve_session::renew_conditions(case_list loads) {
  const auto filter = set_->problem.filter;
  if (auto ok = set_cases(*mesh_, loads, *set_); !ok)
    return ok;
  assembly_ms_ = 0;
  setup_ms_ = 0;
  for (std::size_t c = 0; c < loads.size(); ++c)
    if (set_->filter_of(c) == filter) {
      set_->stand(c);
      return {};
    }
  const stopwatch clock;
  auto set = system_->set_filter(set_->problem.filter);
  setup_ms_ = clock.milliseconds();
  return set;
}

expected<void> solve_session::assemble(const version_ptr& mesh, case_list loads, int element_order,
                                       backend& device, const execution& run) {
  stopwatch clock;
  // The old system goes first: two of them may not fit.
  system_.reset();
  operator_.reset();
  updater_.reset();
  const auto spare = static_cast<std::uint32_t>(256 + mesh->vertex_count() / 50);
  auto made = make_cases(*mesh, loads, element_order, spare);
  if (!made)
    return fail(made.error());
  auto next = std::make_unique<case_set>(std::move(*made));
  auto starts = starts_;
  for (auto& start : starts)
    start.displacement = carry_over(set_->problem, start.displacement, next->problem);
  starts_ = std::move(starts);
  set_ = std::move(next);
  setup_ms_ = clock.restart();
  run.report(0.02, "assembling");
  auto system = device.assemble(set_->problem, run);
  if (!system)
    return fail(system.error());
  assembly_ms_ = clock.restart();
  operator_ = std::make_unique<element_operator>(set_->problem);
  updater_ = std::make_unique<problem_updater>(set_->problem);
  setup_ms_ += clock.restart();
  system_ = std::move(*system);
  mesh_ = mesh;
  materials_ = loads.front().materials;
  device_ = &device;
  return {};
}

// -- following an edit on a thread of its own --------------------------------------------

namespace {

/// On a thread of its own; without room for one, when its result is asked for.
template <class Work>
std::future<expected<bool>> start(const Work& work) {
  try {
    return std::async(std::launch::async, work);
  } catch (const std::system_error&) {
    return std::async(std::launch::deferred, work);
  }
}

expected<void> wait_for(const std::future<expected<bool>>& work, const execution& run) {
  constexpr std::chrono::milliseconds between_looks{5};
  do
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
  while (work.wait_for(between_looks) == std::future_status::timeout);
  return {};
}

}  // namespace

/// Keeps the starts: they are of the present problem.
void solve_session::drop_system() {
  system_.reset();
  if (set_)
    std::erase_if(starts_, [&](const kept_start& start) {
      return start.displacement.size() != set_->problem.dofs();
    });
}

/// Waits for a system that a cancelled solve left on its way to another version.
void solve_session::settle() {
  if (!following_.valid())
    return;
  const auto followed = following_.get();
  if (followed && *followed)
    return;
  if (!followed)
    starts_.clear();  // Who knows which version they are of.
  drop_system();
}

expected<void> solve_session::settle(const execution& run) {
  if (following_.valid())
    if (auto ok = wait_for(following_, run); !ok)
      return ok;
  settle();
  return {};
}

/// `follow`, which nothing stops: half of it would be of no use. A cancel only leaves it behind.
expected<bool> solve_session::follow_beside(const version_ptr& mesh, case_list loads,
                                            const execution& run) {
  following_ = start([this, mesh, cases = std::vector(loads.begin(), loads.end())] {
    return guarded([&] { return follow(mesh, cases); });
  });
  if (auto ok = wait_for(following_, run); !ok)
    return fail(ok.error());
  return following_.get();
}

void solve_session::forget() {
  settle();
  system_.reset();
  operator_.reset();
  updater_.reset();
  starts_.clear();
}

/// A system for the mesh and the conditions: the one that there is, carried on where it can be.
expected<void> solve_session::prepare(const version_ptr& mesh, case_list loads, int element_order,
                                      backend& device, const execution& run) {
  renewed_rows_ = 0;
  assembled_ = false;
  if (fits(loads, element_order, device)) {
    if (mesh_->id() == mesh->id())
      return renew_conditions(loads);
    const auto followed = follow_beside(mesh, loads, run);
    if (!followed && !following_.valid())
      starts_.clear();  // Who knows which version they are of.
    if (!followed)
      return fail(followed.error());
    if (*followed)
      return {};
  }
  assembled_ = true;
  return assemble(mesh, loads, element_order, device, run);
}

/// With room for the nodes that edits add.
void solve_session::keep_start(const std::string& name, const std::vector<double>& displacement) {
  auto& start = starts_.emplace_back(name);
  reserve_for_edits(start.displacement, displacement.size());
  start.displacement = displacement;
}

/// For each case.
std::vector<solve_settings> solve_session::with_starts(const solve_settings& settings) const {
  std::vector<solve_settings> each(set_->cases.size(), settings);
  if (!settings.start.empty() || starts_.empty())
    return each;
  for (std::size_t c = 0; c < each.size(); ++c) {
    const auto same = std::ranges::find(starts_, set_->cases[c].name, &kept_start::name);
    each[c].start = (same != starts_.end() ? *same : starts_.front()).displacement;
  }
  return each;
}

expected<solve_session::cases_result> solve_session::solve(const version_ptr& mesh, case_list loads,
                                                           int element_order, backend& device,
                                                           const solve_settings& settings,
                                                           const execution& run,
                                                           const cases_callback& on_frame) {
  if (auto ok = check_cases(loads); !ok)
    return fail(ok.error());
  if (auto ok = settle(run); !ok)
    return fail(ok.error());
  auto ready = guarded(run, [&] { return prepare(mesh, loads, element_order, device, run); });
  if (!ready) {
    if (!following_.valid())
      drop_system();
    return fail(ready.error());
  }
  standing_system on{*operator_, *system_, device.info().name, assembly_ms_, setup_ms_};
  auto solved = solve_cases(*set_, on, with_starts(settings), run, on_frame);
  if (!solved) {
    const auto code = solved.error().code;
    if (on.lost || code == ec::device_lost || code == ec::out_of_memory)
      system_.reset();  // It may be incomplete, or stand on a device that is gone.
    return fail(solved.error());
  }
  starts_.clear();
  for (std::size_t c = 0; c < loads.size(); ++c)
    keep_start(loads[c].name, solved->cases[c].displacement);
  return cases_result{std::move(*solved), assembled_, renewed_rows_};
}

expected<solve_session::result> solve_session::solve(
  const version_ptr& mesh, const load_case& loads, int element_order, backend& device,
  const solve_settings& settings, const execution& run, const frame_callback& on_frame) {
  cases_callback on_cases;
  if (on_frame)
    on_cases = [&](const cases_frame& now) {
      const auto recover = [&]() -> expected<solution> {
        auto all = now.recover();
        return all ? expected<solution>(std::move(all->front())) : fail(all.error());
      };
      on_frame(
        {now.outer_round, now.iterations, now.true_relative_residual, now.energy_error, recover});
    };
  auto all = solve(mesh, case_list(&loads, 1), element_order, device, settings, run, on_cases);
  if (!all)
    return fail(all.error());
  return result{std::move(all->solved.cases.front()), all->assembled, all->renewed_rows};
}

}  // namespace tedit::fem
