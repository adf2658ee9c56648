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

/// Pieces are not requests of their own: what is said about them ends none that runs with their id.
void client_state::receive_upload(std::uint64_t id, const v1::UploadChunk& body) {
  if (!uploads.contains(body.upload()) && uploads.size() >= most_uploads)
    return reject(id, {ec::conflict,
                       "this connection has " + std::to_string(most_uploads) +
                         " uploads that are not imported yet",
                       "Import some of them first",
                       {}});
  auto& target = uploads.try_emplace(body.upload(), upload_bytes).first->second;
  if (const auto ok = target.append(body.offset(), body.data()); !ok) {
    uploads.erase(body.upload());
    reject(id, ok.error());
  }
}

std::optional<client_state::sent_file> client_state::take_upload(std::uint64_t id,
                                                                 std::uint64_t upload,
                                                                 std::uint64_t size) {
  const auto found = uploads.find(upload);
  if (found == uploads.end() || found->second.size() != size) {
    refuse(id, {ec::protocol_error, "the upload is not complete", "Send the file again", {}});
    return std::nullopt;
  }
  sent_file result{found->second.take_pages(), found->second.held()};
  uploads.erase(found);
  return result;
}

void client_state::add_document(std::uint64_t id, const v1::AddDocument& body) {
  auto file = take_upload(id, body.upload(), body.size());
  if (!file)
    return;
  begin(id, {});
  self
    ->request(
      parts.hub, answer_limit,
      add_request{body.name(), body.or_next_free(), std::move(file->pages), std::move(file->held)})
    .then(
      [=, this](const added_document& added) {
        v1::ServerMessage message;
        message.mutable_document_added()->set_document(added.name);
        answer(id, std::move(message));
      },
      [=, this](const caf::error& e) { refuse(id, e, "adding the document"); });
}

void client_state::import(std::uint64_t id, const v1::ImportMesh& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  auto file = take_upload(id, body.upload(), body.size());
  if (!file)
    return;
  import_request request;
  request.file = std::move(file->pages);
  request.held = std::move(file->held);
  request.ticket = begin(id, document->session);
  request.client = caf::actor_cast<caf::actor>(self);
  request.terms = terms_of(body);
  request.size = body.size();
  request.file_name = cut_text(body.file_name(), longest_file_name);
  request.length_unit = body.length_unit().empty() ? "mm" : body.length_unit();
  self->request(document->session, answer_limit, std::move(request))
    .then([=, this](const head_moved& moved) { answer_head(id, moved); },
          [=, this](const caf::error& e) { refuse(id, e, "the import"); });
}

}  // namespace tedit::gateway
