// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"
#include "client-qt/net/certification.hpp"

namespace tedit::desktop {

/// Has CalculiX, on this computer, solve the version that is shown, too; what came out is shown,
/// kept in a folder, and noted with the version.
class certify_tool : public QObject {
  Q_OBJECT

public:
  explicit certify_tool(window_context& in);

  /// Into a new folder within `parent`.
  void certify_into(const QString& parent);

private:
  void ask_folder();
  void take(const certificate& made);
  void note(const certificate& made);

  window_context& in_;
};

}  // namespace tedit::desktop
