// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <map>

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>

#include "actors/errors.hpp"
#include "actors/gateway/bulk.hpp"
#include "actors/gateway/field_updates.hpp"
#include "actors/gateway/surface_stream.hpp"
#include "actors/gateway/token_guard.hpp"
#include "actors/gateway/uploads.hpp"
#include "actors/interfaces.hpp"
#include "mesh/formats.hpp"

namespace tedit::gateway {

/// The connection can take more; the connection is gone.
using drained_atom = caf::atom_constant<caf::atom("drained")>;
using closed_atom = caf::atom_constant<caf::atom("closed")>;
/// The answer to a wrong token has waited long enough.
using refused_atom = caf::atom_constant<caf::atom("refused")>;

/// A section that was made aside, or why it was not.
struct section_cut {
  std::uint64_t id = 0;
  std::string document;
  std::shared_ptr<const expected<bulk>> result;
};

struct client_state;
using client_pointer = caf::stateful_actor<client_state>*;

/// What all clients of a gateway share.
struct gateway_parts {
  actors::hub_actor hub;
  std::shared_ptr<token_guard> guard;
  std::string server_name;
  std::uint64_t upload_bytes = 0;               ///< That one connection may hold.
  std::shared_ptr<upload_account> all_uploads;  ///< Of all connections.
  std::shared_ptr<field_updates> fields = std::make_shared<field_updates>();
  std::function<std::size_t()> connections;  ///< Set by `start_gateway`.
  /// Each role of workers and its state ("ready", "starting", "degraded"); called from any thread.
  std::function<std::vector<std::pair<std::string, std::string>>()> roles;
};

/// One client: what it has open, what runs for it, what is on its way to it. The members are called
/// by the actor's handlers and by nothing else.
struct client_state {
  struct section_request {
    std::uint64_t id = 0;
    v1::CutSection body;
  };

  struct open_document {
    actors::session_actor session;
    bool watch_surface = false;
    bool watch_fields = false;
    watched_quantities watched;
    surface_stream surface;
    version_ptr head;
    std::optional<actors::solved> last_solved;  ///< Of the head or an earlier version.
    version_ptr wanted_surface;                 ///< The newest head, when it was not sent yet.
    std::optional<actors::solved> wanted_fields;
    unsigned next_field = 0;  ///< Of `wanted_fields`; those before it were sent.
    /// Names that it had in this connection, the latest first: requests may still use them.
    std::deque<std::string> former;
    bool cutting = false;                         ///< A section is being made.
    std::optional<section_request> next_section;  ///< Asked for meanwhile; the newest wins.
  };

  struct waiting_export {
    std::uint64_t id = 0;
    actors::session_actor session;
    actors::export_request request;
  };

  struct sent_file {
    std::vector<page_ptr> pages;
    std::shared_ptr<const void> held;  ///< Keeps them on the account of this client.
  };

  struct running_request {
    std::uint64_t ticket = 0;
    actors::session_actor session;
  };

  void start(client_pointer owner, std::shared_ptr<connection> to, gateway_parts with);
  void on_message(const std::string& bytes);
  /// Whether a message may be taken as a request.
  [[nodiscard]] expected<void> check(const v1::ClientMessage& message) const;
  void on_closed();

  // -- requests (requests.cpp) ---------------------------------------------------------------

  void hello(std::uint64_t id, const v1::Hello& body);
  void turn_away(std::uint64_t id);
  void refuse_token(std::uint64_t id);
  void dispatch(std::uint64_t id, const v1::ClientMessage& message);
  void list_operations(std::uint64_t id);
  void get_status(std::uint64_t id);
  void cancel(std::uint64_t id, const v1::Cancel& body);
  void open(std::uint64_t id, const v1::OpenDocument& body);
  void close(std::uint64_t id, const v1::CloseDocument& body);
  /// Undo, redo or going to a version; what they have in common is read here.
  template <class Body>
  void move(std::uint64_t id, const Body& body, actors::move_request request);
  void solve(std::uint64_t id, const v1::Solve& body);
  void select(std::uint64_t id, const v1::SelectSurfaces& body);
  void history(std::uint64_t id, const v1::GetHistory& body);

  // -- files that come (uploads.cpp) ---------------------------------------------------------

  void receive_upload(std::uint64_t id, const v1::UploadChunk& body);
  void import(std::uint64_t id, const v1::ImportMesh& body);
  void add_document(std::uint64_t id, const v1::AddDocument& body);
  /// An upload that is whole; else the request is refused.
  std::optional<sent_file> take_upload(std::uint64_t id, std::uint64_t upload, std::uint64_t size);

  // -- files that go (exports.cpp) -----------------------------------------------------------

  void export_file(std::uint64_t id, const v1::ExportFile& body);
  /// Has the next files written, as long as this client takes those that are.
  void start_exports();
  void send_file(std::uint64_t id, const actors::exported& file);
  /// Ends an export that was not begun; whether it was one.
  bool drop_export(std::uint64_t id);

  // -- edits (edits.cpp) ---------------------------------------------------------------------

  void edit(std::uint64_t id, const v1::ApplyEdit& body);
  void preview(std::uint64_t id, const v1::PreviewEdit& body);
  void surface_of(std::uint64_t id, const v1::GetSurface& body);
  void send_preview(std::uint64_t id, const actors::previewed& made);
  /// Ends the preview that is asked for, if there is one.
  void end_preview(const error& why);

  // -- what makes no new version (notes.cpp) ------------------------------------------------

  void set_load_case(std::uint64_t id, const v1::SetLoadCase& body);
  void remove_load_case(std::uint64_t id, const v1::RemoveLoadCase& body);
  void cancel_solve(std::uint64_t id, const v1::CancelSolve& body);
  void annotate(std::uint64_t id, const v1::AnnotateVersion& body);
  void rename(std::uint64_t id, const v1::RenameDocument& body);
  void watch(std::uint64_t id, const v1::WatchFields& body);
  void send_again(const std::string& document, const actors::solved& event);
  /// Asks a session or the hub; answers Done, or with its error about `what`.
  template <class Actor, class Request>
  void carry_out(std::uint64_t id, const Actor& whom, Request request, const char* what);

  // -- sections (section.cpp) ----------------------------------------------------------------

  void section(std::uint64_t id, const v1::CutSection& body);
  void begin_section(open_document& document, const section_request& request);
  void on_section(const section_cut& cut);

  // -- events and answers: what is told to all but who asked, and the same as that one's answer
  // ----

  void on_head(const actors::head_moved& event);
  void answer_head(std::uint64_t id, const actors::head_moved& moved);
  void follow(const actors::head_moved& moved);
  void on_solved(const actors::solved& event);
  void on_load_cases(const actors::load_cases_changed& event);
  void on_annotated(const actors::version_annotated& event);
  void on_renamed(const actors::document_renamed& event);
  void on_note(const actors::solve_note& event);
  void on_progress(const actors::request_progress& event);
  void want_surface(const std::string& document, const version_ptr& mesh);
  /// Puts the next field update of a document into the outbox, and after it the ones that follow.
  void queue_field(const std::string& document);
  /// Answers a running request, which ends it.
  void answer(std::uint64_t id, v1::ServerMessage message);
  void refuse(std::uint64_t id, const error& e);
  /// With what an actor said about `what`.
  void refuse(std::uint64_t id, const caf::error& e, const char* what);
  /// Says that a message is not taken as a request; one that runs with its id goes on.
  void reject(std::uint64_t id, const error& e);

  using documents_by_name = std::map<std::string, open_document>;
  /// The document that has this name, or had it in this connection; `documents.end()`: none is open
  /// here.
  documents_by_name::iterator look_up(const std::string& document);
  /// The same; refuses the request when it is not open here.
  open_document* find(std::uint64_t id, const std::string& document);
  /// Notes a request that can be cancelled; returns its ticket.
  std::uint64_t begin(std::uint64_t id, const actors::session_actor& session);
  /// What every request that changes the head says.
  template <class Body>
  [[nodiscard]] actors::change_terms terms_of(const Body& body) const {
    return {client_name, body.edit_id(), body.expected_version()};
  }
  void end(std::uint64_t id) { requests.erase(id); }

  client_pointer self = nullptr;
  std::shared_ptr<connection> to;
  gateway_parts parts;
  std::optional<outbox> bulk_out;
  bool known = false;        ///< Has said hello and proved its right.
  bool turned_away = false;  ///< Gave a wrong token: nothing else of it is heard.
  std::string client_name;   ///< As it introduced itself.
  documents_by_name documents;
  std::map<std::uint64_t, upload> uploads;
  std::shared_ptr<upload_account> upload_bytes;  ///< Of this connection.
  std::deque<waiting_export> exports;            ///< Not begun.
  unsigned exporting = 0;                        ///< Begun, and not written yet.
  std::map<std::uint64_t, running_request> requests;
  std::uint64_t previewing = 0;  ///< The newest PreviewEdit; answered or not.

  static inline const char* name = "client";
};

/// The answer SectionReady for a version with the fields of its solve, if there are any;
/// `load_case` as in CutSection, more than the usual arrays when `watched`. Errors: as
/// `cut_by_plane`, and `not_found` for the load case.
[[nodiscard]] expected<bulk> make_section(const mesh_version& mesh, const actors::solved* fields,
                                          const watched_quantities& watched,
                                          const v1::CutSection& request);

/// Speaks the protocol `tedit.v1` with one client.
caf::behavior make_client(client_pointer self, std::shared_ptr<connection> to, gateway_parts parts);

// -- messages.cpp: what the actors say, as messages of the protocol
// --------------------------------

void to_message(const actors::version_info& info, v1::VersionInfo* out);
/// What the edit that made a version reported, if one did.
void add_report(const actors::shared_report& report, v1::VersionInfo* out);
void to_message(const actors::head_moved& moved, v1::Committed* out);
void to_message(const actors::load_cases_changed& event, v1::LoadCasesChanged* out);
void to_message(const actors::solve_note& note, v1::SolveStatus* out);
void to_message(const actors::solved& done, v1::Solved* out);
void to_message(const error& e, v1::Error* out);
void to_message(const actors::rival& other, v1::Conflict* out);
void to_message(const actors::server_status& status, v1::ServerStatus* out);
void to_message(const file_format& format, v1::FileFormat* out);

}  // namespace tedit::gateway

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(std::shared_ptr<tedit::gateway::connection>)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::gateway::gateway_parts)

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::gateway::section_cut)
