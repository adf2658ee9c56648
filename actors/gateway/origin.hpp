// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tedit::gateway {

/// Whether a request with this Host header may be served: one of localhost, 127.0.0.1 and [::1], or
/// a name in `extra`, alone or with `:port`. An entry of `extra` that has a port of its own matches
/// only with that port. Upper and lower case are the same; nothing else is (no trailing dot, no
/// suffix). This is what stops a web page whose name was re-pointed at this machine (DNS
/// rebinding).
[[nodiscard]] bool host_allowed(std::string_view host_header, std::uint16_t port,
                                const std::vector<std::string>& extra = {});

/// Whether a page of this origin may open a connection. No origin at all (a native client) is
/// allowed, since the token guards it. Otherwise scheme, host and port must be exactly those of
/// http(s)://localhost|127.0.0.1|[::1] with this port, or of an entry of `allowed`, each written as
/// `scheme://host[:port]`; a missing port means 80 for http and 443 for https. Scheme and host
/// compare without regard to case. "null", wildcards, user names, paths and anything outside ASCII
/// never match, in `origin` as in `allowed`.
[[nodiscard]] bool origin_allowed(std::optional<std::string_view> origin, std::uint16_t port,
                                  const std::vector<std::string>& allowed);

}  // namespace tedit::gateway
