// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/loads_panel.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "client-qt/tools/loads/load_editor.hpp"

namespace tedit::desktop {
namespace {

/// A document with a head, as a server would tell it, but without a server.
class LoadsPanel : public testing::Test {
protected:
  LoadsPanel() {
    part_.begin("part");
    client::committed import;
    import.head.version_id = "0";
    import.head.load_cases = {"braking"};
    emit link_.committed(import);
  }

  void apply() { panel_.editor()->findChild<QPushButton*>("apply_item")->click(); }
  [[nodiscard]] QString hint() const { return panel_.findChild<QLabel*>("draft_hint")->text(); }
  [[nodiscard]] const QTreeWidgetItem* load_case() const { return panel_.tree()->topLevelItem(0); }

  remote link_;
  document part_{link_};
  selection picked_{part_};
  loads_panel panel_{part_, picked_};
};

TEST_F(LoadsPanel, NamesTheLoadCasesThatItDoesNotKnow) {
  EXPECT_TRUE(hint().startsWith("braking is solved too"));
}

TEST_F(LoadsPanel, KeepsALoadCaseUntilItCanBeSolved) {
  panel_.add_item(item_kind::material);
  apply();

  ASSERT_EQ(panel_.tree()->topLevelItemCount(), 1);
  EXPECT_EQ(load_case()->childCount(), 1);
  EXPECT_TRUE(hint().contains("it still needs a support, a load."));
}

TEST_F(LoadsPanel, ANewItemIsForTheSurfacesThatArePicked) {
  picked_.set({3, 5});
  panel_.add_item(item_kind::support);
  apply();

  const auto ids = load_case()->child(0)->data(0, Qt::UserRole).value<QList<qint64>>();
  EXPECT_EQ(ids, (QList<qint64>{3, 5}));
}

TEST_F(LoadsPanel, ACompleteLoadCaseStaysMarkedUntilTheServerHasTakenIt) {
  for (const auto kind : {item_kind::material, item_kind::support, item_kind::load}) {
    picked_.set({3});
    panel_.add_item(kind);
    panel_.editor()->findChild<QLineEdit*>("component_z")->setText("-10");
    apply();
    EXPECT_EQ(picked_.surfaces().empty(), kind != item_kind::material) << "its field is to be seen";
  }

  EXPECT_EQ(load_case()->childCount(), 3);
  EXPECT_TRUE(hint().contains("the server has not taken yet"));
}

TEST_F(LoadsPanel, AFormThatIsLeftMakesNoLoadCase) {
  const QString before = hint();
  picked_.set({3});
  panel_.add_item(item_kind::support);
  ASSERT_TRUE(panel_.editor()->isVisibleTo(&panel_));
  panel_.editor()->findChild<QPushButton*>("close_item")->click();

  EXPECT_EQ(panel_.tree()->topLevelItemCount(), 0);
  EXPECT_TRUE(panel_.drafts().empty());
  EXPECT_EQ(hint(), before) << hint().toStdString();
}

TEST_F(LoadsPanel, ADoubleClickChangesTheItemWhereItStands) {
  picked_.set({3});
  panel_.add_item(item_kind::load);
  panel_.editor()->findChild<QLineEdit*>("component_x")->setText("7");
  apply();
  panel_.tree()->setCurrentItem(panel_.tree()->topLevelItem(0)->child(0));
  emit panel_.tree()->itemDoubleClicked(panel_.tree()->currentItem(), 0);
  EXPECT_EQ(panel_.editor()->findChild<QLineEdit*>("component_x")->text(), "7");

  panel_.editor()->findChild<QLineEdit*>("component_x")->setText("8");
  apply();

  ASSERT_EQ(load_case()->childCount(), 1);
  EXPECT_EQ(load_case()->child(0)->text(0), "Force 8 N along +x");
}

TEST_F(LoadsPanel, WhatWasTypedIsThereAgainAfterAnotherForm) {
  const auto field = [&](const char* name) { return panel_.editor()->findChild<QLineEdit*>(name); };
  picked_.set({3, 5});
  panel_.add_item(item_kind::load);
  panel_.editor()->findChild<QComboBox*>("load_kind")->setCurrentText("Moment");
  field("component_x")->setText("12 k");  // No number yet.

  panel_.add_item(item_kind::support);
  picked_.set({});
  panel_.add_item(item_kind::load);

  EXPECT_EQ(panel_.editor()->findChild<QComboBox*>("load_kind")->currentText(), "Moment");
  EXPECT_EQ(field("component_x")->text(), "12 k");
  EXPECT_EQ(picked_.surfaces(), (std::vector<surface_id>{3, 5}));

  client::committed edit;
  edit.head.version_id = "1";
  edit.cause = "edit";
  emit link_.committed(edit);
  ASSERT_FALSE(panel_.cancel()) << "an edit of the part closes the form";
  picked_.set({8});
  panel_.add_item(item_kind::load);
  EXPECT_EQ(field("component_x")->text(), "12 k");
  EXPECT_EQ(picked_.surfaces(), std::vector<surface_id>{8});

  panel_.editor()->findChild<QPushButton*>("close_item")->click();
  panel_.add_item(item_kind::load);
  EXPECT_NE(field("component_x")->text(), "12 k") << "Cancel means it";
}

TEST_F(LoadsPanel, ADraftTakesAnotherNameWhereItStands) {
  panel_.new_load_case();

  panel_.tree()->topLevelItem(0)->setText(0, "Braking");

  ASSERT_EQ(panel_.tree()->topLevelItemCount(), 1);
  EXPECT_EQ(load_case()->text(0), "Braking");
}

TEST_F(LoadsPanel, ANewMaterialForThePartReplacesTheOneItHas) {
  for (const auto* name : {"first", "second"}) {
    panel_.add_item(item_kind::material);
    panel_.editor()->findChild<QLineEdit*>("name")->setText(name);
    apply();
  }

  ASSERT_EQ(load_case()->childCount(), 1);
  EXPECT_TRUE(load_case()->child(0)->text(0).startsWith("second"));
}

TEST_F(LoadsPanel, SurfacesThatAreClickedBecomeThoseOfTheOpenForm) {
  picked_.set({3});
  panel_.add_item(item_kind::support);
  picked_.set({8, 9});
  apply();
  ASSERT_EQ(load_case()->childCount(), 1);
  const auto surfaces = [&] {
    return load_case()->child(0)->data(0, Qt::UserRole).value<QList<qint64>>();
  };
  EXPECT_EQ(surfaces(), (QList<qint64>{8, 9}));

  picked_.set({4});
  EXPECT_EQ(surfaces(), (QList<qint64>{8, 9})) << "no form is open";
  panel_.tree()->setCurrentItem(panel_.tree()->topLevelItem(0)->child(0));
  emit panel_.tree()->itemDoubleClicked(panel_.tree()->currentItem(), 0);
  EXPECT_EQ(picked_.surfaces(), (std::vector<surface_id>{8, 9})) << "Shift adds to what it has";
  picked_.set({8, 9, 11});
  apply();
  EXPECT_EQ(surfaces(), (QList<qint64>{8, 9, 11}));
}

TEST_F(LoadsPanel, TellsWhatIsNotSolvedYetSoThatItCanBeDrawn) {
  int told = 0;
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&panel_, &loads_panel::drafts_changed, &here, [&] { ++told; });
  picked_.set({3});
  panel_.add_item(item_kind::support);
  apply();

  EXPECT_GT(told, 0);
  ASSERT_EQ(panel_.drafts().size(), 1U);
  EXPECT_EQ(panel_.drafts()[0].constraints.size(), 1U);
}

TEST_F(LoadsPanel, CancelClosesTheEditorOnce) {
  panel_.add_item(item_kind::load);

  EXPECT_TRUE(panel_.cancel());
  EXPECT_FALSE(panel_.editor()->isVisibleTo(&panel_));
  EXPECT_FALSE(panel_.cancel());
}

TEST_F(LoadsPanel, IsEmptyWhenThePartIsClosed) {
  panel_.new_load_case();

  part_.files().close();

  EXPECT_EQ(panel_.tree()->topLevelItemCount(), 0);
  EXPECT_TRUE(hint().startsWith("No loads yet"));
}

TEST_F(LoadsPanel, OnlyWhatIsChosenCanBeRemoved) {
  EXPECT_FALSE(panel_.can_remove());
  picked_.set({3});
  panel_.add_item(item_kind::support);
  apply();
  panel_.tree()->setCurrentItem(nullptr);
  EXPECT_FALSE(panel_.can_remove());
  int told = 0;
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&panel_, &loads_panel::chosen_changed, &here, [&] { ++told; });

  panel_.tree()->setCurrentItem(panel_.tree()->topLevelItem(0)->child(0));
  EXPECT_TRUE(panel_.can_remove());
  EXPECT_EQ(told, 1);
  panel_.remove_current();
  EXPECT_EQ(load_case()->childCount(), 0);
}

}  // namespace
}  // namespace tedit::desktop
