// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class history_strip;

/// The versions of the part: undo, redo, going to one, and what it is called.
class history_tool : public QObject {
  Q_OBJECT

public:
  explicit history_tool(window_context& in);

  [[nodiscard]] history_strip& strip() { return *strip_; }
  /// Makes a version the head, behind what runs.
  void step_to(std::uint32_t version);

private:
  void add_commands();
  void tell_cad(const client::version_info& version);
  [[nodiscard]] bool is_busy() const;
  void undo();
  void redo();

  window_context& in_;
  history_strip* strip_;
};

}  // namespace tedit::desktop
