// SPDX-License-Identifier: AGPL-3.0-or-later
// What the rows of CAD models in a document mean.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "actors/local_messages.hpp"
#include "cad/model.hpp"

namespace tedit::actors {

/// The row of a version that the model has; its number is left to who stores it.
[[nodiscard]] store::cad_row row_with(const cad::cad_model& model, double deviation_m);

/// The same for one that is in the mesh only.
[[nodiscard]] store::cad_row row_without_model(std::string reason);

/// The model in a row. Errors: `not_found` for one without, `internal` for one that cannot be read.
[[nodiscard]] expected<cad::cad_model> model_in(const store::cad_row& row);

[[nodiscard]] cad_state cad_state_of(const store::cad_row& row);

/// Why the versions after one that is in the mesh only are so, too: "version 3 (move) is in the
/// mesh only: ...".
[[nodiscard]] std::string reason_after(const version_info& mesh_only, const std::string& reason);

/// Why an edit is in the mesh only whose request is not known.
inline constexpr const char* unknown_request = "the document does not say how it was made";

/// The requests of the edits that made these versions, as the log of their document has them. Older
/// programs logged none. Cost: O(log), of which the lines of edits are read.
[[nodiscard]] std::map<std::uint32_t, edit_request> requests_in(
  const std::vector<store::log_row>& log, const std::set<std::uint32_t>& versions);

}  // namespace tedit::actors
