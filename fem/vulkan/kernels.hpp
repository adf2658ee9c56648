// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <map>

#include "fem/vulkan/backend.hpp"
#include "gpu/kernels.hpp"
#include "shaders/cycle_bindings.h"
#include "shaders/krylov_bindings.h"
#include "shaders/matrix_bindings.h"
#include "shaders/quadratic_bindings.h"
#include "shaders/quadratic_cycle_bindings.h"
#include "shaders/rigid_cycle_bindings.h"
#include "shaders/smoother_bindings.h"

namespace tedit::fem::vulkan {

/// How kernels are compiled and dispatched.
struct kernel_sizes {
  std::uint32_t group_size = 64;
  std::uint32_t slice_rows = 8;    ///< Rows side by side, so that a subgroup reads in a row.
  std::uint32_t most_groups = 64;  ///< Of a dispatch; kernels stride over their rows.
  std::uint32_t sum_groups = 16;   ///< Of a dispatch that leaves partial sums.
  std::uint32_t rows_per_part = 1u << 16;  ///< A part of a program ends after so many.
  /// A dispatch of more is cut: one that has begun cannot be stopped. Of quadratic tets, so many
  /// take about 5 ms on two cores.
  std::uint32_t rows_per_dispatch = 1u << 15;

  /// Kernels read as texels what they do not write; see operands.glsl.
  bool texels = false;
  std::uint32_t cases = 1;  ///< Load cases side by side in every vector; see kernel.glsl.

  /// Partial sums that a sum over so many rows leaves at most.
  [[nodiscard]] std::uint32_t most_sums(std::uint64_t rows) const {
    return static_cast<std::uint32_t>((rows - 1) / rows_per_dispatch + 1) * sum_groups;
  }
};

/// The kernels of `shaders/`, by the names of their files. The last index is the mode.
struct kernel_set : kernel_sizes {
  std::shared_ptr<gpu::kernel_layout> layout;
  /// The first index says how values are read: TEDIT_READ_EXACTLY, for all modes, or otherwise, for
  /// smoothers.
  std::array<std::array<gpu::kernel, 3>, 3> matrix_rows;
  /// The first index says whether sums of earlier ranges of elements are added.
  std::array<std::array<gpu::kernel, 4>, 2> quadratic_rows;
  std::array<gpu::kernel, 3> rigid_cycle_rows;
  std::array<gpu::kernel, 3> krylov_scalars;
  gpu::kernel quadratic_elements, quadratic_cycle_restrict, quadratic_cycle_prolongate;
  gpu::kernel smoother_start, smoother_clusters, cycle_restrict, cycle_prolongate;
  gpu::kernel rigid_cycle_start, rigid_cycle_coarsest;
  gpu::kernel krylov_start, krylov_first, krylov_advance, krylov_product, krylov_turn;
};

/// A device's kernels, compiled once for all systems on it. One thread at a time, as the device.
class kernel_store {
public:
  /// Compiles those for one load case. Errors: those of the device; `invalid_argument` for sizes
  /// that it cannot have.
  [[nodiscard]] static expected<std::shared_ptr<kernel_store>> make(
    std::shared_ptr<gpu::device> on, const vulkan_settings& settings);

  [[nodiscard]] const kernel_set& for_one() const { return for_cases_.at(1); }
  /// For so many load cases at once, without those of quadratic tets; compiled when first asked
  /// for.
  [[nodiscard]] expected<const kernel_set*> for_cases(std::uint32_t cases);

private:
  std::map<std::uint32_t, kernel_set> for_cases_;
};

}  // namespace tedit::fem::vulkan
