// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text.hpp"

#include <gtest/gtest.h>

namespace tedit {
namespace {

TEST(Text, Utf8IsToldFromOtherBytes) {
  for (const char* good : {"", "plain", "Bohrung Süd", "\u20AC", "\U0001F529", "\uFFFD", "\uD7FF"})
    EXPECT_TRUE(is_utf8(good)) << good;
  for (const char* bad : {"S\xFC"
                          "d",
                          "\x80", "\xC3", "\xE2\x82", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                          "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFE"})
    EXPECT_FALSE(is_utf8(bad)) << bad;
}

TEST(Text, WhatIsNoUtf8IsReplacedByteByByte) {
  EXPECT_EQ(to_utf8("S\xFC"
                    "d"),
            "S\uFFFDd");
  EXPECT_EQ(to_utf8("a\xE2\x82"), "a\uFFFD\uFFFD");
  EXPECT_EQ(to_utf8("Süd \U0001F529"), "Süd \U0001F529");
  std::string every(256, '\0');
  for (std::size_t i = 0; i < every.size(); ++i)
    every[i] = static_cast<char>(i);
  EXPECT_TRUE(is_utf8(to_utf8(every)));
}

TEST(Text, IsCutBetweenCharacters) {
  EXPECT_EQ(cut_text("abc", 3), "abc");
  EXPECT_EQ(cut_text("abc", 2), "ab");
  EXPECT_EQ(cut_text("aü", 2), "a");
  EXPECT_EQ(cut_text("a\u20AC"
                     "b",
                     3),
            "a");
  EXPECT_EQ(cut_text("a\u20AC"
                     "b",
                     4),
            "a\u20AC");
  EXPECT_EQ(cut_text("\U0001F529", 3), "");
}

}  // namespace
}  // namespace tedit
