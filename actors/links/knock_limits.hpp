// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace tedit::actors {

/// How often a door gives a handshake.
struct knock_rates {
  /// Failed ones of an address that cost it nothing; each further one makes the next wait, twice as
  /// long as the last one did.
  unsigned free_failures = 8;
  std::chrono::milliseconds first_pause{250};
  std::chrono::milliseconds longest_pause{30'000};
  /// Without a failed one for so long an address is as good as new.
  std::chrono::milliseconds forgotten_after = std::chrono::minutes(2);
  /// In all: so many at once, and then so many a second. A handshake is a millisecond of the door's
  /// thread.
  unsigned at_once = 512;
  unsigned per_second = 100;
  /// Addresses from which somebody came in so lately are given one beyond that, so that a flood
  /// from elsewhere keeps out no machine that works here.
  std::chrono::milliseconds known_for = std::chrono::hours(1);
};

/// Who may knock at a door for nodes: those whose handshakes fail wait longer each time, by
/// address, and all together are bounded. Holds 4096 addresses at most of each kind; the one that
/// has been quiet longest goes first. One thread.
class knock_limits {
public:
  using time_point = std::chrono::steady_clock::time_point;
  static constexpr std::size_t most_addresses = 4096;

  explicit knock_limits(knock_rates rates) : rates_(rates), left_(rates.at_once) {}

  /// Whether somebody of this address gets a handshake now, which then counts.
  [[nodiscard]] bool admits(const std::string& address, time_point now);
  /// Its handshake has failed, for a reason that stands in the way of the next, too.
  void failed(const std::string& address, time_point now);
  /// Somebody of this address came in: what others of it did before is forgotten.
  void came_in(const std::string& address, time_point now);

private:
  struct failures {
    unsigned count = 0;
    time_point last;
    time_point free;  ///< When the next handshake is given.
  };

  void refill(time_point now);
  [[nodiscard]] bool is_known(const std::string& address, time_point now) const;

  const knock_rates rates_;
  double left_;  ///< Handshakes that may be given now.
  time_point filled_{};
  std::map<std::string, failures> failures_;
  std::map<std::string, time_point> known_;  ///< When somebody came in last.
};

/// What of an address in numbers one owner has: all of an IPv4 address, the first half of an IPv6
/// one ("2001:db8:0:1::/64"); an IPv4 address in IPv6's form is as without. Any other text stays.
[[nodiscard]] std::string owner_part(const std::string& address);

}  // namespace tedit::actors
