// SPDX-License-Identifier: AGPL-3.0-or-later
// "Server and workers": a real server and a worker that joins it as from another machine.
#include "tests/desktop/by_words.hpp"

#include <QClipboard>
#include <QFile>
#include <QHeaderView>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTreeWidget>

#include "client-qt/tools/jobs/server_dialog.hpp"

namespace tedit::desktop {
namespace {

class ServerState : public ByWords {
protected:
  [[nodiscard]] server_dialog* open_dialog() {
    EXPECT_TRUE(window->context().all_commands.trigger("view.server"));
    return window->findChild<server_dialog*>();
  }
  static QString facts(const server_dialog& dialog) {
    return dialog.findChild<QLabel*>("server_facts")->text();
  }

  static QString program() { return QCoreApplication::applicationDirPath() + "/tedit"; }
  void call(const QStringList& words) {
    QProcess run;
    run.start(program(), words);
    ASSERT_TRUE(run.waitForFinished(patience_ms));
    ASSERT_EQ(run.exitCode(), 0) << run.readAllStandardError().toStdString();
  }
  void issue(const char* role, const char* name) {
    call({"certs", "issue", state.filePath("authority"), "--role", role, "--name", name, "--host",
          "127.0.0.1", "-o", state.filePath(name)});
  }
  [[nodiscard]] QJsonObject read(const char* file) const {
    QFile from(state.filePath(file));
    return from.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(from.readAll()).object()
                                          : QJsonObject();
  }

  /// A server whose solving is done elsewhere; the window is connected to it.
  void serve_for_nodes() {
    call({"certs", "init", state.filePath("authority")});
    issue("server", "office");
    issue("solver", "rack-1");
    server_.start(program(),
                  {"serve", "--port", "0", "--documents", state.filePath("shared"), "--token-file",
                   state.filePath("shared-token"), "--ready-file", state.filePath("shared.json"),
                   "--node-certificates", state.filePath("office"), "--node-address", "127.0.0.1",
                   "--node-port", "0"});
    ASSERT_TRUE(wait([&] { return !read("shared.json").isEmpty(); }));
    QFile token(state.filePath("shared-token"));
    ASSERT_TRUE(token.open(QIODevice::ReadOnly));
    window->tools().connection.connect_to(
      {read("shared.json")["url"].toString(), QString::fromUtf8(token.readAll()).trimmed()});
    ASSERT_TRUE(wait([&] { return window->context().link.current() == remote::state::connected; }));
  }
  void join() {
    const int port = read("shared.json")["node_port"].toInt();
    node_.start(program(), {"worker", "--join", QString("127.0.0.1:%1").arg(port), "--role",
                            "solver", "--certificates", state.filePath("rack-1")});
  }

  QProcess server_;
  QProcess node_;

  void TearDown() override {
    for (auto* one : {&node_, &server_}) {
      one->terminate();
      if (!one->waitForFinished(5000))
        one->kill();
      one->waitForFinished(5000);
    }
    ByWords::TearDown();
  }
};

TEST_F(ServerState, WithoutOneItSaysSo) {
  const auto* dialog = open_dialog();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(facts(*dialog).contains("no connection")) << facts(*dialog).toStdString();
  EXPECT_FALSE(dialog->findChild<QLabel*>("server_no_nodes")->isVisible());
}

TEST_F(ServerState, ItsOwnServerIsToldWithMemoryAndWorkers) {
  open_plate(false);
  auto* dialog = open_dialog();
  ASSERT_NE(dialog, nullptr);
  const auto* workers = dialog->findChild<QTreeWidget*>("server_workers");
  ASSERT_TRUE(wait([&] { return workers->topLevelItemCount() == 3; }));

  EXPECT_TRUE(facts(*dialog).startsWith("tedit ")) << facts(*dialog).toStdString();
  EXPECT_TRUE(facts(*dialog).contains(window->context().link.address().url));
  EXPECT_TRUE(wait([&] { return facts(*dialog).contains("Open documents: 1"); }));
  EXPECT_GE(dialog->findChild<QTreeWidget*>("server_memory")->topLevelItemCount(), 5);
  EXPECT_TRUE(dialog->findChild<QLabel*>("server_no_nodes")->isVisible());
  EXPECT_FALSE(dialog->nodes()->isVisible());

  look("server", dialog);
  auto* memory = dialog->findChild<QTreeWidget*>("server_memory");
  constexpr int kept = 1;
  memory->sortItems(kept, Qt::DescendingOrder);
  for (int i = 1; i < memory->topLevelItemCount(); ++i)
    EXPECT_GE(memory->topLevelItem(i - 1)->data(kept, Qt::UserRole).toDouble(),
              memory->topLevelItem(i)->data(kept, Qt::UserRole).toDouble());
  emit window->context().link.state_changed();  // As every three seconds.
  EXPECT_EQ(memory->sortColumn(), kept);
  EXPECT_EQ(memory->header()->sortIndicatorOrder(), Qt::DescendingOrder);

  auto* copy = dialog->findChild<QPushButton*>("server_copy");
  QTest::mouseClick(copy, Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), dialog->text());
  EXPECT_TRUE(dialog->text().contains("\nWorkers\nWork\tState\t")) << dialog->text().toStdString();
}

TEST_F(ServerState, ANodeIsSeenToComeAndToLeave) {
  serve_for_nodes();
  auto* dialog = open_dialog();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->nodes()->isVisible());

  join();
  ASSERT_TRUE(wait([&] { return dialog->nodes()->topLevelItemCount() == 1; }));
  EXPECT_TRUE(dialog->nodes()->isVisible());
  const auto* row = dialog->nodes()->topLevelItem(0);
  EXPECT_EQ(row->text(0), "rack-1");
  EXPECT_EQ(row->text(1), "Stress");
  EXPECT_EQ(row->text(2), "idle");
  EXPECT_TRUE(row->text(9).startsWith("127.0.0.1")) << row->text(9).toStdString();
  EXPECT_TRUE(dialog->text().contains("\nOther machines\n"));
  look("server-with-a-node", dialog);

  node_.terminate();  // It did no work, so that nobody fetches anything of it.
  EXPECT_TRUE(wait([&] { return dialog->nodes()->topLevelItemCount() == 0; }));
}

}  // namespace
}  // namespace tedit::desktop
