// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/features/select.hpp"

namespace tedit::v1 {
class SelectSurfaces;
class SurfacesSelected;
}  // namespace tedit::v1

namespace tedit::protocol {

/// Errors: `invalid_argument` for a kind that is not known.
[[nodiscard]] expected<selection_query> from_message(const v1::SelectSurfaces& message);
void to_message(const selection_query& query, v1::SelectSurfaces* out);

[[nodiscard]] std::vector<found_feature> from_message(const v1::SurfacesSelected& message);
void to_message(const std::vector<found_feature>& features, v1::SurfacesSelected* out);

}  // namespace tedit::protocol
