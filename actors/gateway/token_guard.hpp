// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "actors/gateway/users.hpp"

namespace tedit::gateway {

/// Knows the token of a server and those of its users, and makes guessing one slow. Who knows it is
/// let in at once, whatever others of the same address do: only answers to wrong tokens wait,
/// longer with each of them, and those of one address one after the other. Thread-safe.
class token_guard {
public:
  using clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds first_delay{100};
  static constexpr std::chrono::milliseconds longest_delay{3200};
  /// An answer that would wait longer is not given; the connection ends by its hello timeout.
  static constexpr std::chrono::milliseconds longest_wait{4000};
  /// Without a wrong token for so long an address is as good as new.
  static constexpr std::chrono::seconds forgotten_after{60};

  /// An empty token: nobody is asked for one. `users` null: there are none.
  explicit token_guard(std::string token, std::shared_ptr<user_book> users = nullptr)
      : token_(std::move(token)), users_(std::move(users)) {}

  /// Whom this token lets in; a user's may have ended (`grant::has_ended`). None: it is wrong.
  /// Takes as long for any text of the same length.
  [[nodiscard]] std::optional<grant> admits(const std::string& token) const;

  /// What a user's token of this number says by now; none when it was withdrawn.
  [[nodiscard]] std::optional<grant> admits(std::int64_t number) const;

  /// Notes a wrong token from an address ("127.0.0.1"); how long its answer waits, nothing when it
  /// gets none.
  [[nodiscard]] std::optional<std::chrono::milliseconds> turn_away(const std::string& address,
                                                                   clock::time_point now);

  /// Wrong tokens since the server started.
  [[nodiscard]] std::uint64_t turned_away() const { return turned_away_; }

private:
  struct guesser {
    unsigned guesses = 0;
    clock::time_point last;
    clock::time_point free;  ///< When the last answer is given.
  };

  void forget_old(clock::time_point now);

  const std::string token_;
  const std::shared_ptr<user_book> users_;
  std::atomic<std::uint64_t> turned_away_{0};
  std::mutex mutex_;  ///< Guards what follows.
  std::map<std::string, guesser> guessers_;
  clock::time_point next_line_;  ///< Of the log.
  std::uint64_t unlogged_ = 0;
};

}  // namespace tedit::gateway
