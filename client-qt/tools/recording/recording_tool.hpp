// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class recorder;
struct toolbox;

/// Writes down what a person does and saves it as a recipe.
class recording_tool : public QObject {
  Q_OBJECT

public:
  /// After all the tools that it listens to.
  recording_tool(window_context& in, toolbox& tools);

  [[nodiscard]] recorder& recording() { return *recorder_; }

private:
  void add_light();
  void start_or_stop();
  void ask_file();

  window_context& in_;
  recorder* recorder_;
};

}  // namespace tedit::desktop
