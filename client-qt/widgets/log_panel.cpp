// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/log_panel.hpp"

#include <QDateTime>

namespace tedit::desktop {

static constexpr int most_lines = 5000;

log_panel::log_panel(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setMaximumBlockCount(most_lines);
  setAccessibleName(tr("Log"));
}

void log_panel::write(const QString& line, log_level level) {
  if (level <= level_)
    appendPlainText(QDateTime::currentDateTime().toString("HH:mm:ss.zzz  ") + line);
}

}  // namespace tedit::desktop
