// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <optional>
#include <vector>

#include "client-qt/model/version_store.hpp"

namespace tedit::desktop {

/// A line of what was found, and the places that it is about.
struct print_row {
  QString title;
  QString value;
  bool fault = false;                     ///< It hinders printing.
  std::optional<vec3> at = {};            ///< A place of the part, m.
  std::vector<surface_id> surfaces = {};  ///< Of the place.
  std::vector<print_row> places = {};     ///< The largest first; the last may count the rest.
};

/// A person's name for a surface.
using surface_namer = std::function<QString(surface_id)>;

/// Places of one kind that are listed.
inline constexpr std::size_t most_print_rows = 100;

/// What was found, in a person's words.
[[nodiscard]] std::vector<print_row> print_rows(const client::print_check& made,
                                                const surface_namer& name_of);

/// The way that looks away from some surfaces into the part where all of them lie in one plane:
/// what the build direction is when they lie on the plate. Nothing where they do not, within a
/// degree. Cost: O(facets).
[[nodiscard]] std::optional<vec3> up_from(const client::surface_model& part,
                                          const std::vector<surface_id>& surfaces);

}  // namespace tedit::desktop
