// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace tedit::desktop {

/// The headings that commands stand under.
struct command_groups {
  Q_DECLARE_TR_FUNCTIONS(command_groups)

public:
  [[nodiscard]] static QString file() { return tr("File"); }
  [[nodiscard]] static QString edit() { return tr("Edit"); }
  [[nodiscard]] static QString view() { return tr("View"); }
  [[nodiscard]] static QString operation() { return tr("Operation"); }
  [[nodiscard]] static QString loads() { return tr("Loads"); }
  [[nodiscard]] static QString help() { return tr("Help"); }
};

}  // namespace tedit::desktop
