// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/units.hpp"

namespace tedit {

expected<double> metres_per_unit(std::string_view unit) {
  if (unit == "m")
    return 1.0;
  if (unit == "cm")
    return 1e-2;
  if (unit == "mm")
    return 1e-3;
  if (unit == "um")
    return 1e-6;
  if (unit == "nm")
    return 1e-9;
  if (unit == "in")
    return 0.0254;
  if (unit == "ft")
    return 0.3048;
  return fail(ec::invalid_argument, "unknown length unit \"" + std::string(unit) + "\"",
              "Use one of m, cm, mm, um, nm, in, ft");
}

}  // namespace tedit
