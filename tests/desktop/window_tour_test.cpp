// SPDX-License-Identifier: AGPL-3.0-or-later
// The tour of the start page, by the words on its cards.
#include "tests/desktop/window_fixture.hpp"

namespace tedit::desktop {
namespace {

class Tour : public Window {
protected:
  [[nodiscard]] QString title() {
    auto* card = window->findChild<QFrame*>("tour_card");
    return card->isVisible() ? card->findChild<QLabel*>("tour_title")->text() : QString();
  }
  void press(const QString& words) {
    const QWidget* from = window.get();
    if (!title().isEmpty())
      from = window->findChild<QFrame*>("tour_card");
    for (auto* button : from->findChildren<QPushButton*>())
      if (button->isVisible() && button->text() == words)
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button " << words.toStdString();
  }
  void start() {
    press("Take the tour");
    ASSERT_TRUE(wait([&] { return title() == "Turn the part" && is_final(); }));
  }
};

TEST_F(Tour, IsDoneByDoingIt) {
  start();
  view().view().rotate(0.2, 0.1);
  emit view().view_changed();
  EXPECT_EQ(title(), "Pick a bore");
  window->context().picked.click(1, false);
  EXPECT_EQ(title(), "Close it");
  ASSERT_TRUE(wait([&] { return window->context().picked.feature().has_value(); }));
  window->tools().operations.panel().choose("fill_hole");
  EXPECT_EQ(title(), "Apply");
  QTest::keyClick(window.get(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return title() == "Read the result"; }));
  QTest::keyClick(window.get(), Qt::Key_R);
  EXPECT_EQ(title(), "Take it back");
  ASSERT_TRUE(wait([&] { return is_final(); }));
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return title() == "That is all"; }));
  EXPECT_EQ(version(), 0U);
  press("Close");
  EXPECT_EQ(title(), "");
}

TEST_F(Tour, ShowsWhatItAsksFor) {
  start();
  for (const auto* next :
       {"Pick a bore", "Close it", "Apply", "Read the result", "Take it back", "That is all"}) {
    ASSERT_TRUE(wait([&] { return is_final() || window->tools().operations.panel().form(); }));
    ASSERT_TRUE(wait([&] {
      return title() != "Apply" || !window->tools().operations.panel().preview().is_busy();
    }));
    ASSERT_TRUE(wait([&] { return !part().foreground().current(); }));
    press("Show me");
    ASSERT_TRUE(wait([&] { return title() == next; })) << next;
  }
  EXPECT_EQ(version(), 0U);
  EXPECT_EQ(part().versions().size(), 2U);
}

TEST_F(Tour, IsSkippedAndEndedAndGoesWithThePart) {
  start();
  press("Skip");
  EXPECT_EQ(title(), "Pick a bore");
  press("End the tour");
  EXPECT_EQ(title(), "");
  ASSERT_TRUE(window->context().all_commands.trigger("help.tour"));
  ASSERT_TRUE(wait([&] { return title() == "Turn the part" && is_final(); }));
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_EQ(title(), "");
  ASSERT_TRUE(window->context().all_commands.trigger("help.tour"));
  ASSERT_TRUE(wait([&] { return title() == "Turn the part" && is_final(); }));
  ASSERT_TRUE(window->context().all_commands.trigger("file.close"));
  ASSERT_TRUE(wait([&] { return !part().is_open(); }));
  EXPECT_EQ(title(), "");
}

}  // namespace
}  // namespace tedit::desktop
