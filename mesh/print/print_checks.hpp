// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/execution.hpp"
#include "base/units.hpp"
#include "mesh/box.hpp"
#include "mesh/version.hpp"

namespace tedit {

struct print_settings {
  vec3 up{0, 0, 1};           ///< From the plate on, a unit vector.
  double thinner_than = 0;    ///< m; 0: thin walls are not looked for.
  double lean = 45 * degree;  ///< Radians from upright that a wall may lean over.

  friend bool operator==(const print_settings&, const print_settings&) = default;
};

/// Facets that hang together and have the same fault.
struct print_place {
  std::vector<surface_id> surfaces;  ///< Ascending.
  std::size_t facets = 0;
  double area = 0;   ///< m^2.
  double worst = 0;  ///< Least thickness, m; or most lean, radians.
  vec3 at;           ///< Where that is.

  friend bool operator==(const print_place&, const print_place&) = default;
};

/// What a part's boundary is like for who prints it. A part is one thing here: faces between its
/// regions are not walls.
struct print_findings {
  double volume = 0;  ///< Of the tets, m^3.
  double area = 0;    ///< Of the boundary, m^2.
  box extent;
  std::size_t bodies = 0;           ///< Shells that look outward.
  std::size_t closed_voids = 0;     ///< Shells that look inward: what is in them stays there.
  std::size_t open_edges = 0;       ///< With other than as many facets one way as the other.
  std::size_t hinge_edges = 0;      ///< With more than two facets.
  std::size_t crossing_facets = 0;  ///< That meet another one with which they share no corner.
  std::vector<print_place> thin;    ///< Largest first, each wall with both of its sides.
  double thin_area = 0;             ///< Of all sides, m^2.
  std::vector<print_place> overhangs;
  double overhang_area = 0;  ///< m^2.
  double plate_area = 0;     ///< Of what looks down at the lowest height, m^2.

  /// As many facets one way as the other at each edge: closed, and inside and outside are clear.
  [[nodiscard]] bool watertight() const { return open_edges == 0; }
  [[nodiscard]] bool has_findings() const {
    return !watertight() || hinge_edges > 0 || crossing_facets > 0 || closed_voids > 0 ||
           !thin.empty() || !overhangs.empty();
  }

  friend bool operator==(const print_findings&, const print_findings&) = default;
};

/// The same with what is found at each facet slot.
struct print_report : print_findings {
  std::vector<double> thickness;  ///< m; infinite where the wall is not thin.
  std::vector<bool> overhanging;
};

/// What was found at a facet.
enum class print_mark : std::uint8_t { sound, thin, overhang, both };

/// How each mark is shown, red, green and blue: grey, red, orange, violet.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> print_mark_colours{
  {{190, 190, 190}, {214, 40, 40}, {247, 158, 27}, {142, 36, 170}}};

/// @pre the slot is one of the mesh that was checked.
[[nodiscard]] print_mark mark_of(const print_report& report, facet_id facet);

/// Looks at the boundary. A wall is thin where a ray from it straight into the material comes out
/// nearer than `thinner_than` through a side that faces the other way within 30 degrees: so the
/// edge of a right angle or of a wedge is none, a blade is. Rays start at 1 to 16 places of a
/// facet, spread evenly; its share of them is its share of the area. Errors: `invalid_argument` for
/// a direction without length, `cancelled`. Cost: O(n log n) of the facets, and of those that lie
/// within `thinner_than` of each other; on all cores. Tells its stages as progress.
[[nodiscard]] expected<print_report> check_print(const mesh_version& mesh,
                                                 const print_settings& settings,
                                                 const execution& run = {});

}  // namespace tedit
