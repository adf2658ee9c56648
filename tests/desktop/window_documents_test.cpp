// SPDX-License-Identifier: AGPL-3.0-or-later
// One document after another in a window, wrong files between them, and loads that are changed and
// taken back.
#include "tests/desktop/window_fixture.hpp"

#include <QAction>
#include <QContextMenuEvent>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QMenu>

#include "client-qt/tools/documents/document_keeping.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/probes/probes_tool.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/tools/selection/selection_tool.hpp"
#include "client-qt/widgets/truth_line.hpp"

namespace tedit::desktop {
namespace {

class Documents : public Window {
protected:
  [[nodiscard]] QStringList files() const {
    return QDir(state.path() + "/documents").entryList({"*.tedit"}, QDir::Files);
  }
  [[nodiscard]] QString said() { return window->context().messages.text(); }
  void run(const char* command) {
    ASSERT_TRUE(window->context().all_commands.trigger(command)) << command;
  }

  /// A file that is no part: its first bytes tell what it claims to be.
  [[nodiscard]] QString wrong_file(const QString& name) const {
    const QString path = state.path() + "/" + name;
    QFile out(path);
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    if (name.endsWith(".png"))
      out.write("\x89PNG\r\n\x1a\n");
    else if (name.endsWith(".step"))
      out.write("ISO-10303-21;\nHEADER;\nENDSEC;\n");
    else if (name.endsWith(".stl"))
      out.write("solid part\nendsolid part\n");
    else
      out.write([] {
        QFile whole(plate());
        EXPECT_TRUE(whole.open(QIODevice::ReadOnly));
        return whole.read(whole.size() / 2);
      }());
    return path;
  }

  /// A surface that is in sight and stays when bore 1, 2 is filled.
  [[nodiscard]] surface_id seen_beside_the_bore() {
    for (const auto& [id, row] : part().head()->surface->surfaces())
      if (id > 2 && view().visible_point(id))
        return id;
    ADD_FAILURE() << "nothing is in sight";
    return 0;
  }

  /// The plate's load case with other forces.
  [[nodiscard]] fem::load_case times(double factor) {
    auto one = part().loads().all().front();
    for (auto& load : one.loads)
      if (auto* force = std::get_if<fem::force>(&load.kind))
        force->total_n = factor * force->total_n;
    return one;
  }
};

TEST_F(Documents, ExportOffersWhatTheServerWritesAndRefusesTheRest) {
  open_plate(false);

  run("file.export");
  auto* dialog = window->findChild<QFileDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  QStringList wanted;
  for (const auto& format : file_formats)
    wanted << QString("%1 (*.%2)")
                .arg(QString::fromUtf8(format.title.data(),
                                       static_cast<qsizetype>(format.title.size())),
                     QString::fromUtf8(format.name.data(),
                                       static_cast<qsizetype>(format.name.size())));
  EXPECT_EQ(dialog->nameFilters(),
            wanted + QStringList{"CAD model with all edits (*.step)"});  // Not the server's.
  EXPECT_EQ(dialog->defaultSuffix(), "msh");
  dialog->selectNameFilter(wanted.last());
  emit dialog->filterSelected(wanted.last());
  EXPECT_EQ(dialog->defaultSuffix().toStdString(), file_formats.back().name);
  dialog->reject();

  part().files().export_to(state.filePath("part.sat"));
  ASSERT_TRUE(wait([&] { return said().contains("There is no file format \"sat\""); }));
  EXPECT_FALSE(QFile::exists(state.filePath("part.sat")));
}

TEST_F(Documents, AWrongFileLeavesThePartOpenAndNothingElse) {
  open_plate();
  const auto name = part().name();
  ASSERT_EQ(files(), QStringList{name + ".tedit"});

  for (const auto* wrong : {"photo.png", "part.step", "part.stl", "half.msh"}) {
    window->tools().documents.open_file(wrong_file(wrong), {});
    ASSERT_TRUE(wait([&] { return said().contains(wrong); })) << wrong;
    EXPECT_TRUE(said().contains("did not work")) << said().toStdString();
    EXPECT_EQ(part().name(), name);
    EXPECT_TRUE(is_final());
    EXPECT_EQ(files(), QStringList{name + ".tedit"});
  }
  part().edits().apply({"fill_hole", {1, 2}, {}});  // It is open as before.
  EXPECT_TRUE(wait([&] { return version() == 1 && is_final(); }));
}

TEST_F(Documents, AWrongFileOnTheStartPageLeavesIt) {
  window->tools().documents.open_file(wrong_file("half.msh"), {});
  ASSERT_TRUE(wait([&] { return said().contains("did not work"); }));
  EXPECT_TRUE(window->tools().documents.shows_start_page());
  EXPECT_FALSE(part().is_open());
  EXPECT_TRUE(files().isEmpty());
}

TEST_F(Documents, AFileThatIsNoDocumentLeavesNone) {
  for (int i = 0; i < 2; ++i) {
    window->context().messages.clear_message();
    window->tools().documents.open_file(wrong_file("letter.tedit"), {});
    ASSERT_TRUE(wait([&] { return said().contains("did not work"); }));
    EXPECT_TRUE(said().startsWith("Open letter.tedit did not work")) << said().toStdString();
    EXPECT_TRUE(said().contains(state.path() + "/letter.tedit")) << said().toStdString();
    EXPECT_FALSE(said().contains("/documents/")) << "a copy that nobody made or knows";
    EXPECT_TRUE(window->tools().documents.shows_start_page());
    EXPECT_TRUE(files().isEmpty()) << files().join(" ").toStdString();
  }
}

TEST_F(Documents, ADocumentThatIsGoneIsNotMadeAnew) {
  open_plate(false);
  const auto name = part().name();
  window->tools().documents.open_document("gone");
  ASSERT_TRUE(wait([&] { return said().contains("no document"); }));
  EXPECT_EQ(part().name(), name);
  EXPECT_EQ(files(), QStringList{name + ".tedit"});
}

TEST_F(Documents, AnotherPartIsMadeToFit) {
  open_plate(false);
  const auto before = view().view().get();
  auto far = before;
  far.position = before.position + 100.0 * (before.position - before.focus);
  far.focus = before.focus + 100.0 * (before.position - before.focus);
  view().view().set(far);

  const auto name = part().name();
  window->tools().documents.open_file(TEDIT_EXAMPLES "/heatsink_125/heatsink_125.coarse.msh", {});
  ASSERT_TRUE(wait([&] { return part().name() != name && shows_head(); }));

  std::size_t seen = 0;
  for (const auto& [id, row] : part().head()->surface->surfaces())
    seen += view().visible_point(id).has_value() ? 1 : 0;
  EXPECT_GT(seen, 5U);
}

TEST_F(Documents, WhatWasSaidOfAPartGoesWithIt) {
  open_plate(false);
  part().edits().apply({"fill_hole", {}, {}});
  ASSERT_TRUE(wait([&] { return said().contains("did not work"); }));
  part().files().close();
  EXPECT_EQ(said(), "");
  EXPECT_EQ(window->windowTitle(), "TEdit");
  EXPECT_FALSE(window->findChild<QLabel*>("title")->text().contains("plate"));
}

TEST_F(Documents, AVersionThatWasSeenWithoutAQuantityIsNotCalledUnsolved) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  window->tools().results.panel().set_field(shown_field::safety_factor);
  ASSERT_TRUE(wait([&] { return view().painted().extremes.has_value() && is_final(); }));
  ASSERT_TRUE(window->context().all_commands.trigger("view.compare"));

  const auto title = [&] {
    for (const auto* one : window->findChildren<QLabel*>())
      if (one->isVisible() && one->text().startsWith("v0"))
        return one->text();
    return QString();
  };
  EXPECT_TRUE(wait([&] { return title().contains("seen without this quantity"); }))
    << title().toStdString();
  EXPECT_FALSE(title().contains("not solved"));
}

TEST_F(Documents, AVersionThatWasNotSeenIsComparedWithoutMovingTheHead) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  const auto name = part().name();
  part().files().close();
  window->tools().documents.open_document(name);
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  ASSERT_FALSE(part().versions().at(0).surface);

  ASSERT_TRUE(window->context().all_commands.trigger("view.compare"));
  auto* before = window->findChild<viewport*>("compare_before");
  ASSERT_TRUE(
    wait([&] { return before->isVisible() && before->is_settled() && before->geometry(); }));

  EXPECT_EQ(version(), 1U);
  ASSERT_TRUE(before->current().surface);
  EXPECT_TRUE(before->current().surface->surfaces().contains(1)) << "the bore is still open there";
  QStringList titles;
  for (const auto* one : window->findChildren<QLabel*>())
    if (one->isVisible() && one->text().startsWith("v0"))
      titles << one->text();
  ASSERT_EQ(titles.size(), 1) << titles.join("; ").toStdString();
  EXPECT_TRUE(titles.front().contains("not solved here")) << titles.front().toStdString();
  // The server still has the field of both, and so their difference.
  window->findChild<QPushButton*>("compare_difference")->click();
  auto* after = window->findChild<viewport*>("compare_after");
  const auto is_shown = [&] {
    return after->isVisible() && after->current().field &&
           after->current().field != part().head()->fields.front() && after->is_settled();
  };
  ASSERT_TRUE(wait(is_shown));
  const auto& values = after->current().field->values.of("von_mises_pa");
  EXPECT_EQ(values.size(), after->current().field->vertices.size());
  EXPECT_LT(values.size(), part().head()->fields.front()->vertices.size()) << "not in the bore";
  EXPECT_LT(*std::ranges::min_element(values), 0);
  EXPECT_GT(*std::ranges::max_element(values), 0);
  EXPECT_EQ(version(), 1U);
}

TEST_F(Documents, ADifferenceThatTheServerCannotTellSendsToTheVersion) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  const auto name = part().name();
  part().files().close();
  window->tools().documents.open_document(name);
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  // The size of a displacement: the difference of two is not the size of one.
  window->tools().results.panel().set_field(shown_field::displacement);

  ASSERT_TRUE(window->context().all_commands.trigger("view.compare"));
  window->findChild<QPushButton*>("compare_difference")->click();
  auto* go = window->findChild<QPushButton*>("compare_go");
  ASSERT_TRUE(wait([&] { return go->isVisible(); }));
  EXPECT_TRUE(window->findChild<QLabel*>("compare_why")->text().contains("no field"));
  EXPECT_EQ(version(), 1U);
}

TEST_F(Documents, AVersionsMenuComparesItWithThePresentOne) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  auto* strip = window->findChild<history_strip*>();
  ASSERT_TRUE(wait([&] { return strip->count() == 2; }));
  const QPoint at = strip->visualItemRect(strip->item(0)).center();

  QContextMenuEvent wanted(QContextMenuEvent::Mouse, at, strip->viewport()->mapToGlobal(at));
  QApplication::sendEvent(strip->viewport(), &wanted);
  const auto actions = strip->findChild<QMenu*>()->actions();
  const auto found = std::ranges::find(actions, QString("Compare with version 1"), &QAction::text);
  ASSERT_NE(found, actions.end());
  (*found)->trigger();

  auto* before = window->findChild<viewport*>("compare_before");
  ASSERT_TRUE(wait([&] { return before->isVisible() && before->geometry(); }));
  EXPECT_TRUE(before->current().surface->surfaces().contains(1)) << "the bore is open there";
  EXPECT_EQ(version(), 1U);
}

TEST_F(Documents, AChangeOfLoadsIsUndoneAndRedone) {
  open_plate();
  const auto original = part().loads().all();
  EXPECT_FALSE(part().loads().can_undo());  // They came with the part.
  const auto twice = times(2);
  part().loads().set(twice);
  ASSERT_TRUE(wait([&] { return part().loads().all() != original && is_final(); }));
  const double stress = part().head()->outcome->cases.front().max_von_mises_pa;

  run("edit.undo");
  ASSERT_TRUE(wait([&] { return part().loads().all() == original && is_final(); }));
  EXPECT_NEAR(part().head()->outcome->cases.front().max_von_mises_pa, stress / 2, 1e-4 * stress);
  EXPECT_EQ(version(), 0U);
  run("edit.redo");
  ASSERT_TRUE(wait([&] { return part().loads().all().front() == twice && is_final(); }));

  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  run("edit.undo");  // The edit came last.
  ASSERT_TRUE(wait([&] { return version() == 0 && is_final(); }));
  EXPECT_EQ(part().loads().all().front(), twice);
  run("edit.undo");
  ASSERT_TRUE(wait([&] { return part().loads().all() == original && is_final(); }));
}

TEST_F(Documents, ALoadCaseThatIsDroppedAloneIsSetOnTheOpenPart) {
  open_plate(false);
  ASSERT_TRUE(part().loads().all().empty());
  window->tools().documents.open_files({loads()});
  ASSERT_TRUE(wait([&] { return part().loads().all().size() == 1 && is_final(); }));
  EXPECT_EQ(part().loads().all().front().name, "ctc01_plate static");
  const auto name = part().name();

  window->tools().documents.open_files({wrong_file("loads.json")});
  ASSERT_TRUE(wait([&] { return said().contains("loads.json"); })) << said().toStdString();
  EXPECT_EQ(part().loads().all().size(), 1U);
  EXPECT_EQ(part().name(), name);
}

TEST_F(Documents, ARemovedLoadCaseComesBack) {
  open_plate();
  const auto original = part().loads().all();
  part().loads().remove(original.front().name);
  ASSERT_TRUE(wait([&] { return part().loads().all().empty() && shows_head(); }));
  EXPECT_EQ(view().current().field, nullptr);
  run("edit.undo");
  ASSERT_TRUE(wait([&] { return part().loads().all() == original && is_final(); }));
}

TEST_F(Documents, LoadsThatCannotBeSolvedShowNoStress) {
  open_plate();
  auto free = part().loads().all().front();
  free.constraints.clear();
  part().loads().set(free);
  ASSERT_TRUE(wait([&] { return part().solver().progress() == field_state::failed; }));
  ASSERT_TRUE(wait([&] { return shows_head(); }));

  EXPECT_EQ(view().current().field, nullptr);
  EXPECT_FALSE(part().head()->outcome.has_value());
  EXPECT_FALSE(window->context().truth.verdict().contains("final"));
}

TEST_F(Documents, LoadsThatLackASupportSinceItWasTakenAwayShowNoStressUntilUndo) {
  open_plate();
  const auto original = part().loads().all();
  auto* tree = window->tools().loads.panel().tree();
  auto* support = tree->topLevelItem(0)->child(1);
  ASSERT_EQ(support->text(0), "Fixed");
  tree->setCurrentItem(support);

  run("loads.remove");
  ASSERT_TRUE(wait([&] { return shows_head() && !view().current().field; }));
  EXPECT_EQ(window->context().truth.verdict(), "no field");
  EXPECT_EQ(tree->topLevelItem(0)->childCount(), 2) << "the rest is there to go on with";

  run("edit.undo");
  ASSERT_TRUE(wait([&] { return part().loads().all() == original && is_final(); }));
  EXPECT_TRUE(window->tools().loads.panel().drafts().empty());
  EXPECT_EQ(tree->topLevelItem(0)->childCount(), 3);
}

TEST_F(Documents, APartThatIsOpenedAgainAtOnceIsAnotherDocument) {
  QStringList names;
  for (int i = 0; i < 3; ++i) {
    window->tools().documents.open_file(plate(), {});
    ASSERT_TRUE(wait([&] { return part().is_open() && !names.contains(part().name()); }));
    ASSERT_TRUE(wait([&] { return shows_head(); }));
    EXPECT_EQ(version(), 0U);
    names << part().name();
  }
}

TEST_F(Documents, ProbesAndThumbnailsAreThereAgain) {
  open_plate();
  auto& pins = window->tools().probing.pins();
  const surface_id wall = seen_beside_the_bore();
  ASSERT_TRUE(pins.put(3, wall, *view().visible_point(wall)));
  const auto at = pins.all().front().place.at;
  const auto first = part().head()->info.version_id;
  auto* strip = window->findChild<history_strip*>();
  ASSERT_TRUE(wait([&] { return strip->has_thumbnail(first, true); }));
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  const auto second = part().head()->info.version_id;
  ASSERT_TRUE(wait([&] { return strip->has_thumbnail(second, true); }));
  const auto name = part().name();

  window->tools().documents.open_file(plate(), {});
  ASSERT_TRUE(wait([&] { return part().name() != name && shows_head(); }));
  EXPECT_TRUE(pins.all().empty());  // They are of the other document.
  window->close();
  window = std::make_unique<main_window>(state.path());
  window->show();
  window->tools().documents.open_document(name);
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));

  const auto& again = window->tools().probing.pins().all();
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again.front().number, 3);
  EXPECT_NEAR(std::sqrt(dot(again.front().place.at - at, again.front().place.at - at)), 0, 1e-6);
  strip = window->findChild<history_strip*>();
  EXPECT_TRUE(wait([&] { return strip->has_thumbnail(first, true); }));
  EXPECT_TRUE(wait([&] { return strip->has_thumbnail(second, true); }));
}

TEST_F(Documents, WhatWasHiddenAndPickedIsNotSoOnTheNextPart) {
  open_plate(false);
  window->tools().selecting.set_hidden({1, 2});
  window->context().picked.set({7});
  const auto name = part().name();
  window->tools().documents.open_file(TEDIT_EXAMPLES "/heatsink_125/heatsink_125.coarse.msh", {});
  ASSERT_TRUE(wait([&] { return part().name() != name && shows_head(); }));
  EXPECT_TRUE(window->tools().selecting.hidden().empty());
  EXPECT_TRUE(window->context().picked.surfaces().empty());
}

TEST_F(Documents, CtrlSSaysThatEverythingIsSafeAndWhere) {
  open_plate(false);
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  const auto place = state.path() + "/documents/" + part().name() + ".tedit";
  EXPECT_TRUE(said().contains("safe already")) << said().toStdString();
  EXPECT_TRUE(said().contains(place)) << said().toStdString();
  EXPECT_TRUE(QFile::exists(place));
}

TEST_F(Documents, ACopyHasAllVersionsAndLoads) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  const auto name = part().name();
  const auto loads = part().loads().all();
  const auto copy = state.path() + "/mailed.tedit";
  window->tools().documents.keeping().copy_to(copy);
  ASSERT_TRUE(wait([&] { return said().contains("Wrote"); }));
  EXPECT_EQ(QDir(state.path()).entryList({"mailed.tedit*"}).size(), 1) << "one file";

  window->tools().documents.open_file(copy, {});
  ASSERT_TRUE(wait([&] { return part().name() == "mailed" && is_final(); }));
  EXPECT_EQ(version(), 1U);
  EXPECT_EQ(part().versions().size(), 2U);
  EXPECT_EQ(part().loads().all(), loads);
  run("edit.undo");
  ASSERT_TRUE(wait([&] { return version() == 0; }));
  EXPECT_TRUE(files().contains(name + ".tedit"));
}

TEST_F(Documents, AReopenedPartSaysWhatItsEditDid) {
  open_plate();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  const auto name = part().name();
  const auto volume = part().head()->report->volume_change;
  part().files().close();
  window->tools().documents.open_document(name);
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final() && part().head()->report; }));

  EXPECT_EQ(part().head()->report->volume_change, volume);
  const auto text = window->findChild<receipt_panel*>()->toPlainText();
  EXPECT_TRUE(text.contains("Volume")) << text.toStdString();
}

}  // namespace
}  // namespace tedit::desktop
