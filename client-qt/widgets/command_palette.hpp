// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

#include "client-qt/model/commands.hpp"

class QLineEdit;
class QListWidget;

namespace tedit::desktop {

/// All commands and operations by a few letters: Ctrl+K, type, Enter.
class command_palette : public QFrame {
  Q_OBJECT

public:
  command_palette(commands& all, QWidget* parent);

  void open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void search(const QString& letters);
  void run_current();

  commands& all_;
  QLineEdit* letters_;
  QListWidget* hits_;
};

}  // namespace tedit::desktop
