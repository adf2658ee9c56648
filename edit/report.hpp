// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/receipt.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/surface_map.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit {

/// An edit as it is asked for.
struct edit_request {
  std::string operation;
  std::vector<surface_id> surfaces;
  ops::parameters parameters;
  fem::carry_settings loads;  ///< What becomes of loads whose surface goes.

  friend bool operator==(const edit_request&, const edit_request&) = default;
};

/// All that a person wants to know about an edit that was made (message `tedit.v1.EditReport`).
struct edit_report {
  std::string from_version;  ///< 32 hexadecimal digits.
  std::string to_version;
  std::string operation;
  std::vector<surface_id> surfaces;
  std::vector<surface_id> surfaces_used;  ///< As the operation completed them.
  std::vector<surface_change> surface_map;
  fem::carry_settings loads;  ///< What was to become of loads whose surface goes.
  std::vector<fem::receipt_line> receipt;
  std::vector<std::string> notices;
  std::vector<ops::figure> figures;            ///< Numbers of this operation alone.
  std::optional<improve_report> optimisation;  ///< Of a thorough one; both figures are there.
  std::uint64_t tets_added = 0;
  std::uint64_t tets_removed = 0;
  double volume_change = 0;              ///< m^3.
  std::optional<touched_ratios> ratios;  ///< Empty where the edit made and changed no tet.
  double operation_ms = 0;
  double improve_ms = 0;
  double check_ms = 0;
  double total_ms = 0;
};

}  // namespace tedit
