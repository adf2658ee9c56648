// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tedit::actors {

/// Looks at every piece of BASP, the protocol between CAF's nodes, before CAF 0.17.6 parses it:
/// that version dereferences null for a handshake without payload, allocates whatever a header
/// claims, and lets any peer end any actor by an exit message. Pieces alternate as CAF reads them:
/// a header of 32 bytes, then the payload that it announced, if it announced one.
///
/// Admitted are: a handshake, which may come twice, as the first message; after it direct messages
/// that are not forwarded and end no actor, monitor and down messages, heartbeats. All but
/// heartbeats have a payload, of `most_payload` bytes at most. Cost: a header or the first few
/// bytes of a payload.
class basp_guard {
public:
  /// Control messages; pages travel in batches of 256 KiB.
  static constexpr std::uint32_t most_payload = std::uint32_t{64} << 20;
  static constexpr std::size_t header_bytes = 32;

  /// Whether the piece may reach CAF; once one may not, the link must be cut.
  [[nodiscard]] bool admits(std::span<const std::byte> piece);

private:
  [[nodiscard]] bool admits_header(std::span<const std::byte> header);

  std::uint8_t operation_ = 0;
  std::uint32_t announced_ = 0;  ///< Bytes of the payload that comes next; 0: a header does.
  unsigned greetings_ = 0;
  bool talking_ = false;  ///< Something else than a handshake has come.
};

}  // namespace tedit::actors
