// SPDX-License-Identifier: AGPL-3.0-or-later
// Requests about the documents of the server as a whole.
#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/utc.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

void write_row(const document_row& row, v1::DocumentInfo* out) {
  out->set_name(row.name);
  out->set_bytes(static_cast<std::uint64_t>(row.bytes));
  if (row.changed != 0)
    out->set_changed_at(utc_text(row.changed));
  out->set_open(row.open);
  out->set_clients(static_cast<std::uint32_t>(row.clients));
  if (row.versions)
    out->set_versions(static_cast<std::uint32_t>(*row.versions));
  if (row.head)
    out->set_head(*row.head);
}

/// The name by which the hub knows a document: requests may have one from before.
std::string name_for_hub(client_state& client, const std::string& given) {
  const auto here = client.look_up(given);
  return here == client.documents.end() ? given : here->first;
}

void list_documents(client_state& client, std::uint64_t id, const v1::ListDocuments&) {
  client.begin(id, {});
  client.self->request(client.parts.hub, answer_limit, list_atom::value)
    .then(
      [=, &client](const document_list& all) {
        v1::ServerMessage message;
        auto* out = message.mutable_document_list();
        for (const auto& row : all.documents)
          write_row(row, out->add_documents());
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "listing the documents"); });
}

void copy_document(client_state& client, std::uint64_t id, const v1::CopyDocument& body) {
  client.begin(id, {});
  const cancel_token stop;
  client.requests[id].stop = stop;
  client.self
    ->request(client.parts.hub, answer_limit,
              copy_request{name_for_hub(client, body.document()), body.name(), stop})
    .then(
      [=, &client](const added_document& added) {
        v1::ServerMessage message;
        message.mutable_document_added()->set_document(added.name);
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "copying the document"); });
}

/// What this connection asks of the document from now on would get no answer when its session is
/// gone.
void delete_document(client_state& client, std::uint64_t id, const v1::DeleteDocument& body) {
  const auto name = name_for_hub(client, body.document());
  const auto mark = [&client, name](bool deleting) {
    if (const auto here = client.look_up(name); here != client.documents.end())
      here->second.deleting = deleting;
  };
  if (client.documents.contains(name) && !client.find(id, name))
    return;
  mark(true);
  client.begin(id, {});
  client.self
    ->request(client.parts.hub, answer_limit,
              delete_request{name, caf::actor_cast<caf::actor>(client.self)})
    .then(
      [=, &client](const deleted_document& gone) {
        if (const auto here = client.documents.find(gone.name); here != client.documents.end())
          client.leave(here, {ec::cancelled, "the document was deleted", {}, {}});
        v1::ServerMessage message;
        message.mutable_document_deleted()->set_document(gone.name);
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) {
        mark(false);
        client.refuse(id, e, "deleting the document");
      });
}

}  // namespace

request_rows library_requests() {
  using message = v1::ClientMessage;
  return {row_of<&message::list_documents, list_documents>(message::kListDocuments),
          row_of<&message::copy_document, copy_document>(message::kCopyDocument),
          row_of<&message::delete_document, delete_document>(message::kDeleteDocument)};
}

}  // namespace tedit::gateway
