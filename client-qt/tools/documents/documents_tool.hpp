// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class connection_tool;
class document_keeping;
class recipes_tool;
class welcome_page;

/// Opens, closes and exports documents; before one is open, the start page with the recent ones.
class documents_tool : public QObject {
  Q_OBJECT

public:
  documents_tool(window_context& in, connection_tool& connection, recipes_tool& recipes);

  /// What a person dropped or chose: a mesh with load cases, a document, or a recipe that is run.
  void open_files(const QStringList& files);
  /// A mesh or CAD file with load cases, a document file (.tedit) or a recipe.
  void open_file(const QString& mesh, const QStringList& load_cases);
  void open_document(const QString& name);
  /// Opens what was open when the program ended without being closed: after a crash.
  void restore();
  /// The program ends as it should: there will be nothing to restore.
  void forget_unfinished();
  /// Lists the recent documents anew, in the colours of now.
  void show_recent();
  /// Whether the start page is in front.
  [[nodiscard]] bool shows_start_page() const;
  [[nodiscard]] document_keeping& keeping() { return *keeping_; }

private:
  void add_commands();
  void wire_start_page();
  void set_loads(const QStringList& files);
  void ask_file();
  void ask_size(const QString& cad_file, const QStringList& load_cases);
  void ask_export();
  void open_document_file(const QString& path);
  void copy_here(const QString& path, const QString& folder);
  void open_copy(const QString& copy, const QString& of);
  void remember(const QString& document);
  void follow_name(const QString& before);
  void drop_kept(const QString& document);
  void forget(const QString& document);

  window_context& in_;
  connection_tool& connection_;
  recipes_tool& recipes_;
  welcome_page* start_page_;
  document_keeping* keeping_;
};

}  // namespace tedit::desktop
