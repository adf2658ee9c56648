// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/uploads.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/number_range.hpp"
#include "base/part_sizes.hpp"
#include "base/text.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

/// At once, of one connection: even an empty one costs something.
constexpr std::size_t most_uploads = 64;

/// Bytes of a file's name that are kept.
constexpr std::size_t longest_file_name = 200;

// What ImportPart may say.
constexpr std::array<std::string_view, 4> length_units{"mm", "cm", "m", "in"};
constexpr int most_local_sizes = 1000;

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

/// Errors: `invalid_argument` for one that is none of `known`.
expected<void> check_word(const std::string& given, std::span<const std::string_view> known,
                          const std::string& what) {
  if (std::ranges::find(known, given) != known.end())
    return {};
  std::string all;
  for (const auto& one : known)
    all += (all.empty() ? "\"" : ", \"") + std::string(one) + "\"";
  return fail(ec::invalid_argument, "\"" + given + "\" is no " + what, "Give one of " + all);
}

/// Errors: `invalid_argument`.
expected<std::vector<part_local_size>> read_local_sizes(const v1::ImportPart& body) {
  if (body.local_sizes_size() > most_local_sizes)
    return fail(ec::invalid_argument,
                "there are more than " + std::to_string(most_local_sizes) + " local sizes",
                "Give a finer size for the whole part");
  std::vector<part_local_size> sizes;
  for (const auto& one : body.local_sizes()) {
    const auto mm = 1e3 * one.edge_length();
    if (auto ok =
          check_number(mm, {1e-3, 1e6, "mm"}, "the edge length on surface " + one.surface());
        !ok)
      return fail(ok.error());
    sizes.push_back({one.surface(), mm});
  }
  return sizes;
}

/// Errors: `invalid_argument`.
expected<part_order> read_order(const v1::ImportPart& body) {
  part_order order;
  order.file_name =
    cut_text(body.file_name().empty() ? "the file" : body.file_name(), longest_file_name);
  order.length_unit = body.length_unit();
  if (!body.fineness().empty())
    order.size = body.fineness();
  if (auto ok = check_word(order.size, part_sizes, "fineness"); !ok)
    return fail(ok.error());
  if (!order.length_unit.empty())
    if (auto ok = check_word(order.length_unit, length_units, "unit of length"); !ok)
      return fail(ok.error());
  auto sizes = read_local_sizes(body);
  if (!sizes)
    return fail(sizes.error());
  order.local_sizes = std::move(*sizes);
  return order;
}

void import_part(client_state& client, std::uint64_t id, const v1::ImportPart& body) {
  auto file = take_upload(client, id, body.upload(), body.size());
  if (!file)
    return;
  auto order = read_order(body);
  if (!order)
    return client.refuse(id, order.error());
  order->file = std::move(file->pages);
  order->held = std::move(file->held);
  order->client_name = client.client_name;
  order->client = caf::actor_cast<caf::actor>(client.self);
  order->ticket = client.begin(id, {});
  client.requests[id].stop = order->stop;
  client.self
    ->request(client.parts.hub, answer_limit,
              part_request{body.name(), body.or_next_free(), std::move(*order)})
    .then(
      [=, &client](const added_document& added) {
        v1::ServerMessage message;
        auto* out = message.mutable_document_added();
        out->set_document(added.name);
        out->mutable_warnings()->Add(added.warnings.begin(), added.warnings.end());
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "the import"); });
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
          row_of<&message::import_part, import_part>(message::kImportPart),
          row_of<&message::import_mesh, import>(message::kImportMesh)};
}

}  // namespace tedit::gateway
