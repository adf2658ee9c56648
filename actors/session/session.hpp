// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <list>
#include <map>
#include <set>

#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/interfaces.hpp"
#include "actors/pages/page_cache.hpp"
#include "actors/session/bounded_memory.hpp"
#include "actors/session/change_log.hpp"
#include "actors/session/version_graph.hpp"
#include "actors/worker/job_thread.hpp"
#include "base/stopwatch.hpp"
#include "base/tracing/tracing.hpp"

namespace tedit::actors {

/// Longer than any work may take: the pools of workers end what takes too long, each by its own
/// limit, and answer then.
inline constexpr std::chrono::minutes answer_limit{24 * 60};

/// For what a session or the hub answers from memory.
inline constexpr std::chrono::seconds short_limit{60};

/// A session that nobody has open for so long ends; its document can be opened again.
inline constexpr std::chrono::seconds unused_limit{120};

/// Bytes of the fields of results that a server keeps.
inline constexpr std::uint64_t result_bytes = std::uint64_t{512} << 20;

/// Bytes of versions other than the heads that a server keeps at hand.
inline constexpr std::uint64_t version_bytes = std::uint64_t{512} << 20;

/// What a session works with.
struct session_parts {
  std::string document;
  store_actor store;
  page_store_actor pages;
  std::shared_ptr<page_cache> cache;
  worker_set workers;
  std::string device = "auto";  ///< For solves that name none.
  caf::actor hub = {};          ///< Who ends it when nobody has it open; null: nobody.
  std::chrono::milliseconds unused_limit = actors::unused_limit;
  /// Shared by all sessions of a server.
  std::shared_ptr<result_memory> results = std::make_shared<result_memory>(result_bytes);
  std::shared_ptr<version_memory> versions = std::make_shared<version_memory>(version_bytes);
  shared_remains remains = {};   ///< Of the session before; may be null.
  job_thread_actor reader = {};  ///< Does what reads much; null: each has a thread of its own.
  cad_editor_actor cad = {};     ///< Null: no edit is made on CAD models.
};

struct session_state;
using session_pointer = session_actor::stateful_pointer<session_state>;

/// The state of a session. Its members are what the handlers call; they are split over twelve
/// files: session.cpp (subscribers, queue, history), edits.cpp (everything that moves the head),
/// changes.cpp (what every change must pass), meshes.cpp (meshes of versions), candidates.cpp
/// (operations, previews), notes.cpp (what makes no new version), solves.cpp, result_fields.cpp,
/// asides.cpp (what is worked out aside), comparisons.cpp, print_checks.cpp and cad.cpp (edits on
/// the CAD model).
struct session_state {
  /// Something that changes the document. One at a time, in the order of arrival.
  struct command {
    std::uint64_t ticket = 0;
    caf::actor client;  ///< Who asks, or null.
    std::function<void()> start;
    std::function<void(const error&)> refuse;
    tracing::span stage = {};  ///< That it waits.
  };

  /// The command that runs.
  struct running_command {
    std::uint64_t ticket = 0;
    bool cancelled = false;
    std::function<void()> cancel_job;  ///< Empty while nothing can be cancelled.
  };

  /// Who waits for a new head.
  struct head_waiter {
    caf::actor client;
    caf::typed_response_promise<head_moved> promise;
  };

  struct import_run;
  struct edit_run;
  // In candidate.hpp.
  struct candidate_run;
  struct checked_candidate;
  struct kept_candidate;
  struct preview_run;

  /// What is worked out on a thread aside, in the order of arrival.
  struct aside_run {
    std::uint64_t ticket = 0;
    cancel_token token;
    std::function<void()> begin;  ///< Its turn has come.
    std::function<void(const error&)> refuse;
    job_id job = {};  ///< That tells of its progress; of none, nobody is told.
  };

  /// A request that waits for the solve that runs.
  struct solve_waiter {
    std::uint64_t ticket = 0;
    caf::actor client;
    caf::typed_response_promise<solved> promise;
  };

  /// Two solves with one key have one result.
  struct solve_key {
    std::string version;  ///< Hexadecimal; empty: of none.
    load_case_list load_cases;
    std::string device;
    double tolerance = 0;
    double energy_tolerance = 0;
    int element_order = 2;

    friend bool operator==(const solve_key&, const solve_key&) = default;
  };

  struct active_solve {
    job_id job;
    solve_key key;
    std::vector<std::string> names;  ///< Of its load cases.
    version_ptr mesh;
    bool asked_for = false;  ///< By a request; else it follows a new head by itself.
    int retries = 0;
    std::vector<solve_waiter> waiting;  ///< The first one hears of progress.

    [[nodiscard]] std::set<caf::actor> askers() const {
      std::set<caf::actor> result;
      for (const auto& one : waiting)
        result.insert(one.client);
      return result;
    }
  };

  /// A result, with what is needed to write it to a file.
  struct kept_result {
    solve_key key;
    solved event;  ///< Without its fields and its mesh.
    solve_result fields;
    result_memory::handle shown;  ///< The fields, as long as there is room for them.
    std::vector<field_ref>
      left;  ///< Of those that are shown, where they were made: nobody watches.
  };

  /// Takes the fields of a result, and those that were left where they are.
  using fields_taker = std::function<void(const std::shared_ptr<const std::vector<field>>&,
                                          const std::vector<field_ref>& left)>;
  struct field_fetch;

  // -- session.cpp ---------------------------------------------------------------------------

  void start(session_pointer owner, session_parts with, stored_document stored);
  caf::result<session_snapshot> attach(const attach_request& request);
  void detach(const caf::actor& subscriber);
  /// All who have the document open, in the order in which they came.
  [[nodiscard]] std::vector<participant> participants() const;
  [[nodiscard]] session_history history(const history_request& request) const;
  caf::result<session_version> version(const version_request& request);
  void cancel(std::uint64_t ticket);
  /// Whether nobody has the document open and nothing is done for it.
  [[nodiscard]] bool is_unused() const;
  /// Looks after a while whether it still is unused.
  void look_later();
  void look(std::uint64_t number);
  caf::result<shared_remains> end();
  void cancel_jobs_of(std::uint64_t ticket);
  void enqueue(command c);
  void next_command();
  void finish_command();
  /// Calls for the next look at what waits.
  void look_at_queue_after(std::chrono::milliseconds wait);
  /// Tells those who wait how many changes go before theirs.
  void tell_queue(std::uint64_t number);
  void on_progress(const job_progress& note);
  /// Tells all subscribers; not those who hear it as an answer.
  template <class Event>
  void broadcast(const Event& event, const std::set<caf::actor>& answered = {});
  /// Makes a change durable, then calls `done`, or `failed`.
  void commit(store::change change, const std::function<void(double ms)>& done,
              const std::function<void(const error&)>& failed);
  /// Fetches pages into this process, then calls `done`, or `failed`.
  void pull(const caf::actor& source, const hash_list& ids,
            const std::function<void(const page_set&)>& done,
            const std::function<void(const error&)>& failed);
  job_id new_job(std::uint64_t ticket, const caf::actor& client);
  /// Of a job that nobody asked for it is traced as a part of what moved the head.
  [[nodiscard]] order_base base_order(job_id job) const;

  // -- edits.cpp ------------------------------------------------------------------------------

  caf::result<head_moved> import(const import_request& request);
  caf::result<head_moved> edit(const apply_request& request);
  caf::result<head_moved> move(const move_request& request);
  caf::result<exported> write_file(const export_request& request);
  /// The rest of an export, once this process has all pages that its order names, of `mesh` and
  /// `held`, which nobody else may hold.
  void send_export(job_id job, const export_order& order, const std::string& file_name,
                   const std::shared_ptr<caf::typed_response_promise<exported>>& promise,
                   const version_ptr& mesh, const page_set& held = {}, int retries = 0);
  caf::result<selected> select(const select_request& request);

  void begin_import(const std::shared_ptr<import_run>& run);
  void begin_edit(const std::shared_ptr<edit_run>& run);
  void make_edit(const std::shared_ptr<edit_run>& run);
  void refuse_edit(const std::shared_ptr<edit_run>& run, const error& e);
  void commit_edit(const std::shared_ptr<edit_run>& run, const checked_candidate& made);
  /// `made`: the change, but for its version; `how` as it was asked for. `then` is called when all
  /// have been told.
  void commit_node(graph_node node, past_change made, const std::string& how, head_waiter asked_by,
                   const std::function<void()>& then = {});
  void show_head(const past_change& made, double commit_ms, head_waiter asked_by);
  void begin_move(const move_request& request, caf::typed_response_promise<head_moved> promise);
  void commit_move(const move_request& request, const version_graph::target& target,
                   const version_ptr& mesh, caf::typed_response_promise<head_moved> promise);
  void write_version(const export_request& request, const graph_node& node, const version_ptr& mesh,
                     const std::shared_ptr<caf::typed_response_promise<exported>>& promise);
  [[nodiscard]] head_moved describe(const graph_node& node, const std::string& cause) const;

  // -- meshes.cpp -----------------------------------------------------------------------------

  /// The document is open: its head is there.
  void begin_meshes();
  /// The head is about to be another version: its mesh stays at hand.
  void leave_head();
  /// Null when it is only in the document. Counts as a use.
  [[nodiscard]] version_ptr mesh_at_hand(std::uint32_t number);
  /// Calls `use` at once when the mesh is at hand, else once it was read. @pre there is the
  /// version.
  void with_mesh(std::uint32_t number, const std::function<void(const version_ptr&)>& use,
                 const std::function<void(const error&)>& refuse);

  // -- what every change must pass (changes.cpp) -----------------------------------------------

  /// What is said to a change that may not be made: it was made before, its edit id was used for
  /// another, or the head is not the version that it expects. Nothing when it may.
  struct verdict {
    const past_change* made = nullptr;  ///< It was made before.
    std::optional<caf::error> refusal;
  };
  [[nodiscard]] verdict judge(const change_terms& terms, const asked_change& request) const;
  [[nodiscard]] std::optional<caf::error> check_expected(const change_terms& terms) const;
  /// The version that an edit was made for, where it is another than the head and the edit may be
  /// carried over; else null.
  [[nodiscard]] const graph_node* carried_from(const change_terms& terms) const;
  /// The head is not the version that a request was made for; `what`: of it.
  [[nodiscard]] caf::error other_head(const change_terms& terms, const std::string& what) const;
  /// Whether nothing is to be done for a request; then it is answered: refused, or as it was when
  /// it was carried out.
  bool is_settled(const change_terms& terms, const asked_change& request,
                  caf::typed_response_promise<head_moved> promise);
  /// A change as it will stand in the log.
  [[nodiscard]] static past_change begin_change(const change_terms& terms,
                                                const asked_change& request);

  // -- candidates.cpp -------------------------------------------------------------------------

  void make_candidate(const std::shared_ptr<candidate_run>& run);
  void check_candidate(const std::shared_ptr<candidate_run>& run,
                       const operation_result& candidate);
  void accept_candidate(const std::shared_ptr<candidate_run>& run, const check_result& result);
  void retry_candidate(const std::shared_ptr<candidate_run>& run, const error& e);
  caf::result<previewed> preview(const preview_request& wanted);
  void finish_preview(std::uint64_t ticket, const std::shared_ptr<const checked_candidate>& made,
                      double ms);
  void end_preview(std::uint64_t ticket, const error& why);
  void end_previews(const error& why);
  [[nodiscard]] previewed describe_preview(const kept_candidate& candidate) const;

  // -- notes.cpp ------------------------------------------------------------------------------

  /// Queues a change that makes no new version; the same again is made once.
  caf::result<acknowledged> note(const note_request& request);
  caf::result<document_renamed> rename(const std::string& wanted);
  caf::result<acknowledged> copy_to(const copy_order& order);
  caf::result<acknowledged> erase(const caf::actor& asker);
  [[nodiscard]] session_status status() const;
  void restart_solve_of(const fem::load_case& changed);
  void forget_solve_of(const std::string& load_case);

  // -- solves.cpp -----------------------------------------------------------------------------

  caf::result<solved> solve(const solve_request& request);
  [[nodiscard]] held_result held() const;
  /// The result, of this mesh, with its fields; nothing when they had to give way.
  [[nodiscard]] std::optional<solved> with_fields(const kept_result& result,
                                                  const version_ptr& mesh) const;
  /// The last result of a version with load cases that it has now: after a change of loads the old
  /// field would lie. Null when there is none.
  [[nodiscard]] const kept_result* result_of(const graph_node& node) const;
  acknowledged end_solve();
  /// Takes over what the session before had of versions that are there.
  void take_over(session_remains& before);
  /// Has all fields of a result, those that only files have, too, in this process: from the worker
  /// that solved, or, where that has gone or forgotten them, by solving once more.
  void fetch_all_fields(const kept_result& result, const version_ptr& mesh, const order_base& base,
                        const std::function<void(const solve_result&, const page_set&)>& use,
                        const std::function<void(const error&)>& refuse);
  [[nodiscard]] solve_order order_of(const solve_key& key, const version_ptr& mesh,
                                     const order_base& base) const;
  /// Solves the new head when somebody has asked for a solve before.
  void follow_head();
  void start_solve(const solve_request& request,
                   std::optional<caf::typed_response_promise<solved>> promise);
  /// The load cases that a request means; `names` gets their names, also where there are none.
  /// Errors: `conflict`, `not_found`.
  [[nodiscard]] expected<load_case_list> chosen_cases(const solve_request& request,
                                                      std::vector<std::string>& names) const;
  void keep_result(kept_result result);
  void launch(active_solve next);
  /// Ends the wait of one request; whether there was one. The solve goes on for others that wait,
  /// and when it follows a head by itself; else it ends, and the following with it.
  bool leave_solve(std::uint64_t ticket);
  void tell_progress();
  void end_active_solve(ec code, const std::string& why, solve_phase phase);
  void receive_result(job_id job, const solve_result& result);
  void retry_solve(job_id job, const error& e);
  void fail_solve(job_id job, const error& e);
  void on_frame(const job_frame& frame);
  void on_preview(const job_preview& preview);
  /// How a solve goes on; its end is told to those who wait for it by their answer.
  void tell(const active_solve& which, solve_phase phase, const std::string& message = {});

  // -- result_fields.cpp ----------------------------------------------------------------------

  /// Whether somebody needs a field.
  [[nodiscard]] bool is_watched(const field_ref& one) const;
  /// Fetches the fields of a result, over a slow line those that are watched, and hands them on
  /// while `job` is still active.
  void open_fields(job_id job, const solve_result& result, const fields_taker& use,
                   const std::function<void(const error&)>& refuse);
  void fetch_fields(const std::shared_ptr<field_fetch>& fetch);
  caf::result<held_result> watch(const watch_request& request);
  /// Fetches what is watched of a result that is at hand; `done` hears whether all of it is there.
  void bring_watched(std::uint64_t solve, const version_ptr& mesh,
                     const std::function<void(bool)>& done);
  bool add_fields(std::uint64_t solve, const version_ptr& mesh,
                  const std::vector<field_ref>& wanted, const page_set& pages);
  void solve_once_more(std::uint64_t solve);

  // -- asides.cpp -----------------------------------------------------------------------------

  /// It waits for its turn; the one before it says when that has come.
  void add_aside(aside_run run);
  /// In aside.hpp.
  template <class Result>
  void do_aside(caf::typed_response_promise<Result> promise,
                const std::function<expected<Result>()>& work, const char* what);
  /// Calls `done` when the thread has done it, or with why it has not.
  void run_aside(job_task task, const char* what, const std::function<void(const error*)>& done);
  /// The first one cannot be begun.
  void refuse_aside(const error& why);
  /// The first one was answered; the next begins.
  void end_aside();
  /// Ends one early; whether there was one with this ticket.
  bool leave_aside(std::uint64_t ticket);
  /// Has the thread of one that runs notice that nobody wants it.
  void cancel_asides();

  // -- comparisons.cpp ------------------------------------------------------------------------

  /// Refuses what is not there; else it waits for its turn.
  caf::result<compared> compare(const comparison_request& request);
  void begin_comparison(const comparison_request& request, const cancel_token& token,
                        const caf::typed_response_promise<compared>& promise);
  /// Of the result that is compared, what is watched.
  void bring_to_compare(std::uint32_t number, const std::string& load_case, const version_ptr& mesh,
                        const std::function<void(bool)>& done);
  /// `meshes`: before and after.
  void run_comparison(const comparison_request& request,
                      const std::pair<version_ptr, version_ptr>& meshes, const cancel_token& token,
                      const caf::typed_response_promise<compared>& promise);
  /// Results of a version with a load case as it is now, used last first.
  [[nodiscard]] std::vector<const kept_result*> results_of(const graph_node& node,
                                                           const std::string& load_case) const;
  /// Two that may be compared. Errors: which version has no field, or why they do not fit.
  [[nodiscard]] expected<std::pair<solved, solved>> results_to_compare(
    const graph_node& before, const graph_node& after, const std::string& load_case) const;

  // -- print_checks.cpp -----------------------------------------------------------------------

  /// Refuses what is not there; else it waits for its turn.
  caf::result<print_checked> check_print(const print_request& request);
  /// `wanted`: all but what is found.
  void begin_print_check(print_checked wanted, const cancel_token& token,
                         const caf::typed_response_promise<print_checked>& promise);

  // -- cad.cpp --------------------------------------------------------------------------------

  /// The document is open: which edits are still to be made on its CAD model.
  void begin_cad(const std::vector<store::log_row>& log);
  /// The state of a version that is about to be made by an edit.
  [[nodiscard]] std::optional<cad_state> cad_of_child(const graph_node& child) const;
  /// An edit was committed: it is to be made on the model.
  void add_to_cad(std::uint32_t number, const edit_request& wanted);
  /// The first of those that wait, when nothing else is done with the model.
  void next_cad();
  void send_to_cad(const std::shared_ptr<const store::cad_row>& model);
  /// The model of the version is known: makes that durable, between two commands.
  void keep_cad(store::cad_row row);
  void store_cad();
  /// Tells all what is known of a version.
  void show_cad(std::uint32_t number, cad_state state);
  /// The system failed: nothing more is tried until the document is opened again.
  void fail_cad(const error& why);
  /// Ends what runs; `next_cad` begins it anew.
  void stop_cad();

  /// An edit that is being made on the CAD model.
  struct cad_run {
    std::uint32_t number = 0;
    job_id job;
    std::shared_ptr<const store::cad_row> result;  ///< Null until it is known.
    bool storing = false;
  };

  /// A version other than the head that was used lately.
  struct near_version {
    version_memory::handle kept;  ///< Null while it is the head.
    std::uint64_t bytes = 0;      ///< Of pages that came with it.
  };

  session_state();
  session_state(const session_state&) = delete;
  session_state& operator=(const session_state&) = delete;
  ~session_state();

  session_pointer self = nullptr;
  caf::actor ear;  ///< Hears for it what workers tell; they cannot send to the session.
  session_parts parts;
  version_graph graph;
  change_log past;
  std::map<caf::actor, participant> subscribers;
  std::map<caf::actor, std::set<std::string, std::less<>>> watched;  ///< `watch_request`.
  std::uint64_t participants_so_far = 0;
  std::deque<command> waiting;
  std::optional<running_command> running;
  std::uint64_t queue_looks = 0;  ///< Called for by `look_at_queue_after`.
  tracing::context head_trace;    ///< Of the request that made this version the head.
  std::map<std::uint64_t, std::shared_ptr<preview_run>> previews;  ///< By ticket.
  std::shared_ptr<const kept_candidate> last_preview;  ///< Of the head; none once that is another.
  std::map<job_id, std::pair<std::uint64_t, caf::actor>> progress_of;
  std::optional<solve_request> followed;  ///< Without who asked.
  std::optional<active_solve> active;
  std::list<kept_result> results;  ///< Used last at the front.

  std::deque<aside_run> asides;  ///< The first one runs.

  std::map<std::uint32_t, std::optional<edit_request>> cad_waiting;  ///< Null: not known.
  std::optional<cad_run> cad_running;
  std::optional<error> cad_failure;

  std::uint64_t looks = 0;                       ///< Called for by `look_later`.
  std::map<std::uint32_t, near_version> nearby;  ///< By number.
  std::size_t loading = 0;                       ///< Meshes that are being read.
  std::size_t copying = 0;                       ///< Copies of the document that are being written.
  bool ended = false;                            ///< Its document is being closed or deleted.

  static inline const char* name = "session";
};

struct session_remains {
  std::list<session_state::kept_result> results;
  std::optional<solve_request> followed;
};

/// One document, opened: docs/actors.md draws one edit and one solve.
session_actor::behavior_type make_session(session_pointer self, session_parts parts,
                                          stored_document stored);

template <class Event>
void session_state::broadcast(const Event& event, const std::set<caf::actor>& answered) {
  for (const auto& [subscriber, who] : subscribers)
    if (!answered.contains(subscriber))
      caf::anon_send(subscriber, event);
}

[[nodiscard]] inline error no_version(std::uint32_t number) {
  return {ec::not_found,
          "there is no version " + std::to_string(number),
          "The history lists those that there are",
          {}};
}

/// The load cases of a version by their names. Errors: `not_found`.
[[nodiscard]] expected<load_case_list> cases_named(const graph_node& node,
                                                   const std::vector<std::string>& names);

}  // namespace tedit::actors
