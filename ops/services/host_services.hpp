// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "ops/mesher/mesher.hpp"

namespace tedit::ops {

/// The host's services: CGAL for planar triangulation, the program `tedit-mesher` for tets and
/// booleans.
[[nodiscard]] std::unique_ptr<services> make_host_services();

/// The same for what is only looked at while a value is dragged: booleans are drafts
/// (`draft_with_tool`).
[[nodiscard]] std::unique_ptr<services> make_draft_services();

/// `services::triangulate`, in its own .cpp.
[[nodiscard]] expected<planar_filling> triangulate_polygon(const planar_polygon& polygon,
                                                           double spacing);

}  // namespace tedit::ops
