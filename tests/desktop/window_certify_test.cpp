// SPDX-License-Identifier: AGPL-3.0-or-later
// CalculiX as a second opinion, from the window.
#include "tests/desktop/window_fixture.hpp"

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QStandardPaths>
#include <QTreeWidget>

namespace tedit::desktop {
namespace {

class CertifyWindow : public Window {
protected:
  static QString block(const char* file) {
    return QString(TEDIT_TEST_DATA "/parts/inch_block/") + file;
  }
  [[nodiscard]] bool offers() const {
    const auto& all = window->context().all_commands;
    return all.is_enabled(*all.find("file.certify"));
  }
};

TEST_F(CertifyWindow, ShowsKeepsAndNotesHowFarBothAgree) {
  if (QStandardPaths::findExecutable("ccx").isEmpty())
    GTEST_SKIP() << "ccx is not installed (Debian package calculix-ccx)";
  window->tools().documents.open_file(block("inch_block.coarse.msh"), {block("load_case.json")});
  ASSERT_TRUE(wait([&] { return shows_head() && !part().head()->load_cases.empty(); }));
  ASSERT_TRUE(offers());

  window->tools().certifying.certify_into(state.path());

  ASSERT_TRUE(wait([&] { return window->findChild<QDialog*>("certificate") != nullptr; }))
    << window->context().messages.text().toStdString();
  auto* dialog = window->findChild<QDialog*>("certificate");
  const auto verdict = dialog->findChild<QLabel*>("certificate_verdict")->text();
  EXPECT_TRUE(verdict.contains("agrees")) << verdict.toStdString();
  EXPECT_TRUE(verdict.contains("version 0")) << verdict.toStdString();
  const auto* rows = dialog->findChild<QTreeWidget*>("certificate_cases");
  ASSERT_EQ(rows->topLevelItemCount(), 1);
  EXPECT_LE(rows->topLevelItem(0)->text(2).toDouble(), 1e-5);
  ASSERT_TRUE(wait([&] { return part().head()->info.note.find("CalculiX") != std::string::npos; }));
  const QDir folder(state.path() + "/" + part().name() + ", version 0");
  EXPECT_TRUE(folder.exists("certificate.json"));
  EXPECT_TRUE(folder.exists("tedit.vtu"));
  dialog->close();
}

TEST_F(CertifyWindow, NeedsALoadCase) {
  window->tools().documents.open_file(block("inch_block.coarse.msh"), {});
  ASSERT_TRUE(wait([&] { return shows_head(); }));

  EXPECT_FALSE(offers());
}

}  // namespace
}  // namespace tedit::desktop
