// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "cad/exchange.hpp"
#include "scan/exchange.hpp"
#include "scan/reader/file_surface.hpp"

namespace tedit::scan {

/// A surface of a file that bounds solids, with what is known of its patches.
struct part_of_file {
  surface_part part;
  cad::part_facts facts;
};

/// Welds, mends, orients and divides the surface of a file (docs/scans.md). `unit`: of its
/// coordinates where it says none. `stage` is told what is being done. Errors: `bad_input`,
/// `non_manifold`, with the place. Cost: O(n log n).
[[nodiscard]] expected<part_of_file> make_part(
  file_surface read, const std::string& unit,
  const std::function<void(double, const char*)>& stage);

}  // namespace tedit::scan
