// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/messages.hpp"

#include <algorithm>

#include "protocol/convert.hpp"
#include "protocol/json.hpp"

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

/// Errors: `protocol_error` when an array has not a value for each vertex, or a case no name.
expected<void> check_sizes(const field_event& field) {
  const auto n = field.vertices.size();
  const auto cases = field.envelope ? field.envelope->load_cases.size() : 0;
  const auto fits = [&](const char* name, std::size_t size, std::size_t wanted) -> expected<void> {
    if (size == wanted)
      return {};
    return fail(ec::protocol_error, "a field update has " + std::to_string(n) + " vertices and " +
                                      std::to_string(size) + " values of " + name);
  };
  const auto known = [&](std::uint32_t c) { return c < cases; };
  if (!std::ranges::all_of(field.von_mises_case, known) ||
      !std::ranges::all_of(field.safety_factor_case, known))
    return fail(ec::protocol_error, "a field update names a load case that it does not list");
  const bool safety = field.envelope && field.envelope->min_safety_factor;
  const auto watched = [&](const auto& array, std::size_t each) {  // Of a load case, or empty.
    return array.empty() || field.envelope ? 0 : each * n;
  };
  expected<void> ok = fits("von_mises_pa", field.von_mises.size(), n);
  if (ok)
    ok = fits("displacement_m", field.displacement.size(), field.envelope ? 0 : 3 * n);
  if (ok)
    ok = fits("von_mises_case", field.von_mises_case.size(), field.envelope ? n : 0);
  if (ok)
    ok = fits("safety_factor", field.safety_factor.size(),
              safety ? n : watched(field.safety_factor, 1));
  if (ok)
    ok = fits("safety_factor_case", field.safety_factor_case.size(), safety ? n : 0);
  if (ok)
    ok = fits("stress_pa", field.stress.size(), watched(field.stress, 6));
  if (ok)
    ok = fits("relative_error", field.relative_error.size(), watched(field.relative_error, 1));
  return ok;
}

}  // namespace

namespace {

/// Those that can be understood, and a warning for each other one: a newer server may have kinds of
/// loads that we do not know.
std::vector<fem::load_case> load_cases_from(
  const google::protobuf::RepeatedPtrField<v1::LoadCase>& messages,
  std::vector<std::string>& warnings) {
  std::vector<fem::load_case> result;
  for (const auto& one : messages)
    if (auto known = protocol::load_case_from_json(protocol::message_to_json(one), "the server"))
      result.push_back(std::move(*known));
    else
      warnings.push_back("the load case \"" + one.name() +
                         "\" cannot be read and is not shown: " + known.error().message);
  return result;
}

}  // namespace

error from_message(const v1::Error& message) {
  error e{code_from_name(message.code()), message.message(), message.remedy(), message.where(), {}};
  if (message.has_most_that_works())
    e.most = {message.most_that_works().parameter(), message.most_that_works().value()};
  if (message.has_conflict()) {
    const auto& by = message.conflict();
    e.rival = {by.version_id(), by.number(), by.client(), by.cause(), by.operation(), by.made_at()};
  }
  return e;
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
  result.name = message.name();
  result.note = message.note();
  if (message.has_report())
    result.report = protocol::from_message(message.report());
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
  result.repeated = message.repeated();
  result.load_cases = load_cases_from(message.load_cases(), result.warnings);
  return result;
}

solve_status from_message(const v1::SolveStatus& message) {
  const bool known = message.phase() >= v1::SolveStatus::PHASE_UNSPECIFIED &&
                     message.phase() <= v1::SolveStatus::FAILED;
  std::vector<std::string> names(message.load_cases().begin(), message.load_cases().end());
  if (!message.load_case().empty())
    names.push_back(message.load_case());
  return {known ? static_cast<solve_phase>(message.phase()) : solve_phase::unspecified,
          message.version_id(),
          std::move(names),
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
  result.load_cases = load_cases_from(message.load_cases(), result.warnings);
  return result;
}

load_cases_event from_message(const v1::LoadCasesChanged& message) {
  load_cases_event result;
  result.version_id = message.version_id();
  result.load_cases = load_cases_from(message.load_cases(), result.warnings);
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
      {array.name(),
       known ? static_cast<array_type>(array.type()) : array_type::unspecified,
       array.components(),
       array.items(),
       {}});
    if (array.has_offset())
      result.arrays.back().offset = array.offset();
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

expected<edit_preview> read_preview(const v1::EditPreview& message, const incoming_stream& stream) {
  auto surface = read_surface(message.surface(), stream);
  if (!surface)
    return fail(std::move(surface.error()));
  edit_preview result{std::move(*surface),
                      protocol::from_message(message.report()),
                      message.tets(),
                      message.vertices(),
                      message.boundary_facets(),
                      {}};
  result.load_cases = load_cases_from(message.load_cases(), result.report.notices);
  return result;
}

expected<field_event> read_field(const v1::FieldUpdate& message, const incoming_stream& stream) {
  field_event result;
  result.moved = stream.moved();
  result.remaining = message.remaining();
  expected<void> status;
  take(stream.u32("vertices", 1), result.vertices, status);
  take(stream.f32("von_mises_pa", 1), result.von_mises, status);
  if (message.has_envelope()) {
    result.envelope = protocol::from_message(message.envelope());
    take(stream.u32("von_mises_case", 1), result.von_mises_case, status);
    if (result.envelope->min_safety_factor) {
      take(stream.f32("safety_factor", 1), result.safety_factor, status);
      take(stream.u32("safety_factor_case", 1), result.safety_factor_case, status);
    }
  } else {
    result.report = protocol::from_message(message.report());
    take(stream.f32("displacement_m", 3), result.displacement, status);
    take(stream.f32("stress_pa", 6), result.stress, status);
    take(stream.f32("safety_factor", 1), result.safety_factor, status);
    take(stream.f32("relative_error", 1), result.relative_error, status);
  }
  if (status)
    status = check_sizes(result);
  if (!status)
    return fail(std::move(status.error()));
  return result;
}

expected<section> read_section(const v1::SectionReady& message, const incoming_stream& stream) {
  section result;
  result.version_id = message.version_id();
  expected<void> status;
  take(stream.f32("positions", 3), result.positions, status);
  take(stream.u32("triangles", 3), result.triangles, status);
  take(stream.f32("von_mises_pa", 1), result.von_mises, status);
  take(stream.f32("displacement_m", 3), result.displacement, status);
  take(stream.f32("stress_pa", 6), result.stress, status);
  take(stream.f32("safety_factor", 1), result.safety_factor, status);
  take(stream.f32("relative_error", 1), result.relative_error, status);
  if (!status)
    return fail(status.error());
  const auto points = result.positions.size() / 3;
  const auto whole = [&](const std::vector<float>& values, std::size_t each) {
    return values.empty() || values.size() == each * points;
  };
  const bool fits =
    whole(result.von_mises, 1) && whole(result.displacement, 3) && whole(result.stress, 6) &&
    whole(result.safety_factor, 1) && whole(result.relative_error, 1) &&
    std::ranges::all_of(result.triangles, [&](std::uint32_t p) { return p < points; });
  if (!fits)
    return fail(ec::protocol_error,
                "a section's arrays do not fit to its " + std::to_string(points) + " points");
  return result;
}

}  // namespace tedit::client
