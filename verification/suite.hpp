// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fem/kernels.hpp"
#include "fem/load_case.hpp"

/// The finite element solver against closed solutions and published benchmarks. The command
/// `tedit verify --suite` and the tests run the same cases.
namespace tedit::verification {

/// What a figure has to satisfy.
enum class comparison {
  within,    ///< |computed - target| <= tolerance |target|.
  at_most,   ///< computed <= target.
  at_least,  ///< computed >= target.
  refusal,   ///< The input is refused with the right error: computed is 1 when it is, else 0.
};

/// One figure of one case. Quantities are in SI units or, where the source has none, in the
/// source's own consistent units.
struct case_result {
  std::string name;
  std::string source;  ///< Where the target comes from.
  int element_order = 1;
  std::string device;
  std::size_t elements = 0;
  std::string quantity;
  comparison kind = comparison::within;
  double target = 0;
  double computed = 0;
  double relative_error = 0;  ///< computed / target - 1; 0 unless `kind` is `within`.
  double tolerance = 0;       ///< Of the relative error; 0 unless `kind` is `within`.
  bool passed = false;
  double milliseconds = 0;  ///< Of the solve that gave the figure.
};

/// One mesh of the convergence study.
struct convergence_row {
  int element_order = 1;
  std::size_t elements = 0;
  double size = 0;          ///< Edge length of a cell (six tets), m.
  double l2_error = 0;      ///< Relative.
  double energy_error = 0;  ///< Relative, energy norm.
  double l2_rate = 0;       ///< Against the row before; 0 for the first one of an order.
  double energy_rate = 0;
};

/// A real part solved by us and by CalculiX. Differences are relative: of the displacement to the
/// largest one, of reactions to the sum of all surfaces' magnitudes.
struct side_by_side_row {
  std::string part;
  int element_order = 1;
  std::size_t elements = 0;
  std::size_t nodes = 0;
  double displacement = 0;      ///< The largest difference at a node.
  double reaction = 0;          ///< Of the sum of all reactions.
  double surface_reaction = 0;  ///< The largest difference of a surface.
  double compliance = 0;
  double milliseconds = 0;        ///< Our solve.
  double other_milliseconds = 0;  ///< The other program's run, files included.
  std::string program;            ///< The other program and its version.
};

/// What was not run, and why.
struct left_out_case {
  std::string what;
  std::string why;

  friend bool operator==(const left_out_case&, const left_out_case&) = default;
};

/// A real part with a load case: what the invariances and the side by side are run on.
struct real_part {
  std::string name;
  version_ptr mesh;
  fem::load_case loads;
};

struct suite_report {
  std::string device;
  std::vector<case_result> results;
  std::vector<convergence_row> convergence;
  std::vector<side_by_side_row> side_by_side;
  std::vector<left_out_case> left_out;
  double milliseconds = 0;

  [[nodiscard]] bool passed() const;
  [[nodiscard]] std::size_t failures() const;
};

/// What a case is about, for people.
struct case_description {
  std::string name;
  std::string source;
  std::string about;  ///< One sentence.
};

/// All cases, in the order in which they run.
[[nodiscard]] std::vector<case_description> describe_cases();

/// The case that needs the program `ccx` and takes minutes on all parts.
inline constexpr auto side_by_side_case = "side by side with CalculiX";

/// A case for one element order.
struct case_id {
  std::string name;
  int element_order = 1;
};

/// All cases, in the order in which they run.
[[nodiscard]] std::vector<case_id> list_cases();

/// Runs one case and adds what it gives to `report`. An error of the solver is a failed result, not
/// an error of this call. Errors: `not_found` for an unknown case; `cancelled`.
[[nodiscard]] expected<void> run_case(const case_id& id, fem::backend& device,
                                      const real_part* part, const execution& run,
                                      suite_report& report);

/// Runs all cases that the device can do; the others are named in `left_out`, and so are the
/// invariances when `part` is null. Side by side with CalculiX come the parts of `side_by_side`, in
/// both orders. Errors: `cancelled`. Cost: about ten seconds on two cores; CalculiX takes up to
/// 20 s for 20 000 quadratic tets.
[[nodiscard]] expected<suite_report> run_suite(fem::backend& device, const real_part* part,
                                               const execution& run,
                                               std::span<const real_part> side_by_side = {});

/// The target, the computed figure, the error and the tolerance as text; empty where a kind of
/// comparison has none.
struct result_text {
  std::string target;
  std::string computed;
  std::string error;
  std::string tolerance;
};
[[nodiscard]] result_text text_of(const case_result& result);

}  // namespace tedit::verification
