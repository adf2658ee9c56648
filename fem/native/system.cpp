// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/system.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/guard.hpp"
#include "base/memory.hpp"
#include "base/stopwatch.hpp"
#include "fem/multilevel/multilevel_setup.hpp"
#include "fem/native/krylov.hpp"
#include "fem/native/quadratic_cycle.hpp"

namespace tedit::fem::native {

namespace {

/// What all solvers stand on.
struct system_parts {
  multilevel_setup setup;
  std::optional<quadratic_operator> quadratic;  ///< Without it, the matrix is that of the blocks.
  held_nodes held;

  [[nodiscard]] std::size_t rows() const {
    return quadratic ? quadratic->rows() : setup.blocks().rows();
  }
};

/// Conjugate gradients under a cycle, for as many cases at once as `L` is wide.
template <class L>
class case_solver {
public:
  /// `on` must outlive the solver.
  case_solver(const system_parts& on, const native_settings& settings)
      : on_(on),
        krylov_(on.rows(), on.held),
        corners_(on.setup.blocks(), on.setup.levels(),
                 on.quadratic ? settings.corner_cycle : settings.cycle) {
    if (on.quadratic)
      cycle_.emplace(*on.quadratic, on.setup.smoother(), on.setup.edges(), on.held, corners_,
                     settings.cycle.quadratic_degree);
  }

  /// After an update of what it stands on.
  void fit() {
    krylov_.fit(on_.rows());
    corners_.fit();
    if (cycle_)
      cycle_->fit();
  }

  expected<void> solve(std::span<const inner_case> cases, int max_iterations, const execution& run,
                       double& smallest, std::span<inner_result> results) {
    const auto under = [&](const auto& k, auto& cycle) {
      return krylov_.solve(
        k, [&](const float* r, float* z) { cycle.apply(r, z); }, cases, max_iterations, run,
        smallest, results);
    };
    return cycle_ ? under(*on_.quadratic, *cycle_) : under(on_.setup.blocks(), corners_);
  }

  [[nodiscard]] std::uint64_t bytes() const {
    return krylov_.bytes() + corners_.bytes() + (cycle_ ? cycle_->bytes() : 0);
  }

private:
  const system_parts& on_;
  krylov_solver<L> krylov_;
  multilevel_cycle<L> corners_;
  std::optional<quadratic_cycle<L>> cycle_;  ///< Over that of the corners.
};

template <class Operator>
void single_product(const Operator& k, const float* x, float* y) {
  for_rows(k, x, [y](std::size_t i, float4 row) { store3(row, y + 3 * i); });
}

class system final : public linear_system {
public:
  system(const problem& p, const native_settings& settings, const stopwatch& clock)
      : problem_(p),
        settings_(settings),
        on_{{p, p.element_order == 1 ? settings.multilevel : settings.corner_multilevel}, {}, {}} {
    if (p.element_order == 2)
      on_.quadratic.emplace(p);
    assembly_ms_ = clock.milliseconds();
  }

  expected<void> prepare(filter_span filter, const execution& run) {
    const auto product = [this](const float* x, float* y) -> expected<void> {
      single_product(*on_.quadratic, x, y);
      return {};
    };
    if (auto ok = on_.setup.prepare(filter, product, run); !ok)
      return ok;
    on_.held = held_nodes_of(filter);
    smallest_ = usual_smallest;
    solvers_ = {};
    return {};
  }

  expected<void> set_filter(filter_span filter) override {
    return guarded([&] { return prepare(filter, {}); });
  }

  expected<bool> update(const problem_change& change, const incidence& corners) override {
    if (!on_.setup.update(change, corners))
      return false;
    if (on_.quadratic)
      on_.quadratic->update(problem_, change.elements);
    on_.held = held_nodes_of(problem_.filter);
    std::apply([](const auto&... solver) { ((solver ? solver->fit() : void()), ...); }, solvers_);
    return true;
  }

  void distrust() override { on_.setup.raise_bounds(); }

  /// Up to eight cases share every read of the matrix, the hierarchy and the elements.
  expected<std::vector<inner_result>> solve_many(std::span<const inner_case> cases,
                                                 int max_iterations,
                                                 const execution& run) override {
    constexpr std::size_t widest = 8;
    std::vector<inner_result> results(cases.size());
    for (std::size_t first = 0; first < cases.size(); first += widest) {
      const auto count = std::min(widest, cases.size() - first);
      if (auto ok = solve_group(cases.subspan(first, count), max_iterations, run,
                                std::span(results).subspan(first, count));
          !ok)
        return fail(ok.error());
    }
    return results;
  }

  expected<void> multiply(std::span<const double> x, std::span<double> y) override {
    std::vector<float> from(padded3(on_.rows()));
    std::vector<float> to(from.size());
    std::ranges::transform(x, from.begin(), [](double v) { return static_cast<float>(v); });
    if (on_.quadratic)
      single_product(*on_.quadratic, from.data(), to.data());
    else
      single_product(on_.setup.blocks(), from.data(), to.data());
    std::copy_n(to.begin(), y.size(), y.begin());
    return {};
  }

  double assembly_ms() const override { return assembly_ms_; }

  std::uint64_t device_bytes() const override {
    const auto solvers = std::apply(
      [](const auto&... solver) { return ((solver ? solver->bytes() : std::uint64_t{0}) + ...); },
      solvers_);
    return on_.setup.bytes() + (on_.quadratic ? on_.quadratic->bytes() : 0) + solvers;
  }

private:
  expected<void> solve_group(std::span<const inner_case> cases, int max_iterations,
                             const execution& run, std::span<inner_result> results);

  /// One attempt at up to eight cases, on the narrowest solver that has room; results in their
  /// order.
  expected<void> attempt(std::span<const inner_case> cases, int max_iterations,
                         const execution& run, std::span<inner_result> results) {
    const auto on = [&]<class L>(L) {
      auto& solver = std::get<std::unique_ptr<case_solver<L>>>(solvers_);
      if (!solver)
        solver = std::make_unique<case_solver<L>>(on_, settings_);
      return solver->solve(cases, max_iterations, run, smallest_, results);
    };
    if (cases.size() == 1)
      return on(one_case{});
    return cases.size() <= 4 ? on(cases_of<4>{}) : on(cases_of<8>{});
  }

  const problem& problem_;
  native_settings settings_;
  system_parts on_;
  double assembly_ms_ = 0;
  double smallest_ = usual_smallest;  ///< At most the smallest eigenvalue of B K, as far as known.
  /// Made when first needed.
  std::tuple<std::unique_ptr<case_solver<one_case>>, std::unique_ptr<case_solver<cases_of<4>>>,
             std::unique_ptr<case_solver<cases_of<8>>>>
    solvers_;
};

/// Conjugate gradients break down where the cycle is not positive definite: then bounds are raised,
/// and the cases that got nowhere are tried again.
expected<void> system::solve_group(std::span<const inner_case> cases, int max_iterations,
                                   const execution& run, std::span<inner_result> results) {
  constexpr int most_attempts = 10;
  std::vector<inner_case> open(cases.begin(), cases.end());
  std::vector<std::size_t> place(cases.size());
  std::iota(place.begin(), place.end(), std::size_t{0});
  for (int attempt_number = 1; !open.empty(); ++attempt_number) {
    std::vector<inner_result> got(open.size());
    if (auto ok = guarded(run, [&] { return attempt(open, max_iterations, run, got); }); !ok)
      return ok;
    bool broke_down = false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      const int spent = results[place[i]].iterations + got[i].iterations;
      results[place[i]] = got[i];
      results[place[i]].iterations = spent;
      broke_down = broke_down || got[i].broke_down;
      // What there is counts; the next call goes on from there.
      if (!got[i].broke_down || got[i].recurrence_reduction < 0.5 ||
          attempt_number == most_attempts)
        continue;
      open[kept] = open[i];
      place[kept++] = place[i];
    }
    open.resize(kept);
    if (broke_down)
      distrust();
  }
  return {};
}

}  // namespace

expected<std::unique_ptr<linear_system>> make_system(const problem& p,
                                                     const native_settings& settings,
                                                     const execution& run) {
  const stopwatch clock;
  auto result = std::make_unique<system>(p, settings, clock);
  run.report(0.05, "preparing the preconditioner");
  if (auto ok = result->prepare(p.filter, run); !ok)
    return fail(ok.error());
  // Rows of coarse matrices were made by the ten thousand.
  return_freed_memory();
  return result;
}

}  // namespace tedit::fem::native
