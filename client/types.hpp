// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "client/named_arrays.hpp"
#include "fem/load_case.hpp"
#include "mesh/formats.hpp"
#include "protocol/report.hpp"
#include "tls/shown_certificate.hpp"

/// What the client hands to its caller: the protocol's messages as plain data.
namespace tedit::client {

using server_certificate = tls::shown_certificate;

/// Which certificate of a server of wss:// is good. Without any of these: one that the system's
/// authorities vouch for.
struct server_trust {
  /// Only the one of this SHA-256, whatever name and authority it has. Colons and case do not
  /// matter.
  std::string fingerprint;
  /// Those that the authorities of this PEM file vouch for.
  std::filesystem::path authority;
  /// Told what the server showed, trusted or not, on the thread of the connection and before
  /// `connect` returns.
  std::function<void(const server_certificate&)> on_certificate;
};

struct connect_options {
  std::string url;                          ///< "wss://HOST:PORT/PATH", or "ws://..." without TLS.
  server_trust trust;                       ///< Of wss://.
  std::string token;                        ///< Proves that the client may use the server.
  std::string client_name;                  ///< Program and version, for the server's log.
  std::chrono::milliseconds timeout{5000};  ///< For connecting, and again for Welcome.
  std::chrono::milliseconds request_timeout{30'000};          ///< For requests that are short.
  std::chrono::milliseconds long_request_timeout{3'600'000};  ///< For import, edit, solve, export.
  /// The span that each request is a part of, as the header "traceparent" of the W3C's Trace
  /// Context has it; asked from the thread that makes the request. May be empty.
  std::function<std::string()> traceparent;
};

/// What was received for one stream: its header message and its chunks.
struct traffic {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;  ///< WebSocket payload.
  double ms = 0;            ///< From the header to the last chunk.
};

/// The surface of a new head has arrived completely and `client::surface` gives it.
struct surface_event {
  std::string version_id;
  bool full = false;  ///< The whole surface was sent, not a difference.
  traffic moved;
  std::size_t facets_changed = 0;  ///< Facets that were sent plus slots that were emptied.
  std::size_t vertices_sent = 0;
};

/// The fields of a load case on the boundary, or after those of several their envelope. While a
/// solve runs, first fields come with `interim` set.
struct field_event {
  solve_report report;                     ///< Not of an envelope.
  std::optional<solve_envelope> envelope;  ///< Only of an envelope.
  std::uint32_t remaining = 0;             ///< Field events of the same solve that still come.
  std::uint64_t solve = 0;              ///< `solve_outcome::solve` of the solve that they are of.
  std::vector<std::uint32_t> vertices;  ///< Slots, ascending.
  /// By the names of `fem::result_arrays`, SI, rows as `vertices`: those that are always sent,
  /// which an envelope has only as far as there is a worst one, and those that are watched and
  /// there.
  named_arrays<float> values;
  /// Of an envelope, by the same names: the case that each value is of, a place in
  /// `envelope->load_cases`.
  named_arrays<std::uint32_t> worst_cases;
  traffic moved;

  [[nodiscard]] const std::string& version_id() const {
    return envelope ? envelope->version_id : report.version_id;
  }
  [[nodiscard]] bool interim() const { return envelope ? envelope->interim : report.interim; }
};

/// The numbers of `tedit.v1.CadState.Status`.
enum class cad_status { unspecified = 0, pending = 1, same = 2, mesh_only = 3, failed = 4 };

/// How a version stands on the CAD model of its part (message `tedit.v1.CadState`).
struct cad_state {
  cad_status status = cad_status::unspecified;
  std::string reason;      ///< Of `mesh_only` and `failed`.
  double deviation_m = 0;  ///< Of `same`: of the mesh's new vertices from the model, at most.

  friend bool operator==(const cad_state&, const cad_state&) = default;
};

/// One version of a document (message `tedit.v1.VersionInfo`).
struct version_info {
  std::uint32_t number = 0;  ///< In the order in which they were made.
  std::string version_id;    ///< 32 hexadecimal digits.
  std::optional<std::uint32_t> parent;
  std::string operation;  ///< "import" or an operation's id.
  std::uint64_t tets = 0;
  std::uint64_t vertices = 0;
  std::uint64_t boundary_facets = 0;
  std::vector<std::string> load_cases;
  std::string name;  ///< That somebody gave it; mostly empty.
  std::string note;
  /// Of the edit that made it: in `document_state`, and in a `history` that was asked for with it.
  std::optional<edit_report> report;
  std::optional<cad_state> cad;  ///< None for a part that did not come from CAD.
  std::string made_by;           ///< Who made it, by name; empty: not known any more.
  std::string made_at;           ///< UTC, "2026-11-23T08:45:00Z"; empty: not known any more.
};

/// Who has the document open (message `tedit.v1.Participant`).
struct participant {
  std::uint64_t id = 0;     ///< No two of a document have one.
  std::string name;         ///< As `version_info::made_by`; may be empty.
  std::string since;        ///< UTC.
  bool only_looks = false;  ///< A node that watches.
};

/// Names of `fem::result_arrays` that are wanted with every field beside those that are always
/// sent.
using watched_quantities = std::set<std::string>;

/// What a change of a document says beside what it wants.
struct change_terms {
  std::string expected_version;  ///< The head must be this version (`conflict` else); empty: any.
  /// Names the change, so that asking again (`make_edit_id`) after a connection broke makes it
  /// once.
  std::string edit_id;
};

/// A new edit id: 32 random hexadecimal digits.
[[nodiscard]] std::string make_edit_id();

/// The head moved; what it says is durable (message `tedit.v1.Committed`).
struct committed {
  version_info head;
  std::string cause;                  ///< "import", "edit", "undo", "redo".
  std::optional<edit_report> report;  ///< For an edit.
  std::vector<std::string> warnings;  ///< For an import; and of load cases that cannot be read.
  bool can_undo = false;
  bool can_redo = false;
  double commit_ms = 0;                    ///< Waiting for the storage.
  std::vector<fem::load_case> load_cases;  ///< Of the head. Older servers say nothing.
  /// It was made before, by a change with the same edit id; the document's head may be another.
  bool repeated = false;
};

/// The numbers of `tedit.v1.SolveStatus.Phase`.
enum class solve_phase {
  unspecified = 0,
  started = 1,
  converging = 2,
  superseded = 3,
  cancelled = 4,
  failed = 5
};

/// A solve began, converges, or ended without a result.
struct solve_status {
  solve_phase phase = solve_phase::unspecified;
  std::string version_id;
  std::vector<std::string> load_cases;  ///< Names of those that are solved together.
  std::uint32_t iterations = 0;         ///< The most of them.
  double true_relative_residual = 0;    ///< The largest of them.
  std::string message;                  ///< For failed: the reason.
};

struct document_state {
  std::string document;              ///< Its name; made up by the server for an unnamed one.
  std::optional<version_info> head;  ///< None before the first import.
  bool can_undo = false;
  bool can_redo = false;
  std::vector<fem::load_case> load_cases;  ///< Of the head. Older servers say nothing.
  std::vector<std::string> warnings;       ///< Of those that cannot be read.
  std::vector<participant> participants;   ///< All who have it open, this client too.
  std::uint64_t own_participant = 0;       ///< Which of them this client is.
};

/// The load cases of the head were replaced or added to.
struct load_cases_event {
  std::string version_id;
  std::vector<fem::load_case> load_cases;  ///< All of them,
  std::vector<std::string> warnings = {};  ///< but for those that cannot be read.
};

/// A plane through the part (message `tedit.v1.SectionReady`).
struct section {
  std::string version_id;
  std::vector<float> positions;          ///< m, 3 per point.
  std::vector<std::uint32_t> triangles;  ///< 3 points each, counter-clockwise from the normal.
  named_arrays<float> values;            ///< As of a field, rows as points; none without a solve.
};

struct history {
  std::vector<version_info> versions;
  std::uint32_t head = 0;  ///< The head's number.
};

/// One kind of worker process of the server.
struct worker_status {
  std::string role;   ///< "modeling", "optimizer", "solver".
  std::string state;  ///< "ready", "starting", "degraded".
  std::uint32_t pid = 0;
  std::uint32_t restarts = 0;
  std::uint32_t jobs = 0;  ///< Running and waiting.
  std::string detail;
};

/// A worker that joined from another machine (message `tedit.v1.NodeStatus`).
struct node_status {
  std::string name;
  std::string address;
  std::string role;   ///< As of a worker.
  std::string state;  ///< "idle", "working", "leaving", "lost".
  std::string device;
  std::string version;
  std::uint32_t threads = 0;
  std::uint64_t memory_bytes = 0;
  double connected_s = 0;
  std::uint64_t jobs_done = 0;
};

/// A client that is connected (message `tedit.v1.ClientStatus`).
struct client_status {
  std::string user;  ///< Empty: who has the server's own token.
  std::string role;  ///< "view", "edit", "admin".
  std::string client;
  std::string address;
  double connected_s = 0;
};

/// Who this client is to the server.
struct own_access {
  std::string user;  ///< Empty: who has the server's own token.
  std::string role;  ///< What it may do: "view", "edit", "admin".
};

/// Bytes of one kind that the server's process keeps.
struct memory_use {
  std::string what;
  std::uint64_t bytes = 0;
  std::uint64_t budget_bytes = 0;  ///< 0: none.
};

struct server_status {
  std::vector<worker_status> workers;
  std::vector<memory_use> memory;
  std::vector<node_status> nodes;      ///< To others than admins without name and address.
  std::vector<client_status> clients;  ///< For admins only.
  std::uint32_t documents = 0;
  std::uint32_t connections = 0;
};

/// A document of the server, open or not (message `tedit.v1.DocumentInfo`).
struct document_info {
  std::string name;
  std::uint64_t bytes = 0;  ///< Of its file, with its log; 0: it has none before its first import.
  std::string changed_at;   ///< When its file was written last, UTC: "2026-11-23T08:45:00Z".
  bool open = false;        ///< On the server; so for a while after its last client, too.
  std::uint32_t clients = 0;              ///< Connections that have it open.
  std::optional<std::uint32_t> versions;  ///< How many; only of an open one.
  std::optional<std::uint32_t> head;      ///< The head's number; only of an open one that has any.
};

/// Shorter edges on some of a CAD part's surfaces.
struct part_local_size {
  std::string surface;     ///< A number, or a name that one face or several have.
  double edge_length = 0;  ///< Of the longest edge there, m.
};

/// How a CAD file or a surface is meshed (message `tedit.v1.ImportPart`).
struct part_options {
  std::string fineness = "medium";  ///< "coarse", "medium", "fine".
  std::string length_unit = {};     ///< Of an STL, OBJ or PLY: "mm" (also empty), "cm", "m", "in".
  std::vector<part_local_size> local_sizes = {};  ///< Of a CAD file.
  bool or_next_free = false;                      ///< Where the name is taken: NAME-2, ...
};

/// A document that was made of a part.
struct added_part {
  std::string document;               ///< The name that it has got.
  std::vector<std::string> warnings;  ///< What a person should know, a sentence each.
};

/// A kind of mesh file that the server reads or writes (message `tedit.v1.FileFormat`).
struct offered_format {
  std::string name;   ///< Also the suffix of such files: "msh".
  std::string title;  ///< For people who choose one, in English.
  bool reads = false;
  bool writes = false;
  kept_in_file keeps;
};

/// Those that servers of this release offer, for who has no connection.
[[nodiscard]] std::vector<offered_format> usual_formats();

/// Whether a file of this format, or a whole document, can be asked for. Errors:
/// `invalid_argument`, naming those that can.
[[nodiscard]] expected<void> check_format(const std::vector<offered_format>& offered,
                                          const std::string& name);

/// What to solve, and how exactly.
struct solve_settings {
  std::string load_case;                ///< Name; empty: the first one.
  double tolerance = 1e-6;              ///< True relative residual.
  std::string device;                   ///< Empty: the server's default.
  int element_order = 2;                ///< 2: quadratic tets; 1: linear ones, a quick preview.
  std::vector<std::string> load_cases;  ///< Names, to be solved together instead of `load_case`.
  bool all_load_cases = false;          ///< All that the head has, instead of any names.
  /// Stop already at this estimated relative error in energy: a preview; 0: never.
  double energy_tolerance = 0;
  /// A solve (`solve_outcome::solve`) whose fields are here from an earlier connection: where the
  /// outcome is of that one, none follow. 0: none.
  std::uint64_t held_solve = 0;

  friend bool operator==(const solve_settings&, const solve_settings&) = default;
};

/// What happens to the open document without being asked for. All are called from the client's I/O
/// thread, one at a time; they must be quick and must not call the client's blocking functions
/// (those fail with `internal`) nor destroy it. Each may be empty.
/// What the server says of a connection that takes less than it is sent.
struct backlog {
  std::uint64_t waiting_bytes = 0;
  std::uint64_t most_bytes = 0;
  double closes_after_s = 0;  ///< Unless less than `most_bytes` wait by then.
};

struct events {
  std::function<void(const surface_event&)> on_surface;
  std::function<void(const field_event&)> on_field;
  std::function<void(const committed&)> on_committed;  ///< By any client, this one included.
  std::function<void(const solve_status&)> on_solve_status;
  std::function<void(const load_cases_event&)> on_load_cases;  ///< By any client.
  std::function<void(const version_info&)> on_annotated;       ///< By any client.
  std::function<void(const version_info&)> on_cad;  ///< How it stands on the CAD model is known.
  /// Somebody else opened the document; `gone`: has it open no more.
  std::function<void(const participant&, bool gone)> on_participant;
  /// By any client: the document's name from now on, which requests use already.
  std::function<void(const std::string& name)> on_renamed;
  std::function<void(const solve_outcome&)> on_solved;  ///< Whoever asked for it.
  /// Less is taken than the server sends.
  std::function<void(const backlog&)> on_backlog;
};

}  // namespace tedit::client
