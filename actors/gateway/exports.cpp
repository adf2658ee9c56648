// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that a client asks for.
#include <algorithm>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/text.hpp"
#include "mesh/formats.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

/// One is written while another is on its way; more would only wait in front of other clients.
constexpr unsigned exports_at_once = 2;

/// Of a format's name, where it is told that there is none; bytes.
constexpr std::size_t longest_name = 40;

/// A client for which more is prepared gets no further file written until it has taken some.
constexpr std::uint64_t most_prepared = std::uint64_t{32} << 20;

void export_file(client_state& client, std::uint64_t id, const v1::ExportFile& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  const bool whole = body.format() == document_format;
  const auto* format = find_format(body.format());
  if (!whole && !(format && format->writes)) {
    auto known = written_formats();
    known.push_back(document_format);
    return client.refuse(id, no_such_format(cut_text(body.format(), longest_name), known));
  }
  if (whole &&
      !(body.version_id().empty() && body.length_unit().empty() && body.load_case().empty()))
    return client.refuse(id, {ec::invalid_argument,
                              "a document is written with all its versions, as they are",
                              "Leave version_id, length_unit and load_case out",
                              {}});
  if (!body.load_case().empty() && !(format && format->keeps.loads))
    return client.refuse(id, {ec::invalid_argument,
                              "a file of the format " + body.format() + " holds no load case",
                              "Ask for inp (CalculiX, Abaqus) or bdf (Nastran), or name no load "
                              "case",
                              {}});
  if (!body.load_case().empty() && !body.length_unit().empty() && body.length_unit() != "m")
    return client.refuse(
      id,
      {ec::invalid_argument, "a deck with a load case is in metres", "Leave length_unit out", {}});
  export_request request;
  request.ticket = client.begin(id, document->session);
  request.client = caf::actor_cast<caf::actor>(client.self);
  request.version = body.version_id();
  request.format = body.format();
  request.length_unit = body.length_unit().empty() ? "mm" : body.length_unit();
  request.load_case = body.load_case();
  client.exports.push_back({id, document->session, std::move(request)});
  client.start_exports();
}

}  // namespace

request_rows export_requests() {
  return {row_of<&v1::ClientMessage::export_file, export_file>(v1::ClientMessage::kExportFile)};
}

void client_state::start_exports() {
  while (!exports.empty() && exporting < exports_at_once && bulk_out->prepared() < most_prepared) {
    auto next = std::move(exports.front());
    exports.pop_front();
    ++exporting;
    self->request(next.session, answer_limit, std::move(next.request))
      .then(
        [=, this, id = next.id](const exported& file) {
          --exporting;
          send_file(id, file);
          start_exports();
        },
        [=, this, id = next.id](const caf::error& e) {
          --exporting;
          refuse(id, e, "writing the file");
          start_exports();
        });
  }
}

bool client_state::drop_export(std::uint64_t id) {
  const auto found = std::ranges::find(exports, id, &waiting_export::id);
  if (found == exports.end())
    return false;
  exports.erase(found);
  refuse(id, {ec::cancelled, "the request was cancelled before it began", {}, {}});
  return true;
}

void client_state::send_file(std::uint64_t id, const exported& file) {
  const auto make = [=, this]() -> std::optional<bulk> {
    end(id);
    bulk result;
    result.header.set_request_id(id);
    auto* ready = result.header.mutable_file_ready();
    ready->set_file_name(file.file_name);
    result.stream = ready->mutable_stream();
    result.stream->set_bytes(file.size);
    auto* info = result.stream->add_arrays();
    info->set_name("file");
    info->set_type(v1::ArrayInfo::UINT8);
    info->set_components(1);
    info->set_items(file.size);
    const auto pages = std::make_shared<const std::vector<page_ptr>>(file.pages);
    for (const auto& p : *pages)
      result.parts.push_back(p->bytes());
    result.owner = pages;
    return result;
  };
  bulk_out->add(make, file.size);
  bulk_out->pump();
}

}  // namespace tedit::gateway
