// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "actors/interfaces.hpp"
#include "actors/pages/page_cache.hpp"

namespace tedit::actors {

/// A solve of less (tets times load cases) is over before others have got the version.
inline constexpr double least_to_spread = 100'000;

/// Stands for all solvers: a solve of several load cases goes to as many machines as are free, the
/// cases shared out among them, and comes back as one; all else goes to `solvers` as it is
/// (docs/decisions/0049). Fields that are shown are brought here, into `cache`, and held until
/// whoever asked had time to fetch them. What only files have stays where it was made, and over a
/// slow line what only watchers need (docs/decisions/0066); `pages` knows where.
/// @param pages the store of this process.
[[nodiscard]] solver_actor make_case_spreading(caf::actor_system& system, solver_actor solvers,
                                               page_store_actor pages,
                                               std::shared_ptr<page_cache> cache);

}  // namespace tedit::actors
