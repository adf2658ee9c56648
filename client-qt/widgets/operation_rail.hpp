// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client-qt/widgets/tall_scroll.hpp"

class QAction;

namespace tedit::desktop {

/// Buttons below each other, each with its icon and its name; plugins add any number, so what has
/// no room is scrolled to.
class operation_rail : public tall_scroll {
public:
  explicit operation_rail(QWidget* parent = nullptr);

  void clear();
  /// At the end. The action stays its owner's.
  void add(QAction* action);
};

}  // namespace tedit::desktop
