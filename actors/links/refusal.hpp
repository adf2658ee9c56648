// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "certs/role.hpp"

namespace tedit::actors {

/// Who is at the other end of a link over TLS, as its certificate says, which held when it came.
struct link_peer {
  std::string name;
  certs::role what = certs::role::client;
  std::string serial;
  std::string address;           ///< "10.0.0.7:51234", "[::1]:51234".
  std::int64_t valid_until = 0;  ///< Seconds since 1970.
};

/// Why a connection came to no link.
enum class refusal : std::uint8_t {
  silent,           ///< Did not end its handshake in time.
  crowded,          ///< Too many at once, or from one address: the oldest of them had to go.
  full,             ///< No more links.
  gone,             ///< Left during the handshake.
  not_tls,          ///< Bytes that are no TLS.
  old_tls,          ///< Speaks no TLS 1.3.
  not_a_node,       ///< Speaks TLS, but nothing of ours.
  no_certificate,   ///< Showed none.
  other_authority,  ///< Its certificate is not of this node's authority, or broken.
  ended,            ///< Its certificate has ended, or has not begun.
  revoked,          ///< Its certificate stands on the list.
  wrong_role,       ///< Its role is not admitted.
  wrong_host,       ///< A server whose certificate does not hold for the host that was dialled.
  refused_us,       ///< Did not want this node.
  too_often,        ///< Its address, or all strangers together, tried too often.
};

inline constexpr std::size_t refusal_count = 15;

/// A few words for a log: "its certificate was revoked".
[[nodiscard]] std::string_view refusal_text(refusal why);

/// How many were refused, by `refusal`.
using refusal_counts = std::array<std::uint64_t, refusal_count>;

}  // namespace tedit::actors
