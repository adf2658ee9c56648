// SPDX-License-Identifier: AGPL-3.0-or-later
// The window on a small screen, in each of its languages: it fits, and no words are cut off.
#include "tests/desktop/window_fixture.hpp"

#include <QDockWidget>
#include <QPainter>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTranslator>
#include <QTreeWidget>

#include <cmath>

#include "client-qt/model/language.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/view/view_cube.hpp"
#include "client-qt/widgets/tall_scroll.hpp"

namespace tedit::desktop {
namespace {

constexpr QSize small_screen{1280, 720};

class Fit : public Window, public testing::WithParamInterface<const char*> {
protected:
  /// As the program makes its window: with the size before it is shown.
  void SetUp() override {
    if (!languages().contains(GetParam()))
      GTEST_SKIP() << "built without qt6-l10n-tools";
    speak(*qApp, GetParam());
    Window::SetUp();
    window.reset();
    window = std::make_unique<main_window>(state.path());
    window->take_size(small_screen);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    QApplication::setActiveWindow(window.get());
  }

  void TearDown() override {
    Window::TearDown();
    qDeleteAll(qApp->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }

  void run(const char* command) {
    ASSERT_TRUE(window->context().all_commands.trigger(command)) << command;
    QApplication::processEvents();
  }

  /// Docks take up what stands in them a moment later: no more than that is waited for.
  [[nodiscard]] static bool settles(const std::function<bool()>& until) {
    return QTest::qWaitFor(until, 5000);
  }

  /// Of the docks at the right, for who reads that they are not as they should be.
  [[nodiscard]] std::string heights() {
    std::string all;
    for (const auto* name : {"context", "field", "loads", "receipt"}) {
      const auto& dock = window->context().panels.of(name);
      all += std::string(" ") + name + " " + std::to_string(dock.height()) + " for " +
             std::to_string(dock.widget()->sizeHint().height());
    }
    return all;
  }

  void preview_an_erosion() {
    auto& panel = window->tools().operations.panel();
    window->context().picked.set({7});
    panel.choose("erode");
    ASSERT_TRUE(wait([&] { return panel.preview().shown() && !panel.preview().is_busy(); }));
    QApplication::processEvents();
  }

  /// The window, and every form in it that scrolls up and down only.
  void expect_it_fits(const char* state) {
    QApplication::processEvents();
    EXPECT_LE(window->minimumSizeHint().width(), small_screen.width()) << state;
    EXPECT_EQ(window->width(), small_screen.width()) << state;
    for (const auto* form : window->findChildren<tall_scroll*>()) {
      if (!form->isVisible())
        continue;
      EXPECT_LE(form->widget()->minimumSizeHint().width(), form->viewport()->width())
        << state << ": " << form->parentWidget()->objectName().toStdString();
    }
  }

private:
  const QLocale before_;
};

TEST_P(Fit, TheWindowIsNoWiderThanASmallScreenWhateverIsOpen) {
  EXPECT_EQ(window->width(), small_screen.width()) << "on the start page";
  open_plate();
  expect_it_fits("a part");
  preview_an_erosion();
  expect_it_fits("an edit's form");
  run("loads.add_load");
  expect_it_fits("a load's form");
  run("loads.add_material");
  expect_it_fits("a material's form");
  run("help.manual");
  expect_it_fits("the help");
  for (auto* dock : window->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    expect_it_fits(qPrintable(dock->objectName()));
  }
}

TEST_P(Fit, ResultsNeedNoScrollingSideways) {
  open_plate();
  run("view.results");

  const auto* list = window->findChild<QTreeWidget*>("results_list");
  ASSERT_TRUE(wait([&] { return list->isVisible() && list->topLevelItemCount() > 0; }));
  EXPECT_TRUE(wait([&] { return list->horizontalScrollBar()->maximum() == 0; }));
}

TEST_P(Fit, TheFiguresOfAPreviewAreInSightAndWhole) {
  open_plate();
  preview_an_erosion();

  const auto* figures = window->findChild<QLabel*>("preview_figures");
  ASSERT_FALSE(figures->text().isEmpty());
  // Docks take up what their forms need a moment later.
  EXPECT_TRUE(wait([&] { return figures->height() >= figures->heightForWidth(figures->width()); }))
    << figures->height() << " of " << figures->heightForWidth(figures->width());
  EXPECT_EQ(figures->visibleRegion().boundingRect(), figures->rect());
  QTextDocument words;
  words.setDefaultFont(figures->font());
  words.setHtml(figures->text());
  words.setTextWidth(figures->width());
  EXPECT_LE(words.size().width(), figures->width()) << "cells are cut off";
  const auto* apply = window->findChild<QPushButton*>("apply");
  EXPECT_EQ(apply->visibleRegion().boundingRect(), apply->rect());
}

TEST_P(Fit, WhatIsSaidLeavesTheViewCubeFreeAndLosesNoLine) {
  open_plate(false);
  const auto* cube = window->findChild<view_cube*>();
  auto& said = window->context().messages;
  for (const bool with_help : {false, true}) {
    if (with_help)
      run("help.manual");
    said.show_news("Version 1 of /tmp/" + QString("plate").repeated(30) +
                   ".tedit is safe, all of it.");
    // Its words are fitted to the room that it gets, and its height to the words.
    const auto whole = [&] {
      const auto labels = said.findChildren<QLabel*>();
      return std::ranges::all_of(labels, [](const QLabel* one) {
        return !one->isVisible() || one->height() >= one->heightForWidth(one->width());
      });
    };
    EXPECT_TRUE(wait(whole)) << with_help;
    EXPECT_FALSE(said.geometry().intersects(cube->geometry())) << with_help;
    EXPECT_TRUE(window->context().pages.rect().contains(said.geometry())) << with_help;
  }
}

TEST_P(Fit, TheBarOfASectionLeavesThePartsFootFree) {
  open_plate(false);
  run("view.results");
  ASSERT_TRUE(wait([&] { return view().is_settled(); }));
  const auto before = view().view().get();

  run("view.section");

  const auto* bar = window->findChild<QWidget*>("section_bar");
  ASSERT_TRUE(wait([&] { return bar->isVisible() && view().is_settled(); }));
  const auto& box = view().geometry()->bounds;
  for (int corner = 0; corner < 8; ++corner) {
    const auto at = view().to_widget({box[static_cast<std::size_t>(corner & 1)],
                                      box[static_cast<std::size_t>(2 + (corner >> 1 & 1))],
                                      box[static_cast<std::size_t>(4 + (corner >> 2 & 1))]});
    EXPECT_LT(at.y(), bar->geometry().top()) << "corner " << corner;
  }
  run("view.section");
  const vec3 moved = view().view().get().position - before.position;
  EXPECT_LT(std::sqrt(dot(moved, moved)), 1e-9) << "and gives the room back";
}

TEST_P(Fit, TheBarOfASectionStandsInTheMiddle) {
  open_plate(false);
  run("view.section");
  const auto* bar = window->findChild<QWidget*>("section_bar");
  ASSERT_TRUE(wait([&] { return bar->isVisible(); }));

  const int left = bar->geometry().left();
  EXPECT_NEAR(left, view().width() - (left + bar->width()), 1);
}

TEST_P(Fit, AllFiguresOfAPreviewAreInSightOnALargerScreen) {
  window->resize(1600, 1000);
  open_plate();
  preview_an_erosion();

  const auto* all = window->findChild<QLabel*>("preview_details");
  ASSERT_TRUE(all->isVisible());
  // Docks take up what their forms need a moment later.
  EXPECT_TRUE(settles([&] { return all->visibleRegion().boundingRect() == all->rect(); }))
    << all->visibleRegion().boundingRect().height() << " of " << all->height();
}

TEST_P(Fit, WhatAnEditDidHasTheRoomThatItsFormDoesNotNeedUntilTheNextSurface) {
  window->resize(1600, 1000);
  open_plate();
  preview_an_erosion();
  auto& receipt = window->context().panels.of("receipt");
  const auto* apply = window->findChild<QPushButton*>("apply");
  const auto place = [&] { return apply->mapTo(window.get(), QPoint()); };
  const QPoint before = place();
  press("apply");
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  const int least = 200;  // Of 120 that it had.
  EXPECT_TRUE(settles([&] { return receipt.height() >= least; })) << heights();
  EXPECT_EQ(apply->visibleRegion().boundingRect(), apply->rect());

  window->context().picked.set({5});
  ASSERT_TRUE(
    wait([&] { return window->tools().operations.panel().preview().shown() != nullptr; }));
  EXPECT_TRUE(settles([&] { return place() == before; }))
    << place().y() << " of " << before.y() << heights();
}

TEST_P(Fit, ALoadsFormTakesWhatOthersCanSpare) {
  window->resize(1600, 1000);
  open_plate();
  window->tools().operations.panel().choose("fill_hole");
  QApplication::processEvents();
  run("loads.add_load");

  const auto* form = window->tools().loads.panel().editor()->findChild<tall_scroll*>();
  EXPECT_TRUE(settles([&] { return form->verticalScrollBar()->maximum() == 0; })) << heights();
}

TEST_P(Fit, TheHelpBeginsWithTheOperationThatItWasAskedFor) {
  open_plate(false);
  window->tools().operations.panel().choose("improve_mesh");
  run("help.manual");

  const auto* page = window->findChild<QTextBrowser*>("help_page");
  const auto& about = part().operations().find("improve_mesh")->about;
  const auto top = [&] { return page->cursorForPosition(QPoint(20, 4)).block().text(); };
  EXPECT_TRUE(settles([&] { return top() == QString::fromStdString(about.name); }))
    << top().toStdString();
}

TEST_P(Fit, TheHelpBeginsWithWhatCanBeDone) {
  open_plate(false);
  run("help.manual");

  const auto* page = window->findChild<QTextBrowser*>("help_page");
  const auto top = [&] { return page->cursorForPosition(QPoint(20, 4)).block().text(); };
  EXPECT_TRUE(settles([&] { return top() == "The flow"; })) << top().toStdString();
}

TEST_P(Fit, ADifferenceShowsAllOfThePart) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  run("view.compare");
  const auto* after = window->findChild<viewport*>("compare_after");
  ASSERT_TRUE(wait([&] { return after->is_settled() && after->geometry(); }));
  const int narrow = after->width();

  run("view.compare_difference");
  ASSERT_TRUE(wait([&] { return after->width() > narrow && after->is_settled(); }));

  const auto lies_in = [&] {
    const auto& box = after->geometry()->bounds;
    for (int corner = 0; corner < 8; ++corner) {
      const QPointF at = after->to_widget({box[static_cast<std::size_t>(corner & 1)],
                                           box[static_cast<std::size_t>(2 + (corner >> 1 & 1))],
                                           box[static_cast<std::size_t>(4 + (corner >> 2 & 1))]});
      if (!QRectF(after->rect()).contains(at))
        return false;
    }
    return true;
  };
  EXPECT_TRUE(wait(lies_in)) << "the legend below cuts its foot off";
}

/// How many rows of pixels have ink between two columns.
int rows_with_ink(const QImage& image, int from, int to) {
  int rows = 0;
  for (int y = 0; y < image.height(); ++y) {
    const QColor ground = image.pixelColor(from, y);
    bool any = false;
    for (int x = from; x < to && !any; ++x)
      any = std::abs(image.pixelColor(x, y).lightness() - ground.lightness()) > 40;
    rows += any ? 1 : 0;
  }
  return rows;
}

TEST_P(Fit, TitlesOfDocksKeepTheirDescenders) {
  open_plate(false);
  auto& dock = window->context().panels.of("history");
  window->context().panels.raise("history");
  dock.setWindowTitle("dpgy");
  QApplication::processEvents();
  const QFontMetrics by(dock.font());
  const int width = 8 + by.horizontalAdvance("dpgy");

  const auto title = dock.grab(QRect(0, 0, width, dock.widget()->y())).toImage();

  QImage whole(width, 3 * by.height(), QImage::Format_RGB32);
  whole.fill(Qt::white);
  {
    QPainter painter(&whole);
    painter.setFont(dock.font());
    painter.drawText(8, 2 * by.height(), "dpgy");
  }
  EXPECT_EQ(rows_with_ink(title, 1, width), rows_with_ink(whole, 1, width));
}

INSTANTIATE_TEST_SUITE_P(Languages, Fit, testing::Values("en", "de"),
                         [](const auto& one) { return std::string(one.param); });

/// A load case without a load cannot be solved: it is this window's own.
TEST_F(Window, ALoadCaseThatIsNotCompleteIsThereAgainWhenTheDocumentIs) {
  open_plate(false);
  auto* list = &window->tools().loads.panel();
  window->context().picked.set({7});
  list->add_item(item_kind::support);
  press("apply_item");
  ASSERT_EQ(list->drafts().size(), 1U);
  const auto before = list->drafts().front();
  ASSERT_FALSE(missing(before).isEmpty());
  bool renamed = false;
  part().files().rename("with_a_draft",
                        [&](const expected<void>& ok) { renamed = ok.has_value(); });
  ASSERT_TRUE(wait([&] { return renamed && part().name() == "with_a_draft"; }));
  part().files().close();
  EXPECT_TRUE(list->drafts().empty());

  window = std::make_unique<main_window>(state.path());
  window->show();
  list = &window->tools().loads.panel();
  window->tools().documents.open_document("with_a_draft");
  ASSERT_TRUE(wait([&] { return shows_head() && !list->drafts().empty(); }));
  ASSERT_EQ(list->drafts().size(), 1U);
  EXPECT_EQ(list->drafts().front().name, before.name);
  ASSERT_EQ(list->drafts().front().constraints.size(), 1U);
  EXPECT_EQ(list->drafts().front().constraints.front().surfaces, std::vector<surface_id>{7});

  list->tree()->setCurrentItem(list->tree()->topLevelItem(0));
  list->remove_current();
  part().files().close();
  window->tools().documents.open_document("with_a_draft");
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_TRUE(list->drafts().empty()) << "what was discarded stays so";
}

}  // namespace
}  // namespace tedit::desktop
