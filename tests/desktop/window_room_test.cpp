// SPDX-License-Identifier: AGPL-3.0-or-later
// Who has the room: docks that stand beside empty ones do not scroll, rows are whole, and what lies
// over the view covers neither the part nor other words.
#include "tests/desktop/window_fixture.hpp"

#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTranslator>
#include <QTreeWidget>

#include "client-qt/model/language.hpp"
#include "client-qt/tools/loads/load_editor.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/view/view_cube.hpp"
#include "client-qt/widgets/tall_scroll.hpp"

namespace tedit::desktop {
namespace {

struct screen {
  QSize size;
  const char* language;
};

std::string name_of(const screen& one) {
  return std::to_string(one.size.width()) + "x" + std::to_string(one.size.height()) + "_" +
         one.language;
}

class Room : public Window, public testing::WithParamInterface<screen> {
protected:
  /// As the program makes its window: with the size before it is shown.
  void SetUp() override {
    if (!languages().contains(GetParam().language))
      GTEST_SKIP() << "built without qt6-l10n-tools";
    speak(*qApp, GetParam().language);
    Window::SetUp();
    window.reset();
    window = std::make_unique<main_window>(state.path());
    window->take_size(GetParam().size);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    QApplication::setActiveWindow(window.get());
  }

  void TearDown() override {
    Window::TearDown();
    qDeleteAll(qApp->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }

  [[nodiscard]] QDockWidget& dock(const char* name) { return window->context().panels.of(name); }
  [[nodiscard]] context_panel& panel() { return window->tools().operations.panel(); }

  /// Docks take up what stands in them a moment later: no more than that is waited for.
  [[nodiscard]] static bool settles(const std::function<bool()>& until) {
    return QTest::qWaitFor(until, 5000);
  }

  [[nodiscard]] bool scrolls(const char* name) {
    for (const auto* area : dock(name).findChildren<QScrollArea*>())
      if (area->isVisible() && area->verticalScrollBar()->maximum() > 0)
        return true;
    return false;
  }

  [[nodiscard]] std::string heights() {
    std::string all;
    for (const auto* name : {"context", "field", "loads", "receipt"})
      all += std::string(" ") + name + " " + std::to_string(dock(name).height()) + " for " +
             std::to_string(dock(name).widget()->sizeHint().height());
    return all;
  }

  void fill_a_bore() {
    window->context().picked.set({1, 2});
    panel().choose("fill_hole");
    ASSERT_TRUE(wait([&] { return panel().preview().shown() && !panel().preview().is_busy(); }));
    press("apply");
    ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  }

  /// What of the part's box lies behind a part of the view, as it is drawn.
  [[nodiscard]] bool reaches(const QRect& place) {
    const auto& box = view().geometry()->bounds;
    const auto corner = [&](int i) {
      const auto at = [&](int bit) {
        return box[static_cast<std::size_t>(2 * bit + ((i >> bit) & 1))];
      };
      return view().to_widget({at(0), at(1), at(2)});
    };
    for (const auto& face : {std::array{0, 1, 3, 2},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 3, 7, 6},
                             {0, 2, 6, 4},
                             {1, 3, 7, 5}}) {
      QPolygonF shape;
      for (const int i : face)
        shape << corner(i);
      if (shape.intersects(QPolygonF(QRectF(place))))
        return true;
    }
    return false;
  }

private:
  const QLocale before_;
};

TEST_P(Room, TheFieldDoesNotScrollBesideWhatIsNotFilled) {
  open_plate();
  EXPECT_TRUE(settles([&] { return !scrolls("field"); })) << heights();
  EXPECT_FALSE(scrolls("context"));
  // A line of the selection more or less is no empty room.
  constexpr int few_lines = 60;
  EXPECT_LE(dock("context").height(), panel().sizeHint().height() + 30 + few_lines) << heights();

  window->context().picked.set({1, 2});
  EXPECT_TRUE(settles([&] { return !scrolls("context"); })) << "what is selected" << heights();
}

TEST_P(Room, TheFieldDoesNotScrollAfterAnEdit) {
  open_plate();
  fill_a_bore();
  EXPECT_TRUE(settles([&] { return !scrolls("field"); })) << heights();

  panel().choose({});
  EXPECT_TRUE(settles([&] { return !scrolls("field"); })) << "without a form" << heights();
}

TEST_P(Room, OneFormIsOpenAtATimeAndWhatWasTypedStays) {
  open_plate();
  panel().choose("fill_hole");
  auto& loads = window->tools().loads.panel();
  loads.add_item(item_kind::load);
  EXPECT_TRUE(panel().chosen().isEmpty());
  auto* z = loads.editor()->findChild<QLineEdit*>("component_z");
  z->setText("-5 kN");

  panel().choose("thicken");
  EXPECT_FALSE(loads.editor()->isVisible());
  loads.add_item(item_kind::load);
  EXPECT_TRUE(loads.editor()->isVisible());
  EXPECT_TRUE(panel().chosen().isEmpty());
  EXPECT_EQ(z->text(), "-5 kN");

  (void)loads.cancel();
  EXPECT_TRUE(settles([&] { return !scrolls("field") && !scrolls("context"); })) << heights();
}

TEST_P(Room, ALoadsFormShowsAllOfItself) {
  open_plate(false);
  window->context().picked.set({7});
  auto& loads = window->tools().loads.panel();
  loads.add_item(item_kind::load);
  EXPECT_TRUE(settles([&] { return !scrolls("loads"); })) << heights();
  EXPECT_TRUE(settles([&] { return !scrolls("field"); })) << "the field" << heights();
  (void)loads.cancel();
  EXPECT_TRUE(settles([&] { return !scrolls("context"); })) << "with what is offered" << heights();
}

TEST_P(Room, WhereThereAreNoLoadsTheHintStandsAtTheButtonsThatItSpeaksOf) {
  open_plate(false);
  const auto* hint = window->findChild<QLabel*>("draft_hint");
  const auto* button = window->findChild<QPushButton*>("add_support");
  const auto top = [&](const QWidget* one) { return one->mapTo(window.get(), QPoint()).y(); };
  constexpr int near = 20;
  EXPECT_TRUE(settles([&] { return top(hint) - (top(button) + button->height()) < near; }))
    << top(hint) << " below " << top(button);
}

TEST_P(Room, APartWithoutLoadsStandsInTheMiddle) {
  open_plate(false);
  const auto& box = view().geometry()->bounds;
  double left = view().width();
  double right = 0;
  for (int i = 0; i < 8; ++i) {
    const auto at = view().to_widget({box[i & 1], box[2 + (i >> 1 & 1)], box[4 + (i >> 2 & 1)]});
    left = std::min(left, at.x());
    right = std::max(right, at.x());
  }
  const double off = (left + right - view().width()) / 2;
  EXPECT_LT(std::abs(off), 0.05 * view().width()) << off << " of " << view().width();
}

TEST_P(Room, ResultsShowWholeRows) {
  open_plate();
  ASSERT_TRUE(window->context().all_commands.trigger("view.results"));
  const auto* list = window->findChild<QTreeWidget*>("results_list");
  ASSERT_TRUE(wait([&] { return list->isVisible() && list->topLevelItemCount() > 0; }));

  const auto cut_off = [&] {
    for (QTreeWidgetItemIterator it(const_cast<QTreeWidget*>(list)); *it; ++it) {
      const QRect row = list->visualItemRect(*it);
      const int bottom = list->viewport()->height();
      if (row.top() < bottom && row.bottom() >= bottom)
        return row.bottom() + 1 - bottom;
    }
    return 0;
  };
  EXPECT_TRUE(settles([&] { return cut_off() == 0; })) << cut_off();
  EXPECT_GE(list->viewport()->height(), 3 * list->visualItemRect(list->topLevelItem(0)).height());
  window->resize(window->size() + QSize(0, 7));
  EXPECT_TRUE(settles([&] { return cut_off() == 0; })) << cut_off() << " when it is higher";
}

TEST_P(Room, TheCubeCoversNothingOfAPartThatWasMadeToFit) {
  open_plate(false);
  const auto* cube = window->findChild<view_cube*>();
  using look = camera::direction;
  for (const auto from : {look::isometric, look::top, look::bottom, look::front, look::back,
                          look::left, look::right}) {
    view().framing().look_from(from);
    EXPECT_FALSE(reaches(cube->geometry())) << static_cast<int>(from);
  }
}

TEST_P(Room, WhatIsSaidCoversNothingOfTheLegend) {
  open_plate();
  auto& said = window->context().messages;
  auto& over = window->context().over;
  for (const bool with_help : {false, true}) {
    if (with_help) {
      ASSERT_TRUE(window->context().all_commands.trigger("help.manual"));
    }
    said.show_news("Saved: each step is kept in /home/somebody/.local/state/tedit/plate.tedit");
    EXPECT_TRUE(settles([&] {
      return !said.geometry().intersects(over.scale_box().toRect()) &&
             !said.geometry().intersects(window->findChild<view_cube*>()->geometry());
    }))
      << with_help << ": " << said.geometry().bottom() << " of " << over.scale_box().top();
    EXPECT_TRUE(window->context().pages.rect().contains(said.geometry()));
    constexpr double readable = 150;  // Title, unit, three numbers, "final".
    EXPECT_GE(over.scale_box().height(), readable);
  }
}

INSTANTIATE_TEST_SUITE_P(Screens, Room,
                         testing::Values(screen{{1280, 720}, "en"}, screen{{1280, 720}, "de"},
                                         screen{{1600, 1000}, "en"}, screen{{1600, 1000}, "de"},
                                         screen{{1920, 1080}, "de"}),
                         [](const auto& one) { return name_of(one.param); });

}  // namespace
}  // namespace tedit::desktop
