// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/segment/facet_net.hpp"
#include "mesh/segment/fitted_shape.hpp"

namespace tedit {

/// Facets of one cylinder, cone or sphere.
struct round_patch {
  fitted_shape shape;
  std::vector<std::uint32_t> facets;
  double area = 0;
  bool is_exact = true;  ///< Corners are on the shape but for the rounding of coordinates.
};

/// Finds what is round among the flat facets of a surface.
class round_finder {
public:
  /// `patch_of`: of each facet; `no_id` is free to be taken.
  round_finder(const triangle_surface& surface, const facet_net& net, double tolerance,
               const std::vector<std::uint32_t>& groups,
               const std::vector<std::uint32_t>& patch_of);

  /// The largest round patch that hangs together with a facet, if it is on one. Cost: some ten
  /// fits, and one look at each facet of what they find.
  [[nodiscard]] std::optional<round_patch> around(std::uint32_t seed) const;

  /// Whether a facet's corners are on the shape within `tolerance`, and it looks along the shape's
  /// normal.
  [[nodiscard]] bool lies_on(const fitted_shape& shape, std::uint32_t facet,
                             double tolerance) const;

private:
  using facet_list = std::vector<std::uint32_t>;

  [[nodiscard]] std::vector<facet_list> first_guesses(std::uint32_t seed) const;
  [[nodiscard]] facet_list near(std::uint32_t seed, std::size_t most, double bend) const;
  [[nodiscard]] std::optional<fitted_shape> fit(surface_form form, const facet_list& to) const;
  [[nodiscard]] facet_list grow(const fitted_shape& shape, std::uint32_t seed, double most) const;
  [[nodiscard]] bool leaks(const round_patch& patch) const;
  [[nodiscard]] std::optional<round_patch> tried(surface_form form, const facet_list& guess,
                                                 std::uint32_t seed) const;
  [[nodiscard]] bool is_ball(const round_patch& patch) const;
  [[nodiscard]] bool is_proper(const round_patch& patch) const;
  [[nodiscard]] std::vector<std::uint32_t> corners_of(const facet_list& facets) const;
  [[nodiscard]] bool may_join(std::uint32_t seed, std::uint32_t facet) const;
  [[nodiscard]] double exact_tolerance(const fitted_shape& shape) const;
  [[nodiscard]] double sag_of(const fitted_shape& shape, std::uint32_t facet) const;
  [[nodiscard]] double loose_tolerance(const fitted_shape& shape, const facet_list& facets) const;

  const triangle_surface& surface_;
  const facet_net& net_;
  double tolerance_;
  const std::vector<std::uint32_t>& groups_;
  const std::vector<std::uint32_t>& patch_of_;
};

}  // namespace tedit
