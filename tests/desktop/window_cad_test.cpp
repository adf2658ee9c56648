// SPDX-License-Identifier: AGPL-3.0-or-later
// CAD files in the window, and the rail with as many operations as there are.
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "tests/desktop/window_fixture.hpp"
#include "tests/scan/surfaces.hpp"

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QMessageBox>
#include <QScrollArea>
#include <QToolButton>

namespace tedit::desktop {
namespace {

class CadFiles : public Window {
protected:
  [[nodiscard]] static bool can_read() {
    return QFile::exists(QCoreApplication::applicationDirPath() + "/tedit-cad-reader");
  }
  static QString block() { return TEDIT_TEST_DATA "/cad/inch_block.stp"; }

  void open_coarse(const QString& file) {
    window->tools().documents.open_files({file});
    auto* question = window->findChild<QMessageBox*>("cad_size");
    ASSERT_NE(question, nullptr);
    QTest::mouseClick(question->findChild<QPushButton*>("coarse"), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows_head() && !part().operations().operations.empty(); }));
  }
};

TEST_F(CadFiles, AskHowFineAndComeInWithTheirUnitAndFaces) {
  if (!can_read())
    GTEST_SKIP() << "this build reads no CAD files";

  open_coarse(block());
  EXPECT_TRUE(part().name().startsWith("inch_block")) << part().name().toStdString();
  EXPECT_EQ(part().head()->surface->surfaces().size(), 9u);
  EXPECT_EQ(window->findChild<QWidget*>("unit_question")->isVisible(), false);
}

/// A part's command, and why it does nothing.
const command& mesh_anew(main_window& window) {
  return *window.context().all_commands.find("file.mesh_anew");
}

TEST_F(CadFiles, AreMeshedAnewWithShorterEdgesOnPickedWalls) {
  if (!can_read())
    GTEST_SKIP() << "this build reads no CAD files";
  open_coarse(block());
  const auto first = part().name();
  const auto facets_of = [&](surface_id id) {
    return part().head()->surface->surfaces().at(id).facets;
  };
  const auto before = facets_of(4);
  window->context().picked.set({4});

  ASSERT_TRUE(window->context().all_commands.trigger("file.mesh_anew"));
  auto* form = window->findChild<QDialog*>("remesh");
  ASSERT_NE(form, nullptr);
  EXPECT_EQ(form->findChild<QComboBox*>("fineness")->currentData(), "coarse");
  form->findChild<QDoubleSpinBox*>("local_size")->setValue(3);
  QTest::mouseClick(form->findChild<QPushButton*>("remesh_take"), Qt::LeftButton);

  ASSERT_TRUE(wait([&] { return part().name() != first && shows_head(); }));
  EXPECT_EQ(part().head()->surface->surfaces().size(), 9u);
  EXPECT_GT(facets_of(4), 4 * before);
  EXPECT_EQ(part().files().cad_source()->file.local_sizes_mm,
            (std::map<std::string, double>{{"4", 3.0}}));

  part().files().close();
  EXPECT_FALSE(window->context().all_commands.is_enabled(mesh_anew(*window)));
}

TEST_F(CadFiles, APartFromAMeshIsNotMeshedAnewAndIsToldWhy) {
  open_plate(false);

  EXPECT_FALSE(window->context().all_commands.is_enabled(mesh_anew(*window)));
  EXPECT_TRUE(mesh_anew(*window).why_off.contains("CAD file"));
  EXPECT_FALSE(window->context().all_commands.trigger("file.mesh_anew"));
  EXPECT_EQ(window->findChild<QDialog*>("remesh"), nullptr);
}

TEST_F(CadFiles, AFileThatWasChangedMeanwhileIsNotMeshedAnew) {
  if (!can_read())
    GTEST_SKIP() << "this build reads no CAD files";
  const QString copy = state.path() + "/block.stp";
  ASSERT_TRUE(QFile::copy(block(), copy));
  open_coarse(copy);
  QFile file(copy);
  ASSERT_TRUE(file.open(QIODevice::Append));
  file.write("\n");
  file.close();

  ASSERT_TRUE(window->context().all_commands.trigger("file.mesh_anew"));

  EXPECT_EQ(window->findChild<QDialog*>("remesh"), nullptr);
  EXPECT_TRUE(window->context().messages.text().contains("was changed"))
    << window->context().messages.text().toStdString();
}

TEST_F(CadFiles, ASurfaceWithoutCadIsAskedForItsUnit) {
  if (!can_read())
    GTEST_SKIP() << "this build meshes nothing";
  const QString path = state.path() + "/pin.stl";
  const auto text = test::stl_of(test::cylinder_soup(4, 10, 24));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text.data(), static_cast<qint64>(text.size()));
  file.close();

  window->tools().documents.open_files({path});
  auto* question = window->findChild<QMessageBox*>("cad_size");
  ASSERT_NE(question, nullptr);
  auto* unit = question->findChild<QComboBox*>("surface_unit");
  ASSERT_NE(unit, nullptr);
  unit->setCurrentIndex(unit->findData("cm"));
  QTest::mouseClick(question->findChild<QPushButton*>("coarse"), Qt::LeftButton);

  ASSERT_TRUE(wait([&] { return shows_head(); }))
    << window->context().messages.text().toStdString();
  const auto& surfaces = part().head()->surface->surfaces();
  ASSERT_EQ(surfaces.size(), 3u);
  EXPECT_EQ(surfaces.at(2).name, "cylinder 2 d 80 mm");
}

TEST_F(CadFiles, AnEditComesBackInTheStepFile) {
  if (!can_read())
    GTEST_SKIP() << "this build reads no CAD files";
  open_coarse(block());
  part().edits().apply({"fill_hole", {8, 9}, {}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  const QString path = state.path() + "/closed.step";

  part().files().export_to(path);

  ASSERT_TRUE(wait([&] { return QFile::exists(path); }))
    << window->context().messages.text().toStdString();
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const auto text = file.readAll();
  EXPECT_TRUE(text.startsWith("ISO-10303-21"));
  EXPECT_EQ(text.count("ADVANCED_FACE("), 6);  // Nine with the hole.
}

/// What the history says of a version on the CAD model, beside its mark.
QString said_of(const history_strip& history, int row) {
  return history.item(row)->data(Qt::AccessibleDescriptionRole).toString();
}

TEST_F(CadFiles, EachVersionShowsWhetherTheCadModelHasItAndANoticeSaysWhichHasNot) {
  if (!can_read())
    GTEST_SKIP() << "this build reads no CAD files";
  open_coarse(block());
  const auto& history = *window->findChild<history_strip*>();
  const auto* receipt = window->findChild<receipt_panel*>();
  ASSERT_NE(receipt, nullptr);
  ASSERT_TRUE(wait([&] { return history.count() == 1; }));
  EXPECT_EQ(said_of(history, 0), "The part as the CAD model has it");

  part().edits().apply({"fill_hole", {8, 9}, {}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  ASSERT_TRUE(wait([&] { return said_of(history, 1).startsWith("On the CAD model"); }))
    << said_of(history, 1).toStdString();
  EXPECT_TRUE(history.item(1)->toolTip().contains("new vertices within"));
  EXPECT_TRUE(receipt->toPlainText().contains("On the CAD model, new vertices within"));
  EXPECT_FALSE(window->context().messages.text().contains("CAD")) << "nothing is to be done";

  part().edits().apply({"deform", {3}, {{"distance", 1e-3}}, {}});
  ASSERT_TRUE(wait([&] { return version() == 2 && shows_head(); }));
  ASSERT_TRUE(wait([&] { return said_of(history, 2).startsWith("In the mesh only"); }))
    << said_of(history, 2).toStdString();
  EXPECT_TRUE(said_of(history, 2).contains("deform"));
  EXPECT_TRUE(window->context().messages.text().startsWith("Version 2. In the mesh only"))
    << window->context().messages.text().toStdString();
  EXPECT_TRUE(receipt->toPlainText().contains("In the mesh only"));
  window->context().messages.clear_message();

  part().edits().apply({"improve_mesh", {}, {}, {}});
  ASSERT_TRUE(wait([&] { return version() == 3 && shows_head(); }));
  ASSERT_TRUE(wait([&] { return said_of(history, 3).contains("version 2 (deform)"); }))
    << said_of(history, 3).toStdString();
  EXPECT_FALSE(window->context().messages.text().contains("mesh only"))
    << "told once: of the one that can be taken back";
}

TEST_F(CadFiles, APartFromAMeshHasNoModelToExport) {
  open_plate(false);
  const QString path = state.path() + "/plate.step";

  part().files().export_to(path);

  ASSERT_TRUE(wait([&] { return !window->context().messages.text().isEmpty(); }));
  EXPECT_TRUE(window->context().messages.text().contains("no CAD model"))
    << window->context().messages.text().toStdString();
  EXPECT_FALSE(QFile::exists(path));
}

TEST_F(CadFiles, WhatIsNoneIsToldAndTheStartPageStays) {
  const QString path = state.path() + "/part.step";
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is a text");
  file.close();

  window->tools().documents.open_file(path, {});

  ASSERT_TRUE(wait([&] { return !window->context().messages.text().isEmpty(); }));
  EXPECT_TRUE(window->context().messages.text().contains("STEP"))
    << window->context().messages.text().toStdString();
  EXPECT_TRUE(window->tools().documents.shows_start_page());
}

TEST_F(CadFiles, AMeshOfThisComputerCanBeCancelled) {
  if (!can_read())
    GTEST_SKIP() << "this build reads no CAD files";

  part().files().import_cad({TEDIT_TEST_DATA "/cad/as1_assembly.stp", {}, "mm", "fine", {}});
  ASSERT_TRUE(wait([&] { return part().foreground().current().has_value(); }));
  part().foreground().cancel();

  ASSERT_TRUE(wait([&] { return !part().foreground().current(); }));
  EXPECT_FALSE(part().is_open());
}

class Rail : public Window {};

TEST_F(Rail, EveryOperationIsThereAndCanBeScrolledTo) {
  window->resize(1280, 720);
  open_plate(false);
  auto* rail = window->findChild<QScrollArea*>("operations");
  ASSERT_NE(rail, nullptr);
  QTest::qWait(50);

  std::vector<QToolButton*> shown;
  for (auto* button : rail->findChildren<QToolButton*>())
    if (!button->isHidden())
      shown.push_back(button);
  ASSERT_EQ(shown.size(), part().operations().operations.size());
  for (auto* button : shown) {
    rail->ensureWidgetVisible(button);
    const QRect at(button->mapTo(rail->viewport(), QPoint(0, 0)), button->size());
    EXPECT_TRUE(rail->viewport()->rect().contains(at)) << button->text().toStdString();
    EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
  }
}

}  // namespace
}  // namespace tedit::desktop
