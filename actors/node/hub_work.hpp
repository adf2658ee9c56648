// SPDX-License-Identifier: AGPL-3.0-or-later
// What the files of the hub share; for them only.
#pragma once

#include <chrono>

#include "actors/errors.hpp"
#include "actors/node/hub.hpp"

namespace tedit::actors {

using hub_pointer = hub_actor::stateful_pointer<hub_state>;

[[nodiscard]] std::filesystem::path file_of(const hub_state& state, const std::string& name);
[[nodiscard]] bool has_file(const hub_state& state, const std::string& name);

/// Work for a disk that holds up no commit.
template <class Job>
auto ask_disk(hub_pointer self, Job job) {
  const auto& disk = self->state.disks.for_load();
  ++*disk.jobs;
  return self->request(disk.actor, std::chrono::minutes(10), std::move(job));
}

/// Whether something is done with the name that others must wait for.
[[nodiscard]] inline bool is_busy(const hub_state& state, const std::string& name) {
  return state.opening.contains(name) || state.adding.contains(name);
}

/// Whether a document or any file has the name, or is about to.
[[nodiscard]] bool is_taken(const hub_state& state, const std::string& name);
[[nodiscard]] error no_document(const std::string& name);
[[nodiscard]] error taken_name(const std::string& name);

/// The present name of the document that had this one, as long as no other takes it; else the same.
[[nodiscard]] std::string present_name(hub_state& state, const std::string& name);
void forget_former(hub_state& state, const std::string& name);

/// Those who wait for the document get this session.
void answer_all(hub_pointer self, const std::string& name, const session_actor& session);

/// Lets go a name that was held in `opening`: those who wait for it meanwhile have it opened.
void let_go(hub_pointer self, const std::string& name);

// -- arrivals.cpp --------------------------------------------------------------------------------

caf::result<added_document> add_document(hub_pointer self, const add_request& request);
caf::result<added_document> add_part(hub_pointer self, const part_request& request);

// -- library.cpp ---------------------------------------------------------------------------------

caf::result<document_list> list_documents(hub_pointer self);
caf::result<added_document> copy_document(hub_pointer self, const copy_request& request);
caf::result<deleted_document> delete_document(hub_pointer self, const delete_request& request);

/// A document is gone: what is kept of it goes, too.
void take_deleted(hub_state& state, const std::string& name);

// -- temporary.cpp -------------------------------------------------------------------------------

[[nodiscard]] std::string make_temporary_name(hub_state& state);

/// For what gives a document a name. Errors: those of `check_document_name`; `invalid_argument` for
/// a name of those that go.
[[nodiscard]] expected<void> check_lasting_name(const std::string& name);

/// What who asks for one that is gone hears.
[[nodiscard]] error ended_document(const std::string& name);

/// Nobody has the document open any more.
void note_left(hub_pointer self, const std::string& name);

/// The server begins: documents without a name of their own lie there.
void expect_ends(hub_pointer self);

/// Its time is over, if nobody came back.
void end_temporary(hub_pointer self, const std::string& name, std::uint64_t number);

}  // namespace tedit::actors
