// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

namespace tedit::actors {

/// Looks at every piece of BASP, the protocol between CAF's nodes, before CAF 0.17.6 parses it:
/// that version dereferences null for a handshake without payload, allocates whatever a header
/// claims, lets any peer end any actor by an exit message, and send to each actor that any peer has
/// heard of. Pieces alternate as CAF reads them:
/// a header of 32 bytes, then the payload that it announced, if it announced one.
///
/// Admitted are: a handshake, which may come twice, as the first message; after it direct messages
/// that are not forwarded, end no actor and go to one within reach, or are what CAF's brokers say
/// to each other; monitor and down messages, heartbeats. All but heartbeats have a payload, of
/// `most_payload` bytes at most. Cost: a header or the first few bytes of a payload.
class basp_guard {
public:
  /// Control messages; pages travel in batches of 256 KiB.
  static constexpr std::uint32_t most_payload = std::uint32_t{64} << 20;
  static constexpr std::size_t header_bytes = 32;

  enum class receiver { within_reach, spawn_server, out_of_reach };

  /// Says of an actor's number whether the peer may send to it; empty: to each.
  using reach = std::function<bool(std::uint64_t actor)>;

  explicit basp_guard(reach within = {}) : within_(std::move(within)) {}

  /// Whether the piece may reach CAF; once one may not, the link must be cut.
  [[nodiscard]] bool admits(std::span<const std::byte> piece);

private:
  [[nodiscard]] bool admits_header(std::span<const std::byte> header);

  reach within_;
  receiver receiver_ = receiver::within_reach;  ///< Of the message whose payload comes next.
  std::uint8_t operation_ = 0;
  std::uint32_t announced_ = 0;  ///< Bytes of the payload that comes next; 0: a header does.
  unsigned greetings_ = 0;
  bool talking_ = false;  ///< Something else than a handshake has come.
};

}  // namespace tedit::actors
