// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/hash.hpp"

#include <gtest/gtest.h>

namespace tedit {

TEST(Hash, EmptyInputHasThePublishedXxh3Value) {
  EXPECT_EQ(to_hex(hash_bytes({})), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, HexRoundTrips) {
  const hash128 hash{0x0123456789abcdefULL, 0xfedcba9876543210ULL};

  EXPECT_EQ(to_hex(hash), "0123456789abcdeffedcba9876543210");
  EXPECT_EQ(hash_from_hex(to_hex(hash)), hash);
}

TEST(Hash, WrongTextIsRefused) {
  EXPECT_FALSE(hash_from_hex("").has_value());
  EXPECT_FALSE(hash_from_hex("0123456789abcdeffedcba987654321").has_value());
  EXPECT_FALSE(hash_from_hex("0123456789ABCDEFfedcba9876543210").has_value());
}

}  // namespace tedit
