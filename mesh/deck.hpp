// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

/// What a solver's deck says beside its mesh, as it stands there: on nodes and faces. Lengths are
/// in the file's unit, forces in N, so that pressures are N per square unit and masses such that
/// one N moves one of them by a unit per second squared; `deck_in_metres` makes SI of it.
struct deck {
  struct material {
    std::string name;
    double young_modulus = 0;
    double poisson_ratio = 0;
    double density = 0;  ///< 0: not said.
    std::vector<region_id> regions;
  };
  struct support {
    vertex_id vertex = no_id;
    int component = 0;  ///< 0, 1, 2: x, y, z.
    double value = 0;
  };
  struct force {
    vertex_id vertex = no_id;
    vec3 value;
  };
  struct pressure {
    std::array<vertex_id, 3> corners{};
    double value = 0;  ///< Positive pushes on the part.
  };

  std::string name;
  std::vector<material> materials;
  std::vector<support> supports;
  std::vector<force> forces;
  std::vector<pressure> pressures;
  std::optional<vec3> gravity;
  /// The load case as TEdit wrote it into the file (JSON), where nobody changed the cards that it
  /// stands for since; else empty.
  std::string load_case;

  /// Whether there is anything that a load case could be made of.
  [[nodiscard]] bool empty() const {
    return materials.empty() && supports.empty() && forces.empty() && pressures.empty() &&
           !gravity && load_case.empty();
  }
};

/// Takes a deck whose lengths are `metres_per_unit` long to SI units.
void deck_in_metres(deck& one, double metres_per_unit);

}  // namespace tedit
