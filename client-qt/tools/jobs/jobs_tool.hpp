// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

/// "What runs": its button in the status line, its panel, and ending what a person waits for.
class jobs_tool : public QObject {
  Q_OBJECT

public:
  explicit jobs_tool(window_context& in);
};

}  // namespace tedit::desktop
