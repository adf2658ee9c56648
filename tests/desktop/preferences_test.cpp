// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/preferences.hpp"

#include <gtest/gtest.h>

#include <QTemporaryDir>

namespace tedit::desktop {
namespace {

class Preferences : public testing::Test {
protected:
  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("settings.ini"), QSettings::IniFormat};
};

TEST_F(Preferences, AreKeptAndRead) {
  preferences wanted;
  wanted.look = look_wish::dark;
  wanted.language = "de";
  wanted.device = "cpu";
  wanted.element_order = 1;
  wanted.energy_tolerance = 0.05;
  wanted.map = colour_map::cividis;
  wanted.locked = true;
  wanted.logarithmic = true;
  wanted.log = log_level::errors;

  save(wanted, settings_);

  EXPECT_EQ(load_preferences(settings_), wanted);
}

TEST_F(Preferences, WhatMakesNoSenseIsAsIfItWereNotThere) {
  settings_.setValue("look", "pink");
  settings_.setValue("solve/element_order", 7);
  settings_.setValue("solve/energy_tolerance", -3);

  EXPECT_EQ(load_preferences(settings_), preferences{});
}

TEST_F(Preferences, ReachTheSolver) {
  preferences wanted;
  wanted.device = "cpu";
  wanted.element_order = 1;

  const auto solve = solve_settings_of(wanted);

  EXPECT_TRUE(solve.all_load_cases);
  EXPECT_EQ(solve.device, "cpu");
  EXPECT_EQ(solve.element_order, 1);
}

class Shortcuts : public Preferences {
protected:
  Shortcuts() {
    all_.add({"edit.undo", "Undo", "Edit", "Ctrl+Z", [] {}});
    all_.add({"view.fit", "Fit", "View", "F", [] {}});
    all_.add({"view.free", "Free", "View", "", [] {}});
  }

  commands all_;
  shortcut_table table_{all_, settings_};
};

TEST_F(Shortcuts, AreTheOwnOnesUntilTheyAreTheDefaultAgain) {
  table_.set(*all_.find("view.fit"), "G");
  EXPECT_EQ(table_.keys(*all_.find("view.fit")), "G");

  table_.set(*all_.find("view.fit"), "F");

  EXPECT_EQ(table_.keys(*all_.find("view.fit")), "F");
  EXPECT_FALSE(settings_.contains("shortcut/view.fit"));
}

TEST_F(Shortcuts, AConflictIsNamedOnlyForAnotherCommand) {
  const auto others = table_.others_with("ctrl+z", "view.fit");

  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0]->id, "edit.undo");
  EXPECT_TRUE(table_.others_with("F", "view.fit").empty());
  EXPECT_TRUE(table_.others_with("", "view.fit").empty());
}

TEST_F(Shortcuts, TheSheetHasGroupsAndLeavesOutCommandsWithoutKeys) {
  EXPECT_EQ(table_.as_text(), "Edit\n  Ctrl+Z          Undo\n\nView\n  F               Fit\n");
}

}  // namespace
}  // namespace tedit::desktop
