// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/stopwatch.hpp"
#include "fem/solver.hpp"
#include "verification/suite.hpp"

/// What cases are written with; not for callers of the suite.
namespace tedit::verification {

/// Hands a case its device and order, and collects its figures.
class case_context {
public:
  case_context(std::string name, std::string source, int order, fem::backend& device,
               const real_part* part, const execution& run, suite_report& report)
      : name_(std::move(name)),
        source_(std::move(source)),
        order_(order),
        device_(device),
        part_(part),
        run_(run),
        report_(report) {}

  [[nodiscard]] int order() const { return order_; }
  [[nodiscard]] bool linear() const { return order_ == 1; }
  [[nodiscard]] const real_part& part() const { return *part_; }

  /// True when stresses of linear tets come in double precision.
  [[nodiscard]] bool double_precision_stress() const { return device_.info().kind == "native"; }

  /// Solves on the case's device; figures that follow carry its elements and time.
  [[nodiscard]] expected<fem::solution> solve(const fem::problem& p, double tolerance = 1e-9);

  /// `fem::make_problem` of the case's order, then `solve`.
  struct solved {
    fem::problem problem;
    fem::solution solution;
  };
  [[nodiscard]] expected<solved> solve(const mesh_version& mesh, const fem::load_case& loads,
                                       double tolerance = 1e-9);

  // -- figures -----------------------------------------------------------------

  void within(const std::string& quantity, double target, double computed, double tolerance);
  void at_most(const std::string& quantity, double bound, double computed);
  void at_least(const std::string& quantity, double bound, double computed);

  /// Passes when `result` failed with `code` and says why.
  template <class T>
  void refusal(const std::string& what, ec code, const expected<T>& result) {
    add_refusal(what, code, result ? nullptr : &result.error());
  }

  void add_convergence(convergence_row row);

  /// The times of both solves are filled in here.
  void add_side_by_side(side_by_side_row row, double other_milliseconds);

  /// Names the case among what was left out, once for each reason.
  void leave_out(const std::string& why);

  /// For work that a case does outside of `solve`: obeys a cancel.
  [[nodiscard]] execution silent_execution() const;

private:
  void add(const std::string& quantity, comparison kind, double target, double computed,
           double tolerance, bool passed);
  void add_refusal(const std::string& what, ec code, const error* e);

  std::string name_;
  std::string source_;
  int order_;
  fem::backend& device_;
  const real_part* part_;
  const execution& run_;
  suite_report& report_;
  std::size_t elements_ = 0;
  double milliseconds_ = 0;
};

struct case_entry {
  std::string name;
  std::string source;
  std::string about;  ///< One sentence for people.
  std::vector<int> orders;
  expected<void> (*run)(case_context& c);
  bool needs_part = false;
};

[[nodiscard]] std::vector<case_entry> exact_cases();
[[nodiscard]] std::vector<case_entry> beam_cases();
[[nodiscard]] std::vector<case_entry> flexure_cases();
[[nodiscard]] std::vector<case_entry> ring_cases();
[[nodiscard]] std::vector<case_entry> nafems_cases();
[[nodiscard]] std::vector<case_entry> convergence_cases();
[[nodiscard]] std::vector<case_entry> invariance_cases();
[[nodiscard]] std::vector<case_entry> calculix_cases();
[[nodiscard]] std::vector<case_entry> refusal_cases();

/// A load case of one material (Pa, -, kg/m^3) without supports and loads.
[[nodiscard]] fem::load_case with_material(double young_modulus, double poisson_ratio,
                                           double density = 0);

/// Symmetry about a coordinate plane: the component along `axis` (0 to 2) is zero.
[[nodiscard]] fem::constraint symmetry(surface_id surface, int axis);

/// The problem of a material on a mesh without any condition: for cases that set their own.
[[nodiscard]] expected<fem::problem> bare_problem(const mesh_version& mesh,
                                                  const fem::load_case& material, int order);

}  // namespace tedit::verification
