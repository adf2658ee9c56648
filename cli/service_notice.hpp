// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace tedit::cli {

/// Tells the service manager that started this process ("READY=1", "STOPPING=1"): a datagram to
/// $NOTIFY_SOCKET (sd_notify(3)). Nothing without the variable, or where nobody listens.
void tell_service_manager(const std::string& state);

}  // namespace tedit::cli
