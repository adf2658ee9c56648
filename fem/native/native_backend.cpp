// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/native/native_backend.hpp"

#include <algorithm>
#include <optional>
#include <thread>

#include "base/guard.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "fem/element.hpp"
#include "fem/multilevel/lanczos.hpp"
#include "fem/native/conjugate_gradients.hpp"
#include "fem/native/memory_estimate.hpp"
#include "fem/native/quadratic_cycle.hpp"

namespace tedit::fem {

namespace {

/// A system whose matrix is never asked for outside: what linear and quadratic tets share.
class native_system : public linear_system {
public:
  native_system(const problem& p, const native_settings& settings)
      : problem_(p), settings_(settings), krylov_(p.node_count()) {}

  expected<void> element_stress(std::span<const double> displacement,
                                std::span<double> stress) override;
  expected<void> nodal_stress(std::span<const double> element_stress,
                              std::span<double> nodal) override;

  double assembly_ms() const override { return assembly_ms_; }

protected:
  /// Conjugate gradients on K x = residual under `cycle`. Breaks down where the cycle is not
  /// positive definite: then bounds are raised, and what got nowhere is tried again.
  template <class Operator, class Cycle>
  expected<inner_result> solve_by(const Operator& k, Cycle& cycle, std::span<const double> residual,
                                  std::span<double> correction, double reduction,
                                  int max_iterations, const execution& run) {
    constexpr int most_attempts = 10;
    int spent = 0;
    for (int attempt = 1;; ++attempt) {
      auto result = krylov_.solve(
        k, [&cycle](const float* r, float* z) { cycle.apply(r, z); }, residual, correction,
        reduction, max_iterations, run);
      if (!result)
        return result;
      spent += result->iterations;
      result->iterations = spent;
      if (!result->broke_down)
        return result;
      distrust();
      // What there is counts; the next call goes on from there.
      if (result->recurrence_reduction < 0.5 || attempt == most_attempts)
        return result;
    }
  }

  template <class Operator>
  expected<void> multiply_by(const Operator& k, std::span<const double> x, std::span<double> y) {
    std::vector<float> single(padded3(k.rows()));
    std::ranges::transform(x, single.begin(), [](double v) { return static_cast<float>(v); });
    for_rows(k, single.data(), [&](std::size_t i, float4 row) {
      for (int c = 0; c < 3; ++c)
        y[3 * i + c] = static_cast<double>(row[c]);
      return 0.0F;
    });
    return {};
  }

  const problem& problem_;
  native_settings settings_;
  conjugate_gradients krylov_;
  double assembly_ms_ = 0;
};

/// Linear tets: an assembled matrix under a multilevel cycle.
class linear_tets final : public native_system {
public:
  linear_tets(const problem& p, const native_settings& settings, const stopwatch& clock)
      : native_system(p, settings), k_(assemble_blocks(p, incidence(p))) {
    assembly_ms_ = clock.milliseconds();
  }

  expected<void> prepare(filter_span filter, const execution& run) {
    auto built = build_hierarchy(problem_, k_, filter, settings_.multilevel, run);
    if (!built)
      return fail(built.error());
    hierarchy_ = std::move(*built);
    cycle_.emplace(k_, hierarchy_, settings_.cycle);
    krylov_.set_filter(filter);
    return {};
  }

  expected<void> set_filter(filter_span filter) override {
    return guarded([&] { return prepare(filter, {}); });
  }

  expected<bool> update(const problem_change& change, const incidence& corners) override {
    if (k_.places.crowded() || hierarchy_.crowded())
      return false;
    update_blocks(problem_, corners, change.nodes, k_);
    update_hierarchy(problem_, corners, k_, problem_.filter, change.nodes, settings_.multilevel,
                     hierarchy_);
    cycle_.emplace(k_, hierarchy_, settings_.cycle);
    krylov_.resize(problem_.node_count());
    krylov_.set_filter(problem_.filter);
    return true;
  }

  void distrust() override { raise_lambdas(hierarchy_); }

  expected<inner_result> solve(std::span<const double> residual, std::span<double> correction,
                               double reduction, int max_iterations,
                               const execution& run) override {
    return guarded(run, [&] {
      return solve_by(k_, *cycle_, residual, correction, reduction, max_iterations, run);
    });
  }

  expected<void> multiply(std::span<const double> x, std::span<double> y) override {
    return multiply_by(k_, x, y);
  }

  std::uint64_t device_bytes() const override {
    return k_.bytes() + hierarchy_.bytes() + krylov_.bytes() +
           3 * sizeof(float) * padded3(k_.rows());
  }

private:
  block_matrix k_;
  hierarchy hierarchy_;
  std::optional<multilevel_cycle> cycle_;
};

/// Quadratic tets: element by element, under a cycle over the linear tets of the corners.
class quadratic_tets final : public native_system {
public:
  quadratic_tets(const problem& p, const native_settings& settings, const stopwatch& clock)
      : native_system(p, settings), k_(p), corner_matrix_(assemble_blocks(p, incidence(p, 4))) {
    assembly_ms_ = clock.milliseconds();
  }

  expected<void> prepare(filter_span filter, const execution& run) {
    auto built = build_hierarchy(problem_, corner_matrix_, filter.first(corner_matrix_.rows()),
                                 settings_.corner_multilevel, run);
    if (!built)
      return fail(built.error());
    hierarchy_ = std::move(*built);
    edges_ = make_edge_transfer(problem_, filter);
    const auto clusters =
      cluster_slivers(problem_, edges_.held, 100, settings_.corner_multilevel.sliver_condition);
    smoother_ = make_quadratic_smoother(problem_, filter, clusters);
    cluster_of_ = clusters.of;
    smoother_.lambda = settings_.corner_multilevel.lambda_safety *
                       largest_ritz_value(
                         problem_.dofs(), 1, settings_.corner_multilevel.lambda_steps,
                         [this](const float* x, float* y) {
                           for_rows(k_, x, [y](std::size_t i, float4 row) {
                             store3(row, y + 3 * i);
                             return 0.0F;
                           });
                         },
                         [this](const float* x, float* y) { apply_inverse(smoother_, 1, x, y); });
    make_cycle();
    krylov_.set_filter(filter);
    return {};
  }

  expected<void> set_filter(filter_span filter) override {
    return guarded([&] { return prepare(filter, {}); });
  }

  expected<bool> update(const problem_change& change, const incidence& corners) override {
    if (corner_matrix_.places.crowded() || hierarchy_.crowded() || edges_.middles.places.crowded())
      return false;
    const filter_span filter = problem_.filter;
    const auto middles = std::ranges::lower_bound(change.nodes, problem_.corner_count);
    const std::span corner_nodes(change.nodes.begin(), middles);
    k_.update(problem_, change.elements);
    update_blocks(problem_, corners, corner_nodes, corner_matrix_);
    update_hierarchy(problem_, corners, corner_matrix_, filter.first(corner_matrix_.rows()),
                     corner_nodes, settings_.corner_multilevel, hierarchy_);
    update_edge_transfer(problem_, filter, change.nodes, edges_);
    update_quadratic_smoother(problem_, corners, filter, change.nodes,
                              settings_.corner_multilevel.sliver_condition, cluster_of_, smoother_);
    make_cycle();
    krylov_.resize(problem_.node_count());
    krylov_.set_filter(filter);
    return true;
  }

  void distrust() override {
    raise_lambda(smoother_, 10);
    raise_lambdas(hierarchy_);
  }

  expected<inner_result> solve(std::span<const double> residual, std::span<double> correction,
                               double reduction, int max_iterations,
                               const execution& run) override {
    return guarded(run, [&] {
      return solve_by(k_, *cycle_, residual, correction, reduction, max_iterations, run);
    });
  }

  expected<void> multiply(std::span<const double> x, std::span<double> y) override {
    return multiply_by(k_, x, y);
  }

  std::uint64_t device_bytes() const override {
    return k_.bytes() + corner_matrix_.bytes() + hierarchy_.bytes() + krylov_.bytes() +
           3 * sizeof(float) * (padded3(k_.rows()) + padded3(corner_matrix_.rows())) +
           24 * smoother_.inverse.size();
  }

private:
  void make_cycle() {
    corner_cycle_.emplace(corner_matrix_, hierarchy_, settings_.corner_cycle);
    cycle_.emplace(k_, smoother_, edges_, *corner_cycle_, settings_.cycle.quadratic_degree);
  }

  quadratic_operator k_;
  block_matrix corner_matrix_;
  hierarchy hierarchy_;
  edge_transfer edges_;
  node_smoother smoother_;
  std::vector<std::uint32_t> cluster_of_;  ///< Sliver cluster of each node; empty: there are none.
  std::optional<multilevel_cycle> corner_cycle_;
  std::optional<quadratic_cycle> cycle_;
};

expected<void> native_system::element_stress(std::span<const double> displacement,
                                             std::span<double> stress) {
  const auto& p = problem_;
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) {
      const auto g = gradients_of(p, e);
      const auto s = stress_of(displacement_gradient(p, e, g, displacement.data()),
                               p.constants[p.element_materials[e]]);
      std::ranges::copy(s, stress.begin() + static_cast<std::ptrdiff_t>(6 * e));
    }
  });
  return {};
}

expected<void> native_system::nodal_stress(std::span<const double> element_stress,
                                           std::span<double> nodal) {
  const auto& p = problem_;
  const incidence corners(p);
  parallel_for(p.node_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      std::array<double, 6> sum{};
      double volume = 0;
      for (const auto corner : corners.of_node(n)) {
        const std::size_t e = corner / 4;
        const double v = gradients_of(p, e).volume;
        volume += v;
        for (int c = 0; c < 6; ++c)
          sum[c] += v * element_stress[6 * e + c];
      }
      for (int c = 0; c < 6; ++c)
        nodal[6 * n + c] = sum[c] / volume;
    }
  });
  return {};
}

class native_backend final : public backend {
public:
  explicit native_backend(const native_settings& settings) : settings_(settings) {
    info_.name = "cpu";
    info_.kind = "native";
    info_.driver = std::to_string(std::max(1u, std::thread::hardware_concurrency())) + " threads";
  }

  const device_info& info() const override { return info_; }

  expected<std::unique_ptr<linear_system>> assemble(const problem& p,
                                                    const execution& run) override {
    const stopwatch clock;
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    if (auto ok = check_room(p); !ok)
      return fail(ok.error());
    return guarded(run, [&] {
      return p.element_order == 1 ? make<linear_tets>(p, clock, run)
                                  : make<quadratic_tets>(p, clock, run);
    });
  }

private:
  template <class System>
  expected<std::unique_ptr<linear_system>> make(const problem& p, const stopwatch& clock,
                                                const execution& run) {
    auto system = std::make_unique<System>(p, settings_, clock);
    if (auto ok = system->prepare(p.filter, run); !ok)
      return fail(ok.error());
    return system;
  }

  [[nodiscard]] expected<void> check_room(const problem& p) const {
    return check_memory(native_solve_bytes(p),
                        settings_.memory_limit
                          ? memory_room{settings_.memory_limit, "the backend's limit"}
                          : available_memory(),
                        "the solve of " + std::to_string(p.node_count()) + " nodes");
  }

  native_settings settings_;
  device_info info_;
};

}  // namespace

std::unique_ptr<backend> make_native_backend(const native_settings& settings) {
  return std::make_unique<native_backend>(settings);
}

}  // namespace tedit::fem
