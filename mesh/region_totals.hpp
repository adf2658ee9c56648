// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include "mesh/version.hpp"

namespace tedit {

/// What the live tets of a region come to.
struct region_total {
  std::size_t tets = 0;
  double volume = 0;  ///< m3
};

/// By id; regions without tets are not there. Cost: O(tets).
[[nodiscard]] std::map<region_id, region_total> region_totals(const mesh_version& mesh);

}  // namespace tedit
