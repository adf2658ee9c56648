// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/surface.hpp"
#include "fem/load_case.hpp"
#include "protocol/report.hpp"

namespace tedit::client {

/// What an edit would make of the head (message `tedit.v1.EditPreview`). Its version is stored
/// nowhere and cannot be asked for.
struct edit_preview {
  surface_update surface;  ///< The difference to the surface of the head that it names.
  edit_report report;      ///< As the edit's would be.
  std::uint64_t tets = 0;
  std::uint64_t vertices = 0;
  std::uint64_t boundary_facets = 0;
  std::vector<fem::load_case> load_cases;  ///< As they would be carried over.
  /// Only what is seen: no tets, nothing checked. Never where a whole preview was asked for.
  bool draft = false;
};

/// How much of a preview is asked for.
enum class preview_kind {
  draft,  ///< What is seen of it, several times sooner: while a value is dragged.
  whole,  ///< What the edit makes and says, with its refusal.
  /// The same; where it is refused the most that works is looked for, which takes up to 3 s longer.
  whole_or_most,
};

}  // namespace tedit::client
