// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/deck.hpp"

namespace tedit {

void deck_in_metres(deck& one, double metres_per_unit) {
  const double l = metres_per_unit;
  for (auto& m : one.materials) {
    m.young_modulus /= l * l;
    m.density /= l * l * l * l;
  }
  for (auto& s : one.supports)
    s.value *= l;
  for (auto& p : one.pressures)
    p.value /= l * l;
  if (one.gravity)
    one.gravity = l * *one.gravity;
}

}  // namespace tedit
