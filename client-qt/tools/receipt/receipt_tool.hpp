// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class receipt_panel;
class selection_tool;

/// What an edit did: its receipt comes to the front, and what it took from the loads is said.
class receipt_tool : public QObject {
  Q_OBJECT

public:
  receipt_tool(window_context& in, selection_tool& selecting);

private:
  void edited(const edit_report& report, std::uint32_t version);

  window_context& in_;
  receipt_panel* panel_;
};

}  // namespace tedit::desktop
