// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;

/// Opening, importing, exporting and closing. `document::opened` or `document::failed` follows.
class file_requests : public QObject {
  Q_OBJECT

public:
  file_requests(document& part, remote& link);

  /// Opens a document of the server; it is made when it is not there.
  void open(const QString& name);
  /// Makes a new document from a mesh file and load cases (files of canonical JSON), and solves
  /// it. `unit` is the mesh's length unit, "mm" when empty.
  void import(const QString& mesh, const QStringList& load_cases, const QString& unit = {});
  void close();
  /// Writes the head to a file, by its suffix: .msh, .stl or .vtu.
  void export_to(const QString& path);

signals:
  /// A file is written, also one that something else wrote.
  void exported(const QString& path);

private:
  void reopen();
  void ask_import(const QString& mesh, const QString& unit, std::vector<fem::load_case> loads);

  document& part_;
  remote& link_;
};

}  // namespace tedit::desktop
