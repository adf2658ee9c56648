// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class field_panel;
class section_bar;

/// A plane that cuts the part, with its bar over the view.
class section_tool : public QObject {
  Q_OBJECT

public:
  section_tool(window_context& in, const field_panel& fields);

  [[nodiscard]] section_bar& bar() { return *bar_; }

private:
  window_context& in_;
  section_bar* bar_;
  std::optional<picked_point> last_click_;
};

}  // namespace tedit::desktop
