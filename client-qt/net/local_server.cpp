// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/net/local_server.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <csignal>

namespace tedit::desktop {

namespace {

constexpr int poll_ms = 40;
constexpr int behind_the_window = 5;  // Of nice(2).
constexpr int patience_ms = 20'000;
constexpr int most_restarts = 3;
constexpr int restart_window_ms = 60'000;

QString state_folder() {
  const QString set = qEnvironmentVariable("XDG_STATE_HOME");
  return (set.isEmpty() ? QDir::homePath() + "/.local/state" : set) + "/tedit/desktop";
}

QString read_text(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

local_server::local_server(const QString& folder, QObject* parent)
    : QObject(parent), folder_(folder.isEmpty() ? state_folder() : folder) {
  poll_.setInterval(poll_ms);
  connect(&poll_, &QTimer::timeout, this, &local_server::look);
  connect(&process_, &QProcess::finished, this, &local_server::ended);
  // Whatever becomes of us, the server goes too. It solves with all cores: the window comes first.
  process_.setChildProcessModifier([] {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    [[maybe_unused]] const int now = ::nice(behind_the_window);
  });
  process_.setProcessChannelMode(QProcess::MergedChannels);
}

local_server::~local_server() {
  stopping_ = true;
  if (!ours_ || process_.state() == QProcess::NotRunning)
    return;
  process_.terminate();
  if (process_.waitForFinished(3000))
    return;
  process_.kill();  // It is in the middle of a solve; what was acknowledged is stored.
  process_.waitForFinished(3000);
}

/// Beside this program, as it is built and installed; else wherever the shell would find it.
QString local_server::program() {
  const QString beside = QCoreApplication::applicationDirPath() + "/tedit";
  return QFile::exists(beside) ? beside : QStandardPaths::findExecutable("tedit");
}

void local_server::start() {
  if (!QDir().mkpath(folder_)) {
    emit failed({ec::io_error,
                 "cannot make the folder " + folder_.toStdString(),
                 "Set XDG_STATE_HOME to a folder that can be written",
                 {}});
    return;
  }
  if (!lock_) {
    lock_ = std::make_unique<QLockFile>(folder_ + "/server.lock");
    lock_->setStaleLockTime(0);  // Only a process that is gone makes it stale.
  }
  polls_ = 0;
  ours_ = lock_->isLocked() || lock_->tryLock(0);
  if (ours_)
    launch();
  poll_.start();
}

void local_server::launch() {
  const QString tedit = program();
  if (tedit.isEmpty()) {
    poll_.stop();
    emit failed({ec::not_found,
                 "the program \"tedit\", which serves the documents, is not there",
                 "Install it beside tedit-qt, or connect to a server",
                 {}});
    return;
  }
  QFile::remove(folder_ + "/ready.json");
  process_.setStandardOutputFile(folder_ + "/server.log");
  process_.start(tedit,
                 {"serve", "--port", "0", "--documents", folder_ + "/documents", "--token-file",
                  folder_ + "/token", "--ready-file", folder_ + "/ready.json"});
}

void local_server::look() {
  if (read_ready_file()) {
    poll_.stop();
    return;
  }
  if (++polls_ * poll_ms < patience_ms)
    return;
  poll_.stop();
  emit failed({ec::timeout,
               "the server on this computer did not start within 20 s",
               "See " + folder_.toStdString() + "/server.log",
               {}});
}

bool local_server::read_ready_file() {
  const auto state = QJsonDocument::fromJson(read_text(folder_ + "/ready.json").toUtf8()).object();
  if (state.isEmpty())
    return false;
  const QString token = read_text(state["token_file"].toString()).trimmed();
  if (token.isEmpty())
    return false;
  // It gives way to whatever else runs on this computer.
  emit ready({state["url"].toString(), token, std::chrono::milliseconds(patience_ms)});
  return true;
}

void local_server::ended() {
  if (stopping_ || !ours_)
    return;
  if (poll_.isActive()) {  // It never got ready.
    poll_.stop();
    emit failed({ec::service_unavailable,
                 "the server on this computer ended at once: " + last_lines().toStdString(),
                 "See " + folder_.toStdString() + "/server.log",
                 {}});
    return;
  }
  if (restarts_ == 0 || since_.elapsed() > restart_window_ms) {
    restarts_ = 0;
    since_.start();
  }
  if (++restarts_ > most_restarts) {
    emit failed({ec::service_unavailable,
                 "the server on this computer ended " + std::to_string(restarts_) +
                   " times within a minute: " + last_lines().toStdString(),
                 "See " + folder_.toStdString() + "/server.log",
                 {}});
    return;
  }
  start();
}

QString local_server::last_lines() const {
  const auto lines = read_text(folder_ + "/server.log").trimmed().split('\n');
  return lines.isEmpty() ? tr("it printed nothing") : lines.last();
}

}  // namespace tedit::desktop
