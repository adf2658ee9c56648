// SPDX-License-Identifier: AGPL-3.0-or-later
// Checking for printing as a person does it: figures that can be checked by hand, and marks that
// are never those of another version.
#include "tests/desktop/window_fixture.hpp"

#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QTreeWidget>

#include "client-qt/tools/printing/print_panel.hpp"
#include "mesh/io/formats.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::desktop {
namespace {

class PrintWindow : public Window {
protected:
  /// A post of 10 x 10 x 10 mm under the middle of a bar of 30 x 10 x 10 mm.
  void open_hammer() {
    constexpr double edge = 10e-3;
    const auto mesh = test::blocks(
      {3, 1, 2}, [](int x, int, int z) { return x == 1 || z == 1; },
      [](vec3 p) { return edge * p; });
    const QString file = state.path() + "/hammer.msh";
    ASSERT_TRUE(formats::msh::write(file.toStdString(), *mesh, {"mm"}));
    window->tools().documents.open_file(file, {});
    ASSERT_TRUE(wait([&] { return shows_head() && !part().operations().operations.empty(); }));
  }

  [[nodiscard]] const print_inspection& inspection() {
    return window->tools().printing.inspection();
  }
  [[nodiscard]] QTreeWidget& list() { return *window->tools().printing.panel().list(); }
  [[nodiscard]] bool command() {
    return window->context().all_commands.trigger("view.check_print");
  }
  void type(const char* field, const QString& text) {
    auto* line = window->findChild<QLineEdit*>(field);
    ASSERT_NE(line, nullptr);
    line->setText(text);
  }
  /// The value beside a title; empty when there is no such row.
  [[nodiscard]] QString found(const QString& title) {
    for (int i = 0; i < list().topLevelItemCount(); ++i)
      if (list().topLevelItem(i)->text(0) == title)
        return list().topLevelItem(i)->text(1);
    return {};
  }
  [[nodiscard]] QString said() { return window->findChild<QLabel*>("print_state")->text(); }
};

TEST_F(PrintWindow, ThePanelSaysWhatIsHardToPrintAndTheViewShowsIt) {
  open_hammer();
  const QImage before = view().picture();
  ASSERT_TRUE(command());
  EXPECT_TRUE(inspection().is_asking());
  ASSERT_TRUE(wait([&] { return inspection().known() && view().is_seen(); }));

  EXPECT_EQ(found("Watertight"), "yes");
  EXPECT_EQ(found("Volume"), QString::fromUtf8("4000 mm³"));
  EXPECT_EQ(found("Bounding box"), QString::fromUtf8("30 × 10 × 20 mm"));
  EXPECT_EQ(found("Thin walls"), "none under 1 mm");
  EXPECT_EQ(found("Overhangs"), QString::fromUtf8("200 mm² lean more than 45°"));
  EXPECT_TRUE(view().shows_print_marks());

  type("print_wall", "1.1 cm");
  type("print_lean", "90");
  press("print_check");
  ASSERT_TRUE(wait([&] { return inspection().known() && view().is_seen(); }));
  EXPECT_NEAR(inspection().known()->settings.thinner_than, 11e-3, 1e-12);
  EXPECT_EQ(found("Overhangs"), QString::fromUtf8("none beyond 90°"));
  EXPECT_TRUE(found("Thin walls").endsWith(QString::fromUtf8("under 11 mm, both sides counted")))
    << found("Thin walls").toStdString();
  EXPECT_NE(view().picture(), before);
}

TEST_F(PrintWindow, TheWallThatIsSelectedLiesOnThePlate) {
  open_hammer();
  ASSERT_TRUE(command());
  ASSERT_TRUE(wait([&] { return inspection().known() != nullptr; }));
  auto* direction = window->findChild<QComboBox*>("print_direction");
  direction->setCurrentIndex(direction->count() - 1);
  press("print_check");
  EXPECT_TRUE(said().startsWith("Select one flat wall")) << said().toStdString();
  EXPECT_TRUE(inspection().known()) << "nothing was asked";

  window->context().picked.set({6});  // The top: all stands on it.
  press("print_check");
  ASSERT_TRUE(wait([&] { return inspection().known() != nullptr; }));
  EXPECT_EQ(inspection().known()->settings.up, (vec3{0, 0, -1}));
  EXPECT_EQ(found("Overhangs"), QString::fromUtf8("none beyond 45°"));
  EXPECT_EQ(found("On the plate"), QString::fromUtf8("300 mm²"));
  EXPECT_TRUE(said().startsWith("Nothing in version 0")) << said().toStdString();
}

TEST_F(PrintWindow, APlaceIsAWayToIt) {
  open_hammer();
  ASSERT_TRUE(command());
  ASSERT_TRUE(wait([&] { return inspection().known() && list().topLevelItemCount() > 0; }));
  const auto overhangs = list().findItems("Overhangs", Qt::MatchExactly);
  ASSERT_EQ(overhangs.size(), 1);
  ASSERT_EQ(overhangs[0]->childCount(), 2) << "on both sides of the post";
  auto* place = overhangs[0]->child(0);

  const auto from = view().view().get();
  list().scrollToItem(place);
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(place).center());
  EXPECT_NE(view().view().get(), from);
  const auto& at = inspection().known()->what.overhangs[0].at;
  const auto seen = view().pick_at(view().to_widget(at));
  ASSERT_TRUE(seen);
  EXPECT_LT(norm(seen->at - at), 1e-6) << "nothing is before it any more";
  emit list().itemActivated(place, 0);
  EXPECT_EQ(window->context().picked.surfaces(), (std::vector<surface_id>{7}));
}

TEST_F(PrintWindow, MarksAreNeverThoseOfAnotherVersionAndGoWithThePanel) {
  open_plate(false);
  ASSERT_TRUE(command());
  ASSERT_TRUE(wait([&] { return inspection().known() && view().shows_print_marks(); }));
  const auto first = inspection().known()->version_id;
  bool stale = false;
  const auto look = [&] {
    const auto* head = part().head();
    stale =
      stale || (inspection().known() && inspection().known()->version_id != head->info.version_id);
  };
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&part(), &document::head_changed, &here, look);
  QObject::connect(&view(), &viewport::shown, &here, look);
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && inspection().known() && shows_head(); }));
  EXPECT_NE(inspection().known()->version_id, first);
  EXPECT_EQ(inspection().known()->version, 1U);
  EXPECT_TRUE(view().shows_print_marks());
  EXPECT_FALSE(stale);

  window->context().panels.of("print").close();
  EXPECT_FALSE(inspection().is_on());
  EXPECT_FALSE(view().shows_print_marks());
}

TEST_F(PrintWindow, ACheckIsCancelledAndTheNextVersionIsCheckedAllTheSame) {
  open_plate(false);
  ASSERT_TRUE(command());
  ASSERT_TRUE(inspection().is_asking());
  EXPECT_EQ(part().work().all().back().title, "Check for printing");
  window->findChild<QPushButton*>("print_check")->click();
  EXPECT_FALSE(inspection().is_asking());
  EXPECT_TRUE(part().work().all().empty());
  EXPECT_TRUE(said().contains("cancelled")) << said().toStdString();
  EXPECT_FALSE(view().shows_print_marks());

  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && inspection().known(); }));
  EXPECT_EQ(inspection().known()->version, 1U);
}

TEST_F(PrintWindow, NumbersThatAreNoneAreSaidAndNotAsked) {
  open_hammer();
  ASSERT_TRUE(command());
  ASSERT_TRUE(wait([&] { return inspection().known() != nullptr; }));
  type("print_wall", "-1");
  press("print_check");
  EXPECT_TRUE(said().startsWith("The least wall is a length")) << said().toStdString();
  type("print_wall", "");
  type("print_lean", "91");
  press("print_check");
  EXPECT_TRUE(said().startsWith("The overhang is an angle")) << said().toStdString();
  EXPECT_FALSE(inspection().is_asking());
}

}  // namespace
}  // namespace tedit::desktop
