// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/messages.hpp"

#include <algorithm>

#include "fem/quantities.hpp"
#include "protocol/load_case_message.hpp"

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

/// Errors: `protocol_error` when an array has neither a row for each of `items` nor none, or none
/// though it is `needed`.
expected<void> check_rows(const fem::result_array& array, std::size_t values, std::size_t items,
                          bool needed, const char* what) {
  if (values == items * static_cast<std::size_t>(array.components) || (values == 0 && !needed))
    return {};
  return fail(ec::protocol_error, std::string(what) + " has " + std::to_string(items) +
                                    " points and " + std::to_string(values) + " values of " +
                                    std::string(array.name));
}

/// The array of an envelope, with the case that each value is of. Errors: `protocol_error`, also
/// when it has not a case for each value, or a case no name.
expected<void> read_worst(const fem::result_array& array, const incoming_stream& stream,
                          field_event& to) {
  expected<void> status;
  std::vector<std::uint32_t> cases;
  take(stream.u32(array.envelope.sent_cases, 1), cases, status);
  if (!status)
    return status;
  const auto count = to.envelope->load_cases.size();
  if (cases.size() != to.values.of(array.name).size() ||
      !std::ranges::all_of(cases, [&](std::uint32_t c) { return c < count; }))
    return fail(ec::protocol_error, "a field update names a load case that it does not list");
  if (!cases.empty())
    to.worst_cases[array.name] = std::move(cases);
  return {};
}

/// Every array that is sent and there, for so many points. Errors: `protocol_error`.
template <class Needed>
expected<void> read_arrays(const incoming_stream& stream, std::size_t points, const char* what,
                           const Needed& is_needed, named_arrays<float>& to) {
  for (const auto& array : fem::result_arrays) {
    if (array.sent == fem::array_sent::in_files)
      continue;
    auto values = stream.f32(array.name, static_cast<unsigned>(array.components));
    if (!values)
      return fail(std::move(values.error()));
    if (auto ok = check_rows(array, values->size(), points, is_needed(array), what); !ok)
      return ok;
    if (!values->empty())
      to[array.name] = std::move(*values);
  }
  return {};
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
    if (auto known = protocol::from_message(one))
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
  if (message.has_cad())
    result.cad = {static_cast<cad_status>(message.cad().status()), message.cad().reason(),
                  message.cad().deviation_m()};
  result.made_by = message.made_by();
  result.made_at = message.made_at();
  return result;
}

participant from_message(const v1::Participant& message) {
  return {message.id(), message.client(), message.since(), message.only_looks()};
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
  for (const auto& who : message.participants())
    result.participants.push_back(from_message(who));
  result.own_participant = message.participant();
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
  for (const auto& use : message.memory())
    result.memory.push_back({use.what(), use.bytes(), use.budget_bytes()});
  for (const auto& n : message.nodes())
    result.nodes.push_back({n.name(), n.address(), n.role(), n.state(), n.device(), n.version(),
                            n.threads(), n.memory_bytes(), n.connected_s(), n.jobs_done()});
  for (const auto& c : message.clients())
    result.clients.push_back({c.user(), c.role(), c.client(), c.address(), c.connected_s()});
  result.documents = message.documents();
  result.connections = message.connections();
  return result;
}

document_info from_message(const v1::DocumentInfo& message) {
  document_info result{message.name(),
                       message.bytes(),
                       message.changed_at(),
                       message.open(),
                       message.clients(),
                       {},
                       {}};
  if (message.has_versions())
    result.versions = message.versions();
  if (message.has_head())
    result.head = message.head();
  return result;
}

offered_format from_message(const v1::FileFormat& message) {
  return {message.name(),
          message.title(),
          message.reads(),
          message.writes(),
          {message.keeps_tets(), message.keeps_surfaces(), message.keeps_fields()}};
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
  result.draft = message.draft();
  return result;
}

expected<field_event> read_field(const v1::FieldUpdate& message, const incoming_stream& stream) {
  field_event result;
  result.moved = stream.moved();
  result.remaining = message.remaining();
  result.solve = message.solve();
  expected<void> status;
  take(stream.u32("vertices", 1), result.vertices, status);
  if (message.has_envelope())
    result.envelope = protocol::from_message(message.envelope());
  else
    result.report = protocol::from_message(message.report());
  const auto is_needed = [&](const fem::result_array& array) {
    return array.sent == fem::array_sent::always &&
           (!result.envelope || !array.envelope.values.empty());
  };
  if (status)
    status =
      read_arrays(stream, result.vertices.size(), "a field update", is_needed, result.values);
  for (const auto& array : fem::result_arrays)
    if (status && result.envelope && !array.envelope.values.empty())
      status = read_worst(array, stream, result);
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
  const auto points = result.positions.size() / 3;
  if (status)
    status = read_arrays(
      stream, points, "a section", [](const fem::result_array&) { return false; }, result.values);
  if (!status)
    return fail(status.error());
  if (!std::ranges::all_of(result.triangles, [&](std::uint32_t p) { return p < points; }))
    return fail(ec::protocol_error,
                "a section's triangles do not fit to its " + std::to_string(points) + " points");
  return result;
}

}  // namespace tedit::client
