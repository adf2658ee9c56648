// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class connection_tool;
class name_form;

/// What a person does with a document as a thing to hold: whether it is safe, where it is, what it
/// is called, a copy to mail.
class document_keeping : public QObject {
  Q_OBJECT

public:
  document_keeping(window_context& in, connection_tool& connection);

  /// A copy of all versions and loads in one file, which any TEdit opens.
  void copy_to(const QString& path);

private:
  void add_commands();
  void ask_name();
  void rename(const QString& name);
  void say_safe();
  void ask_copy();
  void show_folder();
  [[nodiscard]] QString file() const;

  window_context& in_;
  connection_tool& connection_;
  name_form* naming_;  ///< Of the window.
};

}  // namespace tedit::desktop
