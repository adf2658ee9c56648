// SPDX-License-Identifier: AGPL-3.0-or-later
// The first hour of somebody who has a mesh of their own and has not read the manual.
#include "tests/desktop/by_words.hpp"

#include <QFile>

#include <csignal>

namespace tedit::desktop {
namespace {

class NewcomersHour : public ByWords {
protected:
  void SetUp() override {
    ByWords::SetUp();
    window->take_size({1280, 720});
  }

  static QString own_mesh() {
    return TEDIT_EXAMPLES "/../tests/data/parts/inch_block/inch_block.coarse.msh";
  }
  static QString other_mesh() {
    return TEDIT_EXAMPLES "/../tests/data/parts/foot_cup/foot_cup.coarse.msh";
  }

  void open(const QString& path) {
    choose_in_menu("File", "Open");
    give_file(path);
  }

  void add_loads() {
    EXPECT_TRUE(reads("No loads yet. Pick surfaces of the part, then add a support and a load."));
    press_button("+ Material");
    look("material-form");
    EXPECT_EQ(beside<QComboBox>("From")->currentText(), "Steel S235");
    choose_beside("From", "Aluminium");
    press_button("Apply");
    EXPECT_TRUE(reads("it still needs"));
    click_surface(5);
    press_button("+ Support");
    look("support-form");
    press_button("Apply");
    EXPECT_TRUE(reads("it still needs a load"));
    click_surface(6);
    press_button("+ Load");
    type_beside("z", "-5 kN");
    EXPECT_TRUE(reads("5000 N in all"));
    look("load-form");
    press_button("Apply");
    EXPECT_TRUE(reads("Nothing selected"));
    EXPECT_TRUE(reads("final"));
    ASSERT_TRUE(wait([&] { return is_final(); }));
  }

  /// One edit with the values that the form offers, or that are typed beside a label. `told`: what
  /// a notice begins with.
  void edit(const QString& tool, surface_id at, const QString& label = {},
            const QString& typed = {}, const QString& told = {}) {
    const auto before = version();
    QTest::keyClick(&view(), Qt::Key_Escape);
    QTest::keyClick(&view(), Qt::Key_Escape);
    click_surface(at);
    press_button(tool);
    if (!label.isEmpty())
      type_beside(label, typed);
    const auto& preview = window->tools().operations.panel().preview();
    ASSERT_TRUE(wait([&] { return !preview.is_busy() && (preview.shown() || preview.refusal()); }));
    look(tool + "-previewed");
    ASSERT_FALSE(preview.refusal()) << tool.toStdString() << ": " << render(*preview.refusal());
    press_button("Apply");
    ASSERT_TRUE(wait([&] { return version() == before + 1 && is_final(); })) << tool.toStdString();
    EXPECT_TRUE(reads(QString("v%1").arg(before + 1)));
    EXPECT_EQ(window->context().messages.text().section(':', 0, 0), told) << tool.toStdString();
    look(tool + "-applied");
  }
};

TEST_F(NewcomersHour, GoesFromAnOwnMeshToAReportAndOn) {
  look("start");
  press_button("Open ...");
  look("file-dialog");
  give_file(own_mesh());
  ASSERT_TRUE(reads("inch_block"));
  ASSERT_TRUE(wait([&] { return shows_head() && !part().operations().operations.empty(); }));
  look("own-mesh");
  add_loads();
  look("solved");

  press_tab("Results");
  EXPECT_TRUE(reads("Largest von Mises stress"));
  look("results");
  press_button("Report");
  const QString pdf = state.filePath("report.pdf");
  give_file(pdf);
  ASSERT_TRUE(reads("Wrote " + pdf));
  EXPECT_GT(QFileInfo(pdf).size(), 20'000);
  look("reported");
  press_button("Close");
  press_button("Report");
  const QString html = state.filePath("report.html");
  give_file(html);
  ASSERT_TRUE(reads("Wrote " + html));
  EXPECT_GT(QFileInfo(html).size(), 20'000);
  press_button("Close");

  find_and_run("view from right");
  edit("Fill hole", 8);
  find_and_run("isometric");
  edit("Thicken", 6, "Thickness", "2 mm");
  edit("Erode", 6, "Depth", "1 mm");
  edit("Thicken", 7);
  edit("Erode", 7);
  edit("Thicken", 5);
  edit("Erode", 5);
  edit("Improve mesh", 6);
  edit("Round edges", 6);
  edit("Thicken", 7, "Thickness", "1/8 in", "Rounds at the wall went along with it");
  EXPECT_EQ(version(), 10U);

  choose_in_menu("File", "Close the part");
  ASSERT_TRUE(reads("Go on with"));
  look("closed");
  const auto killed = window->context().server.pid();
  ASSERT_EQ(::kill(static_cast<pid_t>(killed), SIGKILL), 0);
  ASSERT_TRUE(wait([&] { return window->context().server.pid() != killed; }));
  click_row("inch_block");
  ASSERT_TRUE(wait([&] { return is_final(); }));
  EXPECT_EQ(version(), 10U);
  look("again");

  press_tab("History");
  choose_for_row("v3", "Compare with version 10");
  ASSERT_TRUE(reads("Side by side"));
  QTest::qWait(500);
  look("compared");
  press_button("Difference");
  look("difference");
  press_button("Back (Esc)");

  QFile wrong(state.filePath("photo.png"));
  ASSERT_TRUE(wrong.open(QIODevice::WriteOnly) && wrong.write("\x89PNG\r\n\x1a\n") > 0);
  wrong.close();
  open(wrong.fileName());
  ASSERT_TRUE(reads("photo.png did not work"));
  look("wrong-file");
  EXPECT_TRUE(is_final());

  open(other_mesh());
  ASSERT_TRUE(reads("foot_cup"));
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_EQ(window->context().messages.text(), "");
  EXPECT_TRUE(view().framing().shows_whole());
  EXPECT_TRUE(reads("Nothing selected"));
  EXPECT_TRUE(reads("No loads yet."));
  look("another-part");
}

}  // namespace
}  // namespace tedit::desktop
