// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/token_guard.hpp"

#include <gtest/gtest.h>

namespace tedit::gateway {
namespace {

using namespace std::chrono_literals;

const auto noon = token_guard::clock::time_point(100h);

TEST(TokenGuard, AdmitsTheTokenAlone) {
  const token_guard guard("secret");
  EXPECT_TRUE(guard.admits("secret"));
  for (const char* wrong : {"", "secre", "secret ", "Secret", "secrets"})
    EXPECT_FALSE(guard.admits(wrong)) << wrong;
  EXPECT_TRUE(token_guard("").admits("anything"));
}

TEST(TokenGuard, GuessesOfOneAddressWaitLongerAndLongerOneAfterTheOther) {
  token_guard guard("secret");
  EXPECT_EQ(guard.turn_away("127.0.0.1", noon), 100ms);
  EXPECT_EQ(guard.turn_away("127.0.0.1", noon), 300ms);  // 100 and 200.
  EXPECT_EQ(guard.turn_away("127.0.0.1", noon), 700ms);  // and 400 more.
  EXPECT_EQ(guard.turn_away("127.0.0.1", noon + 700ms), 800ms);
  EXPECT_EQ(guard.turn_away("10.0.0.7", noon), 100ms);
  EXPECT_EQ(guard.turned_away(), 5u);
}

TEST(TokenGuard, AFloodIsAnsweredAtALimitedRate) {
  token_guard guard("secret");
  int answers = 0;
  for (auto t = 0ms; t < 60s; t += 10ms)  // 6000 guesses.
    answers += guard.turn_away("127.0.0.1", noon + t).has_value();
  EXPECT_GE(answers, 60 / 4);
  EXPECT_LE(answers, 6 + 60 / 3);
}

TEST(TokenGuard, AnAddressIsForgottenAfterAMinute) {
  token_guard guard("secret");
  for (int i = 0; i < 20; ++i)
    (void)guard.turn_away("127.0.0.1", noon);
  EXPECT_EQ(guard.turn_away("127.0.0.1", noon + 61s), 100ms);
}

TEST(TokenGuard, RemembersABoundedNumberOfAddresses) {
  token_guard guard("secret");
  for (int i = 0; i < 3000; ++i)
    (void)guard.turn_away("10.0." + std::to_string(i / 256) + "." + std::to_string(i % 256),
                          noon + std::chrono::milliseconds(i));
  EXPECT_EQ(guard.turn_away("10.0.0.0", noon + 3s), 100ms);     // The oldest was forgotten,
  EXPECT_EQ(guard.turn_away("10.0.11.183", noon + 3s), 299ms);  // the newest, 2999, was not.
}

}  // namespace
}  // namespace tedit::gateway
