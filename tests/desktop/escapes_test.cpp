// SPDX-License-Identifier: AGPL-3.0-or-later
#include <QStringList>

#include <gtest/gtest.h>

#include "client-qt/context/escapes.hpp"

namespace tedit::desktop {
namespace {

class Escapes : public ::testing::Test {
protected:
  escapes esc_;
  QStringList ended_;
  bool boxing_ = false;
  bool form_open_ = true;

  /// In another order than they are asked in.
  void SetUp() override {
    add(ends::selection, "selection", nullptr);
    add(ends::form, "form", &form_open_);
    add(ends::drag_mode, "box", &boxing_);
  }

  void add(ends place, const char* name, bool* there) {
    esc_.add(place, [this, name, there] {
      if (there && !std::exchange(*there, false))
        return false;
      ended_ << name;
      return true;
    });
  }
};

TEST_F(Escapes, OneEndsTheFirstThatIsThere) {
  esc_.run();

  EXPECT_EQ(ended_, QStringList{"form"});
}

TEST_F(Escapes, TheOrderIsTheListsNotThatOfTheTools) {
  boxing_ = true;

  for (int i = 0; i < 3; ++i)
    esc_.run();

  EXPECT_EQ(ended_, (QStringList{"box", "form", "selection"}));
}

}  // namespace
}  // namespace tedit::desktop
