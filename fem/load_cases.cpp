// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/load_cases.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
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

tl::unexpected<error> fail_in(const std::string& name, error e) {
  e.message = in_case(name, e.message);
  return fail(std::move(e));
}

/// Exchanges the conditions of a problem and those of a case; a second call undoes the first.
void exchange(problem& p, conditions& c) {
  p.loads.swap(c.loads);
  p.filter.swap(c.filter);
  p.prescribed.swap(c.prescribed);
  p.holders.swap(c.holders);
}

conditions conditions_of(const problem& p, const std::string& name) {
  return {name, p.loads, p.filter, p.prescribed, p.holders};
}

/// Indices of the cases by their supports: a group has one filter.
std::vector<std::vector<std::size_t>> groups_of(std::span<const conditions> cases) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const auto same = [&](const auto& group) {
      return cases[group.front()].filter == cases[c].filter;
    };
    const auto found = std::ranges::find_if(groups, same);
    if (found == groups.end())
      groups.push_back({c});
    else
      found->push_back(c);
  }
  return groups;
}

/// The steps of `solve_cases`.
class case_solver {
public:
  case_solver(case_set& set, const solve_settings& settings, const execution& run)
      : set_(set), settings_(settings), run_(run) {}

  expected<solved_cases> solve_on(backend& device) {
    run_.report(0.02, "assembling");
    stopwatch clock;
    auto system = device.assemble(set_.problem, run_);
    if (!system)
      return fail(system.error());
    out_.assembly_ms = clock.restart();
    const element_operator k(set_.problem);
    out_.setup_ms = clock.restart();
    out_.cases.resize(set_.cases.size());
    const auto groups = groups_of(set_.cases);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      clock.restart();
      // The system comes with the first case's filter.
      if (g > 0)
        if (auto ok = (*system)->set_filter(set_.cases[groups[g].front()].filter); !ok)
          return fail(ok.error());
      out_.setup_ms += clock.restart();
      if (auto ok = solve_group(groups[g], k, **system); !ok)
        return fail(ok.error());
    }
    if (auto ok = recover_all(k); !ok)
      return fail(ok.error());
    finish(device.info().name);
    return std::move(out_);
  }

private:
  expected<void> solve_group(const std::vector<std::size_t>& group, const element_operator& k,
                             linear_system& system) {
    const stopwatch clock;
    std::vector<refinement> open;
    open.reserve(group.size());
    for (const auto c : group) {
      const auto& at = set_.cases[c];
      const auto name = set_.cases.size() > 1 ? at.name : "";
      open.emplace_back(conditions_view{name, at.loads, at.filter, at.prescribed}, k, settings_,
                        out_.cases[c]);
    }
    if (auto ok = refine(open, system, settings_, run_); !ok)
      return ok;
    out_.solve_ms += clock.milliseconds();
    return {};
  }

  expected<void> recover_all(const element_operator& k) {
    run_.report(0.95, "recovering stresses");
    const stopwatch clock;
    for (std::size_t c = 0; c < set_.cases.size(); ++c) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the solve was cancelled");
      auto& out = out_.cases[c];
      out.element_order = set_.problem.element_order;
      out.converged = out.true_relative_residual <= settings_.tolerance;
      exchange(set_.problem, set_.cases[c]);
      recover(set_.problem, k, out);
      exchange(set_.problem, set_.cases[c]);
    }
    out_.recovery_ms = clock.milliseconds();
    return {};
  }

  void finish(const std::string& device) {
    const auto count = static_cast<double>(out_.cases.size());
    for (auto& one : out_.cases) {
      one.device = device;
      one.assembly_ms = out_.assembly_ms / count;
      one.setup_ms = out_.setup_ms / count;
      one.solve_ms = out_.solve_ms / count;
      one.recovery_ms = out_.recovery_ms / count;
    }
    out_.envelope = make_envelope(out_.cases);
    run_.report(1, "done");
  }

  case_set& set_;
  const solve_settings& settings_;
  const execution& run_;
  solved_cases out_;
};

}  // namespace

expected<case_set> make_cases(const mesh_version& mesh, std::span<const load_case> loads,
                              int element_order) {
  if (loads.empty())
    return fail(ec::invalid_argument, "there is no load case to solve", "Give at least one");
  for (const auto& other : loads)
    if (!same_materials(loads.front(), other))
      return fail(ec::invalid_material,
                  "load case '" + other.name + "' has other materials than '" + loads.front().name +
                    "', and load cases share one stiffness matrix",
                  "Give both the same materials, or solve them one at a time");
  const auto name_of = [&](std::size_t c) { return loads.size() > 1 ? loads[c].name : ""; };
  auto p = make_problem(mesh, loads.front(), element_order);
  if (!p)
    return fail_in(name_of(0), p.error());
  case_set set{std::move(*p), {}};
  set.cases.push_back(conditions_of(set.problem, loads.front().name));
  for (std::size_t c = 1; c < loads.size(); ++c) {
    if (auto ok = set_conditions(mesh, loads[c], set.problem); !ok)
      return fail_in(name_of(c), ok.error());
    set.cases.push_back(conditions_of(set.problem, loads[c].name));
  }
  auto first = set.cases.front();
  exchange(set.problem, first);
  return set;
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

expected<solved_cases> solve_cases(case_set& set, backend& device, const solve_settings& settings,
                                   const execution& run) {
  if (auto ok = check_settings(set.problem, settings); !ok)
    return fail(ok.error());
  return case_solver(set, settings, run).solve_on(device);
}

}  // namespace tedit::fem
