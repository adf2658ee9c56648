// SPDX-License-Identifier: AGPL-3.0-or-later
// The window before a part is open, and as it is found again.
#include "tests/desktop/window_fixture.hpp"

#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QToolBar>

#include "client-qt/tools/pictures/kept_picture.hpp"

namespace tedit::desktop {
namespace {

class Start : public Window {
protected:
  [[nodiscard]] QStringList shown_docks() {
    QStringList result;
    for (const auto* dock : window->findChildren<QDockWidget*>())
      if (!dock->isHidden())
        result << dock->objectName();
    result.sort();
    return result;
  }
  [[nodiscard]] QDockWidget* dock(const char* name) {
    return window->findChild<QDockWidget*>(name);
  }
  [[nodiscard]] bool has_rail() { return !window->findChild<QToolBar*>("rail")->isHidden(); }
};

TEST_F(Start, TheViewIsEmptyAndDrawsNothingBehindTheStartPage) {
  view().redraw();
  QTest::qWait(100);

  EXPECT_FALSE(view().isVisible());
  EXPECT_EQ(view().frames(), 0);
  EXPECT_EQ(view().geometry(), nullptr);
  const vec3 corner{0.1, 0.2, 0.3};
  EXPECT_EQ(view().to_frame(corner), view().to_widget(corner));  // No frame: no NaN.
}

TEST_F(Start, EveryShippedPartHasItsPicture) {
  const auto cards = window->findChildren<QPushButton*>("example");
  ASSERT_EQ(cards.size(), 3);
  for (const auto* card : cards) {
    const auto* picture = card->findChild<QLabel*>("example_picture");
    ASSERT_NE(picture, nullptr) << card->accessibleName().toStdString();
    EXPECT_FALSE(picture->pixmap().isNull());
    EXPECT_TRUE(card->rect().contains(picture->geometry()));
  }
}

/// Corners of a picture that let what is behind them through.
int clear_corners(const QImage& picture) {
  int clear = 0;
  for (const int x : {0, picture.width() - 1})
    for (const int y : {0, picture.height() - 1})
      clear += picture.pixelColor(x, y).alpha() == 0 ? 1 : 0;
  return clear;
}

TEST_F(Start, PicturesHaveTheGroundOfThePageInEveryLook) {
  for (const auto* card : window->findChildren<QPushButton*>("example")) {
    const auto picture = card->findChild<QLabel*>("example_picture")->pixmap().toImage();
    EXPECT_EQ(clear_corners(picture), 4) << card->accessibleName().toStdString();
  }

  open_plate();
  const QString kept = picture_file(state.path(), part().name());
  ASSERT_TRUE(wait([&] { return QFile::exists(kept) && !QImage(kept).isNull(); }));
  const QImage picture(kept);
  EXPECT_EQ(clear_corners(picture), 4);
  EXPECT_EQ(picture.pixelColor(picture.rect().center()).alpha(), 255) << "the part";
}

TEST_F(Start, NothingEmptyStandsBesideTheStartPage) {
  EXPECT_TRUE(shown_docks().isEmpty()) << shown_docks().join(" ").toStdString();
  EXPECT_FALSE(has_rail());

  open_plate(false);
  EXPECT_EQ(shown_docks(), (QStringList{"context", "field", "history", "loads", "log", "probes",
                                        "receipt", "results"}));
  EXPECT_TRUE(has_rail());
  EXPECT_EQ(window->dockWidgetArea(dock("context")), Qt::RightDockWidgetArea);
  EXPECT_FALSE(dock("history")->visibleRegion().isEmpty());  // In front of its tabs.
}

TEST_F(Start, TheLayoutIsAsItWasWhenAPartIsOpenedAgain) {
  open_plate(false);
  dock("loads")->hide();
  window->addDockWidget(Qt::LeftDockWidgetArea, dock("field"));
  const auto name = part().name();
  const auto shown = shown_docks();

  part().files().close();
  EXPECT_TRUE(shown_docks().isEmpty()) << shown_docks().join(" ").toStdString();
  EXPECT_FALSE(has_rail());
  window->tools().documents.open_document(name);
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_EQ(shown_docks(), shown);
  EXPECT_EQ(window->dockWidgetArea(dock("field")), Qt::LeftDockWidgetArea);

  part().files().close();
  window->close();
  window = std::make_unique<main_window>(state.path());
  window->show();
  EXPECT_TRUE(shown_docks().isEmpty());
  window->tools().documents.open_document(name);
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_EQ(shown_docks(), shown);
  EXPECT_EQ(window->dockWidgetArea(dock("field")), Qt::LeftDockWidgetArea);
}

TEST_F(Start, WhatWasOpenIsFoundWithItsPictureAndCanBeTakenFromTheList) {
  open_plate();
  const auto name = part().name();
  const QString picture = state.path() + "/pictures/" + name + ".png";
  ASSERT_TRUE(wait([&] { return QFile::exists(picture); }));
  part().files().close();

  auto* list = window->findChild<QListWidget*>("recent");
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->isVisible());
  EXPECT_TRUE(list->item(0)->text().contains("today")) << list->item(0)->text().toStdString();
  list->setCurrentRow(0);
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(list->count(), 0);
  window->close();
  window = std::make_unique<main_window>(state.path());
  window->show();
  EXPECT_EQ(window->findChild<QListWidget*>("recent")->count(), 0);

  window->tools().documents.open_document(name);  // It is still there.
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_EQ(part().loads().all().size(), 1U);
}

TEST_F(Start, TheHelpStaysBesideTheStartPageAndThePart) {
  ASSERT_TRUE(window->context().all_commands.trigger("help.manual"));
  EXPECT_EQ(shown_docks(), QStringList{"help"});
  open_plate(false);
  EXPECT_TRUE(shown_docks().contains("help"));
  part().files().close();
  EXPECT_EQ(shown_docks(), QStringList{"help"});
}

TEST_F(Start, WhatIsBeingOpenedIsSaidOnTheStartPageAndCanBeCancelled) {
  window->tools().documents.open_file(plate(), {});
  auto* stage = window->findChild<QLabel*>("welcome_stage");
  ASSERT_TRUE(wait([&] { return part().foreground().current().has_value(); }));
  EXPECT_TRUE(stage->isVisible());
  EXPECT_TRUE(stage->text().contains("ctc01_plate.coarse.msh")) << stage->text().toStdString();

  press("welcome_cancel");
  ASSERT_TRUE(wait([&] { return !part().foreground().current(); }));
  EXPECT_FALSE(stage->isVisible());
}

TEST_F(Start, TheIconsOfOfferedOperationsHaveTheColourOfTheWords) {
  window->context().look.set_dark(false);
  open_plate(false);
  window->context().picked.set({98});
  const auto ink = [&] {
    const auto* offer = window->findChild<QPushButton*>("offer_fill_hole");
    const QImage drawn = offer->icon().pixmap(16, 16).toImage();
    int lightest = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x)
        if (drawn.pixelColor(x, y).alpha() > 200)
          lightest = std::max(lightest, drawn.pixelColor(x, y).lightness());
    return lightest;
  };
  EXPECT_LT(ink(), 128);

  window->context().look.set_dark(true);
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_GT(ink(), 128);
}

TEST_F(Start, ThePartFitsTheViewAgainUntilItIsTurned) {
  open_plate(false);
  const auto far = [&] {
    const auto pose = view().view().get();
    const vec3 way = pose.position - pose.focus;
    return std::sqrt(dot(way, way));
  };
  const double before = far();
  const int width = view().width();
  window->resize(window->width() - 250, window->height());
  ASSERT_TRUE(wait([&] { return view().width() < width; }));
  const double narrow = far();
  const int narrow_width = view().width();
  EXPECT_GT(narrow, 1.05 * before);

  view().view().rotate(0.1, 0);
  window->resize(window->width() + 250, window->height());
  // The docks may keep a little of it.
  ASSERT_TRUE(wait([&] { return view().width() > narrow_width; })) << narrow_width;
  EXPECT_NEAR(far(), narrow, 1e-9);
}

TEST_F(Start, MarksMoveWithTheFrameNotAheadOfIt) {
  open_plate(false);
  ASSERT_TRUE(wait([&] { return view().is_seen() && view().seen() == view().asked(); }));
  const vec3 corner{view().geometry()->bounds[1], 0, 0};
  const QPointF before = view().to_frame(corner);
  EXPECT_EQ(before, view().to_widget(corner));

  view().view().rotate(0.1, 0);
  view().redraw();

  EXPECT_NE(view().to_widget(corner), before);  // Where the next frame has it.
  EXPECT_EQ(view().to_frame(corner), before);
  ASSERT_TRUE(wait([&] { return view().seen() == view().asked(); }));
  EXPECT_EQ(view().to_frame(corner), view().to_widget(corner));
}

}  // namespace
}  // namespace tedit::desktop
