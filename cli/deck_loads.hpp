// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/deck_case.hpp"
#include "mesh/io/import.hpp"

namespace tedit::cli {

/// The load case of a deck: as TEdit wrote it into the file, where it did and the cards are still
/// those; else what its supports and loads make up (fem/deck_case.hpp). Errors: `not_found` for a
/// file without any.
[[nodiscard]] expected<fem::deck_case> load_case_of(const imported_mesh& mesh);

}  // namespace tedit::cli
