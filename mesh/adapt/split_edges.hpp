// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "base/execution.hpp"
#include "mesh/adapt/adapt_mesh.hpp"
#include "mesh/adapt/size_field.hpp"
#include "mesh/adapt/wall_places.hpp"
#include "mesh/box.hpp"

namespace tedit {

/// How long edges may be, m: a size where it was picked, more further off.
struct split_settings {
  mesh_pick pick;
  double size = 0;                  ///< m.
  std::size_t most_tets = 4000000;  ///< Of the whole part afterwards.
};

struct split_report {
  std::size_t vertices = 0;  ///< New ones.
};

/// How many tets `split_edges` would leave, within a factor of about 1.5. Cost: O(mesh).
[[nodiscard]] double tets_after_split(const mesh_version& mesh, const split_settings& settings);

/// Halves edges until none is longer than `size` + `size_growth` times how far its nearer end is
/// from what was picked: always the longest edge of all tets around, so that tets keep their shape.
/// New vertices on round walls, on free form and on their edges lie on what is behind the facets
/// (`wall_places`). Source: Rivara 1997, New longest-edge algorithms for the refinement of
/// triangulations. Errors: `invalid_parameter` when more than `most_tets` come out, `cancelled`.
/// Cost: some microseconds a new tet.
[[nodiscard]] expected<split_report> split_edges(const mesh_version& base, adapt_mesh& mesh,
                                                 const split_settings& settings,
                                                 const execution& run);

/// The same where each vertex says how long its edges may be (m, by slot of `base`); a new vertex
/// as much as the ends of its edge in the mean. Errors: the same.
[[nodiscard]] expected<split_report> split_edges(const mesh_version& base, adapt_mesh& mesh,
                                                 std::vector<double> sizes, std::size_t most_tets,
                                                 const execution& run);

/// Which chords of round walls are halved.
struct chord_settings {
  box near;             ///< Those that meet it.
  round_test is_round;  ///< Of these walls; no vertex goes onto another's fit.
  double most_off = 0;  ///< m: how far the middle of one may be off its wall.
  /// A new vertex stays beside its wall where on it a tet would be flatter than this, and less than
  /// half as good as beside it.
  double least_quality = 0.1;
  std::size_t most_tets = 4000000;  ///< Of the whole part afterwards.
};

/// Halves edges of round walls until their middles are no further off the walls than that: the part
/// is then as round there as a finer mesh would have it. New vertices lie on the walls. Errors:
/// as above. Cost: O(mesh), a fit of each wall, and some microseconds a new tet.
[[nodiscard]] expected<split_report> split_chords(const mesh_version& base, adapt_mesh& mesh,
                                                  const chord_settings& settings,
                                                  const execution& run);

/// Tets of a builder that came out flatter than q = 0.2 are mended with what is around them: on
/// flat walls facets may change and vertices slide, by no more than `tolerance` (m). Errors:
/// `cancelled`. Cost: O(touched), and some milliseconds a place.
[[nodiscard]] expected<void> mend_split(mesh_builder& mesh, double tolerance, const execution& run);

/// The same for those of some tets. Cost: O(tets), and some milliseconds a place.
[[nodiscard]] expected<void> mend_flat(mesh_builder& mesh, std::span<const tet_id> tets,
                                       double tolerance, const execution& run);

}  // namespace tedit
