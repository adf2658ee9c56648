// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/basp_guard.hpp"
#include "tests/fuzz/promise.hpp"

namespace {

using namespace tedit;

// docs/decisions/0036: what CAF 0.17.6 may see.
constexpr std::uint8_t client_handshake = 1;
constexpr std::uint8_t direct_message = 2;
constexpr std::uint8_t routed_message = 3;
constexpr std::uint8_t heartbeat = 6;

/// Actors with an odd number are within reach.
bool is_odd(std::uint64_t actor) {
  return actor % 2 == 1;
}

/// What holds of every header that CAF is shown; how long the payload behind it is.
std::uint32_t check_header(std::span<const std::uint8_t> header, bool first) {
  fuzz::require(header.size() == actors::basp_guard::header_bytes, "a header is whole");
  fuzz::require(header[0] <= heartbeat && header[0] != routed_message, "its operation is known");
  fuzz::require(!first || header[0] <= client_handshake, "the first message is a handshake");
  std::uint32_t announced = 0;
  for (std::size_t i = 4; i < 8; ++i)
    announced = announced << 8 | header[i];
  fuzz::require(announced <= actors::basp_guard::most_payload, "a payload is bounded");
  fuzz::require((announced == 0) == (header[0] == heartbeat), "all but heartbeats have a payload");
  return announced;
}

}  // namespace

/// The bytes are what a peer sends: pieces as CAF reads them, headers and the payloads that they
/// announce. Whatever the guard admits keeps the rules that CAF does not check itself.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in({data, size});
  actors::basp_guard guard(is_odd);
  bool first = true;
  std::uint32_t announced = 0;
  while (!in.at_end()) {
    const bool is_header = announced == 0;
    const auto header_or_payload =
      in.take(is_header ? actors::basp_guard::header_bytes : announced);
    const bool whole = is_header || header_or_payload.size() == announced;
    if (!guard.admits(std::as_bytes(header_or_payload)))
      return 0;
    fuzz::require(whole, "a payload that is cut off is refused");
    announced = is_header ? check_header(header_or_payload, first) : 0;
    first = false;
  }
  return 0;
}
