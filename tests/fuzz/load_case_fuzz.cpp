// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "fem/fields.hpp"
#include "fem/load_cases.hpp"
#include "fem/make_report.hpp"
#include "fem/native/backend.hpp"
#include "protocol/convert.hpp"
#include "protocol/load_case_message.hpp"
#include "tedit/v1/load_case.pb.h"
#include "tests/support/blocks.hpp"

namespace {

using namespace tedit;

/// A broken promise counts as a crash, so that libFuzzer keeps the input.
void require(bool holds, const char* promise, const std::string& detail = {}) {
  if (holds)
    return;
  std::fprintf(stderr, "load_case_fuzz: broken promise: %s %s\n", promise, detail.c_str());
  std::abort();
}

/// A bar of 2 x 1 x 1 mm with surfaces 1 to 6, some dozen tets.
const mesh_version& part() {
  static const auto made = test::blocks(
    {2, 1, 1}, [](int, int, int) { return true; }, [](vec3 p) { return 1e-3 * p; });
  return *made;
}

/// Fields are sent in single precision.
constexpr double most = std::numeric_limits<float>::max();

/// All numbers of a load.
std::vector<vec3> vectors_of(const fem::load& item) {
  struct collect {
    std::vector<vec3> operator()(const fem::force& f) const { return {f.total_n}; }
    std::vector<vec3> operator()(const fem::traction& t) const { return {t.pa}; }
    std::vector<vec3> operator()(const fem::gravity& g) const { return {g.m_s2}; }
    std::vector<vec3> operator()(const fem::moment& m) const { return {m.total_nm}; }
    std::vector<vec3> operator()(const fem::bearing_force& f) const { return {f.total_n}; }
    std::vector<vec3> operator()(const fem::normal_force& f) const { return {{f.total_n, 0, 0}}; }
    std::vector<vec3> operator()(const fem::remote_force& f) const {
      return {f.total_n, f.at_m, f.moment_nm};
    }
    std::vector<vec3> operator()(const fem::pressure& p) const {
      return {{p.pa, 0, 0}, p.gradient_pa_m, p.at_m};
    }
  };
  return std::visit(collect{}, item.kind);
}

/// Zero would be a wrong answer to a load that is no number, and look right.
void check_accepted(const fem::load_case& loads) {
  for (const auto& item : loads.loads)
    for (const auto& one : vectors_of(item))
      require(is_finite(one), "a load that is accepted is a number");
  for (const auto& item : loads.constraints)
    if (const auto* d = std::get_if<fem::prescribed_displacement>(&item.kind))
      require(is_finite({d->x_m.value_or(0), d->y_m.value_or(0), d->z_m.value_or(0)}),
              "a displacement that is accepted is a number");
}

void check_result(const fem::case_set& set, const fem::solved_cases& solved) {
  for (const auto& f : fem::make_fields(part(), set, solved, fem::field_range::all))
    for (std::size_t i = 0; i < f.values.size(); ++i)
      require(std::abs(f.values[i]) <= most, "every value of a field is a number", f.name);
  const auto report = make_outcome(part(), set, solved, false, 0).cases.front();
  for (const double value :
       {report.max_displacement_m, report.max_von_mises_pa, report.compliance_j,
        report.strain_energy_j, report.relative_error_estimate, report.true_relative_residual,
        report.min_safety_factor.value_or(0), report.mass_kg.value_or(0)})
    require(std::abs(value) <= most, "every number of a report is one");
  require(is_finite(report.reaction_n) && is_finite(report.applied_n),
          "reactions and loads are numbers");
}

void check_refused(const error& failure) {
  require(!failure.message.empty(), "a refusal says why");
  require(failure.code != ec::internal, "a refusal is no defect:", render(failure));
}

/// On linear and quadratic tets.
void solve(const fem::load_case& loads) {
  for (const int order : {1, 2}) {
    auto set = fem::make_cases(part(), std::span(&loads, 1), order);
    if (!set) {
      check_refused(set.error());
      continue;
    }
    const auto solved = fem::solve_cases(*set, *fem::make_native_backend(), {}, {});
    if (solved)
      check_result(*set, *solved);
    else
      check_refused(solved.error());
  }
}

}  // namespace

/// Takes the bytes as a load case's file, else as the message that a client sends, and solves it on
/// a small bar: it must be refused with a reason, or every number of the result is finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  auto loads = protocol::load_case_from_json(bytes, "file");
  v1::LoadCase message;
  if (!loads && message.ParseFromString(bytes))
    loads = protocol::from_message(message);
  if (!loads) {
    check_refused(loads.error());
    return 0;
  }
  check_accepted(*loads);
  solve(*loads);
  return 0;
}
