// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "node/node.hpp"

/// What solver.cpp and observer.cpp share.
namespace tedit::node {

[[nodiscard]] inline auto join(const place& where, const cancel_token& stop) {
  return actors::membership::join(
    actors::join_place{where.host, where.port, where.certificates, TEDIT_VERSION}, stop);
}

/// Nothing when it was stopped, whatever came of that.
[[nodiscard]] inline expected<void> unless_stopped(const error& why, const cancel_token& stop) {
  if (stop.cancelled())
    return {};
  return fail(why);
}

[[nodiscard]] inline error gone() {
  return {ec::service_unavailable, "the server is gone", "Join again in a moment", {}};
}

}  // namespace tedit::node
