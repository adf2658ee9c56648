// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/native/backend.hpp"

namespace tedit::fem::native {

/// The matrix of a problem of either element order with its preconditioner, on the CPU's cores.
/// `p` must outlive it. Errors: those of `build_hierarchy`.
[[nodiscard]] expected<std::unique_ptr<linear_system>> make_system(const problem& p,
                                                                   const native_settings& settings,
                                                                   const execution& run);

}  // namespace tedit::fem::native
