// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/solver/solve_output.hpp"

#include <algorithm>

#include "fem/fields.hpp"
#include "fem/make_report.hpp"

namespace tedit::actors {

namespace {

/// As precise as clients get it: half of each number is zeros then, which take no time on a slow
/// line (docs/decisions/0048).
void round_to_single(field& f) {
  auto values = f.values.to_vector();
  for (auto& value : values)
    value = static_cast<float>(value);
  f.values = paged_array<double>::from(values);
}

}  // namespace

job_output<solve_result> make_solve_output(const mesh_version& mesh, const fem::case_set& set,
                                           const fem::solved_cases& solved,
                                           const solve_facts& facts) {
  const auto range = facts.interim ? fem::field_range::shown : fem::field_range::all;
  auto outcome = make_outcome(mesh, set, solved, facts.interim, facts.total_ms);
  for (auto& report : outcome.cases)
    report.notice = facts.notice;
  job_output<solve_result> output;
  output.result.outcome = wire_value(std::move(outcome));
  auto fields = fem::make_fields(mesh, set, solved, range);
  if (facts.of_several && set.cases.size() == 1)
    for (auto& f : fields)
      f.name = fem::case_field(f.name, set.cases.front().name);
  if (facts.interim)
    std::ranges::for_each(fields, round_to_single);
  for (const auto& f : fields) {
    auto& list = fem::is_shown(f) ? output.result.fields : output.result.more;
    list.push_back(make_ref(f));
    const auto& pages = f.values.pages();
    output.pages.insert(output.pages.end(), pages.begin(), pages.end());
  }
  return output;
}

}  // namespace tedit::actors
