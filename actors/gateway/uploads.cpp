// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/uploads.hpp"

#include <span>
#include <utility>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/text.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

/// At once, of one connection: even an empty one costs something.
constexpr std::size_t most_uploads = 64;

/// Bytes of a file's name that are kept.
constexpr std::size_t longest_file_name = 200;

}  // namespace

expected<void> upload_account::take(std::uint64_t bytes) {
  const auto before = used_.fetch_add(bytes);
  if (bytes > limit_ || before > limit_ - bytes) {
    used_ -= bytes;
    const std::string whose = all_ ? "this connection" : "all connections together";
    return fail(ec::conflict,
                "uploads of " + whose + " that are not imported yet may hold " +
                  std::to_string(limit_) + " bytes",
                all_ ? "Import or drop what was sent, or raise limits.upload_bytes in the server's "
                       "configuration"
                     : "Send the file again later, or raise limits.all_upload_bytes in the "
                       "server's configuration");
  }
  if (!all_)
    return {};
  auto ok = all_->take(bytes);
  if (!ok)
    used_ -= bytes;
  return ok;
}

void upload_account::give_back(std::uint64_t bytes) {
  used_ -= bytes;
  if (all_)
    all_->give_back(bytes);
}

expected<void> upload::append(std::uint64_t offset, const std::string& data) {
  if (offset != size())
    return fail(ec::protocol_error,
                "a piece of an upload is missing: it goes on at byte " + std::to_string(offset) +
                  " after " + std::to_string(size()) + " bytes",
                "Send the file again");
  if (auto ok = hold_->account->take(data.size()); !ok)
    return ok;
  hold_->bytes += data.size();
  rest_ += data;
  std::size_t used = 0;
  for (; rest_.size() - used >= max_page_bytes; used += max_page_bytes)
    pages_.push_back(
      page::from_bytes(std::as_bytes(std::span(rest_).subspan(used, max_page_bytes))));
  rest_.erase(0, used);
  return {};
}

std::vector<page_ptr> upload::take_pages() {
  if (!rest_.empty())
    pages_.push_back(page::from_bytes(std::as_bytes(std::span(rest_))));
  rest_.clear();
  return std::exchange(pages_, {});
}

// -- requests ------------------------------------------------------------------------------------

namespace {

/// Pieces are not requests of their own: what is said about them ends none that runs with their id.
void receive_upload(client_state& client, std::uint64_t id, const v1::UploadChunk& body) {
  if (!client.uploads.contains(body.upload()) && client.uploads.size() >= most_uploads)
    return client.reject(id, {ec::conflict,
                              "this connection has " + std::to_string(most_uploads) +
                                " uploads that are not imported yet",
                              "Import some of them first",
                              {}});
  auto& target = client.uploads.try_emplace(body.upload(), client.upload_bytes).first->second;
  if (const auto ok = target.append(body.offset(), body.data()); !ok) {
    client.uploads.erase(body.upload());
    client.reject(id, ok.error());
  }
}

/// An upload that is whole; else the request is refused and what is there is dropped.
std::optional<client_state::sent_file> take_upload(client_state& client, std::uint64_t id,
                                                   std::uint64_t upload, std::uint64_t size) {
  const auto found = client.uploads.find(upload);
  if (found == client.uploads.end() || found->second.size() != size) {
    client.uploads.erase(upload);
    client.refuse(id,
                  {ec::protocol_error, "the upload is not complete", "Send the file again", {}});
    return std::nullopt;
  }
  client_state::sent_file result{found->second.take_pages(), found->second.held()};
  client.uploads.erase(found);
  return result;
}

void add_document(client_state& client, std::uint64_t id, const v1::AddDocument& body) {
  auto file = take_upload(client, id, body.upload(), body.size());
  if (!file)
    return;
  client.begin(id, {});
  client.self
    ->request(
      client.parts.hub, answer_limit,
      add_request{body.name(), body.or_next_free(), std::move(file->pages), std::move(file->held)})
    .then(
      [=, &client](const added_document& added) {
        v1::ServerMessage message;
        message.mutable_document_added()->set_document(added.name);
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "adding the document"); });
}

void import(client_state& client, std::uint64_t id, const v1::ImportMesh& body) {
  // First: a file whose import is refused must not stay on the account.
  auto file = take_upload(client, id, body.upload(), body.size());
  if (!file)
    return;
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  import_request request;
  request.file = std::move(file->pages);
  request.held = std::move(file->held);
  request.ticket = client.begin(id, document->session);
  request.client = caf::actor_cast<caf::actor>(client.self);
  request.terms = client.terms_of(body);
  request.size = body.size();
  request.file_name = cut_text(body.file_name(), longest_file_name);
  request.length_unit = body.length_unit().empty() ? "mm" : body.length_unit();
  client.self->request(document->session, answer_limit, std::move(request))
    .then([=, &client](const head_moved& moved) { client.answer_head(id, moved); },
          [=, &client](const caf::error& e) { client.refuse(id, e, "the import"); });
}

}  // namespace

request_rows upload_requests() {
  using message = v1::ClientMessage;
  return {row_of<&message::upload_chunk, receive_upload>(message::kUploadChunk),
          row_of<&message::add_document, add_document>(message::kAddDocument),
          row_of<&message::import_mesh, import>(message::kImportMesh)};
}

}  // namespace tedit::gateway
