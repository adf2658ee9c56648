// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/multilevel_setup.hpp"
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

/// With products of the native operator.
inline expected<void> prepare_native(const problem& p, multilevel_setup& setup) {
  std::optional<native::quadratic_operator> k;
  if (p.element_order == 2)
    k.emplace(p);
  const auto product = [&](const float* x, float* y) -> expected<void> {
    for_rows(*k, x, [y](std::size_t i, float4 row) { store3(row, y + 3 * i); });
    return {};
  };
  return setup.prepare(p.filter, product, {});
}

/// z = B r by the native cycle, which reads exactly what the device does.
inline std::vector<double> native_cycle(const problem& p, const vulkan_settings& settings,
                                        const multilevel_setup& setup, std::span<const double> r) {
  std::vector<float> right(padded3(p.node_count()));
  std::vector<float> z(right.size());
  std::ranges::transform(r, right.begin(), [](double v) { return static_cast<float>(v); });
  auto& h = const_cast<hierarchy&>(setup.levels());  // As before when this returns.
  const auto rows = h.exact_rows;
  read_whole_slices(settings, h);
  native::multilevel_cycle corners(setup.blocks(), h, settings.cycle);
  if (p.element_order == 1)
    corners.apply(right.data(), z.data());
  else
    native::quadratic_cycle(native::quadratic_operator(p), setup.smoother(), setup.edges(),
                            native::held_nodes_of(p.filter), corners,
                            settings.cycle.quadratic_degree)
      .apply(right.data(), z.data());
  h.exact_rows = rows;
  return {z.begin(), z.end() - 1};
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
        native_(p_, settings_.multilevel),
        system_(fresh()) {
    EXPECT_TRUE(prepare_native(p_, native_).has_value());
  }

  [[nodiscard]] const problem& current() const { return p_; }
  [[nodiscard]] const version_ptr& mesh() const { return mesh_; }
  [[nodiscard]] vulkan::system& system() { return *system_; }

  /// Of the inverse of the coarsest level.
  [[nodiscard]] std::uint64_t dense_bytes() const {
    const std::uint64_t size = 6 * std::uint64_t{native_.levels().levels.back().nodes()};
    return size / 3 * size * 16;
  }

  /// A system of the problem as it is now, without history.
  [[nodiscard]] std::unique_ptr<vulkan::system> fresh() const {
    auto made = make_system(p_, settings_);
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

  void follow(const version_ptr& next) {
    ASSERT_NO_FATAL_FAILURE(advance(next));
    ASSERT_TRUE(native_.update(change_, updater_.corners()));
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
    ASSERT_NO_FATAL_FAILURE(expect_near_all(z, native_cycle(p_, settings_, native_, r), 1e-4))
      << "B r";
  }

private:
  version_ptr mesh_;
  load_case loads_;
  vulkan_settings settings_;
  problem p_;
  problem_updater updater_;
  multilevel_setup native_;
  problem_change change_;
  std::unique_ptr<vulkan::system> system_;
};

}  // namespace tedit::fem::test
