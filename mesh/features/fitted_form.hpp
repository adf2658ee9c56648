// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mesh/box.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/features/corner_directions.hpp"
#include "mesh/features/exact_wall.hpp"
#include "mesh/surface_foot.hpp"

namespace tedit {

/// A smooth surface through all corners of a wall of free form of which no CAD model says anything:
/// a curved triangle on each facet, cubic, whose edges leave its corners as the wall does there.
/// Where a corner's direction is not said, at creases, in noise, on narrow strips, the facets are
/// taken as they are. Sources: Vlachos, Peters, Boyd and Mitchell 2001, Curved PN triangles; of the
/// edges the handles are as long as those of a circle's arc.
class fitted_form final : public surface_projection {
public:
  /// Nothing without facets. Cost: O(facets log facets).
  [[nodiscard]] static std::shared_ptr<const fitted_form> through(const facet_corners& facets);

  /// The same of the facets that meet a box and those around; nothing where not all corners there
  /// have a direction. Elsewhere it may not be asked. Cost: O(facets).
  [[nodiscard]] static std::shared_ptr<const fitted_form> near(const facet_corners& facets,
                                                               const box& within);

  /// Past the rim it goes on straight. The same for the same point, to rounding. Not by several
  /// threads at once. Cost: O(log facets) some times, and the fit of a corner once.
  [[nodiscard]] surface_foot operator()(vec3 p) const override;
  /// m: between the corners of the facet there, at most the extent.
  [[nodiscard]] double radius_at(vec3 p) const override;

private:
  using triangle_corners = std::array<std::uint32_t, 3>;

  struct patch_point {
    std::uint32_t triangle = 0;
    std::array<double, 3> share{};  ///< Of its corners.
  };

  /// A cubic triangle of Bezier's: S(s) by three shares whose sum is 1.
  struct patch {
    std::array<vec3, 3> corner;
    std::array<std::array<vec3, 2>, 3>
      edge;  ///< Beside each corner, towards the next and the last.
    vec3 middle;

    struct slopes {
      vec3 at;
      std::array<vec3, 3> by;  ///< Derivatives by the shares.
    };
    [[nodiscard]] slopes operator()(const std::array<double, 3>& share) const;
  };

  explicit fitted_form(facet_corners facets);
  [[nodiscard]] vec3 handle(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] patch patch_on(const triangle_corners& t) const;
  [[nodiscard]] patch_point nearest_facet(vec3 p) const;
  [[nodiscard]] vec3 flat_at(const patch_point& where) const;
  [[nodiscard]] vec3 normal_at(const patch_point& where) const;
  [[nodiscard]] static std::array<double, 3> stepped(const patch_point& from,
                                                     const patch::slopes& here, vec3 aside);

  facet_corners facets_;
  corner_directions directions_;
  std::optional<box_tree> tree_;
};

/// A fitted form as the wall behind its facets: of all of them, or near a box. Nothing where there
/// is no such form. Cost: that of `through` or `near`.
[[nodiscard]] std::optional<exact_wall> fit_free_form(const facet_corners& facets,
                                                      const std::optional<box>& near = {});

}  // namespace tedit
