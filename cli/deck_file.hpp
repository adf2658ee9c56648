// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "fem/calculix_deck.hpp"
#include "fem/load_case.hpp"
#include "mesh/version.hpp"

namespace tedit::cli {

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

/// Writes a deck for CalculiX. Ids, names and regions go into it, and the load case that its cards
/// stand for: so that `tedit convert` gets all of it back. Errors: `io_error`.
[[nodiscard]] expected<fem::calculix_counts> write_calculix_file(const std::filesystem::path& file,
                                                                 const deck_job& job,
                                                                 fem::calculix_solver solver);

}  // namespace tedit::cli
