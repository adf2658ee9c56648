// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/print_checks.hpp"

#include "actors/session/session.hpp"
#include "protocol/print_message.hpp"

namespace tedit::gateway {

namespace {

using actors::print_checked;

/// It waits for its turn among what is written, as surfaces do.
void send_print_check(client_state& client, std::uint64_t id, const print_checked& made) {
  const auto ticket = client.requests.at(id).ticket;
  client.bulk_out->add([=, &client]() -> std::optional<bulk> {
    const auto found = client.requests.find(id);
    if (found == client.requests.end() || found->second.ticket != ticket)
      return std::nullopt;
    client.end(id);
    auto result = make_print_check(made);
    result.header.set_request_id(id);
    return result;
  });
  client.bulk_out->pump();
}

void check_print(client_state& client, std::uint64_t id, const v1::CheckPrint& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  const auto settings = protocol::read_print_settings(body);
  if (!settings)
    return client.refuse(id, settings.error());
  actors::print_request request{
    client.begin(id, document->session), {}, *settings, caf::actor_cast<caf::actor>(client.self)};
  if (body.has_version())
    request.number = body.version();
  client.self->request(document->session, actors::answer_limit, request)
    .then([=, &client](const print_checked& made) { send_print_check(client, id, made); },
          [=, &client](const caf::error& e) { client.refuse(id, e, "the check"); });
}

}  // namespace

bulk make_print_check(const print_checked& made) {
  bulk result;
  auto* out = result.header.mutable_print_checked();
  protocol::to_message(made.settings, *made.what, out);
  out->set_document(made.document);
  out->set_version(made.number);
  out->set_version_id(to_hex(made.mesh->id()));
  result.stream = out->mutable_stream();
  std::vector<facet_id> facets;
  std::vector<std::uint8_t> marks;
  for (facet_id f = 0; f < made.mesh->facet_slots(); ++f) {
    if (!made.mesh->is_live_facet(f))
      continue;
    if (const auto mark = mark_of(*made.what, f); mark != print_mark::sound) {
      facets.push_back(f);
      marks.push_back(static_cast<std::uint8_t>(mark));
    }
  }
  bulk_builder builder;
  builder.add(result.stream, "facets", v1::ArrayInfo::UINT32, 1, facets);
  builder.add(result.stream, "marks", v1::ArrayInfo::UINT8, 1, marks);
  builder.finish(result);
  return result;
}

request_rows print_requests() {
  return {row_of<&v1::ClientMessage::check_print, check_print>(v1::ClientMessage::kCheckPrint)};
}

}  // namespace tedit::gateway
