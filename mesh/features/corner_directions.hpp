// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/features/round_fit.hpp"

namespace tedit {

/// Which way a wall of free form looks at each of its corners: unit, outward. Each is found when it
/// is first asked for; not by several threads at once.
class corner_directions {
public:
  /// @param facets must outlive it. Cost: O(facets log facets).
  explicit corner_directions(const facet_corners& facets);

  /// Fits the height over the tangent plane, a polynomial of third order, of second where corners
  /// are few, to the corners within two edges. Nothing where that leaves a quarter of what a plane
  /// does (creases, noise), where facets turn by more than 35 degrees from their mean, and where
  /// the wall is less than four rows of corners wide: three lie on a parabola whatever they are a
  /// part of. Cost: some microseconds the first time.
  [[nodiscard]] const std::optional<vec3>& at(std::uint32_t corner) const;

  /// Of the facets there, by their areas.
  [[nodiscard]] vec3 mean_at(std::uint32_t corner) const { return mean_[corner]; }

private:
  [[nodiscard]] std::optional<vec3> fitted(std::uint32_t corner) const;
  [[nodiscard]] bool is_on_rim(std::uint32_t corner) const { return on_rim_[corner] != 0; }
  [[nodiscard]] std::vector<std::uint32_t> around(std::uint32_t corner) const;
  [[nodiscard]] bool has_rows(std::uint32_t corner, const std::vector<std::uint32_t>& near) const;

  const facet_corners& facets_;
  std::vector<std::uint32_t> first_;       ///< Of each corner, in `neighbours_`, and past the last.
  std::vector<std::uint32_t> neighbours_;  ///< Some of them twice.
  std::vector<vec3> mean_;
  std::vector<double> bends_;  ///< The least cosine between a corner's facets and their mean.
  std::vector<std::uint8_t> on_rim_;
  std::vector<std::uint8_t> is_deep_;  ///< A corner of a facet of which none is on the rim.
  mutable std::vector<std::uint8_t> is_found_;
  mutable std::vector<std::optional<vec3>> found_;
};

}  // namespace tedit
