// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "fem/solver.hpp"

namespace tedit::bench {

/// A solve from the mesh to the stresses.
struct whole_solve {
  const mesh_version& mesh;
  const fem::load_case& loads;
  int element_order = 1;
  fem::backend& device;
  fem::solve_settings settings;
};

/// Solves twice, then cancels `moments` further solves at moments spread evenly over that time. The
/// figures are milliseconds from the cancel until the solve has come back and everything that it
/// held is gone: median, 99th percentile, worst, and the worst of each stage; by the clock, and CPU
/// milliseconds of all threads, which other programs on the machine do not change. At the end it
/// solves once more on the same backend: `same_bits` says whether nothing of the cancelled ones is
/// left.
[[nodiscard]] expected<nlohmann::json> cancel_sweep(const whole_solve& work, int moments);

}  // namespace tedit::bench
