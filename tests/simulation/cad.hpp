// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "actors/interfaces.hpp"
#include "actors/store/document.hpp"
#include "tests/simulation/timeline.hpp"

namespace tedit::simulation {

using namespace actors;

/// Takes its time for each edit and fails now and then; what it says of a version follows from the
/// version: `is_made`.
[[nodiscard]] caf::actor spawn_cad_editor(caf::actor_system& system, timeline& time);

/// Whether the made-up CAD model can have the edit that led to this version.
[[nodiscard]] bool is_made(const hash128& version);

/// A document with one version that came from CAD. Errors: those of `store::document`.
[[nodiscard]] expected<void> make_cad_document(const std::filesystem::path& file);

}  // namespace tedit::simulation
