// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <optional>
#include <vector>

#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;

/// Opening, importing, exporting and closing. `document::opened` or `document::failed` follows. The
/// document that is open stays so until the other one is there: what fails changes nothing.
class file_requests : public QObject {
  Q_OBJECT

public:
  file_requests(document& part, remote& link);

  /// Opens a document that the server has. `document::failed` says `not_found` when it has none.
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
  /// What a person should know of a document that was made ready.
  struct ready {
    std::string name;
    std::vector<std::string> warnings;
    std::optional<error> refused_loads;
  };
  /// What an import needs, whatever becomes of the window meanwhile.
  struct new_part {
    QString mesh;
    std::string unit;
    std::vector<fem::load_case> loads;
  };
  void reopen();
  void switch_to(const QString& title, remote::work<ready> prepare);
  [[nodiscard]] static expected<std::string> open_empty(client::client& server,
                                                        const QString& mesh);
  [[nodiscard]] static expected<ready> make(client::client& server, const execution& run,
                                            const new_part& from);

  document& part_;
  remote& link_;
  int wanted_ = 0;  ///< The last document that was asked for, or that none shall be open.
};

}  // namespace tedit::desktop
