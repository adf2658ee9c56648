// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cad/editor/part.hpp"

namespace tedit::cad {

/// Area and volume of each solid of an edited part, from its faces, whose rows are there. Solids
/// stay in their order, with their names; a piece of one is called as the solid before that it has
/// most of its surfaces of.
void measure_solids(const part_model& before, part_model& part);

}  // namespace tedit::cad
