// SPDX-License-Identifier: AGPL-3.0-or-later
// What every change of a document must pass: done once for one edit id, and of the head that its
// client has seen.
#include "actors/errors.hpp"
#include "actors/session/session.hpp"

namespace tedit::actors {

namespace {

/// "\"bench\" made it with fill_hole at 2026-11-23T08:45:00Z".
std::string words_of(const past_change& made) {
  const auto who = made.client.empty() ? "a client without a name" : "\"" + made.client + "\"";
  const auto how = made.what == "edit" ? made.operation : made.what;
  return who + " made it the head with " + how + " at " + made.time;
}

}  // namespace

past_change session_state::begin_change(const change_terms& terms, const asked_change& request) {
  past_change made;
  made.what = request.what;
  made.client = terms.client;
  made.time = utc_now();
  made.edit_id = terms.edit_id;
  made.request = request.id();
  return made;
}

std::optional<caf::error> session_state::check_expected(const change_terms& terms) const {
  const auto* head = graph.head();
  const auto id = head ? to_hex(head->info.id) : std::string();
  if (terms.expected_version.empty() || terms.expected_version == id || carried_from(terms))
    return std::nullopt;
  if (!head)
    return to_caf(empty_document());
  return other_head(terms, {});
}

const graph_node* session_state::carried_from(const change_terms& terms) const {
  const auto* head = graph.head();
  if (!terms.carry_over || !head || terms.expected_version == to_hex(head->info.id))
    return nullptr;
  return graph.find(terms.expected_version);
}

caf::error session_state::other_head(const change_terms& terms, const std::string& what) const {
  const auto* head = graph.head();
  const auto id = to_hex(head->info.id);
  const auto& who = past.last_move();
  const bool known = who && who->version == head->info.number;
  const error said{ec::conflict,
                   "the head is version " + id + " (number " + std::to_string(head->info.number) +
                     "), not " + terms.expected_version + (known ? ": " + words_of(*who) : "") +
                     what,
                   "Look at the new head, then ask again",
                   {}};
  rival other{id, head->info.number, {}, {}, {}, {}};
  if (known)
    other = {id, head->info.number, who->client, who->what, who->operation, who->time};
  return to_caf(said, other);
}

session_state::verdict session_state::judge(const change_terms& terms,
                                            const asked_change& request) const {
  if (auto ok = check_edit_id(terms.edit_id); !ok)
    return {nullptr, to_caf(ok.error())};
  const auto* made = past.find(terms.edit_id);
  if (!made)
    return {nullptr, check_expected(terms)};
  if (made->request == request.id())
    return {made, std::nullopt};
  return {nullptr, to_caf({ec::conflict,
                           "the edit_id \"" + terms.edit_id + "\" was used for another request (" +
                             made->what + " at " + made->time + ")",
                           "Give every change an edit_id of its own; only a retry has the same",
                           {}})};
}

bool session_state::is_settled(const change_terms& terms, const asked_change& request,
                               caf::typed_response_promise<head_moved> promise) {
  const auto found = judge(terms, request);
  if (found.refusal)
    promise.deliver(*found.refusal);
  if (!found.made || !found.made->version)
    return found.refusal.has_value();
  auto moved = describe(graph.nodes().at(*found.made->version), found.made->what);
  moved.warnings = found.made->warnings;
  moved.repeated = true;
  promise.deliver(std::move(moved));
  return true;
}

}  // namespace tedit::actors
