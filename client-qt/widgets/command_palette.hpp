// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/model/commands.hpp"
#include "client-qt/widgets/finder_popup.hpp"

namespace tedit::desktop {

/// All commands and operations by a few letters: Ctrl+K, type, Enter.
class command_palette : public finder_popup {
  Q_OBJECT

public:
  command_palette(commands& all, QWidget* parent);

protected:
  void search(const QString& letters) override;
  void take(int row) override;

private:
  commands& all_;
};

}  // namespace tedit::desktop
