// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QPlainTextEdit>

#include "client-qt/model/preferences.hpp"

namespace tedit::desktop {

/// What happened, line by line with its time; the oldest lines go.
class log_panel : public QPlainTextEdit {
  Q_OBJECT

public:
  explicit log_panel(QWidget* parent = nullptr);

  /// What is worth a line from now on.
  void set_level(log_level level) { level_ = level; }
  void write(const QString& line, log_level level = log_level::everything);

private:
  log_level level_ = log_level::everything;
};

}  // namespace tedit::desktop
