// SPDX-License-Identifier: AGPL-3.0-or-later
// Forms and the selection in the real window: what Esc ends, where keys go, what stays in sight.
#include "tests/desktop/window_fixture.hpp"

#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSpinBox>

#include <map>

#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/loads/load_editor.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/operations/operation_form.hpp"

namespace tedit::desktop {
namespace {

class Forms : public Window {
protected:
  [[nodiscard]] context_panel& panel() { return window->tools().operations.panel(); }
  [[nodiscard]] loads_panel& loads_list() { return *window->findChild<loads_panel*>(); }
  [[nodiscard]] const std::vector<surface_id>& picked() {
    return window->context().picked.surfaces();
  }
  /// Of the form that is open; by the catalogue, whatever it says comes first.
  [[nodiscard]] QWidget* first_field(const char* operation) {
    const auto& about = part().operations().find(operation)->about;
    return panel().form()->findChild<QWidget*>(QString::fromStdString(about.parameters.front().id));
  }
  void press_esc() {
    auto* focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : window.get(), Qt::Key_Escape);
  }
  void open_heat_sink() {
    window->tools().documents.open_file(TEDIT_EXAMPLES "/heatsink_125/heatsink_125.coarse.msh", {});
    ASSERT_TRUE(wait([&] { return shows_head() && !part().operations().operations.empty(); }));
  }
};

TEST_F(Forms, AfterAnApplyNothingIsSelectedAndTheFormWaitsForTheNextSurface) {
  open_plate(false);
  window->context().picked.set({7});
  panel().choose("thicken");
  ASSERT_TRUE(wait([&] { return panel().preview().shown() && !panel().preview().is_busy(); }));
  press("apply");
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));

  EXPECT_TRUE(picked().empty());
  EXPECT_EQ(panel().chosen(), "thicken");
  EXPECT_FALSE(window->findChild<QPushButton*>("apply")->isEnabled());
}

TEST_F(Forms, AnEditOfSomebodyElseLeavesTheSelection) {
  open_plate(false);
  window->context().picked.set({7});
  panel().choose("thicken");
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));

  EXPECT_EQ(picked(), (std::vector<surface_id>{7}));
}

TEST_F(Forms, WhatTakesMuchOfThePartIsAskedForInTheForm) {
  open_heat_sink();
  window->context().picked.set({1});
  panel().choose("erode");
  panel().form()->set_values({{"layers", std::int64_t{1}}, {"depth", 0.0}});
  panel().apply();  // Before its preview: what it takes away is not known yet.
  auto* sure = window->findChild<QPushButton*>("apply_sure");
  ASSERT_TRUE(wait([&] { return sure->isVisible(); }));

  EXPECT_EQ(version(), 0U);
  EXPECT_TRUE(sure->text().startsWith("Take ") && sure->text().endsWith(" % of the part off"))
    << sure->text().toStdString();
  EXPECT_FALSE(window->findChild<QPushButton*>("apply")->isVisible());
  QTest::mouseClick(sure, Qt::LeftButton);
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
}

TEST_F(Forms, KeysGoToTheFirstFieldOfAnOperationThatWasChosen) {
  open_plate(false);
  window->context().picked.set({7});
  view().setFocus();

  ASSERT_TRUE(window->context().all_commands.trigger("op.erode"));

  EXPECT_EQ(QApplication::focusWidget(), first_field("erode"));
}

TEST_F(Forms, EnterInAFieldTakesItsValueAndApplies) {
  open_plate(false);
  window->context().picked.set({7});
  ASSERT_TRUE(window->context().all_commands.trigger("op.erode"));
  auto* field = QApplication::focusWidget();

  QTest::keyClicks(field, "0.4");
  QTest::keyClick(field, Qt::Key_Return);

  ASSERT_TRUE(wait([&] { return version() == 1; }));
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);  // What was entered is not taken back.
  ASSERT_TRUE(wait([&] { return version() == 0; }));
  QTest::keyClick(field, Qt::Key_Y, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return version() == 1; }));
  // 5000 mm2, and a little of the walls beside it; the depth that stood there would be 25 % more.
  EXPECT_NEAR(part().head()->report->volume_change, -0.4e-3 * 5e-3, 0.2e-6);
}

TEST_F(Forms, ApplyStaysInSightOnASmallScreenAndNoFieldIsSquashed) {
  window->resize(1280, 720);
  open_plate(false);
  window->context().picked.set({7});
  panel().choose("erode");
  ASSERT_TRUE(wait([&] { return !panel().preview().is_busy(); }));
  QApplication::processEvents();

  const auto* apply = window->findChild<QPushButton*>("apply");
  EXPECT_EQ(apply->visibleRegion().boundingRect(), apply->rect());
  for (const auto* field : panel().form()->findChildren<QSpinBox*>())
    EXPECT_GE(field->height(), field->minimumSizeHint().height());
  for (const auto* field : window->tools().results.panel().findChildren<QComboBox*>())
    EXPECT_GE(field->height(), field->minimumSizeHint().height());
  for (const auto* dock : {"context", "field"}) {
    const auto& there = window->context().panels.of(dock);
    EXPECT_LE(there.geometry().bottom(), window->height()) << dock;
  }
}

TEST_F(Forms, NoFieldOfALoadsFormIsSquashedAndItsButtonsAreInSight) {
  for (const QSize size : {QSize(1440, 900), QSize(1280, 720)}) {
    window->resize(size);
    if (!part().is_open())
      open_plate();
    window->context().picked.set({7});
    panel().choose("thicken");
    for (const auto kind : {item_kind::support, item_kind::load, item_kind::material}) {
      loads_list().add_item(kind);
      const auto* form = loads_list().editor();
      const auto is_whole = [&](const QWidget* one) {
        return one->height() >= one->minimumSizeHint().height();
      };
      ASSERT_TRUE(wait([&] {
        const auto fields = form->findChildren<QLineEdit*>();
        const auto choices = form->findChildren<QComboBox*>();
        const auto hidden_or_whole = [&](const QWidget* one) {
          return !one->isVisible() || is_whole(one);
        };
        return std::ranges::all_of(fields, hidden_or_whole) &&
               std::ranges::all_of(choices, hidden_or_whole);
      }))
        << size.width() << ", kind " << static_cast<int>(kind);
      const auto* button = form->findChild<QPushButton*>("apply_item");
      EXPECT_TRUE(is_whole(button));
      EXPECT_TRUE(panel().chosen().isEmpty()) << "one form at a time";
      EXPECT_EQ(button->visibleRegion().boundingRect().size(), button->size());
      (void)loads_list().cancel();
    }
  }
}

TEST_F(Forms, ALoadsFormGivesTheRoomBackThatItTook) {
  open_plate(false);
  window->resize(1280, 720);
  const auto heights = [&] {
    QList<int> all;
    for (const auto* name : {"loads", "field", "context"})
      all << window->findChild<QDockWidget*>(name)->height();
    return all;
  };
  ASSERT_TRUE(wait([&] { return window->height() == 720; }));
  QTest::qWait(200);  // Docks share the new height a moment later.
  const auto before = heights();
  loads_list().add_item(item_kind::material);  // The highest of these forms.
  ASSERT_TRUE(wait([&] { return heights() != before; }));
  QTest::qWait(50);

  (void)loads_list().cancel();

  EXPECT_TRUE(wait([&] { return heights() == before; })) << heights()[0] << " " << before[0];
}

TEST_F(Forms, SurfacesThatAreClickedBecomeThoseOfTheLoadAndEscClosesItsFormFirst) {
  open_plate(false);
  click_surface(98);
  ASSERT_TRUE(window->context().all_commands.trigger("loads.add_support"));
  ASSERT_TRUE(loads_list().editor()->isVisible());
  click_surface(7);
  ASSERT_TRUE(wait([&] { return window->context().link.running() == 0; }));

  const auto item = loads_list().editor()->value();
  ASSERT_TRUE(item);
  EXPECT_EQ(std::get<fem::constraint>(*item).surfaces, picked());
  EXPECT_TRUE(window->context().picked.contains(7));
  EXPECT_FALSE(window->context().picked.contains(98));

  press_esc();
  EXPECT_FALSE(loads_list().editor()->isVisible());
  EXPECT_FALSE(picked().empty());
  press_esc();
  EXPECT_TRUE(picked().empty());
}

/// The place that the open form has, m; far away without one.
vec3 place_of(const operation_form& form) {
  const auto typed = QString::fromStdString(std::get<std::string>(form.values().at("at")));
  const auto numbers = typed.split(',');
  return numbers.size() == 3
           ? vec3{numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()}
           : vec3{9, 9, 9};
}

TEST_F(Forms, AClickWhileAFormHasAPlaceIsThatPlaceOnThatWall) {
  open_plate(false);
  ASSERT_TRUE(window->context().all_commands.trigger("op.drill"));
  auto* form = window->findChild<operation_form*>();
  ASSERT_TRUE(form);
  // Places around which nothing but one wall is, of the wall that has most of them.
  const auto wall_at = [&](QPointF at) {
    const auto hit = view().pick_at(at);
    return hit ? hit->surface : 0;
  };
  std::map<surface_id, std::vector<QPointF>> places;
  for (int x = 40; x < view().width() - 40; x += 10)
    for (int y = 40; y < view().height() - 40; y += 10) {
      const QPointF at(x, y);
      const auto wall = wall_at(at);
      if (wall == wall_at(at + QPointF(15, 0)) && wall == wall_at(at - QPointF(15, 0)) &&
          wall == wall_at(at + QPointF(0, 15)) && wall == wall_at(at - QPointF(0, 15)))
        places[wall].push_back(at);
    }
  places.erase(0);
  ASSERT_FALSE(places.empty());
  const auto& [wall, clear] =
    *std::ranges::max_element(places, {}, [](const auto& row) { return row.second.size(); });
  ASSERT_GE(clear.size(), 3U);
  const auto click_at = [&](QPointF at) {
    QTest::mouseClick(&view(), Qt::LeftButton, {}, at.toPoint());
    const auto hit = view().pick_at(at);
    return hit ? hit->at : vec3{};
  };

  const auto first = click_at(clear[clear.size() / 2]);

  EXPECT_EQ(picked(), std::vector{wall});
  EXPECT_LT(norm(place_of(*form) - first), 2e-3);  // A pixel is about a millimetre.
  auto& preview = window->tools().operations.panel().preview();
  ASSERT_TRUE(wait([&] { return !preview.is_busy() && (preview.shown() || preview.refusal()); }));
  ASSERT_TRUE(preview.shown()) << render(*preview.refusal());

  // With the preview in sight, elsewhere on the wall: it stays selected, the place moves.
  const auto then = click_at(clear.front());
  EXPECT_EQ(picked(), std::vector{wall});
  EXPECT_GT(norm(place_of(*form) - first), 5e-3);
  EXPECT_LT(norm(place_of(*form) - then), 2e-3);

  // Shift adds to the selection as ever; once the form is closed a click selects.
  const auto second = place_of(*form);
  click_surface(wall == 98 ? 7 : 98, Qt::ShiftModifier);
  EXPECT_EQ(place_of(*form), second);
  EXPECT_TRUE(window->context().picked.contains(wall));
}

TEST_F(Forms, EscClosesThePaletteAndLeavesAListBeforeItDropsTheSelection) {
  open_plate(false);
  window->context().picked.set({7});
  ASSERT_TRUE(window->context().all_commands.trigger("help.palette"));
  auto* letters = window->findChild<QLineEdit*>("palette_letters");
  ASSERT_TRUE(letters->isVisible());
  QTest::keyClick(letters, Qt::Key_Escape);
  EXPECT_FALSE(letters->isVisible());
  EXPECT_EQ(picked().size(), 1U);

  auto* history = window->findChild<history_strip*>();
  history->setFocus();
  ASSERT_TRUE(history->hasFocus());
  QTest::keyClick(history, Qt::Key_Escape);
  EXPECT_EQ(picked().size(), 1U);
  EXPECT_TRUE(view().hasFocus());
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_TRUE(picked().empty());
}

TEST_F(Forms, WhatTheTruthLineSaysDoesNotMakeTheWindowWider) {
  open_plate(false);
  const int before = window->minimumSizeHint().width();
  auto* facts = window->findChild<QLabel*>("facts");
  facts->setText(QString(400, 'm'));
  QApplication::processEvents();

  EXPECT_EQ(window->minimumSizeHint().width(), before);
  EXPECT_LE(before, 1280);
}

TEST_F(Forms, ASizeIsTakenAlsoAfterAMaximisedSession) {
  window.reset();
  main_window next(state.path());
  next.setWindowState(Qt::WindowMaximized);  // As its kept geometry says.

  next.take_size({1200, 720});

  EXPECT_FALSE(next.isMaximized());
  EXPECT_EQ(next.size(), QSize(1200, 720));
}

}  // namespace
}  // namespace tedit::desktop
