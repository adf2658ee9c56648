// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/comparisons.hpp"

#include "actors/session/session.hpp"
#include "mesh/facet_pages.hpp"
#include "protocol/comparison.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

/// Values of a field at some vertices, as the array has them.
template <class T>
std::vector<T> values_at(const field& of, const std::vector<vertex_id>& vertices) {
  std::vector<T> values;
  values.reserve(vertices.size() * static_cast<std::size_t>(of.components));
  for (const auto v : vertices)
    for (int c = 0; c < of.components; ++c)
      values.push_back(static_cast<T>(of.at(v, c)));
  return values;
}

/// The arrays of VersionsCompared, as comparison.proto lists them.
void add_difference(const compared& made, const watched_quantities& watched, v1::Stream* stream,
                    bulk& result) {
  const auto& fields = *made.difference;
  const auto* marks = find_field(fields, mark_array);
  if (!marks)
    return;
  const auto vertices = boundary_vertices(*made.mesh);
  bulk_builder builder;
  builder.add(stream, "vertices", v1::ArrayInfo::UINT32, 1, vertices);
  builder.add(stream, std::string(mark_array), v1::ArrayInfo::UINT8, 1,
              values_at<std::uint8_t>(*marks, vertices));
  for (const auto& array : fem::result_arrays) {
    const auto name = std::string(array.name) + std::string(difference_ending);
    const auto* found = is_wanted(array, watched) ? find_field(fields, name) : nullptr;
    if (found)
      builder.add(stream, name, v1::ArrayInfo::FLOAT32, static_cast<unsigned>(found->components),
                  values_at<float>(*found, vertices));
  }
  builder.finish(result);
}

/// It waits for its turn among what is written, as surfaces do.
void send_comparison(client_state& client, std::uint64_t id, const compared& made) {
  const auto ticket = client.requests.at(id).ticket;
  client.bulk_out->add([=, &client]() -> std::optional<bulk> {
    const auto found = client.requests.find(id);
    if (found == client.requests.end() || found->second.ticket != ticket)
      return std::nullopt;
    client.end(id);
    const auto open = client.look_up(made.document);
    auto result = make_comparison(
      made, open == client.documents.end() ? watched_quantities() : open->second.watched);
    result.header.set_request_id(id);
    return result;
  });
  client.bulk_out->pump();
}

void compare(client_state& client, std::uint64_t id, const v1::CompareVersions& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  const comparison_request request{client.begin(id, document->session), body.before(), body.after(),
                                   body.load_case()};
  client.self->request(document->session, answer_limit, request)
    .then([=, &client](const compared& made) { send_comparison(client, id, made); },
          [=, &client](const caf::error& e) { client.refuse(id, e, "the comparison"); });
}

}  // namespace

bulk make_comparison(const compared& made, const watched_quantities& watched) {
  bulk result;
  auto* out = result.header.mutable_versions_compared();
  protocol::to_message(*made.what, out);
  out->set_document(made.document);
  out->set_before(made.before);
  out->set_after(made.after);
  out->set_load_case(made.load_case);
  result.stream = out->mutable_stream();
  add_difference(made, watched, result.stream, result);
  return result;
}

request_rows compare_requests() {
  return {
    row_of<&v1::ClientMessage::compare_versions, compare>(v1::ClientMessage::kCompareVersions)};
}

}  // namespace tedit::gateway
