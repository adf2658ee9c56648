// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/document_name.hpp"

#include <gtest/gtest.h>

namespace {

using namespace tedit::desktop;

const QDateTime then(QDate(2026, 11, 22), QTime(0, 53, 56));

TEST(DocumentName, HoldsTheFileAndTheTimeAndGivesThemBack) {
  const auto name = new_document_name("/home/me/two words.coarse.msh", then);
  EXPECT_EQ(name, "two_words.coarse-20261122-005356");
  EXPECT_EQ(title_of(name).words, "two_words.coarse");
  EXPECT_EQ(title_of(name).made, then);
}

TEST(DocumentName, IsATitleAsItIsWhenItWasGivenByAPerson) {
  for (const QString name : {"bracket", "bracket-2", "run-20261322-005356", "-20261122-005356"}) {
    EXPECT_EQ(title_of(name).words, name);
    EXPECT_FALSE(title_of(name).made.isValid());
  }
}

TEST(Moment, IsSaidAsAPersonWould) {
  const QDateTime now(QDate(2026, 3, 2), QTime(8, 0));
  EXPECT_TRUE(moment(QDateTime(QDate(2026, 3, 2), QTime(7, 5)), now).startsWith("today, "));
  EXPECT_TRUE(moment(QDateTime(QDate(2026, 3, 1), QTime(23, 5)), now).startsWith("yesterday, "));
  const auto earlier = moment(QDateTime(QDate(2026, 2, 27), QTime(23, 5)), now);
  EXPECT_TRUE(earlier.contains("27")) << earlier.toStdString();
}

}  // namespace
