// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/system.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/guard.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "fem/element.hpp"
#include "fem/multilevel/lanczos.hpp"
#include "fem/native/krylov.hpp"
#include "fem/native/quadratic_cycle.hpp"

namespace tedit::fem::native {

namespace {

/// A system whose matrix is never asked for outside: what linear and quadratic tets share.
class system : public linear_system {
public:
  system(const problem& p, const native_settings& settings) : problem_(p), settings_(settings) {}

  expected<inner_result> solve(const inner_case& one, int max_iterations,
                               const execution& run) override {
    inner_result result;
    if (auto ok = solve_group({&one, 1}, max_iterations, run, {&result, 1}); !ok)
      return fail(ok.error());
    return result;
  }

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

  double assembly_ms() const override { return assembly_ms_; }

protected:
  /// One attempt at up to eight cases; results in their order.
  virtual expected<void> attempt(std::span<const inner_case> cases, int max_iterations,
                                 const execution& run, std::span<inner_result> results) = 0;

  template <class Operator>
  expected<void> multiply_by(const Operator& k, std::span<const double> x, std::span<double> y) {
    std::vector<float> single(padded3(k.rows()));
    std::ranges::transform(x, single.begin(), [](double v) { return static_cast<float>(v); });
    for_rows(k, single.data(), [&](std::size_t i, float4 row) {
      for (int c = 0; c < 3; ++c)
        y[3 * i + c] = static_cast<double>(row[c]);
    });
    return {};
  }

  const problem& problem_;
  native_settings settings_;
  held_nodes held_;
  double assembly_ms_ = 0;
  double smallest_ = usual_smallest;  ///< At most the smallest eigenvalue of B K, as far as known.

private:
  expected<void> solve_group(std::span<const inner_case> cases, int max_iterations,
                             const execution& run, std::span<inner_result> results);
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

/// Solvers for one, four and eight cases; those for several are made when first needed.
template <template <class> class Solver>
class lane_solvers {
public:
  void reset() { solvers_ = {}; }

  /// After an update of what they stand on.
  void fit() {
    std::apply([](const auto&... solver) { ((solver ? solver->fit() : void()), ...); }, solvers_);
  }

  /// At most eight cases on the narrowest solver that has room; `make(lane type)` makes it.
  template <class Operator, class Make>
  expected<void> solve(const Operator& k, const Make& make, std::span<const inner_case> cases,
                       int max_iterations, const execution& run, double& smallest,
                       std::span<inner_result> results) {
    const auto on = [&]<class L>(L lanes) {
      auto& solver = std::get<std::unique_ptr<Solver<L>>>(solvers_);
      if (!solver)
        solver = make(lanes);
      return solver->krylov.solve(
        k, [&](const float* r, float* z) { solver->cycle.apply(r, z); }, cases, max_iterations, run,
        smallest, results);
    };
    if (cases.size() == 1)
      return on(one_case{});
    return cases.size() <= 4 ? on(cases_of<4>{}) : on(cases_of<8>{});
  }

  [[nodiscard]] std::uint64_t bytes() const {
    return std::apply(
      [](const auto&... solver) { return ((solver ? solver->bytes() : std::uint64_t{0}) + ...); },
      solvers_);
  }

private:
  std::tuple<std::unique_ptr<Solver<one_case>>, std::unique_ptr<Solver<cases_of<4>>>,
             std::unique_ptr<Solver<cases_of<8>>>>
    solvers_;
};

template <class L>
struct linear_solver {
  const block_matrix& k;
  krylov_solver<L> krylov;
  multilevel_cycle<L> cycle;

  linear_solver(const block_matrix& matrix, const hierarchy& h, const held_nodes& held,
                const cycle_settings& settings)
      : k(matrix), krylov(k.rows(), held), cycle(k, h, settings) {}

  void fit() {
    krylov.fit(k.rows());
    cycle.fit();
  }

  [[nodiscard]] std::uint64_t bytes() const { return krylov.bytes() + cycle.bytes(); }
};

/// Linear tets: an assembled matrix under a multilevel cycle.
class linear_tets final : public system {
public:
  linear_tets(const problem& p, const native_settings& settings, const stopwatch& clock)
      : system(p, settings), k_(assemble_blocks(p, incidence(p))) {
    assembly_ms_ = clock.milliseconds();
  }

  expected<void> prepare(filter_span filter, const execution& run) {
    auto built = build_hierarchy(problem_, k_, filter, settings_.multilevel, run);
    if (!built)
      return fail(built.error());
    hierarchy_ = std::move(*built);
    held_ = held_nodes_of(filter);
    smallest_ = usual_smallest;
    solvers_.reset();
    return {};
  }

  expected<void> set_filter(filter_span filter) override {
    return guarded([&] { return prepare(filter, {}); });
  }

  expected<bool> update(const problem_change& change, const incidence& corners) override {
    if (k_.places.crowded() || hierarchy_.crowded())
      return false;
    update_blocks(problem_, corners, change.nodes, k_);
    if (!update_hierarchy(problem_, corners, k_, problem_.filter, change.nodes,
                          settings_.multilevel, hierarchy_))
      return false;
    held_ = held_nodes_of(problem_.filter);
    solvers_.fit();
    return true;
  }

  void distrust() override { raise_lambdas(hierarchy_); }

  expected<void> multiply(std::span<const double> x, std::span<double> y) override {
    return multiply_by(k_, x, y);
  }

  std::uint64_t device_bytes() const override {
    return k_.bytes() + hierarchy_.bytes() + solvers_.bytes();
  }

private:
  expected<void> attempt(std::span<const inner_case> cases, int max_iterations,
                         const execution& run, std::span<inner_result> results) override {
    const auto make = [this]<class L>(L) {
      return std::make_unique<linear_solver<L>>(k_, hierarchy_, held_, settings_.cycle);
    };
    return solvers_.solve(k_, make, cases, max_iterations, run, smallest_, results);
  }

  block_matrix k_;
  hierarchy hierarchy_;
  lane_solvers<linear_solver> solvers_;
};

template <class L>
struct quadratic_solver {
  const quadratic_operator& k;
  krylov_solver<L> krylov;
  multilevel_cycle<L> corners;
  quadratic_cycle<L> cycle;

  quadratic_solver(const quadratic_operator& elements, const node_smoother& smoother,
                   const edge_transfer& edges, const block_matrix& corner_matrix,
                   const hierarchy& h, const held_nodes& held, const native_settings& settings)
      : k(elements),
        krylov(k.rows(), held),
        corners(corner_matrix, h, settings.corner_cycle),
        cycle(k, smoother, edges, held, corners, settings.cycle.quadratic_degree) {}

  void fit() {
    krylov.fit(k.rows());
    corners.fit();
    cycle.fit();
  }

  [[nodiscard]] std::uint64_t bytes() const {
    return krylov.bytes() + corners.bytes() + cycle.bytes();
  }
};

/// Quadratic tets: element by element, under a cycle over the linear tets of the corners.
class quadratic_tets final : public system {
public:
  quadratic_tets(const problem& p, const native_settings& settings, const stopwatch& clock)
      : system(p, settings), k_(p), corner_matrix_(assemble_blocks(p, incidence(p, 4))) {
    assembly_ms_ = clock.milliseconds();
  }

  expected<void> prepare(filter_span filter, const execution& run) {
    auto built = build_hierarchy(problem_, corner_matrix_, filter.first(corner_matrix_.rows()),
                                 settings_.corner_multilevel, run);
    if (!built)
      return fail(built.error());
    hierarchy_ = std::move(*built);
    edges_ = make_edge_transfer(problem_);
    const auto clusters = cluster_slivers(problem_, wholly_held(filter), 100,
                                          settings_.corner_multilevel.sliver_condition);
    smoother_ = make_quadratic_smoother(problem_, filter, clusters);
    cluster_of_ = clusters.of;
    smoother_.lambda =
      settings_.corner_multilevel.lambda_safety *
      largest_ritz_value(
        problem_.dofs(), 1, settings_.corner_multilevel.lambda_steps,
        [this](const float* x, float* y) {
          for_rows(k_, x, [y](std::size_t i, float4 row) { store3(row, y + 3 * i); });
        },
        [this](const float* x, float* y) { apply_inverse(smoother_, 1, x, y); });
    held_ = held_nodes_of(filter);
    smallest_ = usual_smallest;
    solvers_.reset();
    return {};
  }

  expected<void> set_filter(filter_span filter) override {
    return guarded([&] { return prepare(filter, {}); });
  }

  expected<bool> update(const problem_change& change, const incidence& corners) override {
    if (corner_matrix_.places.crowded() || hierarchy_.crowded() || edges_.middles.places.crowded())
      return false;
    const filter_span filter = problem_.filter;
    const auto middles =
      std::ranges::lower_bound(change.nodes, static_cast<std::uint32_t>(problem_.corner_count));
    const std::span corner_nodes(change.nodes.begin(), middles);
    k_.update(problem_, change.elements);
    update_blocks(problem_, corners, corner_nodes, corner_matrix_);
    if (!update_hierarchy(problem_, corners, corner_matrix_, filter.first(corner_matrix_.rows()),
                          corner_nodes, settings_.corner_multilevel, hierarchy_))
      return false;
    update_edge_transfer(problem_, edges_);
    update_quadratic_smoother(problem_, corners, filter, change.nodes, settings_.corner_multilevel,
                              cluster_of_, smoother_);
    held_ = held_nodes_of(filter);
    solvers_.fit();
    return true;
  }

  void distrust() override {
    raise_lambda(smoother_, 10);
    raise_lambdas(hierarchy_);
  }

  expected<void> multiply(std::span<const double> x, std::span<double> y) override {
    return multiply_by(k_, x, y);
  }

  std::uint64_t device_bytes() const override {
    return k_.bytes() + corner_matrix_.bytes() + hierarchy_.bytes() + solvers_.bytes() +
           24 * smoother_.inverse.size();
  }

private:
  expected<void> attempt(std::span<const inner_case> cases, int max_iterations,
                         const execution& run, std::span<inner_result> results) override {
    const auto make = [this]<class L>(L) {
      return std::make_unique<quadratic_solver<L>>(k_, smoother_, edges_, corner_matrix_,
                                                   hierarchy_, held_, settings_);
    };
    return solvers_.solve(k_, make, cases, max_iterations, run, smallest_, results);
  }

  quadratic_operator k_;
  block_matrix corner_matrix_;
  hierarchy hierarchy_;
  edge_transfer edges_;
  node_smoother smoother_;
  std::vector<std::uint32_t> cluster_of_;  ///< Sliver cluster of each node; empty: there are none.
  lane_solvers<quadratic_solver> solvers_;
};

template <class System>
expected<std::unique_ptr<linear_system>> made(const problem& p, const native_settings& settings,
                                              const execution& run) {
  const stopwatch clock;
  auto result = std::make_unique<System>(p, settings, clock);
  run.report(0.05, "preparing the preconditioner");
  if (auto ok = result->prepare(p.filter, run); !ok)
    return fail(ok.error());
  // Rows of coarse matrices were made by the ten thousand.
  return_freed_memory();
  return result;
}

}  // namespace

expected<std::unique_ptr<linear_system>> make_system(const problem& p,
                                                     const native_settings& settings,
                                                     const execution& run) {
  return p.element_order == 1 ? made<linear_tets>(p, settings, run)
                              : made<quadratic_tets>(p, settings, run);
}

}  // namespace tedit::fem::native
