// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "fem/vulkan/kernels.hpp"

namespace tedit::fem::vulkan {

/// The push constants of any kernel, which all begin alike (shaders/bindings.h).
struct push_constants {
  std::uint32_t rows = 0;
  std::uint32_t from = 0;
  std::uint32_t first_sum = 0;
  std::array<std::uint32_t, 5> others{};

  template <class Push>
  push_constants(const Push& push) {
    static_assert(sizeof(Push) <= sizeof(push_constants));
    std::memcpy(static_cast<void*>(this), &push, sizeof(Push));
  }
  [[nodiscard]] bool operator==(const push_constants&) const = default;
};

/// A list of dispatches that is recorded once and run any number of times. With gates their group
/// counts come from a buffer that `krylov_scalars` zeroes when the loop is over.
///
/// It is recorded in parts, so that a slow device gets a run in several submissions and a fast one
/// several runs in one: each should take about `submission_ms`. The cut changes no bits.
class device_program {
public:
  /// Buffers at named bindings, `{{krylov_at::u, &u}, ...}`; those that are null are left out.
  using places = std::vector<std::pair<int, const gpu::buffer*>>;

  explicit device_program(const kernel_set& kernels) : kernels_(kernels) {}

  /// Adds a kernel over `push.rows` rows (none: no dispatch), in several dispatches if one would
  /// take too long for a cancel to wait.
  void add(const gpu::kernel& k, const places& at, const push_constants& push);
  /// Adds a kernel that leaves one partial sum per workgroup, from `push.first_sum` on; returns
  /// their number, which does not depend on the device's speed.
  std::uint32_t add_sum(const gpu::kernel& k, const places& at, const push_constants& push);
  /// Adds a kernel of one workgroup.
  void add_single(const gpu::kernel& k, const places& at, const push_constants& push);

  /// Records what was added; the buffers must exist now and as long as the program runs. Without
  /// `gates` the group counts are fixed.
  [[nodiscard]] expected<void> record(const gpu::buffer* gates = nullptr);
  /// Whether both have the same dispatches on the same buffers, so that what the other one recorded
  /// will do. Only while no buffer of either was replaced.
  [[nodiscard]] bool same_steps(const device_program& other) const {
    return steps_ == other.steps_;
  }
  /// Runs it `times` times and waits; asks `check_cancelled` before each submission.
  [[nodiscard]] expected<void> run(int times = 1);

  /// How long a submission should take: a cancelled solve ends soon, yet a fast device does not
  /// wait for the host.
  static constexpr double submission_ms = 25;

  [[nodiscard]] const kernel_set& kernels() const { return kernels_; }

  /// The gate of each possible number of workgroups, closed: a power of two, the last one less.
  [[nodiscard]] static std::vector<std::array<std::uint32_t, 4>> closed_gates();

private:
  using buffers = std::array<const gpu::buffer*, TEDIT_BINDINGS>;
  struct step {
    const gpu::kernel* kernel;
    buffers at;
    push_constants push;
    std::uint32_t gate;

    [[nodiscard]] bool operator==(const step& other) const = default;
  };

  [[nodiscard]] expected<gpu::commands> record_part(std::span<const step> steps,
                                                    const std::map<buffers, VkDescriptorSet>& sets,
                                                    const gpu::buffer* gates) const;
  [[nodiscard]] std::size_t fitting(std::size_t first, std::size_t most) const;
  [[nodiscard]] expected<void> submit(std::size_t first, std::size_t count);
  void add_step(const gpu::kernel& k, const places& at, const push_constants& push,
                std::uint32_t gate);
  /// Calls `add(push)` for each dispatch of a kernel over `push.rows` rows.
  template <class Add>
  void cut(push_constants push, const Add& add) const {
    const auto rows = push.rows;
    for (push.from = 0; push.from < rows; push.from = push.rows) {
      push.rows = push.from + std::min(rows - push.from, kernels_.rows_per_dispatch);
      add(push);
    }
  }

  const kernel_set& kernels_;
  std::vector<step> steps_;
  std::optional<gpu::binding_pool> pool_;
  std::vector<gpu::commands> parts_;
  std::vector<double> part_ms_;  ///< How long each takes, by measurement.
};

}  // namespace tedit::fem::vulkan
