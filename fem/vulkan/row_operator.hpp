// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/vulkan/program.hpp"

namespace tedit::fem::vulkan {

/// What a product works on; see rows_bindings.h. All but `x` and `r` depend on the mode.
struct row_buffers {
  const gpu::buffer* x = nullptr;
  const gpu::buffer* r = nullptr;
  const gpu::buffer* diagonal = nullptr;
  const gpu::buffer* next = nullptr;
  const gpu::buffer* z = nullptr;
  const gpu::buffer* partials = nullptr;

  /// These and what an operator binds beside them.
  [[nodiscard]] device_program::places with(device_program::places own = {}) const {
    own.insert(own.end(), {{row_at::x, x},
                           {row_at::r, r},
                           {row_at::diagonal, diagonal},
                           {row_at::next, next},
                           {row_at::z, z},
                           {row_at::partials, partials}});
    return own;
  }
};

/// An operator on nodes with three unknowns on the device: linear or quadratic tets.
class row_operator {
public:
  virtual ~row_operator() = default;

  [[nodiscard]] virtual std::uint32_t rows() const = 0;
  /// Most partial sums that a product with these kernels leaves for each case.
  [[nodiscard]] virtual std::uint32_t most_partials(const kernel_set& kernels) const = 0;
  /// Adds a product and what becomes of its rows: TEDIT_MULTIPLY, _RESIDUAL or _MOVE. Of `push` the
  /// weights count. Returns the number of partial sums (TEDIT_MULTIPLY only).
  virtual std::uint32_t add(device_program& program, std::uint32_t mode, const row_buffers& at,
                            row_push push) const = 0;
};

}  // namespace tedit::fem::vulkan
