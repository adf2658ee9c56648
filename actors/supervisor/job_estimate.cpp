// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/job_estimate.hpp"

#include <string>

#include "actors/versions.hpp"

namespace tedit::actors {

namespace {

/// Bytes that a solve takes for each tet, and what each further load case adds to that
/// (bench/FIGURES.md, "One solve").
constexpr double linear_bytes = 650, quadratic_bytes = 2000, part_of_case = .3;

}  // namespace

job_estimate estimate(const import_order& order) {
  return {{"import", static_cast<double>(order.size)}};
}

job_estimate estimate(const edit_order& order) {
  const auto wanted = order.wanted.get();
  const auto operation = wanted ? (*wanted)->operation : std::string();
  return {{(order.preview ? "preview " : "edit ") + operation, tets_of(order.version)}};
}

job_estimate estimate(const export_order& order) {
  return {{"file " + order.format, tets_of(order.version)}};
}

job_estimate estimate(const select_order& order) {
  return {{"select", tets_of(order.version)}};
}

job_estimate estimate(const check_order& order) {
  return {{order.preview ? "check of a preview" : "check", tets_of(order.before)}};
}

job_estimate estimate(const solve_order& order) {
  const auto loads = order.load_cases.get();
  const auto cases = loads && !(*loads)->empty() ? static_cast<double>((*loads)->size()) : 1;
  const auto tets = tets_of(order.version);
  const auto bytes = order.element_order == 1 ? linear_bytes : quadratic_bytes;
  return {{"solve " + order.device + " " + std::to_string(order.element_order), tets * cases},
          tets * bytes * (1 + part_of_case * (cases - 1))};
}

}  // namespace tedit::actors
