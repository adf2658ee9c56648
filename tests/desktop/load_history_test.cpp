// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/load_history.hpp"

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

/// One load case with this pressure.
load_history::load_cases pressed(double pa) {
  fem::load_case one;
  one.name = "press";
  one.loads.push_back({{4}, fem::pressure{pa}});
  return {one};
}

TEST(LoadHistory, GoesBackAndForthOverChanges) {
  load_history past;
  past.changed(3, {}, pressed(1));
  past.changed(3, pressed(1), pressed(2));

  ASSERT_NE(past.to_undo(3, pressed(2)), nullptr);
  EXPECT_EQ(*past.to_undo(3, pressed(2)), pressed(1));
  EXPECT_EQ(past.to_redo(3, pressed(2)), nullptr);
  past.undone(3);
  EXPECT_EQ(*past.to_undo(3, pressed(1)), load_history::load_cases{});
  EXPECT_EQ(*past.to_redo(3, pressed(1)), pressed(2));
  past.undone(3);
  EXPECT_EQ(past.to_undo(3, {}), nullptr);
  past.redone(3);
  past.redone(3);
  EXPECT_EQ(past.to_redo(3, pressed(2)), nullptr);
  EXPECT_EQ(*past.to_undo(3, pressed(2)), pressed(1));
}

TEST(LoadHistory, AChangeAfterAnUndoEndsWhatCouldBeRedone) {
  load_history past;
  past.changed(0, pressed(1), pressed(2));
  past.undone(0);
  past.changed(0, pressed(1), pressed(5));

  EXPECT_EQ(past.to_redo(0, pressed(5)), nullptr);
  EXPECT_EQ(*past.to_undo(0, pressed(5)), pressed(1));
}

TEST(LoadHistory, EachVersionHasItsOwn) {
  load_history past;
  past.changed(0, pressed(1), pressed(2));

  EXPECT_EQ(past.to_undo(1, pressed(2)), nullptr);
  past.changed(1, pressed(2), pressed(3));
  past.undone(1);
  EXPECT_EQ(*past.to_undo(0, pressed(2)), pressed(1));
}

TEST(LoadHistory, WhatSomebodyElseChangedIsNotTakenBack) {
  load_history past;
  past.changed(0, pressed(1), pressed(2));

  EXPECT_EQ(past.to_undo(0, pressed(7)), nullptr);
  past.changed(0, pressed(7), pressed(8));
  EXPECT_EQ(*past.to_undo(0, pressed(8)), pressed(7));
  past.undone(0);
  EXPECT_EQ(past.to_undo(0, pressed(7)), nullptr);
}

TEST(LoadHistory, NoChangeIsNoStep) {
  load_history past;
  past.changed(0, pressed(1), pressed(1));
  EXPECT_EQ(past.to_undo(0, pressed(1)), nullptr);
  past.changed(0, pressed(1), pressed(2));
  past.clear();
  EXPECT_EQ(past.to_undo(0, pressed(2)), nullptr);
}

}  // namespace
}  // namespace tedit::desktop
