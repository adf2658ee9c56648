// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/gateway/users.hpp"
#include "tedit/v1/envelope.pb.h"

namespace tedit::gateway {

/// The least role that may ask for this; all of it stands here.
[[nodiscard]] access_role least_role(const v1::ClientMessage& message);

/// Errors: `permission_denied`, naming the role that is needed.
[[nodiscard]] expected<void> check_role(access_role has, const v1::ClientMessage& message);

}  // namespace tedit::gateway
