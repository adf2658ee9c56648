// SPDX-License-Identifier: AGPL-3.0-or-later
// What the window says of what it shows: that something is hidden, that a shape is drawn larger,
// what an edit is called.
#include "tests/desktop/window_fixture.hpp"

#include <QComboBox>
#include <QLineEdit>

#include "client-qt/tools/loads/load_editor.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/view/view_cube.hpp"

namespace tedit::desktop {
namespace {

TEST_F(Window, SaysHowMuchIsHiddenAndShowsItAgain) {
  open_plate(false);
  const auto* count = window->findChild<QPushButton*>("hidden_count");
  EXPECT_FALSE(count->isVisible());
  window->context().picked.set({1, 2});
  ASSERT_TRUE(window->context().all_commands.trigger("view.hide"));

  ASSERT_TRUE(count->isVisible());
  EXPECT_EQ(count->text(), "Hidden surfaces: 2 - show all");
  EXPECT_TRUE(view().rect().contains(count->geometry()));
  EXPECT_FALSE(window->findChild<view_cube*>()->geometry().intersects(count->geometry()));
  press("hidden_count");
  EXPECT_TRUE(window->tools().selecting.hidden().empty());
  EXPECT_FALSE(count->isVisible());
}

TEST_F(Window, SaysThatAShapeIsDrawnLargerThanItIs) {
  open_plate();
  auto& over = window->context().over;
  EXPECT_EQ(over.note(), "final");
  auto& fields = window->tools().results.panel();
  fields.set_deform(1000);
  EXPECT_TRUE(wait([&] { return over.note() == QString::fromUtf8("final\ndeformation × 1000"); }))
    << over.note().toStdString();

  fields.set_deform(0);
  EXPECT_TRUE(wait([&] { return over.note() == "final"; }));
}

TEST_F(Window, ItsWordsAreNotThoseOfCommandLines) {
  auto& solver = part().solver();  // "auto" is whatever is fastest on this machine.
  auto on_processor = solver.settings();
  on_processor.device = "cpu";
  solver.set_settings(on_processor);
  open_plate();
  const auto* facts = window->findChild<QLabel*>("facts");
  EXPECT_TRUE(facts->text().contains("on CPU")) << facts->text().toStdString();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));

  const auto log = window->context().log.toPlainText();
  EXPECT_TRUE(log.contains("Fill hole: version 1")) << log.toStdString();
  EXPECT_FALSE(log.contains("fill_hole"));
}

TEST_F(Window, FieldsToTypeIntoAreAsHighAsThoseToChooseFrom) {
  open_plate(false);
  ASSERT_TRUE(window->context().all_commands.trigger("loads.add_material"));
  const auto* form = window->tools().loads.panel().editor();
  const auto* choice = form->findChild<QComboBox*>("library");
  ASSERT_TRUE(QTest::qWaitFor([&] { return choice->isVisible(); }, 5000));
  QApplication::processEvents();
  for (const auto* name : {"name", "density", "regions"})
    EXPECT_NEAR(form->findChild<QLineEdit*>(name)->height(), choice->height(), 1) << name;
}

TEST_F(Window, BesideAFormNobodyIsToldHowToSelect) {
  open_plate(false);
  auto& panel = window->tools().operations.panel();
  const auto explains = [&] {
    const auto all = panel.findChildren<QLabel*>();
    return std::ranges::any_of(
      all, [](const QLabel* one) { return one->isVisible() && one->text().contains("Ctrl+drag"); });
  };
  EXPECT_TRUE(explains());
  panel.choose("fill_hole");
  EXPECT_FALSE(explains());
  panel.choose({});
  EXPECT_TRUE(explains());
}

}  // namespace
}  // namespace tedit::desktop
