// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/profiles.hpp"

namespace tedit::ops {

std::vector<parameter_description> profile_parameters() {
  using enum parameter_type;
  std::vector<parameter_description> all{
    {"profile",
     "Profile",
     "What it looks like from above.",
     choice,
     "",
     {},
     {},
     {"circle", "rectangle", "slot", "polygon"},
     std::string("circle")},
    {"size",
     "Size",
     "The circle's and the polygon's diameter, the rectangle's and the slot's length.",
     real,
     "m",
     1e-6,
     10.0,
     {},
     0.01},
    {"width",
     "Width",
     "Across the length of a rectangle or a slot; 0: a square, half the slot.",
     real,
     "m",
     0.0,
     10.0,
     {},
     0.0},
    {"corners", "Corners", "Of a polygon.", integer, "", 3.0, 64.0, {}, std::int64_t{6}},
    direction_parameter("along", "Along", "Which way the length goes. Empty: by the part's axes."),
  };
  return all;
}

}  // namespace tedit::ops
