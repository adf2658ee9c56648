// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeWidget>

#include "client-qt/tools/connection/trust_dialog.hpp"
#include "client-qt/tools/help/about_dialog.hpp"
#include "client-qt/tools/help/shortcuts_dialog.hpp"
#include "client-qt/tools/operations/operation_form.hpp"
#include "client-qt/tools/settings/settings_dialog.hpp"

namespace tedit::desktop {
namespace {

TEST(SettingsDialog, ShowsWhatIsSetAndTellsEveryChange) {
  preferences now;
  now.element_order = 1;
  now.device = "NVIDIA";
  settings_dialog dialog(now);
  EXPECT_EQ(dialog.values(), now);
  std::vector<preferences> told;
  QObject::connect(&dialog, &settings_dialog::changed,
                   [&](const preferences& wanted) { told.push_back(wanted); });

  dialog.findChild<QComboBox*>("look")->setCurrentIndex(2);

  now.look = look_wish::dark;
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0], now);
}

TEST(SettingsDialog, SearchLeavesWhatFits) {
  settings_dialog dialog({});

  dialog.findChild<QLineEdit*>("search")->setText("device");

  EXPECT_TRUE(dialog.findChild<QComboBox*>("device")->isVisibleTo(&dialog));
  EXPECT_FALSE(dialog.findChild<QComboBox*>("look")->isVisibleTo(&dialog));
}

TEST(TrustDialog, ShowsTheFingerprintAndTrustsNobodyByItself) {
  untrusted_server what{"hall.example.org:7464", {}, {}};
  for (int i = 0; i < 32; ++i)
    what.certificate.fingerprint += i == 0 ? "AB" : ":0C";
  trust_dialog dialog(what);
  const auto shown = dialog.findChild<QLabel*>("fingerprint")->text();
  EXPECT_EQ(shown.count('\n'), 1);
  EXPECT_TRUE(shown.startsWith("AB:0C:0C:0C  0C:"));
  EXPECT_EQ(dialog.findChild<QLabel*>("known_fingerprint"), nullptr);
  auto* trust = dialog.findChild<QPushButton*>("trust");
  EXPECT_FALSE(trust->isDefault());
  int accepted = 0;
  QObject::connect(&dialog, &QDialog::accepted, [&] { ++accepted; });
  trust->click();
  EXPECT_EQ(accepted, 1);

  what.known = what.certificate.fingerprint;
  EXPECT_NE(trust_dialog(what).findChild<QLabel*>("known_fingerprint"), nullptr);
}

struct two_commands : commands {
  two_commands() {
    add({"a", "Undo", "Edit", "Ctrl+Z", [] {}});
    add({"b", "Fit", "View", "F", [] {}});
  }
};

class ShortcutsDialog : public testing::Test {
protected:
  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("settings.ini"), QSettings::IniFormat};
  two_commands all_;
  shortcuts_dialog dialog_{{all_, settings_}};
  QTreeWidgetItem* fit_ = dialog_.list()->topLevelItem(1)->child(0);
};

TEST_F(ShortcutsDialog, GivesNewKeysAndResetsThem) {
  int changes = 0;
  QObject::connect(&dialog_, &shortcuts_dialog::changed, [&] { ++changes; });
  dialog_.list()->setCurrentItem(fit_);

  dialog_.assign(QKeySequence("G"));
  EXPECT_EQ(settings_.value("shortcut/b").toString(), "G");
  dialog_.findChild<QPushButton*>("reset")->click();

  EXPECT_FALSE(settings_.contains("shortcut/b"));
  EXPECT_EQ(changes, 2);
}

TEST_F(ShortcutsDialog, NamesTheCommandThatHasTheKeysAlready) {
  dialog_.list()->setCurrentItem(fit_);

  dialog_.assign(QKeySequence("Ctrl+Z"));

  EXPECT_TRUE(dialog_.findChild<QLabel*>("conflict")->text().contains("\"Undo\""));
  EXPECT_FALSE(settings_.contains("shortcut/b"));
}

TEST(AboutDialog, NamesEveryLibraryWithItsLicence) {
  about_dialog dialog;
  const auto* list = dialog.findChild<QTreeWidget*>("libraries");

  ASSERT_EQ(list->topLevelItemCount(), static_cast<int>(used_libraries().size()));
  for (int i = 0; i < list->topLevelItemCount(); ++i)
    EXPECT_FALSE(list->topLevelItem(i)->text(2).isEmpty()) << i;
}

TEST(OperationForm, F1IsForTheParameterThatHasTheFocus) {
  ops::operation_description about;
  ops::parameter_description depth;
  depth.id = "depth";
  depth.name = "Depth";
  depth.help = "How deep";
  depth.unit = "m";
  depth.min = 0.001;
  depth.default_value = 0.002;
  about.parameters = {depth};
  operation_form form(about);
  auto* field = form.findChild<QWidget*>("depth");
  field->setFocus();

  QKeyEvent ask(QEvent::ShortcutOverride, Qt::Key_F1, Qt::NoModifier);
  ask.ignore();
  QApplication::sendEvent(field, &ask);

  EXPECT_TRUE(ask.isAccepted());
  EXPECT_EQ(field->whatsThis(), "<b>Depth</b><br>How deep<br>At least 1 mm<br>Usually 2 mm");
}

}  // namespace
}  // namespace tedit::desktop
