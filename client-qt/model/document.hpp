// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "client-qt/model/catalogue.hpp"
#include "client-qt/model/edit_requests.hpp"
#include "client-qt/model/file_requests.hpp"
#include "client-qt/model/foreground_work.hpp"
#include "client-qt/model/head_questions.hpp"
#include "client-qt/model/load_requests.hpp"
#include "client-qt/model/solve_requests.hpp"
#include "client-qt/model/version_store.hpp"
#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

/// The document that is open, as the server has it: its versions, surface and fields. What can be
/// asked for stands with what it is about: `files`, `edits`, `loads`, `solver`, `questions`.
/// Nothing here waits; what happened is told by signals. It survives a lost connection: the
/// document is opened again when there is one.
class document : public QObject {
  Q_OBJECT

public:
  explicit document(remote& link, QObject* parent = nullptr);

  // -- what is known -------------------------------------------------------------------

  [[nodiscard]] bool is_open() const noexcept { return !name_.isEmpty(); }
  [[nodiscard]] const QString& name() const noexcept { return name_; }
  /// The current version; null before the first import.
  [[nodiscard]] const version_record* head() const { return versions_.head(); }
  [[nodiscard]] const std::map<std::uint32_t, version_record>& versions() const {
    return versions_.all();
  }
  [[nodiscard]] const catalogue& operations() const noexcept { return operations_; }
  /// Who else has it open, in the order in which they came.
  [[nodiscard]] const std::vector<client::participant>& others() const noexcept { return others_; }
  /// A person's name for a surface: its own, or its number.
  [[nodiscard]] QString surface_name(surface_id id) const;

  // -- what can be asked for; each is told by signals, errors by `failed` ----------------

  /// What a person waits for,
  [[nodiscard]] foreground_work& foreground() { return foreground_; }
  [[nodiscard]] const foreground_work& foreground() const { return foreground_; }
  /// and all that runs.
  [[nodiscard]] jobs& work() { return foreground_.all(); }
  [[nodiscard]] file_requests& files() { return files_; }
  [[nodiscard]] edit_requests& edits() { return edits_; }
  [[nodiscard]] const edit_requests& edits() const { return edits_; }
  [[nodiscard]] load_requests& loads() { return loads_; }
  [[nodiscard]] const load_requests& loads() const { return loads_; }
  [[nodiscard]] solve_requests& solver() { return solver_; }
  [[nodiscard]] const solve_requests& solver() const { return solver_; }
  [[nodiscard]] head_questions& questions() { return questions_; }

  // -- for the requests ----------------------------------------------------------------

  /// Changes with each document: answers to an earlier one are not for this.
  [[nodiscard]] int opening() const noexcept { return opening_; }
  /// Forgets the document before; an empty name: none is open.
  void begin(const QString& name);
  void take(const client::document_state& state);
  /// The server calls it so from now on.
  void take_name(const QString& name);
  void take(const client::committed& what);
  /// The surface that the connection holds: it may come before what it belongs to is known, and is
  /// taken with that.
  void take_surface();
  /// With `reports` also of what edits did that were made before this was opened.
  void refresh_history(bool reports = false);
  void load_catalogue();
  /// Without loads, or with others, the head has no field, whatever was shown of it before.
  void forget_fields();
  void say(const std::vector<std::string>& texts);
  void warn(const std::vector<std::string>& texts);

signals:
  /// Another document takes the place of the one before, or none: `opened` or `closed` follows.
  void begun();
  void opened();
  void closed();
  /// It has another name now, whoever gave it; all else is as it was.
  void renamed(const QString& before);
  void others_changed();
  void head_changed();
  void surface_changed();
  void field_changed();
  void history_changed();
  /// How a version stands on the CAD model; it is in the history by then.
  void cad_known(const tedit::client::version_info& version);
  void operations_changed();
  void edited(const tedit::client::committed& what);
  void notice(const QString& text);
  /// What a person should know before going on: of a mesh, of loads that do not fit it.
  void warned(const QString& text);
  /// What was tried, and why it did not work.
  void failed(const QString& what, const tedit::error& reason);

private:
  void take_load_cases(const client::load_cases_event& event);
  void take_field(const shared_field& field);
  void take(const client::participant& who, bool gone);

  remote& link_;
  QString name_;
  int opening_ = 0;
  version_store versions_;
  catalogue operations_;
  std::vector<client::participant> others_;
  foreground_work foreground_;
  solve_requests solver_;
  load_requests loads_;
  edit_requests edits_;
  file_requests files_;
  head_questions questions_;
};

}  // namespace tedit::desktop
