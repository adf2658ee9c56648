// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "fem/receipt.hpp"

class QComboBox;

namespace tedit::desktop {

/// What becomes of loads and supports whose surface an edit takes away.
class policy_row : public QWidget {
  Q_OBJECT

public:
  explicit policy_row(fem::load_policy now);

  [[nodiscard]] fem::load_policy policy() const;

signals:
  void changed();

private:
  QComboBox* choice_;
};

}  // namespace tedit::desktop
