// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/messages.hpp"

namespace tedit::client {

namespace {

/// Puts an array where it belongs, or keeps the first error.
template <class T>
void take(expected<std::vector<T>> array, std::vector<T>& to, expected<void>& status) {
  if (array)
    to = std::move(*array);
  else if (status)
    status = fail(std::move(array.error()));
}

}  // namespace

error from_message(const v1::Error& message) {
  return {code_from_name(message.code()), message.message(), message.remedy(), message.where()};
}

version_info from_message(const v1::VersionInfo& message) {
  version_info result;
  result.number = message.number();
  result.version_id = message.version_id();
  if (message.has_parent())
    result.parent = message.parent();
  result.operation = message.operation();
  result.tets = message.tets();
  result.vertices = message.vertices();
  result.boundary_facets = message.boundary_facets();
  result.load_cases = {message.load_cases().begin(), message.load_cases().end()};
  return result;
}

committed from_message(const v1::Committed& message) {
  committed result;
  result.head = from_message(message.head());
  result.cause = message.cause();
  if (message.has_report())
    result.report = protocol::from_message(message.report());
  result.warnings = {message.warnings().begin(), message.warnings().end()};
  result.can_undo = message.can_undo();
  result.can_redo = message.can_redo();
  result.commit_ms = message.commit_ms();
  return result;
}

solve_status from_message(const v1::SolveStatus& message) {
  const bool known = message.phase() >= v1::SolveStatus::PHASE_UNSPECIFIED &&
                     message.phase() <= v1::SolveStatus::FAILED;
  return {known ? static_cast<solve_phase>(message.phase()) : solve_phase::unspecified,
          message.version_id(),
          message.load_case(),
          message.iterations(),
          message.true_relative_residual(),
          message.message()};
}

document_state from_message(const v1::DocumentState& message) {
  document_state result;
  result.document = message.document();
  if (message.has_head())
    result.head = from_message(message.head());
  result.can_undo = message.can_undo();
  result.can_redo = message.can_redo();
  return result;
}

history from_message(const v1::History& message) {
  history result;
  for (const auto& version : message.versions())
    result.versions.push_back(from_message(version));
  result.head = message.head();
  return result;
}

server_status from_message(const v1::ServerStatus& message) {
  server_status result;
  for (const auto& w : message.workers())
    result.workers.push_back({w.role(), w.state(), w.pid(), w.restarts(), w.jobs(), w.detail()});
  result.documents = message.documents();
  result.connections = message.connections();
  return result;
}

stream_header from_message(const v1::Stream& message) {
  stream_header result{message.stream(), message.bytes(), {}};
  for (const auto& array : message.arrays()) {
    const bool known =
      array.type() >= v1::ArrayInfo::UINT8 && array.type() <= v1::ArrayInfo::FLOAT64;
    result.arrays.push_back(
      {array.name(), known ? static_cast<array_type>(array.type()) : array_type::unspecified,
       array.components(), array.items()});
  }
  return result;
}

expected<surface_update> read_surface(const v1::SurfaceUpdate& message,
                                      const incoming_stream& stream) {
  surface_update result;
  result.version_id = message.version_id();
  result.base_version_id = message.base_version_id();
  for (const auto& s : message.surfaces())
    result.surfaces.push_back({s.id(), s.name(), s.facets(), s.area_m2()});
  result.removed = {message.removed().begin(), message.removed().end()};
  expected<void> status;
  take(stream.u32("removed_facets", 1), result.removed_facets, status);
  take(stream.u32("vertices", 1), result.vertices, status);
  take(stream.f64("positions", 3), result.positions, status);
  take(stream.u32("facets", 1), result.facets, status);
  take(stream.u32("facet_vertices", 3), result.facet_vertices, status);
  take(stream.i64("facet_surfaces", 1), result.facet_surfaces, status);
  if (!status)
    return fail(std::move(status.error()));
  return result;
}

expected<field_event> read_field(const v1::FieldUpdate& message, const incoming_stream& stream) {
  field_event result;
  result.report = protocol::from_message(message.report());
  result.moved = stream.moved();
  expected<void> status;
  take(stream.u32("vertices", 1), result.vertices, status);
  take(stream.f32("displacement_m", 3), result.displacement, status);
  take(stream.f32("von_mises_pa", 1), result.von_mises, status);
  if (!status)
    return fail(std::move(status.error()));
  const auto n = result.vertices.size();
  if (result.displacement.size() != 3 * n || result.von_mises.size() != n)
    return fail(ec::protocol_error, "a field update has " + std::to_string(n) + " vertices, " +
                                      std::to_string(result.displacement.size()) +
                                      " displacement components and " +
                                      std::to_string(result.von_mises.size()) + " stresses");
  return result;
}

}  // namespace tedit::client
