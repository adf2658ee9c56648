// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/widgets/theme.hpp"

class QSettings;

namespace tedit::desktop {

/// How the window looks now: dark or light, kept in the settings.
class appearance : public QObject {
  Q_OBJECT

public:
  explicit appearance(QSettings& settings) : settings_(settings) {}

  [[nodiscard]] const theme& now() const noexcept { return now_; }
  void set_dark(bool on);

signals:
  void changed(const tedit::desktop::theme& look);

private:
  QSettings& settings_;
  theme now_;
};

}  // namespace tedit::desktop
