// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/lanczos.hpp"
#include "fem/native/quadratic_cycle.hpp"
#include "fem/vulkan/system.hpp"
#include "gpu/device.hpp"
#include "tests/gpu/bent_bar.hpp"
#include "tests/support/edits.hpp"

namespace tedit::fem::test {

inline load_case held_at_one_end() {
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
  loads.constraints = {{{1}, fixed{}}, {{3}, roller{}}};
  loads.loads = {{{2}, force{{100, 0, -1000}}}};
  return loads;
}

/// Bindings and dispatches so small that all that can be cut is cut, and three rigid levels.
inline vulkan_settings in_pieces() {
  vulkan_settings result;
  result.most_bytes_per_binding = 40'000;
  result.multilevel.coarsest = 2;
  result.rows_per_dispatch = 300;
  return result;
}

/// A problem that follows its mesh from edit to edit, with the native matrix and hierarchy beside
/// the device's, made and carried on by the same steps.
class followed_system {
public:
  followed_system(version_ptr mesh, load_case loads, int order, const vulkan_settings& settings)
      : mesh_(std::move(mesh)),
        loads_(std::move(loads)),
        settings_(settings.for_order(order)),
        p_(*make_problem(*mesh_, loads_, order, 200)),
        updater_(p_),
        k_(assemble_blocks(p_, updater_.corners())),
        h_(*build_hierarchy(p_, k_, corner_filter(), settings_.multilevel, {})),
        system_(fresh()) {
    if (order == 2)
      make_quadratic();
  }

  [[nodiscard]] const problem& current() const { return p_; }
  [[nodiscard]] const version_ptr& mesh() const { return mesh_; }
  [[nodiscard]] vulkan::system& system() { return *system_; }

  /// Of the inverse of the coarsest level.
  [[nodiscard]] std::uint64_t dense_bytes() const {
    const std::uint64_t size = 6 * std::uint64_t{h_.levels.back().nodes()};
    return size / 3 * size * 16;
  }

  /// A system of the problem as it is now, without history.
  [[nodiscard]] std::unique_ptr<vulkan::system> fresh() const {
    auto made = vulkan::system::make(*gpu::device::open(""), p_, settings_, {});
    EXPECT_TRUE(made.has_value()) << (made ? "" : render(made.error()));
    return std::move(*made);
  }

  /// Takes the problem to the next version of its mesh, the systems not yet.
  void advance(const version_ptr& next) {
    ASSERT_TRUE(next);
    auto applied = updater_.apply(*mesh_, *next, loads_, p_);
    ASSERT_TRUE(applied.has_value()) << render(applied.error());
    ASSERT_TRUE(applied->has_value()) << "was not taken as a small change";
    ASSERT_TRUE(set_conditions(*next, loads_, p_).has_value());
    mesh_ = next;
    change_ = **applied;
  }

  expected<bool> update_device() { return system_->update(change_, updater_.corners()); }

  void update_native() {
    const auto& nodes = change_.nodes;
    const std::span corners(
      nodes.begin(), std::ranges::lower_bound(nodes, static_cast<std::uint32_t>(p_.corner_count)));
    update_blocks(p_, updater_.corners(), corners, k_);
    ASSERT_TRUE(update_hierarchy(p_, updater_.corners(), k_, corner_filter(), corners,
                                 settings_.multilevel, h_)
                  .has_value());
    if (p_.element_order == 1)
      return;
    update_edge_transfer(p_, edges_);
    update_quadratic_smoother(p_, updater_.corners(), p_.filter, nodes, settings_.multilevel,
                              cluster_of_, smoother_);
  }

  void follow(const version_ptr& next) {
    ASSERT_NO_FATAL_FAILURE(advance(next));
    ASSERT_NO_FATAL_FAILURE(update_native());
    const auto updated = update_device();
    ASSERT_TRUE(updated.has_value()) << render(updated.error());
    ASSERT_TRUE(*updated) << "no room was left";
  }

  /// Products as those of a fresh system, cycles as those of the native hierarchy.
  void expect_as_fresh_and_native() {
    const auto x = wave(p_.dofs(), 0.7);
    std::vector<double> expected_y(p_.dofs());
    std::vector<double> y(p_.dofs());
    ASSERT_TRUE(fresh()->multiply(x, expected_y).has_value());
    ASSERT_TRUE(system_->multiply(x, y).has_value());
    ASSERT_NO_FATAL_FAILURE(expect_near_all(y, expected_y, 2e-6)) << "K x";
    const auto r = wave(p_.dofs(), 0.9);
    std::vector<double> z(p_.dofs());
    ASSERT_TRUE(system_->precondition(r, z).has_value());
    ASSERT_NO_FATAL_FAILURE(expect_near_all(z, native_cycle(r), 1e-4)) << "B r";
  }

private:
  [[nodiscard]] filter_span corner_filter() const {
    return filter_span(p_.filter).first(p_.corner_count);
  }

  void make_quadratic() {
    edges_ = make_edge_transfer(p_);
    const auto clusters =
      cluster_slivers(p_, wholly_held(p_.filter), 100, settings_.multilevel.sliver_condition);
    smoother_ = make_quadratic_smoother(p_, p_.filter, clusters);
    cluster_of_ = clusters.of;
    const native::quadratic_operator k(p_);
    smoother_.lambda =
      settings_.multilevel.lambda_safety *
      largest_ritz_value(
        p_.dofs(), 1, settings_.multilevel.lambda_steps,
        [&](const float* x, float* y) {
          for_rows(k, x, [y](std::size_t i, float4 row) { store3(row, y + 3 * i); });
        },
        [&](const float* x, float* y) { apply_inverse(smoother_, 1, x, y); });
  }

  [[nodiscard]] std::vector<double> native_cycle(std::span<const double> r) {
    std::vector<float> right(padded3(p_.node_count()));
    std::vector<float> z(right.size());
    std::ranges::transform(r, right.begin(), [](double v) { return static_cast<float>(v); });
    const auto rows = h_.exact_rows;
    read_whole_slices(settings_, h_);
    native::multilevel_cycle corners(k_, h_, settings_.cycle);
    if (p_.element_order == 1)
      corners.apply(right.data(), z.data());
    else
      native::quadratic_cycle(native::quadratic_operator(p_), smoother_, edges_,
                              native::held_nodes_of(p_.filter), corners,
                              settings_.cycle.quadratic_degree)
        .apply(right.data(), z.data());
    h_.exact_rows = rows;
    return {z.begin(), z.end() - 1};
  }

  version_ptr mesh_;
  load_case loads_;
  vulkan_settings settings_;
  problem p_;
  problem_updater updater_;
  block_matrix k_;
  hierarchy h_;
  edge_transfer edges_;
  node_smoother smoother_;
  std::vector<std::uint32_t> cluster_of_;
  problem_change change_;
  std::unique_ptr<vulkan::system> system_;
};

}  // namespace tedit::fem::test
