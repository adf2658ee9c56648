// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include <caf/actor.hpp>
#include <caf/allowed_unsafe_message_type.hpp>

#include "actors/cad_messages.hpp"
#include "actors/library_messages.hpp"
#include "actors/messages.hpp"
#include "actors/store/document.hpp"
#include "fem/receipt.hpp"
#include "mesh/field.hpp"

/// What actors of one process hand each other: values and shared pointers, never serialised.
namespace tedit::actors {

/// The answer of requests that have no other.
struct acknowledged {};

using page_map = std::unordered_map<hash128, page_ptr>;

/// Pages that a fetch holds in memory for as long as the set lives.
struct page_set {
  std::shared_ptr<const page_map> pages;
  std::size_t moved = 0;  ///< Pages that came over the network.

  [[nodiscard]] page_ptr find(const hash128& id) const {
    const auto found = pages->find(id);
    return found == pages->end() ? nullptr : found->second;
  }
};

/// Pages that live for as long as the message does.
struct held_pages {
  std::vector<page_ptr> pages;
};

/// Values that several hold; never null unless it is said.
using shared_report = std::shared_ptr<const edit_report>;
using shared_load_cases = std::shared_ptr<const load_case_list>;

[[nodiscard]] inline shared_load_cases no_load_cases() {
  static const auto none = std::make_shared<const load_case_list>();
  return none;
}

[[nodiscard]] inline std::vector<std::string> names_of(const load_case_list& load_cases) {
  std::vector<std::string> names;
  for (const auto& one : load_cases)
    names.push_back(one.name);
  return names;
}

/// One row of a document's version list.
struct version_info {
  std::uint32_t number = 0;
  hash128 id;
  std::optional<std::uint32_t> parent;
  std::string operation;
  std::uint64_t tets = 0;
  std::uint64_t vertices = 0;
  std::uint64_t boundary_facets = 0;
  std::vector<std::string> load_cases;  ///< Names.
  std::string name;                     ///< That somebody gave it; mostly empty.
  std::string note;
  std::optional<cad_state> cad = {};  ///< None for a part that did not come from CAD.
  std::string made_by = {};           ///< A client's name; empty: not known any more.
  std::string made_at = {};           ///< UTC, "2026-11-23T08:45:00Z"; empty: not known any more.
};

/// Who has a document open.
struct participant {
  std::uint64_t id = 0;     ///< No two of a session have one.
  std::string name;         ///< That the client gave itself, after its user's; may be empty.
  std::string since;        ///< UTC, as `version_info::made_at`.
  bool only_looks = false;  ///< Keeps the document open, but nobody from deleting it.
};

// -- requests to a session; `ticket` names the request for progress and cancel, `client` who hears
// of the change by the answer and not as an event, too
// ---------------------------------------------

struct attach_request {
  caf::actor subscriber;
  bool only_looks = false;  ///< It keeps the document open, but nobody from deleting it.
  std::string name = {};    ///< For the others.
};

/// What a request that changes a document says beside what it wants.
struct change_terms {
  std::string client;            ///< Who asks, by the name that the client gave itself.
  std::string edit_id;           ///< Made by the client: the same again is done once. May be empty.
  std::string expected_version;  ///< Of the head, hexadecimal; empty: any.
  /// An edit made for another version goes on the head where it touches nothing that was changed
  /// since.
  bool carry_over = false;
};

struct import_request {
  std::uint64_t ticket = 0;
  caf::actor client;
  change_terms terms;
  std::vector<page_ptr> file;
  std::shared_ptr<const void> held;  ///< Keeps the file on the account of who sent it.
  std::uint64_t size = 0;
  std::string file_name;
  std::string length_unit;
};

struct apply_request {
  std::uint64_t ticket = 0;
  caf::actor client;
  edit_request wanted;
  change_terms terms;
};

/// An edit that is only looked at.
struct preview_request {
  apply_request edit;
  bool find_most = false;  ///< Where it is refused, look for the most that works.
  bool draft = false;      ///< Only what is seen of it.
};

enum class move_kind { undo, redo, go_to };

struct move_request {
  move_kind kind = move_kind::undo;
  std::uint32_t number = 0;  ///< For go_to.
  change_terms terms;
  caf::actor client = {};
  std::uint64_t ticket = 0;
};

/// A load case for the head: in the place of that with its name, else a new one.
struct set_load_case {
  fem::load_case load_case;
};

struct remove_load_case {
  std::string load_case;  ///< Name.
};

/// A name and a note for a version.
struct annotate_version {
  std::uint32_t number = 0;
  std::string name;
  std::string note;
};

/// A change that makes no new version.
struct note_request {
  std::variant<set_load_case, remove_load_case, annotate_version> wanted;
  change_terms terms;
  caf::actor client = {};
  std::uint64_t ticket = 0;
};

struct solve_request {
  std::uint64_t ticket = 0;
  caf::actor client;
  std::vector<std::string> load_cases;  ///< Names; empty: the first.
  bool all_load_cases = false;          ///< Whatever the head has, whichever it is.
  double tolerance = 1e-6;
  double energy_tolerance = 0;  ///< 0: none.
  std::string device;
  int element_order = 2;
};

struct export_request {
  std::uint64_t ticket = 0;
  caf::actor client;
  std::string version;  ///< Hexadecimal; empty: the head.
  std::string format;
  std::string length_unit;
  std::string load_case = {};  ///< Of a deck that another solver runs; empty: the mesh alone.
};

struct history_request {
  bool reports = false;  ///< Also those of the edits.
};

/// By its number, or by its id (hexadecimal) where that is not empty.
struct version_request {
  std::uint32_t number = 0;
  std::string id = {};
};

struct select_request {
  std::uint64_t ticket = 0;
  caf::actor client;
  selection_query query;
};

// -- what a session answers and tells its subscribers ---------------------------------------------

struct session_snapshot {
  std::string document;
  std::optional<version_info> head;
  version_ptr version;
  shared_report report;  ///< Of the edit that made the head; null when none did.
  shared_load_cases load_cases = no_load_cases();
  bool can_undo = false;
  bool can_redo = false;
  std::vector<participant> participants;  ///< All, in the order in which they came.
  std::uint64_t own_participant = 0;      ///< Which of them asked.
};

struct head_moved {
  std::string document;
  version_info head;
  version_ptr version;
  std::string cause;
  shared_report report;  ///< Null unless `cause` is "edit".
  shared_load_cases load_cases = no_load_cases();
  std::vector<std::string> warnings;
  bool can_undo = false;
  bool can_redo = false;
  double commit_ms = 0;
  bool repeated = false;  ///< It was made before, for the same edit id; the head may be another.
};

/// What an edit would make of the head; nowhere stored.
struct previewed {
  std::string document;
  version_ptr base;
  version_ptr version;
  shared_report report;
  shared_load_cases load_cases = no_load_cases();
  bool draft = false;  ///< The version's new tets are none to work with.
};

struct load_cases_changed {
  std::string document;
  std::string version;  ///< Hexadecimal.
  shared_load_cases load_cases = no_load_cases();
};

struct version_annotated {
  std::string document;
  version_info info;
};

/// Somebody opened the document, or has it open no more.
struct participant_changed {
  std::string document;
  participant who;
  bool gone = false;
};

/// How a version stands on the CAD model is known now.
struct cad_known {
  std::string document;
  version_info info;
};

/// A document has got another name.
struct document_renamed {
  std::string before;
  std::string document;
};

enum class solve_phase { started, converging, superseded, cancelled, failed };

struct solve_note {
  std::string document;
  std::string version;
  std::vector<std::string> load_cases;
  solve_phase phase = solve_phase::started;
  std::int32_t iterations = 0;
  double residual = 1;
  std::string message;
};

struct solved {
  std::string document;
  version_ptr version;
  std::shared_ptr<const solve_outcome> outcome;
  std::shared_ptr<const std::vector<field>> fields;
  std::uint64_t number = 0;  ///< Of the solve: no two of a server have one.
};

/// Which arrays (`fem::result_arrays`) a subscriber wants of each result, beside those that all
/// get, instead of what it said before.
struct watch_request {
  caf::actor subscriber;
  std::set<std::string, std::less<>> arrays;
};

/// The result of the head as it is held, when it is; `solving`: it is on its way.
struct held_result {
  std::optional<solved> result;
  bool solving = false;
};

struct request_progress {
  std::uint64_t ticket = 0;
  double fraction = 0;
  std::string stage;
};

struct exported {
  std::string file_name;
  std::vector<page_ptr> pages;
  std::uint64_t size = 0;
};

struct selected {
  std::string document;
  std::string version;  ///< Hexadecimal.
  std::shared_ptr<const std::vector<found_feature>> features;
};

/// A version as it is, whether it is the head or not.
struct session_version {
  std::string document;
  std::uint32_t number = 0;
  version_ptr mesh;
};

struct session_history {
  std::string document;
  std::vector<version_info> versions;
  std::vector<shared_report> reports;  ///< One for each version; none unless asked for.
  std::uint32_t head = 0;
};

class page_cache;

/// What a session has that its document does not (actors/session/session.hpp).
struct session_remains;
using shared_remains = std::shared_ptr<session_remains>;

/// Bytes of one kind that the server's process keeps.
struct memory_use {
  std::string what;
  std::uint64_t bytes = 0;
  std::uint64_t budget = 0;  ///< 0: none.
};

/// What ties a worker to its pool (actors/supervisor/lifeline.hpp).
class lifeline;

/// A worker that joined from another machine, for the pool of its role. Answered by whether it is
/// taken in.
struct remote_worker {
  caf::actor worker;
  node_facts node;
  std::shared_ptr<lifeline> line;
};

struct server_status {
  std::vector<worker_status> workers;
  std::vector<memory_use> memory;
  std::uint32_t documents = 0;
};

/// A change of a document that is to be made durable.
struct stored_change {
  std::shared_ptr<const store::change> change;
};

/// A document's file, open from its `load` on. Disks use it one at a time.
struct document_file {
  explicit document_file(std::filesystem::path where) : path(std::move(where)) {}

  std::mutex in_use;
  std::filesystem::path path;                 ///< Guarded by `in_use`, as it may be renamed.
  std::unique_ptr<store::document> document;  ///< Guarded by `in_use`.
};
using shared_file = std::shared_ptr<document_file>;

/// A version as it stands in a document.
struct graph_node {
  version_info info;
  version_ptr mesh;  ///< Null where it is only in the document, or kept elsewhere.
  shared_load_cases load_cases = no_load_cases();
  shared_report report;               ///< Null for imports.
  std::optional<std::uint32_t> redo;  ///< The child that a redo goes to.
};

/// A version's mesh is wanted. Pages that are known are not read.
struct version_query {
  std::uint32_t number = 0;
  hash128 id;
  std::shared_ptr<page_cache> known;
};

struct stored_version {
  version_ptr mesh;
  std::uint64_t read_bytes = 0;  ///< Of pages that nobody had.
};

/// What a document holds when it is opened.
struct stored_document {
  std::vector<graph_node> nodes;  ///< By number.
  std::optional<std::uint32_t> head;
  std::vector<store::log_row> log;  ///< Ascending by sequence.
};

/// A document file that a client sent, to become a document.
struct add_request {
  std::string name;
  bool or_next_free = false;  ///< Where the name is taken: NAME-2, ...
  std::vector<page_ptr> file;
  std::shared_ptr<const void> held;  ///< Keeps the file on the account of who sent it.
};

/// The same for a disk: where it goes.
struct adoption {
  std::filesystem::path file;
  std::vector<page_ptr> bytes;
};

/// The name that an added document has got.
struct added_document {
  std::string name;
  std::vector<std::string> warnings = {};  ///< Of a part that was meshed for it.
};

/// Another name for a document that is open.
struct rename_request {
  caf::actor session;
  std::string name;
  bool close = false;  ///< It was opened for that: ends the session afterwards if nobody uses it.
};

/// A session, with the name that the server gave it.
struct opened_document {
  std::string name;
  caf::actor session;
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::acknowledged)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::page_set)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::held_pages)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::remote_worker)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::attach_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::import_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::apply_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::preview_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::previewed)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::move_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::note_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::solve_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::export_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::history_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::version_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::session_version)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::select_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::session_snapshot)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::head_moved)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::load_cases_changed)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::version_annotated)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::participant_changed)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::cad_known)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::document_renamed)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::held_result)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::watch_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::solve_note)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::solved)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::request_progress)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::exported)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::selected)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::session_history)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::shared_remains)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::server_status)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::shared_file)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::stored_change)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::stored_document)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::stored_version)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::version_query)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::opened_document)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::add_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::adoption)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::added_document)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::rename_request)
