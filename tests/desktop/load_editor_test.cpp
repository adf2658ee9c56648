// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/load_editor.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
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

/// By the first words of its title.
void choose_kind(const load_editor& editor, const QString& title) {
  auto* kinds = field<QComboBox>(editor, "load_kind");
  const int at = kinds->findText(title, Qt::MatchStartsWith);
  ASSERT_GE(at, 0) << title.toStdString();
  kinds->setCurrentIndex(at);
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

  choose_kind(editor, "Pressure");
  field(editor, "pressure")->setText("1");

  ASSERT_TRUE(editor.value());
  EXPECT_EQ(std::get<fem::load>(*editor.value()).surfaces, (std::vector<surface_id>{7}));
}

TEST(LoadEditor, APressureIsTypedInMegapascal) {
  load_editor editor(library);
  editor.edit("New load", fem::load{{1}, fem::force{}});

  choose_kind(editor, "Pressure");
  field(editor, "pressure")->setText("0.4");

  const auto item = editor.value();
  ASSERT_TRUE(item);
  EXPECT_DOUBLE_EQ(std::get<fem::pressure>(std::get<fem::load>(*item).kind).pa, 0.4e6);
}

TEST(LoadEditor, NumbersMayHaveAnyUnitOfTheirKind) {
  load_editor editor(library);
  editor.edit("New load", fem::load{{1}, fem::force{}});

  field(editor, "component_x")->setText("5 kN");
  ASSERT_TRUE(editor.value());
  EXPECT_EQ(std::get<fem::force>(std::get<fem::load>(*editor.value()).kind).total_n,
            (vec3{5000, 0, 0}));
  field(editor, "component_x")->setText("5 mm");

  EXPECT_FALSE(editor.value());
  EXPECT_EQ(field<QLabel>(editor, "fault_components")->text(),
            "Give three numbers, alone or with a unit of their kind");
}

/// What is shown and read again is what it was, whichever kind it is.
TEST(LoadEditor, ShowingAndReadingALoadChangesNothing) {
  const fem::load all[] = {
    {{3}, fem::force{{1, -2, 3}}},
    {{3}, fem::traction{{0, 0, 2e6}}},
    {{3}, fem::pressure{-5e5}},
    {{3}, fem::pressure{0, {0, 0, -9810}, {0, 0, 0.25}}},
    {{}, fem::gravity{{0, 0, -9.81}}},
    {{3}, fem::normal_force{-120}},
    {{3}, fem::moment{{0, 12.5, 0}}},
    {{3}, fem::remote_force{{10, 0, 0}, {0, 0.125, 0}, {0, 0, 2}}},
    {{3}, fem::remote_force{{}, {0, 0.125, 0}, {0, 0, 2}}},
    {{3}, fem::bearing_force{{0, -300, 0}}},
  };
  load_editor editor(library);
  for (const auto& one : all) {
    editor.edit("Load", one);
    ASSERT_TRUE(editor.value()) << one.kind.index();
    EXPECT_EQ(std::get<fem::load>(*editor.value()), one) << one.kind.index();
  }
}

TEST(LoadEditor, ARemoteForceIsTypedWithItsPlaceAndMoment) {
  load_editor editor(library);
  editor.show();
  editor.edit("New load", fem::load{{1}, fem::force{}});
  EXPECT_FALSE(field(editor, "place_x")->isVisible());

  choose_kind(editor, "Remote");
  field(editor, "component_z")->setText("-100");
  field(editor, "place_x")->setText("0.2 m");
  field(editor, "second_y")->setText("500 N mm");

  EXPECT_TRUE(field(editor, "place_x")->isVisible());
  ASSERT_TRUE(editor.value());
  EXPECT_EQ(std::get<fem::load>(*editor.value()).kind,
            decltype(fem::load::kind)(fem::remote_force{{0, 0, -100}, {0.2, 0, 0}, {0, 0.5, 0}}));
  field(editor, "place_x")->setText("here");
  EXPECT_FALSE(editor.value());
  EXPECT_FALSE(field<QLabel>(editor, "fault_place")->text().isEmpty());
}

TEST(LoadEditor, APressureMayGrowWithTheDepth) {
  load_editor editor(library);
  editor.show();
  editor.edit("New load", fem::load{{1}, fem::pressure{0}});
  EXPECT_FALSE(editor.value());
  EXPECT_FALSE(field(editor, "second_z")->isVisible());

  field<QCheckBox>(editor, "by_place")->setChecked(true);
  field(editor, "second_z")->setText("-9,81 kPa/m");
  field(editor, "place_z")->setText("100");

  const auto item = editor.value();
  ASSERT_TRUE(item);
  const auto& read = std::get<fem::pressure>(std::get<fem::load>(*item).kind);
  EXPECT_DOUBLE_EQ(read.gradient_pa_m.z, -9810);
  EXPECT_DOUBLE_EQ(read.at_m.z, 0.1);
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
