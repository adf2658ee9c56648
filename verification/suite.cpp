// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/suite.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "verification/cases.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

std::vector<case_entry> all_cases() {
  std::vector<case_entry> all;
  for (auto&& group : {exact_cases(), beam_cases(), flexure_cases(), ring_cases(), nafems_cases(),
                       convergence_cases(), invariance_cases(), calculix_cases(), refusal_cases()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

/// Why the device cannot solve elements of this order; empty when it can. Asked by a tiny problem.
std::string why_not(fem::backend& device, int order, const execution& run) {
  auto loads = with_material(1, 0.3);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  loads.loads = {{{s_high}, fem::force{{1, 0, 0}}}};
  const auto mesh = block_mesh({1, 1, 1}, box({1, 1, 1}));
  const auto p = fem::make_problem(**mesh, loads, order);
  const auto system = device.assemble(*p, run);
  return system ? std::string() : system.error().message;
}

std::vector<const real_part*> pointers_to(std::span<const real_part> parts) {
  std::vector<const real_part*> pointers;
  for (const auto& part : parts)
    pointers.push_back(&part);
  return pointers;
}

}  // namespace

// -- context ---------------------------------------------------------------------------

expected<fem::solution> case_context::solve(const fem::problem& p, double tolerance) {
  const stopwatch clock;
  fem::solve_settings settings;
  settings.tolerance = tolerance;
  auto result = fem::solve(p, device_, settings, silent_execution());
  elements_ = p.element_count();
  milliseconds_ = clock.milliseconds();
  return result;
}

expected<case_context::solved> case_context::solve(const mesh_version& mesh,
                                                   const fem::load_case& loads, double tolerance) {
  auto p = fem::make_problem(mesh, loads, order_);
  if (!p)
    return fail(p.error());
  auto result = solve(*p, tolerance);
  if (!result)
    return fail(result.error());
  return solved{std::move(*p), std::move(*result)};
}

void case_context::add(const std::string& quantity, comparison kind, double target, double computed,
                       double tolerance, bool passed) {
  const double error = kind == comparison::within ? computed / target - 1 : 0;
  report_.results.push_back({name_, source_, order_, device_.info().name, elements_, quantity, kind,
                             target, computed, error, tolerance, passed, milliseconds_});
}

void case_context::within(const std::string& quantity, double target, double computed,
                          double tolerance) {
  add(quantity, comparison::within, target, computed, tolerance,
      std::abs(computed - target) <= tolerance * std::abs(target));
}

void case_context::at_most(const std::string& quantity, double bound, double computed) {
  add(quantity, comparison::at_most, bound, computed, 0, computed <= bound);
}

void case_context::at_least(const std::string& quantity, double bound, double computed) {
  add(quantity, comparison::at_least, bound, computed, 0, computed >= bound);
}

void case_context::add_refusal(const std::string& what, ec code, const error* e) {
  const bool refused = e != nullptr && e->code == code && !e->message.empty();
  elements_ = 0;
  milliseconds_ = 0;
  add(what + ": " + std::string(code_name(code)), comparison::refusal, 1, refused ? 1 : 0, 0,
      refused);
}

void case_context::add_convergence(convergence_row row) {
  report_.convergence.push_back(row);
}

void case_context::add_side_by_side(side_by_side_row row, double other_milliseconds) {
  row.milliseconds = milliseconds_;
  row.other_milliseconds = other_milliseconds;
  report_.side_by_side.push_back(std::move(row));
}

void case_context::leave_out(const std::string& why) {
  left_out_case item{name_ + " (order " + std::to_string(order_) + ")", why};
  if (std::ranges::find(report_.left_out, item) == report_.left_out.end())
    report_.left_out.push_back(std::move(item));
}

execution case_context::silent_execution() const {
  execution silent;
  silent.cancel = run_.cancel;
  return silent;
}

// -- helpers of cases ------------------------------------------------------------------

fem::load_case with_material(double young_modulus, double poisson_ratio, double density) {
  fem::load_case loads;
  loads.materials = {{"material", young_modulus, poisson_ratio, density, 0, {}}};
  return loads;
}

fem::constraint symmetry(surface_id surface, int axis) {
  fem::prescribed_displacement held;
  (axis == 0 ? held.x_m : axis == 1 ? held.y_m : held.z_m) = 0;
  return {{surface}, held};
}

// -- the suite -------------------------------------------------------------------------

bool suite_report::passed() const {
  return failures() == 0 && !results.empty();
}

std::size_t suite_report::failures() const {
  return static_cast<std::size_t>(
    std::ranges::count_if(results, [](const case_result& r) { return !r.passed; }));
}

std::vector<case_description> describe_cases() {
  std::vector<case_description> all;
  for (const auto& entry : all_cases())
    all.push_back({entry.name, entry.source, entry.about});
  return all;
}

std::vector<case_id> list_cases() {
  std::vector<case_id> ids;
  for (const auto& entry : all_cases())
    for (const int order : entry.orders)
      ids.push_back({entry.name, order});
  return ids;
}

expected<void> run_case(const case_id& id, fem::backend& device, const real_part* part,
                        const execution& run, suite_report& report) {
  const auto cases = all_cases();
  const auto found = std::ranges::find(cases, id.name, &case_entry::name);
  if (found == cases.end())
    return fail(ec::not_found, "there is no verification case \"" + id.name + "\"");
  if (found->needs_part && part == nullptr) {
    report.left_out.push_back(
      {id.name + " (order " + std::to_string(id.element_order) + ")", "no real part was given"});
    return {};
  }
  case_context context(id.name, found->source, id.element_order, device, part, run, report);
  auto done = found->run(context);
  if (done)
    return {};
  if (done.error().code == ec::cancelled)
    return done;
  report.results.push_back({id.name, found->source, id.element_order, device.info().name, 0,
                            "failed: " + render(done.error()), comparison::refusal, 0, 0, 0, 0,
                            false, 0});
  return {};
}

expected<suite_report> run_suite(fem::backend& device, const real_part* part, const execution& run,
                                 std::span<const real_part> side_by_side) {
  const stopwatch clock;
  suite_report report;
  report.device = device.info().name;
  std::array<std::string, 3> refusal;
  for (const int order : {1, 2}) {
    refusal[order] = why_not(device, order, run);
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the verification was cancelled");
    if (!refusal[order].empty())
      report.left_out.push_back(
        {"all cases with tets of order " + std::to_string(order), refusal[order]});
  }
  if (side_by_side.empty())
    report.left_out.push_back({side_by_side_case, "not asked for: add --calculix"});
  const auto ids = list_cases();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!refusal[ids[i].element_order].empty())
      continue;
    run.report(static_cast<double>(i) / static_cast<double>(ids.size()), ids[i].name);
    const bool by_part = ids[i].name == side_by_side_case;
    for (const auto* each : by_part ? pointers_to(side_by_side) : std::vector{part})
      if (auto ok = run_case(ids[i], device, each, run, report); !ok)
        return fail(ok.error());
  }
  report.milliseconds = clock.milliseconds();
  run.report(1, "done");
  return report;
}

result_text text_of(const case_result& r) {
  switch (r.kind) {
    case comparison::within:
      return {format_number("%.6g", r.target), format_number("%.6g", r.computed),
              format_number("%+.2g %%", 100 * r.relative_error),
              format_number("%.2g %%", 100 * r.tolerance)};
    case comparison::at_most:
      return {"<= " + format_number("%.3g", r.target), format_number("%.3g", r.computed), "", ""};
    case comparison::at_least:
      return {">= " + format_number("%.3g", r.target), format_number("%.3g", r.computed), "", ""};
    case comparison::refusal:
      break;
  }
  return {"refused", r.computed == 1 ? "refused" : "not refused", "", ""};
}

}  // namespace tedit::verification
