// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "client-qt/model/document.hpp"

/// What of the version before can be set beside a version's figures.
namespace tedit::desktop {

/// The report of a load case; null when it is not there.
[[nodiscard]] const solve_report* report_of(const solve_outcome& outcome, const std::string& name);

/// A load case of a version by its name; null when it is not there or not known.
[[nodiscard]] const fem::load_case* loads_of(const version_record& version,
                                             const std::string& name);

/// The final report of the same load case of `before`, when it was solved with elements of the same
/// order and the same loads: a difference is then the edit's doing. Null otherwise, and without
/// `before`. Surfaces may differ, and whatever else the edit's receipt says of them.
[[nodiscard]] const solve_report* comparable_report(const solve_report& now,
                                                    const version_record& version,
                                                    const version_record* before);

/// The envelope of `before`, when that is of the same load cases and each of them is comparable.
[[nodiscard]] std::optional<solve_envelope> comparable_envelope(const solve_outcome& now,
                                                                const version_record& version,
                                                                const version_record* before);

}  // namespace tedit::desktop
