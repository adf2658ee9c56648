// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/comparable.hpp"

#include <algorithm>

namespace tedit::desktop {

namespace {

/// Without what an edit may change: surfaces, and warnings about them.
fem::load_case bare(fem::load_case of) {
  for (auto& one : of.constraints) {
    one.surfaces.clear();
    one.warning.clear();
  }
  for (auto& one : of.loads) {
    one.surfaces.clear();
    one.warning.clear();
  }
  return of;
}

/// Whether the edit itself took away or moved some of its loads.
bool was_changed_by_edit(const version_record& version, const std::string& name) {
  return version.report && std::ranges::any_of(version.report->receipt, [&](const auto& line) {
           return line.load_case == name && line.fate != fem::receipt_fate::kept &&
                  line.fate != fem::receipt_fate::area_changed;
         });
}

}  // namespace

const solve_report* report_of(const solve_outcome& outcome, const std::string& name) {
  const auto found = std::ranges::find(outcome.cases, name, &solve_report::load_case);
  return found == outcome.cases.end() ? nullptr : &*found;
}

const fem::load_case* loads_of(const version_record& version, const std::string& name) {
  const auto found = std::ranges::find(version.load_cases, name, &fem::load_case::name);
  return found == version.load_cases.end() ? nullptr : &*found;
}

const solve_report* comparable_report(const solve_report& now, const version_record& version,
                                      const version_record* before) {
  const auto* was =
    before && before->outcome ? report_of(*before->outcome, now.load_case) : nullptr;
  if (!was || was->interim || was->element_order != now.element_order ||
      was->preview != now.preview)
    return nullptr;
  const auto* loads = loads_of(version, now.load_case);
  const auto* loads_before = loads_of(*before, now.load_case);
  const bool same = !loads || !loads_before || bare(*loads) == bare(*loads_before) ||
                    was_changed_by_edit(version, now.load_case);
  return same ? was : nullptr;
}

std::optional<solve_envelope> comparable_envelope(const solve_outcome& now,
                                                  const version_record& version,
                                                  const version_record* before) {
  if (!before || !before->outcome || !before->outcome->envelope || !now.envelope ||
      before->outcome->envelope->load_cases != now.envelope->load_cases)
    return std::nullopt;
  const bool all = std::ranges::all_of(
    now.cases, [&](const auto& one) { return comparable_report(one, version, before) != nullptr; });
  return all ? before->outcome->envelope : std::nullopt;
}

}  // namespace tedit::desktop
