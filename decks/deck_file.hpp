// SPDX-License-Identifier: AGPL-3.0-or-later
// A load case on a mesh as a deck that another solver runs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "fem/calculix_deck.hpp"
#include "fem/load_case.hpp"
#include "mesh/io/file.hpp"
#include "mesh/version.hpp"

namespace tedit::decks {

/// What a deck is made of.
struct deck_job {
  const mesh_version& mesh;
  const fem::problem& problem;
  std::string load_case;  ///< JSON.
  std::string title;
  std::vector<std::size_t> elements;  ///< Number of each tet in the deck.

  [[nodiscard]] std::size_t element_of(tet_id t) const { return elements[t]; }
};

/// @param problem the load case on the mesh; both outlive the job.
[[nodiscard]] deck_job make_deck_job(const mesh_version& mesh, const fem::problem& problem,
                                     const fem::load_case& loads, std::string title);

/// What a deck holds besides nodes and elements.
struct deck_counts {
  std::size_t held_nodes = 0;
  std::size_t boundaries = 0;  ///< Components of them.
  std::size_t equations = 0;
  std::size_t loads = 0;  ///< CalculiX: components at nodes; Nastran: forces at nodes.
};

/// Writes a deck for CalculiX. Ids, names and regions go into it, and the load case that its cards
/// stand for: so that `tedit convert` gets all of it back. Errors: `io_error`.
[[nodiscard]] expected<deck_counts> write_calculix(const file_target& to, const deck_job& job,
                                                   fem::calculix_solver solver);

/// The same for Nastran. Errors: also what its cards cannot hold.
[[nodiscard]] expected<deck_counts> write_nastran(const file_target& to, const deck_job& job);

/// The same by the name of a format (mesh/formats.hpp) that keeps loads: `inp` or `bdf`. Errors:
/// `invalid_argument` for another one; those of `fem::make_problem`. Cost: O(mesh).
[[nodiscard]] expected<void> write_deck(std::string_view format, const file_target& to,
                                        const mesh_version& mesh, const fem::load_case& loads,
                                        const std::string& title);

}  // namespace tedit::decks
