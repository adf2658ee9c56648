// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "fem/kernels.hpp"
#include "fem/native/cycle.hpp"

namespace tedit::fem {

/// How the native backend solves; the defaults are measured (bench/FIGURES.md).
struct native_settings {
  multilevel_settings multilevel;
  cycle_settings cycle;
};

/// The backend on the CPU's cores: what runs without a GPU, and what other devices are compared
/// with. Single precision in difference form with a multilevel preconditioner; the outer loop of
/// `solve` makes the result exact to double precision.
[[nodiscard]] std::unique_ptr<backend> make_native_backend(const native_settings& settings = {});

}  // namespace tedit::fem
