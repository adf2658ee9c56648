// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/token_guard.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <openssl/crypto.h>
#include <openssl/sha.h>

#include "base/logging/logging.hpp"

namespace tedit::gateway {

namespace {

/// Addresses that are remembered; an attacker with more of them is not kept off by delays.
constexpr std::size_t most_guessers = 1024;

std::array<unsigned char, SHA256_DIGEST_LENGTH> digest(const std::string& text) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> result{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), result.data());
  return result;
}

}  // namespace

std::optional<grant> token_guard::admits(const std::string& token) const {
  // Of equal length whatever was given, so that the comparison does not tell the token's.
  const auto given = digest(token);
  const auto known = digest(token_);
  if (token_.empty() || CRYPTO_memcmp(given.data(), known.data(), given.size()) == 0)
    return grant{};
  return users_ ? users_->find(token) : std::nullopt;
}

std::optional<grant> token_guard::admits(std::int64_t number) const {
  return users_ ? users_->find(number) : std::nullopt;
}

void token_guard::forget_old(clock::time_point now) {
  std::erase_if(guessers_, [&](const auto& g) { return now - g.second.last > forgotten_after; });
  if (guessers_.size() < most_guessers)
    return;
  const auto by_time = [](const auto& a, const auto& b) { return a.second.last < b.second.last; };
  guessers_.erase(std::ranges::min_element(guessers_, by_time));
}

std::optional<std::chrono::milliseconds> token_guard::turn_away(const std::string& address,
                                                                clock::time_point now) {
  ++turned_away_;
  const std::lock_guard lock(mutex_);
  forget_old(now);
  auto& who = guessers_[address];
  who.last = now;
  const auto doublings = std::min(who.guesses++, 10U);
  ++unlogged_;
  if (now >= next_line_) {  // A flood must not fill the disk.
    logging::warn(
      "{}: wrong token, {} from there lately; {} since the server started, {} since the "
      "last such line",
      address, who.guesses, turned_away_.load(), std::exchange(unlogged_, 0));
    next_line_ = now + std::chrono::seconds(1);
  }
  const auto delay = std::min(first_delay * (1U << doublings), longest_delay);
  const auto free = std::max(who.free, now) + delay;
  if (free - now > longest_wait)
    return std::nullopt;
  who.free = free;
  return std::chrono::duration_cast<std::chrono::milliseconds>(free - now);
}

}  // namespace tedit::gateway
