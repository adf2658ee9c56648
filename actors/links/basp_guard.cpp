// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/basp_guard.hpp"

#include <string_view>
#include <utility>

namespace tedit::actors {

namespace {

// `caf::io::basp::message_type`; the numbers are the protocol's.
constexpr std::uint8_t client_handshake = 1;
constexpr std::uint8_t direct_message = 2;
constexpr std::uint8_t routed_message = 3;
constexpr std::uint8_t heartbeat = 6;

/// Who joins greets again when it has chosen this of its connections.
constexpr unsigned most_greetings = 2;

/// A number of eight bytes, the highest first: of the actor that a message is for. With a flag it
/// is a name.
constexpr std::size_t receiver_at = 24;
constexpr std::size_t flags_at = 3;
constexpr std::uint8_t by_name = 1;

/// CAF's brokers ask each other's "SpawnServ" (ten letters in eight bytes) what it is, and answer a
/// helper of the asker, which only they know: messages of these types are for nobody else.
constexpr std::uint64_t spawn_server = 278614525059968507U;
constexpr std::string_view brokers_question = "@<>+@atom+@atom+@str";
constexpr std::string_view brokers_answer = "@<>+@atom+@str+@strong_actor_ptr+@str";

std::uint8_t byte_at(std::span<const std::byte> bytes, std::size_t i) {
  return std::to_integer<std::uint8_t>(bytes[i]);
}

/// Reads a size in CAF's variable-length form (seven bits a byte, the lowest first) at `at`, which
/// moves behind it. False when the bytes end first or the size needs more than 32 bits.
bool read_size(std::span<const std::byte> bytes, std::size_t& at, std::uint32_t& size) {
  size = 0;
  for (unsigned shift = 0; shift < 32; shift += 7) {
    if (at >= bytes.size())
      return false;
    const auto b = byte_at(bytes, at++);
    size |= std::uint32_t{b & 0x7fU} << shift;
    if (b < 0x80)
      return true;
  }
  return false;
}

using receiver = basp_guard::receiver;

/// The payload of a direct message begins with the actors that forwarded it (a count), a type
/// number (two bytes, 0 for what has a name) and the names of the types that it holds.
bool is_harmless(std::span<const std::byte> payload, receiver whom) {
  std::size_t at = 0;
  std::uint32_t forwarders = 0;
  if (!read_size(payload, at, forwarders) || forwarders != 0)
    return false;
  for (const auto end = at + 2; at < end; ++at)
    if (at >= payload.size() || payload[at] != std::byte(0))
      return false;
  std::uint32_t length = 0;
  if (!read_size(payload, at, length) || length > payload.size() - at)
    return false;
  const std::string_view types(reinterpret_cast<const char*>(payload.data() + at), length);
  if (whom == receiver::spawn_server)
    return types == brokers_question;
  if (whom == receiver::out_of_reach)
    return types == brokers_answer;
  return types.find("@exit") == std::string_view::npos;
}

std::uint64_t number_at(std::span<const std::byte> header, std::size_t first) {
  std::uint64_t result = 0;
  for (std::size_t i = first; i < first + 8; ++i)
    result = result << 8 | byte_at(header, i);
  return result;
}

}  // namespace

bool basp_guard::admits_header(std::span<const std::byte> header) {
  if (header.size() != header_bytes)
    return false;
  operation_ = byte_at(header, 0);
  announced_ = 0;
  for (std::size_t i = 4; i < 8; ++i)
    announced_ = announced_ << 8 | byte_at(header, i);
  if (operation_ <= client_handshake) {
    if (talking_ || ++greetings_ > most_greetings)
      return false;
  } else if (greetings_ == 0) {
    return false;
  } else {
    talking_ = true;
  }
  const auto whom = number_at(header, receiver_at);
  const bool named = (byte_at(header, flags_at) & by_name) != 0;
  receiver_ = !named && (!within_ || within_(whom)) ? receiver::within_reach
              : named && whom == spawn_server       ? receiver::spawn_server
                                                    : receiver::out_of_reach;
  return operation_ <= heartbeat && operation_ != routed_message && announced_ <= most_payload &&
         (announced_ == 0) == (operation_ == heartbeat);
}

bool basp_guard::admits(std::span<const std::byte> piece) {
  if (announced_ == 0)
    return admits_header(piece);
  const auto expected = std::exchange(announced_, 0);
  return piece.size() == expected &&
         (operation_ != direct_message || is_harmless(piece, receiver_));
}

}  // namespace tedit::actors
