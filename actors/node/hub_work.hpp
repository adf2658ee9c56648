// SPDX-License-Identifier: AGPL-3.0-or-later
// What the files of the hub share; for them only.
#pragma once

#include "actors/errors.hpp"
#include "actors/node/hub.hpp"

namespace tedit::actors {

using hub_pointer = hub_actor::stateful_pointer<hub_state>;

[[nodiscard]] std::filesystem::path file_of(const hub_state& state, const std::string& name);
[[nodiscard]] bool has_file(const hub_state& state, const std::string& name);

/// Whether a document or any file has the name, or is about to.
[[nodiscard]] bool is_taken(const hub_state& state, const std::string& name);
[[nodiscard]] error taken_name(const std::string& name);

/// The present name of the document that had this one, as long as no other takes it; else the same.
[[nodiscard]] std::string present_name(hub_state& state, const std::string& name);
void forget_former(hub_state& state, const std::string& name);

/// Those who wait for the document get this session.
void answer_all(hub_pointer self, const std::string& name, const session_actor& session);

/// Lets go a name that was held in `opening`: those who wait for it meanwhile have it opened.
void let_go(hub_pointer self, const std::string& name);

// -- library.cpp ---------------------------------------------------------------------------------

caf::result<document_list> list_documents(hub_pointer self);
caf::result<added_document> copy_document(hub_pointer self, const copy_request& request);
caf::result<deleted_document> delete_document(hub_pointer self, const delete_request& request);

}  // namespace tedit::actors
