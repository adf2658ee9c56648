// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/load_editor.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace tedit::desktop {
namespace {

const std::vector<fem::material> library{{"Steel", 210e9, 0.3, 7850, 235e6, {}},
                                         {"Lead", 16e9, 0.44, 11340, 12e6, {}}};

template <class T = QLineEdit>
T* field(const load_editor& editor, const char* name) {
  return editor.findChild<T*>(name);
}

TEST(LoadEditor, ReadsAForceInNewtonOnTheSelection) {
  load_editor editor(library);
  editor.edit("New load", fem::load{{}, fem::force{}});
  EXPECT_FALSE(editor.value());

  editor.set_selection({4, 9});
  field(editor, "component_z")->setText("-2,5e3");

  const auto item = editor.value();
  ASSERT_TRUE(item);
  const auto& load = std::get<fem::load>(*item);
  EXPECT_EQ(load.surfaces, (std::vector<surface_id>{4, 9}));
  EXPECT_EQ(std::get<fem::force>(load.kind).total_n, (vec3{0, 0, -2500}));
  EXPECT_EQ(field<QLabel>(editor, "size")->text(), "2500 N in all");
}

TEST(LoadEditor, ActsOnWhatIsPickedWhileItIsOpen) {
  load_editor editor(library);
  editor.edit("New load", fem::load{{1}, fem::force{{0, 0, -5}}});

  editor.set_selection({7});

  ASSERT_TRUE(editor.value());
  EXPECT_EQ(std::get<fem::load>(*editor.value()).surfaces, (std::vector<surface_id>{7}));
  EXPECT_EQ(field<QLabel>(editor, "picked")->text(), "Surfaces: 7");
  editor.set_selection({});
  EXPECT_FALSE(editor.value());
}

TEST(LoadEditor, GravityLeavesTheSelectionToTheLoadsAfterIt) {
  load_editor editor(library);
  editor.edit("New load", fem::load{{}, fem::gravity{{0, 0, -9.81}}});
  editor.set_selection({7});
  ASSERT_TRUE(editor.value());
  EXPECT_TRUE(std::get<fem::load>(*editor.value()).surfaces.empty());

  field<QComboBox>(editor, "load_kind")->setCurrentIndex(2);
  field(editor, "pressure")->setText("1");

  ASSERT_TRUE(editor.value());
  EXPECT_EQ(std::get<fem::load>(*editor.value()).surfaces, (std::vector<surface_id>{7}));
}

TEST(LoadEditor, APressureIsTypedInMegapascal) {
  load_editor editor(library);
  editor.edit("New load", fem::load{{1}, fem::force{}});

  field<QComboBox>(editor, "load_kind")->setCurrentIndex(2);
  field(editor, "pressure")->setText("0.4");

  const auto item = editor.value();
  ASSERT_TRUE(item);
  EXPECT_DOUBLE_EQ(std::get<fem::pressure>(std::get<fem::load>(*item).kind).pa, 0.4e6);
}

TEST(LoadEditor, WhatIsWrongStandsAtItsField) {
  load_editor editor(library);
  editor.edit("Material", library[0]);
  auto* fault = field<QLabel>(editor, "fault_poisson_ratio");
  EXPECT_TRUE(fault->text().isEmpty());

  field(editor, "poisson_ratio")->setText("0.5");

  EXPECT_FALSE(fault->text().isEmpty());
  EXPECT_FALSE(editor.value());
  EXPECT_FALSE(field<QPushButton>(editor, "apply_item")->isEnabled());
}

TEST(LoadEditor, AFaultOfTwoLinesHasTheirRoom) {
  load_editor editor(library);
  editor.edit("Material", library[0]);
  editor.resize(editor.minimumSizeHint().width(), 700);
  editor.show();

  field(editor, "poisson_ratio")->setText("0.5");
  QApplication::processEvents();

  const auto* fault = field<QLabel>(editor, "fault_poisson_ratio");
  EXPECT_GT(fault->heightForWidth(fault->width()), fault->fontMetrics().height());
  EXPECT_GE(fault->height(), fault->heightForWidth(fault->width()));
}

TEST(LoadEditor, AMaterialOfTheLibraryKeepsTheRegions) {
  load_editor editor(library);
  auto before = library[0];
  before.regions = {3};
  editor.edit("Material", before);

  field<QComboBox>(editor, "library")->setCurrentIndex(2);

  const auto item = editor.value();
  ASSERT_TRUE(item);
  auto lead = library[1];
  lead.regions = {3};
  EXPECT_EQ(std::get<fem::material>(*item), lead);
}

TEST(LoadEditor, RegionsAreNumbers) {
  load_editor editor(library);
  editor.edit("Material", library[0]);

  field(editor, "regions")->setText("2, 5");
  ASSERT_TRUE(editor.value());
  EXPECT_EQ(std::get<fem::material>(*editor.value()).regions, (std::vector<region_id>{2, 5}));
  field(editor, "regions")->setText("left");

  EXPECT_FALSE(editor.value());
  EXPECT_FALSE(field<QLabel>(editor, "fault_regions")->text().isEmpty());
}

TEST(LoadEditor, ShowingAndReadingASupportChangesNothing) {
  load_editor editor(library);
  editor.edit("Support", fem::constraint{{2}, fem::prescribed_displacement{0.0, {}, -0.25e-3}});

  const auto item = editor.value();

  ASSERT_TRUE(item);
  const auto& support = std::get<fem::constraint>(*item);
  const auto& kind = std::get<fem::prescribed_displacement>(support.kind);
  EXPECT_EQ(kind.x_m, 0.0);
  EXPECT_FALSE(kind.y_m.has_value());
  EXPECT_DOUBLE_EQ(*kind.z_m, -0.25e-3);
}

}  // namespace
}  // namespace tedit::desktop
