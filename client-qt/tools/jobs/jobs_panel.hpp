// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>
#include <QToolButton>

#include <map>

#include "client-qt/model/document.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace tedit::desktop {

/// What runs, for how long and how much longer, each with its Cancel; below how the server's
/// workers are.
class jobs_panel : public QFrame {
  Q_OBJECT

public:
  jobs_panel(jobs& work, remote& link, QWidget* parent = nullptr);

  /// `corner`: where its lower right one is to be on the screen, also when it grows.
  void open_above(const QPoint& corner);
  /// All that it says, line by line.
  [[nodiscard]] QString text() const;

private:
  /// What shows one job; it stays in place while the job runs, so that its button can be pressed.
  struct row {
    QWidget* box = nullptr;
    QProgressBar* bar = nullptr;
    QLabel* facts = nullptr;
    QPushButton* cancel = nullptr;
  };

  void refresh();
  void show_job(const job& one);
  [[nodiscard]] row make_row(const job& one);
  [[nodiscard]] QString server() const;

  jobs& work_;
  remote& link_;
  QPoint corner_;
  QVBoxLayout* list_;
  QLabel* nothing_;
  QLabel* server_;
  std::map<int, row> rows_;  ///< By the job's id.
};

/// What is said where nothing of this window's part runs: the server may work for others, or still
/// solve the document that was `left`.
[[nodiscard]] QString nothing_words(const client::server_status& server, const QString& left = {});

/// In the status line: what runs now in a word; a click opens the panel.
class jobs_button : public QToolButton {
  Q_OBJECT

public:
  jobs_button(jobs& work, remote& link, QWidget* parent = nullptr);

  void open_panel();

private:
  void refresh();

  jobs& work_;
  remote& link_;
  QTimer clock_;  ///< While something runs: its time goes on.
};

}  // namespace tedit::desktop
