// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLockFile>
#include <QObject>
#include <QProcess>
#include <QTimer>

#include <memory>

#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

/// The server that this computer runs for its user: `tedit serve` as a process of its own, with the
/// documents in `folder`. The first client that needs it starts it and ends it; clients that come
/// meanwhile share it. Nothing here waits.
class local_server : public QObject {
  Q_OBJECT

public:
  /// `folder`: documents, token and log; empty: tedit/desktop under $XDG_STATE_HOME.
  explicit local_server(const QString& folder = {}, QObject* parent = nullptr);
  ~local_server() override;  ///< Ends the server when it is ours; waits for it 3 s at most.

  /// Starts it, or finds the one that runs. `ready` or `failed` follows, also later on when it had
  /// to be started anew.
  void start();

  /// The program tedit of this installation: beside this one, else on the path.
  [[nodiscard]] static QString program();

  [[nodiscard]] const QString& folder() const noexcept { return folder_; }
  [[nodiscard]] qint64 pid() const { return process_.processId(); }
  /// Whether `ready` or `failed` is still to come: an address that was told before leads nowhere.
  [[nodiscard]] bool is_starting() const { return poll_.isActive(); }

signals:
  void ready(const tedit::desktop::server_address& address);
  void failed(const tedit::error& reason);

private:
  void launch();
  void look();
  void ended();
  [[nodiscard]] bool read_ready_file();
  [[nodiscard]] QString last_lines() const;

  QString folder_;
  std::unique_ptr<QLockFile> lock_;
  QProcess process_;
  QTimer poll_;
  int polls_ = 0;
  QElapsedTimer since_;  ///< The first of the restarts that count.
  int restarts_ = 0;
  bool ours_ = false;
  bool stopping_ = false;
};

}  // namespace tedit::desktop
