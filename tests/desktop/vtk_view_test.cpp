// SPDX-License-Identifier: AGPL-3.0-or-later
// Frames are drawn beside the window: what it does meanwhile, and that no change is lost.
#include "client-qt/view/vtk_view.hpp"

#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <vtkRenderer.h>

#include <atomic>
#include <future>

namespace tedit::desktop {
namespace {

constexpr int longest_wait_ms = 60'000;

class bare_view : public vtk_view {
public:
  using vtk_view::change;
  using vtk_view::end_drawing;
  ~bare_view() override { end_drawing(); }

  void paint(double red, double green, double blue) {
    change([=](vtkRenderer& renderer) { renderer.SetBackground(red, green, blue); });
    redraw();
  }
};

/// A view on the screen, with a first frame.
class VtkView : public ::testing::Test {
protected:
  std::unique_ptr<bare_view> view = std::make_unique<bare_view>();

  void SetUp() override {
    view->resize(64, 48);
    view->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(view.get()));
    ASSERT_TRUE(all_seen());
  }

  [[nodiscard]] bool all_seen() {
    return QTest::qWaitFor([&] { return view->seen() == view->asked(); }, longest_wait_ms);
  }
};

TEST_F(VtkView, AFrameHasThePixelsOfTheScreenRightWayRound) {
  view->change([](vtkRenderer& renderer) {
    renderer.GradientBackgroundOn();
    renderer.SetBackground(1, 0, 0);   // At the bottom,
    renderer.SetBackground2(0, 0, 1);  // and at the top.
  });
  view->redraw();

  const auto picture = view->picture();

  ASSERT_EQ(picture.size(), QSize(64, 48));
  EXPECT_TRUE(view->is_fine());
  EXPECT_GT(qBlue(picture.pixel(32, 1)), 240);
  EXPECT_LT(qRed(picture.pixel(32, 1)), 15);
  EXPECT_GT(qRed(picture.pixel(32, 46)), 240);
  EXPECT_LT(qBlue(picture.pixel(32, 46)), 15);
}

TEST_F(VtkView, TheWindowWorksOnWhileAFrameIsDrawn) {
  std::promise<void> go_on;
  std::atomic<bool> draws = false;
  view->change([&draws, gate = go_on.get_future().share()](vtkRenderer& renderer) {
    draws = true;
    gate.wait();
    renderer.SetBackground(0, 1, 0);
  });
  const int before = view->frames();
  view->redraw();

  // The frame waits for what only this loop can do: drawn here, it would wait for ever.
  ASSERT_TRUE(QTest::qWaitFor([&] { return draws.load(); }, longest_wait_ms));
  int events = 0;
  for (int i = 0; i < 3; ++i)
    QTimer::singleShot(0, view.get(), [&] { ++events; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return events == 3; }, longest_wait_ms));
  EXPECT_EQ(view->frames(), before);
  EXPECT_LT(view->seen(), view->asked());

  go_on.set_value();
  ASSERT_TRUE(all_seen());
  EXPECT_EQ(view->frames(), before + 1);
  EXPECT_EQ(qGreen(view->last_picture().pixel(32, 24)), 255);
}

TEST_F(VtkView, ManyWishesDuringAFrameMakeOneFrameMore) {
  std::promise<void> go_on;
  std::atomic<bool> draws = false;
  view->change([&draws, gate = go_on.get_future().share()](vtkRenderer&) {
    draws = true;
    gate.wait();
  });
  const int before = view->frames();
  view->redraw();
  ASSERT_TRUE(QTest::qWaitFor([&] { return draws.load(); }, longest_wait_ms));
  for (int i = 1; i <= 50; ++i)
    view->paint(0, 0, i / 50.0);

  go_on.set_value();

  ASSERT_TRUE(all_seen());
  EXPECT_EQ(view->frames(), before + 2);
  EXPECT_EQ(qBlue(view->last_picture().pixel(32, 24)), 255);  // The last wish.
}

TEST_F(VtkView, APictureWaitsForWhatWasChanged) {
  for (const auto& [red, blue] : {std::pair{1, 0}, {0, 1}}) {
    view->paint(red, 0, blue);
    const auto picture = view->picture();
    EXPECT_EQ(qRed(picture.pixel(5, 5)), 255 * red);
    EXPECT_EQ(qBlue(picture.pixel(5, 5)), 255 * blue);
  }
}

TEST_F(VtkView, AHiddenViewKeepsChangesInOrderAndDrawsNothing) {
  view->hide();
  const int before = view->frames();
  std::vector<int> order;
  for (int i = 0; i < 200; ++i) {
    view->change([&order, i](vtkRenderer&) { order.push_back(i); });
    view->redraw();
  }
  QTest::qWait(50);
  EXPECT_EQ(view->frames(), before);

  (void)view->picture();  // Waits for the thread that writes.

  ASSERT_EQ(order.size(), 200U);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

TEST_F(VtkView, AQuickFrameHasFewerPixelsAndAFineOneFollows) {
  view->draw_quickly();
  view->redraw();
  ASSERT_TRUE(all_seen());

  ASSERT_TRUE(QTest::qWaitFor([&] { return view->is_fine(); }, longest_wait_ms));
  EXPECT_EQ(view->last_picture().size(), QSize(64, 48));
}

TEST_F(VtkView, MayBeClosedWhileAFrameIsDrawn) {
  std::atomic<int> done = 0;
  for (int i = 0; i < 20; ++i) {
    view->change([&done](vtkRenderer&) { ++done; });
    view->redraw();
    QCoreApplication::processEvents();
  }
  view.reset();

  const int at_the_end = done;
  QTest::qWait(20);
  EXPECT_EQ(done, at_the_end);  // Nothing is changed any more.
}

}  // namespace
}  // namespace tedit::desktop
