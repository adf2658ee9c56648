// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/metrics.hpp"

/// What sessions count, for the process's metrics.
namespace tedit::actors::numbers {

[[nodiscard]] metrics::gauge& open_documents();
[[nodiscard]] metrics::gauge& subscriptions();
[[nodiscard]] metrics::counter& heads_moved(const std::string& kind);
/// Edits that were made for another version than the head.
[[nodiscard]] metrics::counter& carried_over(bool done);
[[nodiscard]] metrics::counter& solves();
[[nodiscard]] metrics::counter& failed_solves();

}  // namespace tedit::actors::numbers
