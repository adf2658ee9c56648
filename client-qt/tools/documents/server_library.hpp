// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class connection_tool;
class documents_dialog;

/// "Documents on the server": the list, and what is done with one of them without opening it.
class server_library : public QObject {
  Q_OBJECT

public:
  server_library(window_context& in, connection_tool& connection);

  void show();

signals:
  void document_wanted(const QString& name);
  /// A document was deleted.
  void gone(const QString& name);

private:
  void refresh();
  void copy(const QString& name, const QString& to);
  void rename(const QString& name, const QString& to);
  void remove(const QString& name);
  void finish(const expected<void>& done, const QString& words);

  window_context& in_;
  connection_tool& connection_;
  QPointer<documents_dialog> dialog_;
};

}  // namespace tedit::desktop
