// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <caf/error.hpp>

#include "base/error.hpp"

namespace tedit::actors {

/// An error of ours as CAF carries it, over the network too.
[[nodiscard]] caf::error to_caf(const error& e);

/// The inverse. What CAF itself reports becomes `timeout` or `service_unavailable`; `what` names
/// the work that failed.
[[nodiscard]] error from_caf(const caf::error& e, const std::string& what);

/// True for failures that another worker may not have: the worker died or did not answer.
[[nodiscard]] bool worth_a_retry(const error& e);

}  // namespace tedit::actors
