// SPDX-License-Identifier: AGPL-3.0-or-later
// Surfaces by words and keys in the real window.
#include "tests/desktop/window_fixture.hpp"

#include <QLineEdit>
#include <QListWidget>

#include <cmath>
#include <set>

namespace tedit::desktop {
namespace {

class Finder : public Window {
protected:
  [[nodiscard]] QLineEdit* letters() { return window->findChild<QLineEdit*>("finder_letters"); }
  [[nodiscard]] QListWidget* hits() { return window->findChild<QListWidget*>("finder_hits"); }
  [[nodiscard]] const std::vector<surface_id>& picked() {
    return window->context().picked.surfaces();
  }
  void open_finder() {
    QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier);
    ASSERT_TRUE(letters()->isVisible());
    ASSERT_TRUE(letters()->hasFocus());
  }
  [[nodiscard]] testing::AssertionResult finds(const QString& words, const QString& first_row) {
    letters()->clear();
    QTest::keyClicks(letters(), words);
    return wait([=, this] { return hits()->count() > 0 && hits()->item(0)->text() == first_row; });
  }
};

/// The last column of an image with ink, of what stands in it.
int end_of_ink(const QImage& row) {
  const QColor ground = row.pixelColor(row.width() - 1, row.height() / 2);
  for (int x = row.width() - 1; x >= 0; --x)
    for (int y = 0; y < row.height(); ++y)
      if (std::abs(row.pixelColor(x, y).lightness() - ground.lightness()) > 60)
        return x;
  return -1;
}

TEST_F(Finder, AreasEndBelowEachOther) {
  open_plate(false);
  open_finder();
  ASSERT_GE(hits()->count(), 4);
  QApplication::processEvents();

  const auto image = hits()->viewport()->grab().toImage();
  std::set<int> ends;
  for (int i = 0; i < 4; ++i)  // 1911.15 and 176158 mm2 and others.
    ends.insert(end_of_ink(image.copy(hits()->visualItemRect(hits()->item(i)))));

  EXPECT_EQ(ends.size(), 1U);
  EXPECT_GT(*ends.begin(), hits()->viewport()->width() / 2);
  EXPECT_EQ(hits()->item(0)->data(Qt::AccessibleTextRole).toString(),
            QString::fromUtf8("Surface 1, 1911.15 mm²"));
}

TEST_F(Finder, BoresAreSelectedByTheirDiameter) {
  open_plate(false);
  open_finder();

  // Two of 20 mm, of four surfaces each.
  ASSERT_TRUE(finds("bores 19 to 21 mm", "All 2 bores"));
  EXPECT_EQ(hits()->count(), 3);
  QTest::keyClick(letters(), Qt::Key_Return);

  EXPECT_FALSE(letters()->isVisible());
  EXPECT_EQ(picked(), (std::vector<surface_id>{51, 52, 53, 54, 57, 58, 59, 60}));
}

TEST_F(Finder, KeysWalkThroughSurfacesAndEscLeavesTheSelectionAsItWas) {
  open_plate(false);
  window->context().picked.set({7});
  open_finder();
  EXPECT_EQ(hits()->count(), 117);
  EXPECT_EQ(picked(), (std::vector<surface_id>{7})) << "nothing is shown before it is walked to";

  QTest::keyClick(letters(), Qt::Key_Down);
  EXPECT_EQ(picked(), (std::vector<surface_id>{1}));
  QTest::keyClick(letters(), Qt::Key_Down);
  EXPECT_EQ(picked(), (std::vector<surface_id>{2}));
  QTest::keyClick(letters(), Qt::Key_Escape);

  EXPECT_EQ(picked(), (std::vector<surface_id>{7}));
  EXPECT_FALSE(letters()->isVisible());
}

TEST_F(Finder, EqualBoresAndNeighboursBelongToTheSelection) {
  open_plate(false);
  open_finder();
  EXPECT_TRUE(finds("equal", "Select a surface first"));
  QTest::keyClick(letters(), Qt::Key_Escape);

  window->context().picked.click(1, false);
  ASSERT_TRUE(wait([&] { return window->context().picked.feature().has_value(); }));
  const auto bore = picked();
  open_finder();
  ASSERT_TRUE(wait([&] { return hits()->count() > 0; }));
  letters()->clear();
  QTest::keyClicks(letters(), "equal");
  ASSERT_TRUE(
    wait([&] { return hits()->count() > 0 && hits()->item(0)->text().endsWith(" bores"); }));
  EXPECT_GT(picked().size(), bore.size());
  for (const auto id : bore)
    EXPECT_TRUE(window->context().picked.contains(id));
}

TEST_F(Finder, WhatIsNotThereIsSaidAndTakesNothing) {
  open_plate(false);
  window->context().picked.set({7});
  open_finder();
  ASSERT_TRUE(finds("bores 900 mm", "There is no such bore"));
  QTest::keyClick(letters(), Qt::Key_Return);
  EXPECT_EQ(picked(), (std::vector<surface_id>{7}));
  open_finder();
  EXPECT_TRUE(finds("lid", "No surface has \"lid\" in its name"));
}

}  // namespace
}  // namespace tedit::desktop
