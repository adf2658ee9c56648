// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

/// How the part is looked at: from where, with mesh and edges or without, dark or light.
class viewing_tool : public QObject {
  Q_OBJECT

public:
  explicit viewing_tool(window_context& in);

private:
  window_context& in_;
  bool mesh_ = false;
  bool edges_ = true;
};

}  // namespace tedit::desktop
