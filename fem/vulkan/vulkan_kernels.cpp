// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/vulkan_kernels.hpp"

#include <algorithm>
#include <bit>

#include "kernels/assemble_rows.h"
#include "kernels/cg_apply.h"
#include "kernels/cg_begin.h"
#include "kernels/cg_direction.h"
#include "kernels/cg_start.h"
#include "kernels/cg_update.h"
#include "kernels/count_columns.h"
#include "kernels/element_stress.h"
#include "kernels/nodal_stress.h"
#include "kernels/precondition.h"
#include "shaders/elasticity_bindings.h"

namespace tedit::fem {

expected<vulkan_kernels> make_kernels(std::shared_ptr<gpu::device> on, std::uint32_t most_columns) {
  constexpr std::uint32_t most_sets = 512;
  vulkan_kernels result;
  const auto& limits = on->limits();
  result.group_size = std::min(64u, std::bit_floor(limits.workgroup_size));
  // Rows of a slice sit side by side, so that a subgroup reads contiguous memory.
  result.slice_rows = std::clamp(std::bit_floor(limits.subgroup_size), 1u, result.group_size);
  auto layout =
    gpu::kernel_layout::make(std::move(on), TEDIT_BINDINGS, sizeof(push_constants), most_sets);
  if (!layout)
    return fail(layout.error());
  result.layout = *layout;
  const std::vector<std::uint32_t> constants{result.group_size, result.slice_rows, most_columns};
  struct entry {
    gpu::kernel* kernel;
    std::span<const std::uint32_t> code;
  };
  const entry entries[] = {{&result.count_columns, count_columns_spirv},
                           {&result.assemble_rows, assemble_rows_spirv},
                           {&result.precondition, precondition_spirv},
                           {&result.cg_start, cg_start_spirv},
                           {&result.cg_begin, cg_begin_spirv},
                           {&result.cg_apply, cg_apply_spirv},
                           {&result.cg_update, cg_update_spirv},
                           {&result.cg_direction, cg_direction_spirv},
                           {&result.element_stress, element_stress_spirv},
                           {&result.nodal_stress, nodal_stress_spirv}};
  for (const auto& e : entries) {
    auto made = gpu::kernel::make(result.layout, e.code, constants);
    if (!made)
      return fail(made.error());
    *e.kernel = std::move(*made);
  }
  return result;
}

}  // namespace tedit::fem
