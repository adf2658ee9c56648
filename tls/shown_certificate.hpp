// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tedit::tls {

/// The certificate that a server showed.
struct shown_certificate {
  std::string fingerprint;         ///< SHA-256, as "AB:CD:...".
  std::string name;                ///< Its subject, for people.
  std::string issuer;              ///< For people.
  std::vector<std::string> hosts;  ///< Names and addresses that it holds for.
  std::int64_t until = 0;          ///< Seconds since 1970.
  std::string fault;               ///< Why no authority vouches for it here; empty: one does.
};

}  // namespace tedit::tls
