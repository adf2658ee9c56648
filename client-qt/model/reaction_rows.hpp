// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <vector>

#include "client-qt/model/results_summary.hpp"

namespace tedit::desktop {

/// A force by its direction, "along −z", or by those components that are no noise, "x 3 N, z −4 N".
[[nodiscard]] QString direction_words(const vec3& force_n);

/// How each support of a load case holds the part, and their sum against the loads. Without the
/// load case each surface is a support. Forces below 1e-5 of the largest are noise and have no row.
[[nodiscard]] std::vector<result_row> reaction_rows(
  const solve_report& report, const fem::load_case* loads,
  const std::function<QString(surface_id)>& surface_name);

}  // namespace tedit::desktop
