// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <map>

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>

#include "actors/errors.hpp"
#include "actors/gateway/bulk.hpp"
#include "actors/gateway/client_list.hpp"
#include "actors/gateway/field_updates.hpp"
#include "actors/gateway/surface_stream.hpp"
#include "actors/gateway/token_guard.hpp"
#include "actors/gateway/uploads.hpp"
#include "actors/interfaces.hpp"
#include "base/metrics.hpp"
#include "base/tracing/tracing.hpp"
#include "mesh/formats.hpp"

namespace tedit::gateway {

/// The connection can take more; the connection is gone.
using drained_atom = caf::atom_constant<caf::atom("drained")>;
using closed_atom = caf::atom_constant<caf::atom("closed")>;
/// The answer to a wrong token has waited long enough.
using refused_atom = caf::atom_constant<caf::atom("refused")>;
/// Time to look whether a user's token still holds.
using access_atom = caf::atom_constant<caf::atom("access")>;

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
  std::shared_ptr<client_list> clients = std::make_shared<client_list>();
  /// So often it is looked whether the token of each user still holds.
  std::chrono::milliseconds access_every{30'000};
  /// Each role of workers and its state ("ready", "starting", "degraded"); called from any thread.
  std::function<std::vector<std::pair<std::string, std::string>>()> roles;
  /// Brings what is only looked at, as the use of memory, into the process's metrics; called from
  /// any thread. May be empty.
  std::function<void()> measure;
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
    bool deleting = false;                        ///< By this client: it asks for nothing more.
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

  /// A request from its coming to its answer.
  struct unanswered {
    metrics::times* counted = nullptr;
    std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
    tracing::span span;
  };

  struct running_request {
    std::uint64_t ticket = 0;
    actors::session_actor session;
    std::optional<cancel_token> stop = {};  ///< Of what is no session's to cancel.

    void cancel() const;
  };

  void start(client_pointer owner, std::shared_ptr<connection> to, gateway_parts with);
  void on_message(const std::string& bytes);
  /// Whether a message may be taken as a request.
  [[nodiscard]] expected<void> check(const v1::ClientMessage& message) const;
  void on_closed();

  // -- requests (requests.cpp); who handles which stands with the handlers, see `request_rows` ---

  void hello(std::uint64_t id, const v1::Hello& body);
  void turn_away(std::uint64_t id);
  void refuse_token(std::uint64_t id);
  // -- whom its token lets in (access.cpp) ------------------------------------------------------

  /// Lets it in.
  void admit(const grant& who, const std::string& client);
  /// Looks whether its token still holds, and ends the connection when it does not.
  void look_at_access();
  /// Errors: `permission_denied` for a token that has ended and for what its role may not do.
  [[nodiscard]] expected<void> may(const v1::ClientMessage& message) const;
  void look_later();

  void dispatch(std::uint64_t id, const v1::ClientMessage& message);

  // -- files that go (exports.cpp) -----------------------------------------------------------

  /// Has the next files written, as long as this client takes those that are.
  void start_exports();
  void send_file(std::uint64_t id, const actors::exported& file);
  /// Ends an export that was not begun; whether it was one.
  bool drop_export(std::uint64_t id);

  // -- edits (edits.cpp) ---------------------------------------------------------------------

  /// Ends the preview that is asked for, if there is one; with a session only one of its document.
  void end_preview(const error& why, const actors::session_actor& of = {});

  // -- answers, and what follows them (client_actor.cpp) ----------------------------------------

  void answer_head(std::uint64_t id, const actors::head_moved& moved);
  void follow(const actors::head_moved& moved);
  /// Queues the fields of a solve for those who watch them; also when they were sent before, unless
  /// it is the solve `held`, whose fields the client says it has from an earlier connection.
  void send_again(const std::string& document, const actors::solved& event, std::uint64_t held = 0);
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
  /// Ends what is on its way of a document that was open here and forgets it.
  void leave(documents_by_name::iterator document, const error& why);
  /// The same as `look_up`; refuses the request when it is not open here, or is being deleted.
  open_document* find(std::uint64_t id, const std::string& document);
  /// Notes a request that can be cancelled; returns its ticket.
  std::uint64_t begin(std::uint64_t id, const actors::session_actor& session);
  /// What every request that changes the head says.
  template <class Body>
  [[nodiscard]] actors::change_terms terms_of(const Body& body) const {
    return {client_name, body.edit_id(), body.expected_version()};
  }
  void end(std::uint64_t id);
  /// Whatever the answer is, its trace has what went wrong.
  void note_failure(std::uint64_t id, const std::string& code);
  /// From here on it is counted and traced how long the answer takes.
  void note_begin(std::uint64_t id, const v1::ClientMessage& message);

  client_pointer self = nullptr;
  std::shared_ptr<connection> to;
  gateway_parts parts;
  std::optional<outbox> bulk_out;
  bool known = false;        ///< Has said hello and proved its right.
  bool turned_away = false;  ///< Gave a wrong token: nothing else of it is heard.
  grant access;
  std::string client_name;  ///< As it introduced itself, and whose token it gave.
  present_client here;      ///< As it is listed.
  std::shared_ptr<const void> listed;
  documents_by_name documents;
  std::map<std::uint64_t, upload> uploads;
  std::shared_ptr<upload_account> upload_bytes;  ///< Of this connection.
  std::deque<waiting_export> exports;            ///< Not begun.
  unsigned exporting = 0;                        ///< Begun, and not written yet.
  std::map<std::uint64_t, running_request> requests;
  std::map<std::uint64_t, unanswered> asked;
  std::uint64_t previewing = 0;  ///< Ticket of the newest PreviewEdit; answered or not.

  static inline const char* name = "client";
};

/// A kind of request, and what handles it.
struct request_row {
  v1::ClientMessage::BodyCase kind = v1::ClientMessage::BODY_NOT_SET;
  void (*handle)(client_state&, std::uint64_t id, const v1::ClientMessage&) = nullptr;
};

/// A row whose handler takes the request's own message:
/// `row_of<&v1::ClientMessage::cancel, cancel>(v1::ClientMessage::kCancel)`.
template <auto Body, auto Handle>
[[nodiscard]] constexpr request_row row_of(v1::ClientMessage::BodyCase kind) {
  return {kind, [](client_state& client, std::uint64_t id, const v1::ClientMessage& message) {
            Handle(client, id, (message.*Body)());
          }};
}

/// The requests that each file of this folder handles. A new one is a handler and a row there.
using request_rows = std::vector<request_row>;
[[nodiscard]] request_rows server_requests();    ///< requests.cpp
[[nodiscard]] request_rows compare_requests();   ///< comparisons.cpp
[[nodiscard]] request_rows document_requests();  ///< documents.cpp
[[nodiscard]] request_rows edit_requests();      ///< edits.cpp
[[nodiscard]] request_rows export_requests();    ///< exports.cpp
[[nodiscard]] request_rows library_requests();   ///< library.cpp
[[nodiscard]] request_rows note_requests();      ///< notes.cpp
[[nodiscard]] request_rows print_requests();     ///< print_checks.cpp
[[nodiscard]] request_rows section_requests();   ///< section.cpp
[[nodiscard]] request_rows upload_requests();    ///< uploads.cpp

/// Why a token lets nobody in any more; access.cpp.
[[nodiscard]] error token_ended(const grant& access);

/// What the actor handles beside the messages of its client.
[[nodiscard]] caf::message_handler note_events(client_state& client);     ///< notes.cpp
[[nodiscard]] caf::message_handler section_events(client_state& client);  ///< section.cpp

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

void to_message(const actors::cad_state& state, v1::CadState* out);
void to_message(const actors::version_info& info, v1::VersionInfo* out);
void to_message(const actors::participant& who, v1::Participant* out);
/// What the edit that made a version reported, if one did.
void add_report(const actors::shared_report& report, v1::VersionInfo* out);
void to_message(const actors::head_moved& moved, v1::Committed* out);
void to_message(const actors::load_cases_changed& event, v1::LoadCasesChanged* out);
void to_message(const actors::solve_note& note, v1::SolveStatus* out);
void to_message(const actors::solved& done, v1::Solved* out);
void to_message(const error& e, v1::Error* out);
void to_message(const actors::rival& other, v1::Conflict* out);
void to_message(const actors::memory_use& use, v1::MemoryUse* out);
/// Of all clients.
[[nodiscard]] metrics::gauge& running_requests();

void to_message(const actors::server_status& status, v1::ServerStatus* out);
void to_message(const file_format& format, v1::FileFormat* out);
void to_message(const fem::result_array& array, v1::ResultArray* out);

}  // namespace tedit::gateway

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(std::shared_ptr<tedit::gateway::connection>)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::gateway::gateway_parts)

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::gateway::section_cut)
