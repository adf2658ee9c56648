// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "fem/kernels.hpp"

namespace tedit::fem {

/// The double-precision backend on the CPU's cores: oracle of the tests, and what runs without a
/// GPU.
[[nodiscard]] std::unique_ptr<backend> make_native_backend();

}  // namespace tedit::fem
