// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/model/version_store.hpp"
#include "client/surface.hpp"

namespace tedit::desktop {

/// What is still known of a field on the surface that an edit would make: its values at vertices
/// that are on both surfaces at the same place, as a field of the version `after`. It is the field
/// before the edit, and nothing that a solver found for the new part; where the edit changed the
/// surface there is none. Cost: O(vertices).
[[nodiscard]] shared_field carried_field(const client::field_event& field,
                                         const client::surface_model& before,
                                         const client::surface_model& after);

}  // namespace tedit::desktop
