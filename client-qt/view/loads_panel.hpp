// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTreeWidget>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

/// Materials, supports and loads of every load case of the head.
class loads_panel : public QTreeWidget {
  Q_OBJECT

public:
  explicit loads_panel(document& part, QWidget* parent = nullptr);

signals:
  void surfaces_wanted(const QList<qint64>& surfaces);

private:
  void refresh();

  document& part_;
};

}  // namespace tedit::desktop
