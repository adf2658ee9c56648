// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "gpu/kernels.hpp"

namespace tedit::fem {

/// The compiled kernels of `shaders/` on one device, for one choice of constants.
struct vulkan_kernels {
  std::shared_ptr<gpu::kernel_layout> layout;
  gpu::kernel count_columns, assemble_rows, precondition;
  gpu::kernel cg_start, cg_begin, cg_apply, cg_update, cg_direction;
  gpu::kernel element_stress, nodal_stress;
  std::uint32_t group_size = 64;
  std::uint32_t slice_rows = 8;
};

/// Compiles all kernels. `most_columns` bounds the blocks of one row.
[[nodiscard]] expected<vulkan_kernels> make_kernels(std::shared_ptr<gpu::device> on,
                                                    std::uint32_t most_columns);

}  // namespace tedit::fem
