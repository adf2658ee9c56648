// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "client-qt/model/catalogue.hpp"
#include "client-qt/model/jobs.hpp"
#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

using shared_surface = std::shared_ptr<const client::surface_model>;
using shared_field = std::shared_ptr<const client::field_event>;

/// What is held of one version: always its row, the rest once it was seen.
struct version_record {
  client::version_info info;
  std::optional<edit_report> report;  ///< Of the edit that made it.
  shared_surface surface;
  std::vector<shared_field> fields;        ///< One for each load case, then their envelope.
  std::vector<fem::load_case> load_cases;  ///< As the server said when it was the head.
  std::optional<solve_outcome> outcome;    ///< The converged one.
  int annotation = 0;                      ///< Which of all annotations was its last.
  int told = 0;                            ///< Which of all events last said that it is the head.
};

/// What an edit would make; its version is nowhere but here.
struct shown_preview {
  client::edit_preview made;  ///< Its `surface` is moved on to below.
  shared_surface before;      ///< The head's.
  shared_surface surface;
};
using shared_preview = std::shared_ptr<const shown_preview>;

/// What the user waits for.
struct activity {
  QString title;  ///< "Fill hole".
  QString stage;  ///< As the server says it.
  double fraction = 0;
  bool can_cancel = true;
};

/// How far the field of the head is.
enum class field_state { none, waiting, solving, interim, converged, failed, stopped };

/// The document that is open, as the server has it: its versions, load cases, surface and fields,
/// and every request about it. Nothing here waits; what happened is told by signals. It survives a
/// lost connection: the document is opened again when there is one.
class document : public QObject {
  Q_OBJECT

public:
  explicit document(remote& link, QObject* parent = nullptr);

  // -- what is known -------------------------------------------------------------------

  [[nodiscard]] bool is_open() const noexcept { return !name_.isEmpty(); }
  [[nodiscard]] const QString& name() const noexcept { return name_; }
  /// The current version; null before the first import.
  [[nodiscard]] const version_record* head() const;
  [[nodiscard]] const std::map<std::uint32_t, version_record>& versions() const {
    return versions_;
  }
  [[nodiscard]] bool can_undo() const noexcept { return can_undo_; }
  [[nodiscard]] bool can_redo() const noexcept { return can_redo_; }
  [[nodiscard]] const catalogue& operations() const noexcept { return operations_; }
  [[nodiscard]] const std::optional<activity>& current_activity() const { return activity_; }
  /// All that runs for this window, what `current_activity` shows included.
  [[nodiscard]] jobs& work() { return work_; }
  [[nodiscard]] field_state field_progress() const noexcept { return field_state_; }
  [[nodiscard]] const client::solve_status& solve_progress() const { return solve_status_; }
  /// The load cases of the head.
  [[nodiscard]] const std::vector<fem::load_case>& load_cases() const;
  /// What holds or loads some of these surfaces: "fixed in ctc01_plate static".
  [[nodiscard]] QStringList acting_on(const std::vector<surface_id>& surfaces) const;
  /// A person's name for a surface: its own, or its number.
  [[nodiscard]] QString surface_name(surface_id id) const;

  // -- what can be asked for; each is told by signals, errors by `failed` ----------------

  /// Opens a document of the server; it is made when it is not there.
  void open(const QString& name);
  /// Makes a new document from a mesh file and load cases (files of canonical JSON), and solves
  /// it. `unit` is the mesh's length unit, "mm" when empty.
  void import(const QString& mesh, const QStringList& load_cases, const QString& unit = {});
  void close();
  void set_load_case(const fem::load_case& loads);
  /// Whether a load case is on its way to the server.
  [[nodiscard]] bool changes_loads() const noexcept { return load_requests_ > 0; }
  /// Takes a load case from the head, and solves what is left.
  void remove_load_case(const std::string& name);
  /// Gives a load case the name that `renamed` has: the head is never without it. One request, so
  /// that nothing comes between.
  void rename_load_case(const std::string& before, const fem::load_case& renamed);
  /// Gives a version another name and note.
  void annotate(std::uint32_t number, const QString& name, const QString& note);
  /// Fields bring this, too, from now on, and the one of the head comes again with it. What was
  /// watched before stays so until the document is closed.
  void watch(const client::watched_quantities& wanted);
  /// `loads`: what becomes of loads whose surface goes.
  void apply(const QString& operation, const std::vector<surface_id>& surfaces,
             const ops::parameters& values, const fem::carry_settings& loads = {});
  /// What `apply` would make of the head. A newer question makes an older one `superseded`.
  ticket preview(const QString& operation, const std::vector<surface_id>& surfaces,
                 const ops::parameters& values, remote::reply<shared_preview> done,
                 remote::progress advanced = {});
  void undo();
  void redo();
  /// Makes any version the head.
  void go_to(std::uint32_t number);
  /// Solves all load cases of the head; from then on every new head is solved by itself.
  void solve();
  void set_solve_settings(const client::solve_settings& settings);
  [[nodiscard]] const client::solve_settings& solve_settings() const { return settings_; }
  /// Ends what `current_activity` shows.
  void cancel();
  /// Ends the solve that runs, also one that followed an edit by itself.
  void cancel_solve();
  /// Whether one runs or is about to.
  [[nodiscard]] bool is_solving() const noexcept { return solve_job_ != 0; }
  /// Writes the head to a file, by its suffix: .msh, .stl or .vtu.
  void export_file(const QString& path);
  void refresh_history();
  /// Which surfaces belong together, or why none do: that is no failure to be told.
  void select(const selection_query& query, remote::reply<std::vector<found_feature>> done);

  /// A plane through the head, with the field of a load case as `client::cut` says. A newer
  /// question makes an older one `superseded`; one that is cancelled in `work` is `cancelled` at
  /// once.
  void cut(const vec3& at, const vec3& normal, const std::string& load_case,
           remote::reply<client::section> done);

signals:
  void opened();
  void closed();
  void head_changed();
  void surface_changed();
  void field_changed();
  void solve_changed();
  void history_changed();
  void load_cases_changed();
  void operations_changed();
  void activity_changed();
  void edited(const tedit::client::committed& what);
  /// An operation was asked for; `edited` or `failed` follows.
  void applied(const QString& operation, const std::vector<tedit::surface_id>& surfaces,
               const tedit::ops::parameters& values);
  /// A load case that was asked for from here is the head's, or is gone from it.
  void load_case_set(const tedit::fem::load_case& loads);
  void load_case_removed(const std::string& name);
  void exported(const QString& path);
  void notice(const QString& text);
  /// What was tried, and why it did not work.
  void failed(const QString& what, const tedit::error& reason);

private:
  template <class T>
  ticket ask(const QString& title, remote::work<T> call, std::function<void(T&)> done,
             std::function<bool(const error&)> keep = {});
  void begin_activity(const QString& title);
  void end_activity();
  void progressed(double fraction, const QString& stage);
  void note_solve();

  void connection_changed();
  void reopen();
  void take_state(const client::document_state& state);
  version_record& take_info(const client::version_info& info);
  void ask_commit(const QString& title, remote::work<client::committed> call);
  void ask_again();
  void take_event(const client::committed& what);
  void take_commit(const client::committed& what);
  void take_surface();
  void take_field(const shared_field& field);
  void take_outcome(const solve_outcome& outcome);
  void take_status(const client::solve_status& status);
  void take_load_cases(const std::vector<fem::load_case>& loads);
  void take_other_load_cases(const std::vector<fem::load_case>& loads);
  void ask_history(bool reports);
  void take_history(const client::history& history, int known);
  void send_watch();
  void load_catalogue();
  void set_field_state(field_state next);
  void forget_fields();
  [[nodiscard]] version_record* find(const std::string& version_id);
  void change_loads(const QString& title, remote::work<void> change, std::function<void()> done);
  void send_load_cases(std::vector<fem::load_case> loads, std::function<void()> then = {});
  void forget();

  /// A change whose answer the connection took with it when it broke.
  struct unanswered_change {
    QString title;
    remote::work<client::committed> call;
    error why;
  };

  remote& link_;
  QString name_;
  std::optional<unanswered_change> unanswered_;
  std::map<std::uint32_t, version_record> versions_;
  std::optional<std::uint32_t> head_;
  bool can_undo_ = false;
  bool can_redo_ = false;
  catalogue operations_;
  client::solve_settings settings_;
  client::watched_quantities watched_;
  std::optional<activity> activity_;
  jobs work_;
  int activity_job_ = 0;
  int solve_job_ = 0;  ///< 0: no solve runs.
  ticket running_;
  int solves_ = 0;         ///< Solve requests without an answer.
  int load_requests_ = 0;  ///< The same for load cases.
  field_state field_state_ = field_state::none;
  client::solve_status solve_status_;
  int annotations_ = 0;
  int told_ = 0;     ///< Events that moved the head.
  int opening_ = 0;  ///< Answers to an earlier opening are not for us.
};

}  // namespace tedit::desktop
