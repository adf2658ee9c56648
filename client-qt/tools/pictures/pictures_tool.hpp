// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <set>
#include <string>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class history_tool;

/// Pictures of the view: the one that a person saves, the thumbnails of the history, and the one
/// on the start page. The latter come of frames that are there: the window waits for none.
class pictures_tool : public QObject {
  Q_OBJECT

public:
  pictures_tool(window_context& in, history_tool& history);

private:
  void ask_file();
  void shown();
  void take();
  void find_kept();

  window_context& in_;
  history_tool& history_;
  std::string thumbnail_due_;         ///< The version whose picture the next frame gives.
  QString kept_;                      ///< Document, version and field of the picture that was kept.
  std::set<std::string> looked_for_;  ///< Versions of this document whose files were looked for.
};

}  // namespace tedit::desktop
