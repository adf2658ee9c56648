// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class connection_tool;

/// Meshes the CAD file of the part once more, with other lengths of edges on picked surfaces.
class remeshing : public QObject {
  Q_OBJECT

public:
  remeshing(window_context& in, connection_tool& connection);

private:
  void ask();
  void mesh(const imported_file& file);

  window_context& in_;
  connection_tool& connection_;
};

}  // namespace tedit::desktop
