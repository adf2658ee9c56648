// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/incidence.hpp"
#include "fem/vulkan/matrix.hpp"

namespace tedit::fem::vulkan {

/// K x of straight-sided ten-node tets, element by element: one kernel writes the ten forces of
/// each element, a second one sums them at each node, in a fixed order. Elements come in ranges
/// whose forces fit a binding; the ranges share one buffer of forces. The last one has room for
/// elements that edits add.
class quadratic_operator final : public row_operator {
public:
  /// `kernels` and `memory` must outlive the operator; `p` has order 2. Ask `memory` for its status
  /// afterwards.
  quadratic_operator(const kernel_set& kernels, device_memory& memory, const problem& p,
                     const device_scale& scale);

  std::uint32_t rows() const override { return nodes_; }
  std::uint32_t most_partials(const kernel_set& kernels) const override {
    return kernels.most_sums(with_spare(nodes_));
  }
  std::uint32_t add(device_program& program, std::uint32_t mode, const row_buffers& at,
                    row_push push) const override;

  /// Follows `change` of `p`; `corners` has the elements' corners.
  void update(const problem& p, const incidence& corners, const problem_change& change,
              device_changes& changes);

private:
  using four = std::array<std::uint32_t, 4>;
  struct range {
    std::uint32_t first = 0;
    std::uint32_t elements = 0;
    std::uint32_t room = 0;            ///< For elements.
    gpu::buffer nodes, values;         ///< Of the elements.
    gpu::buffer rows, list;            ///< Forces of each node, their places four by four.
    roomy_places places;               ///< Of the rows in `list`.
    std::vector<std::uint32_t> count;  ///< Forces of each node.
  };

  void add_range(const problem& p, std::uint32_t first, std::uint32_t last, std::uint32_t room);
  void update_rows(range& part, const problem& p, const incidence& corners,
                   std::span<const std::uint32_t> nodes, device_changes& changes);
  /// Where a force lies: those of neighbouring elements side by side, so that a subgroup writes in
  /// a row, and all ten of an element near by, so that caches write in few places.
  [[nodiscard]] std::uint32_t place_of(std::uint32_t element, std::uint32_t local) const;
  [[nodiscard]] static std::array<std::uint32_t, 2> row_at(const range& part, std::uint32_t node);

  const kernel_set& kernels_;
  device_memory& memory_;
  std::uint32_t nodes_;
  device_scale scale_;
  std::deque<range> ranges_;
  gpu::buffer forces_, sums_;
};

}  // namespace tedit::fem::vulkan
