// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/load_cases.hpp"

#include <algorithm>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"
#include "fem/problem_parts.hpp"
#include "fem/recovery.hpp"
#include "fem/refinement.hpp"

namespace tedit::fem {

namespace {

/// Names of materials are for people: only their numbers have to be the same.
bool same_materials(const load_case& a, const load_case& b) {
  const auto nameless = [](material m) {
    m.name.clear();
    return m;
  };
  return std::ranges::equal(a.materials, b.materials, {}, nameless, nameless);
}

/// Exchanges the conditions of a problem and those of a case; a second call undoes the first.
void exchange(problem& p, conditions& c) {
  p.loads.swap(c.loads);
  p.filter.swap(c.filter);
  p.prescribed.swap(c.prescribed);
  p.holders.swap(c.holders);
}

/// Lets a case stand for as long as this lives.
class standing_for {
public:
  standing_for(case_set& set, std::size_t c) : set_(set), before_(set.standing) { set.stand(c); }
  standing_for(const standing_for&) = delete;
  standing_for& operator=(const standing_for&) = delete;
  ~standing_for() { set_.stand(before_); }

private:
  case_set& set_;
  std::size_t before_;
};

conditions_view view_of(const case_set& set, std::size_t c) {
  const auto& at = set.cases[c];
  const auto name = set.cases.size() > 1 ? at.name : "";
  if (c == set.standing)
    return {name, set.problem.loads, set.problem.filter, set.problem.prescribed};
  return {name, at.loads, at.filter, at.prescribed};
}

using case_group = std::vector<std::size_t>;

/// Indices of the cases by their supports: a group has one filter. The one of the case that stands
/// comes first.
std::vector<case_group> groups_of(const case_set& set) {
  std::vector<case_group> groups;
  for (std::size_t c = 0; c < set.cases.size(); ++c) {
    const auto same = [&](const case_group& group) {
      return set.filter_of(group.front()) == set.filter_of(c);
    };
    const auto found = std::ranges::find_if(groups, same);
    if (found == groups.end())
      groups.push_back({c});
    else
      found->push_back(c);
  }
  const auto stands = [&](const case_group& group) {
    return std::ranges::find(group, set.standing) != group.end();
  };
  std::ranges::rotate(groups, std::ranges::find_if(groups, stands));
  return groups;
}

/// The steps of `solve_cases`.
class case_solver {
public:
  case_solver(case_set& set, standing_system& on, std::vector<solve_settings> settings,
              const execution& run, const cases_callback& on_frame)
      : set_(set), on_(on), settings_(std::move(settings)), run_(run), on_frame_(on_frame) {}

  expected<solved_cases> solve() {
    run_.report(0.1, "solving");
    out_.assembly_ms = on_.assembly_ms;
    out_.setup_ms = on_.setup_ms;
    out_.cases.resize(set_.cases.size());
    for (auto& one : out_.cases) {
      one.element_order = set_.problem.element_order;
      one.device = on_.device;
    }
    const auto groups = groups_of(set_);
    together_ = groups.size() == 1;
    if (!together_)  // No field of all cases comes early: the first rounds need not end early.
      for (auto& one : settings_)
        one.preview_energy = 0;
    for (const auto& group : groups) {
      if (&group != &groups.front())
        if (auto ok = take_filter_of(group.front()); !ok)
          return fail(ok.error());
      if (auto ok = solve_group(group); !ok)
        return fail(ok.error());
    }
    if (auto ok = recover_all(); !ok)
      return fail(ok.error());
    finish();
    return std::move(out_);
  }

private:
  expected<void> take_filter_of(std::size_t c) {
    const stopwatch clock;
    on_.lost = true;
    set_.stand(c);
    if (auto ok = on_.system.set_filter(set_.problem.filter); !ok)
      return ok;
    on_.lost = false;
    out_.setup_ms += clock.milliseconds();
    return {};
  }

  expected<void> solve_group(const case_group& group) {
    const stopwatch clock;
    std::vector<refinement> open;
    open.reserve(group.size());
    for (const auto c : group)
      open.emplace_back(view_of(set_, c), on_.k, settings_[c], out_.cases[c]);
    std::function<void(int)> on_round;
    if (on_frame_)
      on_round = [&](int round) { on_frame_(frame_of(round, group)); };
    if (auto ok = refine(open, on_.system, settings_.front(), run_, on_round); !ok)
      return ok;
    out_.solve_ms += clock.milliseconds();
    return {};
  }

  cases_frame frame_of(int round, const case_group& group) {
    cases_frame frame{round, 0, 0, 0, {}};
    for (const auto c : group) {
      const auto& one = out_.cases[c];
      frame.iterations = std::max(frame.iterations, one.iterations);
      frame.true_relative_residual =
        std::max(frame.true_relative_residual, one.true_relative_residual);
      frame.energy_error = std::max(frame.energy_error, one.energy_error);
    }
    if (together_)
      frame.recover = [this] { return guarded([this] { return as_they_are(); }); };
    return frame;
  }

  expected<std::vector<solution>> as_they_are() {
    auto copies = out_.cases;
    for (std::size_t c = 0; c < copies.size(); ++c)
      if (auto ok = recover_one(c, copies[c]); !ok)
        return fail(ok.error());
    return copies;
  }

  expected<void> recover_one(std::size_t c, solution& out) {
    const standing_for now(set_, c);
    auto ok = recover(set_.problem, on_.k, out);
    if (!ok && set_.cases.size() > 1)
      ok.error().message = in_case(set_.cases[c].name, ok.error().message);
    return ok;
  }

  expected<void> recover_all() {
    run_.report(0.95, "recovering stresses");
    const stopwatch clock;
    for (std::size_t c = 0; c < set_.cases.size(); ++c) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the solve was cancelled");
      auto& out = out_.cases[c];
      out.converged = out.true_relative_residual <= settings_[c].tolerance;
      if (auto ok = recover_one(c, out); !ok)
        return ok;
    }
    out_.recovery_ms = clock.milliseconds();
    return {};
  }

  void finish() {
    const auto count = static_cast<double>(out_.cases.size());
    for (auto& one : out_.cases) {
      one.assembly_ms = out_.assembly_ms / count;
      one.setup_ms = out_.setup_ms / count;
      one.solve_ms = out_.solve_ms / count;
      one.recovery_ms = out_.recovery_ms / count;
    }
    if (out_.cases.size() > 1)
      out_.envelope = make_envelope(out_.cases);
    run_.report(1, "done");
  }

  case_set& set_;
  standing_system& on_;
  std::vector<solve_settings> settings_;
  const execution& run_;
  const cases_callback& on_frame_;
  bool together_ = true;  ///< All cases have the same supports.
  solved_cases out_;
};

expected<solved_cases> assemble_and_solve(case_set& set, backend& device,
                                          const solve_settings& settings, const execution& run) {
  run.report(0.02, "assembling");
  stopwatch clock;
  auto system = device.assemble(set.problem, run);
  if (!system)
    return fail(system.error());
  const double assembly_ms = clock.restart();
  const element_operator k(set.problem);
  standing_system on{k, **system, device.info().name, assembly_ms, clock.restart()};
  return solve_cases(set, on, std::vector(set.cases.size(), settings), run);
}

using filter = std::vector<std::array<double, 6>>;

/// The cases that the set does not have yet; then the first one stands. `sound`: supports that are
/// known to hold the part, as those of the set's cases are.
expected<void> add_cases(const mesh_version& mesh, std::span<const load_case> loads,
                         std::vector<filter> sound, case_set& set) {
  auto& p = set.problem;
  for (std::size_t c = set.cases.size(); c < loads.size(); ++c) {
    if (auto ok = place_conditions(mesh, loads[c], p); !ok)
      return fail_in_case(loads, c, ok.error());
    const bool known =
      std::ranges::find(sound, p.filter) != sound.end() ||
      std::ranges::find(set.cases, p.filter, &conditions::filter) != set.cases.end();
    if (!known)
      if (auto ok = check_supports(mesh, p); !ok)
        return fail_in_case(loads, c, ok.error());
    set.cases.push_back(take_conditions(p, loads[c]));
  }
  set.let_stand(0);
  return {};
}

}  // namespace

void case_set::stand(std::size_t c) {
  if (c == standing)
    return;
  exchange(problem, cases[standing]);
  let_stand(c);
}

void case_set::let_stand(std::size_t c) {
  exchange(problem, cases[c]);
  standing = c;
}

conditions take_conditions(problem& p, const load_case& of) {
  conditions taken{of.name, {}, {}, {}, {}, {}};
  const auto warn = [&](const std::string& text) {
    if (!text.empty() && std::ranges::find(taken.warnings, text) == taken.warnings.end())
      taken.warnings.push_back(text);
  };
  for (const auto& item : of.constraints)
    warn(item.warning);
  for (const auto& item : of.loads)
    warn(item.warning);
  exchange(p, taken);
  return taken;
}

tl::unexpected<error> fail_in_case(std::span<const load_case> loads, std::size_t c, error e) {
  if (loads.size() > 1)
    e.message = in_case(loads[c].name, e.message);
  return fail(std::move(e));
}

expected<void> check_cases(std::span<const load_case> loads) {
  if (loads.empty())
    return fail(ec::invalid_argument, "there is no load case to solve", "Give at least one");
  for (const auto& other : loads)
    if (!same_materials(loads.front(), other))
      return fail(ec::invalid_material,
                  "load case '" + other.name + "' has other materials than '" + loads.front().name +
                    "', and load cases share one stiffness matrix",
                  "Give both the same materials, or solve them one at a time");
  return {};
}

expected<case_set> make_cases(const mesh_version& mesh, std::span<const load_case> loads,
                              int element_order, std::uint32_t spare_corners) {
  if (auto ok = check_cases(loads); !ok)
    return fail(ok.error());
  auto p = make_problem(mesh, loads.front(), element_order, spare_corners);
  if (!p)
    return fail_in_case(loads, 0, p.error());
  case_set set{std::move(*p), {}};
  set.cases.push_back(take_conditions(set.problem, loads.front()));
  if (auto ok = add_cases(mesh, loads, {}, set); !ok)
    return fail(ok.error());
  return set;
}

expected<void> set_cases(const mesh_version& mesh, std::span<const load_case> loads,
                         case_set& set) {
  std::vector<filter> sound;
  set.stand(0);
  sound.push_back(std::move(set.problem.filter));
  for (std::size_t c = 1; c < set.cases.size(); ++c)
    sound.push_back(std::move(set.cases[c].filter));
  set.cases.clear();
  return add_cases(mesh, loads, std::move(sound), set);
}

envelope make_envelope(std::span<const solution> cases) {
  envelope result;
  const auto& first = cases.front();
  result.von_mises = first.von_mises;
  result.von_mises_case.assign(first.von_mises.size(), 0);
  result.safety_factor = first.safety_factor;
  result.safety_factor_case.assign(first.safety_factor.size(), 0);
  result.max_von_mises = {first.max_von_mises_pa, first.max_von_mises_at, 0};
  result.max_displacement = {first.max_displacement_m, first.max_displacement_at, 0};
  result.min_safety_factor = {first.min_safety_factor, first.min_safety_factor_at, 0};
  for (std::uint32_t c = 1; c < cases.size(); ++c) {
    const auto& one = cases[c];
    for (std::size_t n = 0; n < one.von_mises.size(); ++n)
      if (one.von_mises[n] > result.von_mises[n]) {
        result.von_mises[n] = one.von_mises[n];
        result.von_mises_case[n] = c;
      }
    for (std::size_t n = 0; n < one.safety_factor.size(); ++n)
      if (one.safety_factor[n] < result.safety_factor[n]) {
        result.safety_factor[n] = one.safety_factor[n];
        result.safety_factor_case[n] = c;
      }
    if (one.max_von_mises_pa > result.max_von_mises.value)
      result.max_von_mises = {one.max_von_mises_pa, one.max_von_mises_at, c};
    if (one.max_displacement_m > result.max_displacement.value)
      result.max_displacement = {one.max_displacement_m, one.max_displacement_at, c};
    if (one.min_safety_factor < result.min_safety_factor.value)
      result.min_safety_factor = {one.min_safety_factor, one.min_safety_factor_at, c};
  }
  return result;
}

expected<solved_cases> solve_cases(case_set& set, standing_system& on,
                                   std::vector<solve_settings> settings, const execution& run,
                                   const cases_callback& on_frame) {
  for (const auto& one : settings)
    if (auto ok = check_settings(set.problem, one); !ok)
      return fail(ok.error());
  return guarded(run,
                 [&] { return case_solver(set, on, std::move(settings), run, on_frame).solve(); });
}

expected<solved_cases> solve_cases(case_set& set, backend& device, const solve_settings& settings,
                                   const execution& run) {
  if (auto ok = check_settings(set.problem, settings); !ok)
    return fail(ok.error());
  return guarded(run, [&] { return assemble_and_solve(set, device, settings, run); });
}

}  // namespace tedit::fem
