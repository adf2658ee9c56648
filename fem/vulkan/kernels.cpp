// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/kernels.hpp"

#include <algorithm>
#include <bit>

#include "base/guard.hpp"

#include "kernels/all.h"

namespace tedit::fem::vulkan {

namespace {

constexpr std::uint32_t push_bytes = 32;       // of any kernel
constexpr std::uint32_t most_in_group = 1024;  // what group_sum.glsl has room for

struct entry {
  gpu::kernel* kernel;
  std::span<const std::uint32_t> code;
  std::uint32_t mode = 0;  ///< Specialisation constant 2.
  std::uint32_t variant =
    0;  ///< Specialisation constant 3: how values are read, or what is summed.
};

expected<void> compile(const std::shared_ptr<gpu::kernel_layout>& layout,
                       std::span<const entry> entries, const kernel_set& like) {
  for (const auto& e : entries) {
    check_cancelled();
    auto made = gpu::kernel::make(
      layout, e.code,
      {like.group_size, like.slice_rows, e.mode, e.variant, like.cases, like.texels ? 1u : 0u});
    if (!made)
      return fail(made.error());
    *e.kernel = std::move(*made);
  }
  return {};
}

expected<void> choose_sizes(const gpu::device_limits& limits, const vulkan_settings& settings,
                            kernel_set& result) {
  const auto most = std::min(std::bit_floor(limits.workgroup_size), most_in_group);
  result.group_size = settings.group_size ? settings.group_size : std::min(64u, most);
  result.slice_rows = settings.slice_rows
                        ? settings.slice_rows
                        : std::clamp(std::bit_floor(limits.subgroup_size), 1u, result.group_size);
  if (std::has_single_bit(result.group_size) && result.group_size <= most &&
      std::has_single_bit(result.slice_rows) && result.slice_rows <= result.group_size)
    return {};
  return fail(
    ec::invalid_argument,
    "workgroups of " + std::to_string(result.group_size) + " with slices of " +
      std::to_string(result.slice_rows) + " rows do not exist on this device",
    "Take powers of two, at most " + std::to_string(most) + ", and no more rows than invocations");
}

/// Those that do without quadratic tets.
std::vector<entry> entries_of_linear_tets(kernel_set& to) {
  std::vector<entry> entries{{&to.smoother_start, smoother_start_spirv},
                             {&to.smoother_clusters, smoother_clusters_spirv},
                             {&to.cycle_restrict, cycle_restrict_spirv},
                             {&to.cycle_prolongate, cycle_prolongate_spirv},
                             {&to.rigid_cycle_start, rigid_cycle_start_spirv},
                             {&to.rigid_cycle_coarsest, rigid_cycle_coarsest_spirv},
                             {&to.krylov_start, krylov_start_spirv},
                             {&to.krylov_first, krylov_first_spirv},
                             {&to.krylov_advance, krylov_advance_spirv},
                             {&to.krylov_product, krylov_product_spirv},
                             {&to.krylov_turn, krylov_turn_spirv}};
  for (std::uint32_t mode = 0; mode < 3; ++mode) {
    for (std::uint32_t reading = 0; reading < 3; ++reading)
      if (reading == TEDIT_READ_EXACTLY || mode != TEDIT_MULTIPLY)
        entries.push_back({&to.matrix_rows[reading][mode], matrix_rows_spirv, mode, reading});
    entries.push_back({&to.rigid_cycle_rows[mode], rigid_cycle_rows_spirv, mode});
    entries.push_back({&to.krylov_scalars[mode], krylov_scalars_spirv, mode});
  }
  return entries;
}

}  // namespace

expected<std::shared_ptr<kernel_store>> kernel_store::make(std::shared_ptr<gpu::device> on,
                                                           const vulkan_settings& settings) {
  auto made = std::make_shared<kernel_store>();
  auto& result = made->for_cases_[1];
  if (auto ok = choose_sizes(on->limits(), settings, result); !ok)
    return fail(ok.error());
  if (on->summary().kind != "software") {
    result.most_groups = 65535;  // what Vulkan guarantees
    result.sum_groups = 512;
    result.rows_per_part = 1u << 20;
    result.rows_per_dispatch = 1u << 20;
  }
  result.texels = settings.texels.value_or(on->summary().kind == "software") &&
                  on->limits().texel_buffer_range >= on->limits().storage_buffer_range;
  if (settings.rows_per_part > 0)
    result.rows_per_part = settings.rows_per_part;
  if (settings.rows_per_dispatch > 0)
    result.rows_per_dispatch = settings.rows_per_dispatch;
  auto layout = gpu::kernel_layout::make(std::move(on), TEDIT_BINDINGS, push_bytes);
  if (!layout)
    return fail(layout.error());
  result.layout = *layout;
  auto entries = entries_of_linear_tets(result);
  entries.push_back({&result.quadratic_elements, quadratic_elements_spirv});
  entries.push_back({&result.quadratic_cycle_restrict, quadratic_cycle_restrict_spirv});
  entries.push_back({&result.quadratic_cycle_prolongate, quadratic_cycle_prolongate_spirv});
  for (std::uint32_t earlier = 0; earlier < 2; ++earlier)
    for (std::uint32_t mode = 0; mode < 4; ++mode)
      entries.push_back(
        {&result.quadratic_rows[earlier][mode], quadratic_rows_spirv, mode, earlier});
  if (auto ok = compile(result.layout, entries, result); !ok)
    return fail(ok.error());
  return made;
}

expected<const kernel_set*> kernel_store::for_cases(std::uint32_t cases) {
  if (const auto known = for_cases_.find(cases); known != for_cases_.end())
    return &known->second;
  const auto& like = for_one();
  kernel_set result;
  static_cast<kernel_sizes&>(result) = like;
  result.layout = like.layout;
  result.rows_per_part = std::max(1u, like.rows_per_part / cases);
  result.rows_per_dispatch = std::max(1u, like.rows_per_dispatch / cases);
  result.cases = cases;
  if (auto ok = compile(result.layout, entries_of_linear_tets(result), result); !ok)
    return fail(ok.error());
  return &for_cases_.emplace(cases, std::move(result)).first->second;
}

}  // namespace tedit::fem::vulkan
