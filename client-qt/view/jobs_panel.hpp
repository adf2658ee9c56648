// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>
#include <QToolButton>

#include "client-qt/model/document.hpp"

class QLabel;
class QVBoxLayout;

namespace tedit::desktop {

/// What runs, for how long and how much longer, each with its Cancel; below how the server's
/// workers are.
class jobs_panel : public QFrame {
  Q_OBJECT

public:
  jobs_panel(jobs& work, remote& link, QWidget* parent = nullptr);

  /// All that it says, line by line.
  [[nodiscard]] QString text() const;

private:
  void refresh();
  void add_job(const job& one);
  void add_workers();
  QLabel* add_line(const QString& text, const char* role);

  jobs& work_;
  remote& link_;
  QVBoxLayout* column_;
};

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
