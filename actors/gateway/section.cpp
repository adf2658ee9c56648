// SPDX-License-Identifier: AGPL-3.0-or-later
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "fem/fields.hpp"
#include "mesh/section.hpp"
#include "protocol/json.hpp"

namespace tedit::gateway {

namespace {

vec3 from_message(const v1::Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Adds a field at the section's points; nothing when it is not among the fields.
void add_field(const plane_section& cut, const std::vector<field>& fields, const std::string& name,
               const char* array, bulk_builder& builder, v1::Stream* stream) {
  const auto* found = find_field(fields, name);
  if (!found)
    return;
  std::vector<float> values;
  values.reserve(cut.points.size() * static_cast<std::size_t>(found->components));
  for (const auto& p : cut.points)
    for (int c = 0; c < found->components; ++c)
      values.push_back(static_cast<float>((1 - p.t) * found->at(p.a, c) + p.t * found->at(p.b, c)));
  builder.add(stream, array, v1::ArrayInfo::FLOAT32, static_cast<unsigned>(found->components),
              values);
}

struct field_names {
  std::string displacement;  ///< Empty for an envelope, which has none.
  std::string von_mises;
};

/// What a load case's fields are called among those of a solve. Errors: `not_found`.
expected<field_names> names_for(const actors::solved& event, const std::string& load_case) {
  const auto outcome = protocol::message_from_json<v1::Solved>(event.outcome);
  if (!outcome)
    return fail(outcome.error());
  if (outcome->cases_size() == 0)
    return field_names{"displacement_m", "von_mises_pa"};
  if (load_case.empty())
    return field_names{{}, "envelope_von_mises"};
  for (const auto& report : outcome->cases())
    if (report.load_case() == load_case)
      return field_names{fem::case_field("displacement_m", load_case),
                         fem::case_field("von_mises_pa", load_case)};
  return fail(ec::not_found, "load case \"" + load_case + "\" is not among those that were solved");
}

}  // namespace

expected<bulk> make_section(const mesh_version& mesh, const actors::solved* fields,
                            const v1::CutSection& request) {
  const auto cut =
    cut_by_plane(mesh, from_message(request.point_m()), from_message(request.normal()), {});
  if (!cut)
    return fail(cut.error());
  bulk result;
  auto* ready = result.header.mutable_section_ready();
  ready->set_document(request.document());
  ready->set_version_id(to_hex(mesh.id()));
  result.stream = ready->mutable_stream();
  bulk_builder builder;
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < cut->points.size(); ++i) {
    const vec3 p = cut->position(mesh, i);
    for (const double x : {p.x, p.y, p.z})
      positions.push_back(static_cast<float>(x));
  }
  for (const auto& corners : cut->triangles)
    triangles.insert(triangles.end(), corners.begin(), corners.end());
  builder.add(result.stream, "positions", v1::ArrayInfo::FLOAT32, 3, positions);
  builder.add(result.stream, "triangles", v1::ArrayInfo::UINT32, 3, triangles);
  if (fields) {
    const auto names = names_for(*fields, request.load_case());
    if (!names)
      return fail(names.error());
    add_field(*cut, *fields->fields, names->von_mises, "von_mises_pa", builder, result.stream);
    add_field(*cut, *fields->fields, names->displacement, "displacement_m", builder, result.stream);
  }
  builder.finish(result);
  return result;
}

/// While a plane is dragged many are asked for: one is made at a time, and of those that wait only
/// the newest.
void client_state::section(std::uint64_t id, const v1::CutSection& body) {
  auto* document = find(id, body.document());
  if (!document)
    return;
  if (!document->head)
    return refuse(id, {ec::conflict, "the document has no mesh yet", "Import one first", {}});
  begin(id, {});
  if (!document->cutting)
    return begin_section(*document, {id, body});
  if (document->next_section)
    refuse(document->next_section->id,
           {ec::superseded, "another section was asked for meanwhile", {}, {}});
  document->next_section = {id, body};
}

/// On a thread of its own: a million tets take a tenth of a second.
void client_state::begin_section(open_document& document, const section_request& request) {
  document.cutting = true;
  const bool fits = document.last_solved && document.last_solved->version &&
                    document.last_solved->version->id() == document.head->id();
  self->spawn<caf::detached>(
    [request, mesh = document.head,
     fields = fits ? document.last_solved : std::optional<actors::solved>(),
     home = caf::actor_cast<caf::actor>(self)](caf::event_based_actor*) {
      auto made = std::make_shared<const expected<bulk>>(
        make_section(*mesh, fields ? &*fields : nullptr, request.body));
      caf::anon_send(home, section_cut{request.id, request.body.document(), std::move(made)});
    });
}

void client_state::on_section(const section_cut& cut) {
  const auto found = documents.find(cut.document);
  if (found != documents.end()) {
    found->second.cutting = false;
    if (const auto next = std::exchange(found->second.next_section, std::nullopt))
      begin_section(found->second, *next);
  }
  if (!*cut.result)
    return refuse(cut.id, cut.result->error());
  bulk_out->add([this, cut]() -> std::optional<bulk> {
    end(cut.id);
    bulk result = **cut.result;
    result.header.set_request_id(cut.id);
    result.stream = result.header.mutable_section_ready()->mutable_stream();
    return result;
  });
  bulk_out->pump();
}

}  // namespace tedit::gateway
