// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <QStringList>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;

/// A mesh that was opened, with its load cases, and the length unit that it was read in; or a CAD
/// file, which says its unit.
struct imported_file {
  QString mesh;
  QStringList load_cases;
  QString unit;             ///< "mm", "cm", "m", "in".
  QString size = "medium";  ///< Of the mesh of a CAD or surface file: "coarse", "medium", "fine".
  std::map<std::string, double> local_sizes_mm = {};  ///< Of a CAD file: longest edges, by surface.
};

/// The CAD file that a part was meshed from, as it was then.
struct cad_source {
  imported_file file;
  QDateTime changed_at = {};
  qint64 bytes = 0;

  /// Whether it is gone, or another by its time or size.
  [[nodiscard]] bool is_changed() const;
};

/// Opening, importing, exporting and closing. `document::opened` or `document::failed` follows. The
/// document that is open stays so until the other one is there: what fails changes nothing.
class file_requests : public QObject {
  Q_OBJECT

public:
  file_requests(document& part, remote& link);

  /// Opens a document that the server has. `document::failed` says `not_found` when it has none.
  void open(const QString& name);
  /// Opens the copy of a document's file, `of`, that was put in the folder of the server's. Errors
  /// name the file that a person knows; what is no document leaves no copy.
  void open_copy(const QString& copy, const QString& of);
  /// Makes a new document from a mesh file and load cases (files of canonical JSON), and solves
  /// it. `unit` is the mesh's length unit, "mm" when empty.
  void import(const QString& mesh, const QStringList& load_cases, const QString& unit = {});
  /// The same from a CAD file, which is meshed on this computer first (`mesh_cad_file`); the
  /// document has its model, too. Or from a surface file (STL, OBJ, PLY, 3MF), which has none;
  /// `unit` is that of its coordinates where it says none.
  void import_cad(const imported_file& file);
  /// What the open document was meshed from by this window; none after it was closed, and of one
  /// that was there before.
  [[nodiscard]] const std::optional<desktop::cad_source>& cad_source() const { return source_; }
  /// What was imported once more, in another unit.
  void import_anew(imported_file file, const QString& unit);
  /// Gives the server a document that lies in a file, under its name or, where that is taken, the
  /// next one, and opens it.
  void add(const QString& path);
  /// Gives the document another name. `done` gets why not; that it has it is told by
  /// `document::renamed`.
  void rename(const QString& name, std::function<void(const expected<void>&)> done);
  /// The server hears of it: others may delete the document then, and its memory is free soon.
  void close();
  /// Writes a file, by its suffix: the head in a format of the server's, the whole document
  /// (.tedit), or the CAD model with all edits (.step). Another suffix fails with those that there
  /// are.
  void export_to(const QString& path);

signals:
  /// A file is written, also one that something else wrote.
  void exported(const QString& path);
  /// After `document::opened`: it came from a mesh file, which says no unit of its own.
  void imported(const tedit::desktop::imported_file& from);

private:
  /// What a person should know of a document that was made ready.
  struct ready {
    std::string name;
    std::vector<std::string> warnings;
    std::optional<error> refused_loads;
    std::optional<imported_file> from;  ///< Not of a document that was there.
    std::optional<desktop::cad_source> cad = {};
  };
  /// What an import needs, whatever becomes of the window meanwhile.
  struct new_part {
    imported_file file;
    std::vector<fem::load_case> loads;
  };
  /// What the connection has open is changed by one thread at a time, and what was asked for before
  /// it is not done after it.
  struct opening_order {
    std::mutex one_at_a_time;
    std::atomic<int> last{0};
  };
  void import_from(const imported_file& file);
  void leave();
  void reopen();
  [[nodiscard]] static expected<ready> look_up(client::client& server, const std::string& name);
  [[nodiscard]] static expected<client::document_state> open_named(
    client::client& server, const std::string& name, const std::string& or_else,
    const client::surface_model& held);
  void switch_to(const QString& title, remote::work<ready> prepare,
                 std::function<void()> when_refused = {});
  [[nodiscard]] static expected<std::string> open_empty(client::client& server,
                                                        const QString& mesh);
  [[nodiscard]] static expected<ready> make(client::client& server, const execution& run,
                                            const new_part& from);
  [[nodiscard]] static expected<ready> make_of_cad(client::client& server, const execution& run,
                                                   const imported_file& file);
  [[nodiscard]] static expected<ready> make_of_mesh(client::client& server, const execution& run,
                                                    const imported_file& file);

  document& part_;
  remote& link_;
  std::optional<desktop::cad_source> source_;
  QString asked_name_;  ///< Whether the document has got it is not known: the connection broke.
  int wanted_ = 0;      ///< The last document that was asked for, or that none shall be open.
  const std::shared_ptr<opening_order> order_ = std::make_shared<opening_order>();
};

}  // namespace tedit::desktop
