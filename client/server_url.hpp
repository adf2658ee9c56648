// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"

namespace tedit::client {

/// Where a server is, from "ws://HOST[:PORT][/PATH]" or "wss://...".
struct server_url {
  bool secure = false;    ///< With TLS.
  std::string host;       ///< Without brackets.
  std::string port;       ///< A number: 80, or 443 with TLS, when it is not said.
  std::string authority;  ///< As it stands in the URL, for the Host header.
  std::string target;     ///< Path and query, begins with '/'.

  /// Host and port, as "hall.example.org:7464" or "[::1]:7464".
  [[nodiscard]] std::string place() const;
};

/// Errors: `invalid_argument`.
[[nodiscard]] expected<server_url> parse_server_url(const std::string& url);

}  // namespace tedit::client
