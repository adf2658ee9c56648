// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "client-qt/model/legend.hpp"
#include "client/types.hpp"

namespace tedit::desktop {

/// The shown quantity at place `i` of a field's arrays, SI; NaN where it has none.
[[nodiscard]] float value_in(const client::field_event& field, std::size_t i, shown_field wanted);

/// The same at a vertex slot; NaN when the field has no value there. Cost: O(log vertices).
[[nodiscard]] float value_at(const client::field_event& field, std::uint32_t slot,
                             shown_field wanted);

}  // namespace tedit::desktop
