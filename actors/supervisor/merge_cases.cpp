// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/merge_cases.hpp"

#include <algorithm>
#include <utility>

#include "actors/versions.hpp"
#include "fem/fields.hpp"
#include "fem/make_report.hpp"
#include "fem/quantities.hpp"

namespace tedit::actors {

namespace {

bool is_of_case(const field_ref& f) {
  return f.name.find(" (") != std::string::npos;
}

/// The values of one array of each case, in the order of the cases.
expected<std::vector<paged_array<double>>> values_of(const std::vector<field_ref>& arrays,
                                                     std::string_view name,
                                                     const std::vector<std::string>& load_cases,
                                                     const page_set& pages) {
  std::vector<paged_array<double>> result;
  for (const auto& load_case : load_cases) {
    const auto found =
      std::ranges::find(arrays, fem::case_field(name, load_case), &field_ref::name);
    if (found == arrays.end())
      continue;
    auto opened = open_field(*found, pages);
    if (!opened)
      return fail(opened.error());
    result.push_back(std::move(opened->values));
  }
  const auto other_size = [&](const auto& one) { return one.size() != result.front().size(); };
  if (!result.empty() &&
      (result.size() != load_cases.size() || std::ranges::any_of(result, other_size)))
    return fail(ec::protocol_error,
                "solvers sent arrays \"" + std::string(name) + "\" that do not belong together");
  return result;
}

/// The worst value at each place, and which case it is of.
std::pair<field, field> worst_of(const fem::envelope_names& names,
                                 const std::vector<paged_array<double>>& values, bool smallest) {
  auto worst = values.front().to_vector();
  std::vector<double> of(worst.size());
  for (std::size_t c = 1; c < values.size(); ++c)
    for (std::size_t i = 0; i < worst.size(); ++i) {
      const double value = values[c][i];
      if (smallest ? value < worst[i] : value > worst[i]) {
        worst[i] = value;
        of[i] = static_cast<double>(c);
      }
    }
  const auto made = [](std::string_view name, const std::vector<double>& all) {
    return field{std::string(name), field_location::vertex, 1, paged_array<double>::from(all)};
  };
  return {made(names.values, worst), made(names.cases, of)};
}

/// Errors: `protocol_error`.
expected<solve_outcome> merge_outcomes(std::span<const solve_result> parts,
                                       const std::vector<std::string>& load_cases) {
  solve_outcome outcome;
  for (const auto& name : load_cases) {
    const solve_report* found = nullptr;
    for (const auto& part : parts) {
      const auto said = part.outcome.get();
      if (!said)
        return fail(said.error());
      const auto& reports = (*said)->cases;
      const auto at = std::ranges::find(reports, name, &solve_report::load_case);
      found = at == reports.end() ? found : &*at;
    }
    if (!found)
      return fail(ec::protocol_error,
                  "no solver sent the result of the load case \"" + name + "\"");
    outcome.cases.push_back(*found);
  }
  outcome.envelope = make_envelope(outcome.cases);
  return outcome;
}

}  // namespace

std::vector<field_ref> arrays_of_cases(const solve_result& part) {
  std::vector<field_ref> result;
  std::ranges::copy_if(part.fields, std::back_inserter(result), is_of_case);
  return result;
}

expected<merged_cases> merge_cases(std::span<const solve_result> parts,
                                   const std::vector<std::string>& load_cases,
                                   const page_set& pages) {
  auto outcome = merge_outcomes(parts, load_cases);
  if (!outcome)
    return fail(outcome.error());
  merged_cases merged;
  merged.result.outcome = wire_value(std::move(*outcome));
  for (const auto& part : parts) {
    std::ranges::move(arrays_of_cases(part), std::back_inserter(merged.result.fields));
    std::ranges::copy(part.more, std::back_inserter(merged.result.more));
  }
  for (const auto& id : pages_of(merged.result.fields))
    if (auto p = pages.find(id))
      merged.pages.push_back(std::move(p));
  for (const auto& row : fem::result_arrays) {
    if (row.envelope.values.empty())
      continue;
    const auto values = values_of(merged.result.fields, row.name, load_cases, pages);
    if (!values)
      return fail(values.error());
    if (values->empty())
      continue;  // Without a yield strength there is no safety factor.
    const auto [worst, of] = worst_of(row.envelope, *values, row.needs_yield);
    for (const auto& one : {worst, of}) {
      merged.result.fields.push_back(make_ref(one));
      const auto& own = one.values.pages();
      merged.pages.insert(merged.pages.end(), own.begin(), own.end());
    }
  }
  return merged;
}

std::vector<load_case_list> spread_cases(const load_case_list& load_cases, std::size_t places) {
  load_case_list sorted;
  for (const auto& first : load_cases)
    for (const auto& one : load_cases)
      if (one.constraints == first.constraints &&
          std::ranges::count(sorted, one.name, &fem::load_case::name) == 0)
        sorted.push_back(one);
  const auto count = std::clamp<std::size_t>(places, 1, sorted.size());
  std::vector<load_case_list> result(count);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    result[i * count / sorted.size()].push_back(sorted[i]);
  return result;
}

}  // namespace tedit::actors
