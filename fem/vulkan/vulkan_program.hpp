// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "fem/vulkan/vulkan_kernels.hpp"

namespace tedit::fem {

/// A list of dispatches that is recorded once and run any number of times. With gates their group
/// counts come from a buffer that `cg_scalars` zeroes when the loop is over.
class vulkan_program {
public:
  using place = std::pair<int, const gpu::buffer*>;

  explicit vulkan_program(const cycle_kernels& kernels) : kernels_(kernels) {}

  /// Adds a kernel over `push.rows` rows (none: no dispatch). `places` are bindings.
  void add(const gpu::kernel& k, std::initializer_list<place> places, const cycle_push& push);
  /// Adds a kernel that leaves one partial sum per workgroup; returns their number.
  std::uint32_t add_sum(const gpu::kernel& k, std::initializer_list<place> places,
                        const cycle_push& push);
  /// Adds a kernel of one workgroup.
  void add_single(const gpu::kernel& k, std::initializer_list<place> places,
                  const cycle_push& push);

  /// Records what was added; the buffers must exist now and as long as the program runs. Without
  /// `gates` the group counts are fixed.
  [[nodiscard]] expected<void> record(const gpu::buffer* gates = nullptr);
  [[nodiscard]] expected<void> run(int times = 1);

  [[nodiscard]] const cycle_kernels& kernels() const { return kernels_; }

  /// The gate of each possible number of workgroups, closed: a power of two, the last one less.
  [[nodiscard]] static std::vector<std::array<std::uint32_t, 4>> closed_gates();

private:
  using buffers = std::array<const gpu::buffer*, TEDIT_CYCLE_BINDINGS>;
  struct step {
    const gpu::kernel* kernel;
    buffers at;
    cycle_push push;
    std::uint32_t gate;
  };

  void add_step(const gpu::kernel& k, std::initializer_list<place> places, const cycle_push& push,
                std::uint32_t gate);

  const cycle_kernels& kernels_;
  std::vector<step> steps_;
  std::optional<gpu::binding_pool> pool_;
  std::optional<gpu::commands> commands_;
};

}  // namespace tedit::fem
