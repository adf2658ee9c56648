// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/client_actor.hpp"
#include "protocol/load_case_message.hpp"
#include "protocol/report.hpp"
#include "tedit/v1/session.pb.h"

namespace tedit::gateway {

void to_message(const actors::cad_state& state, v1::CadState* out) {
  static_assert(static_cast<int>(actors::cad_status::pending) + 1 == v1::CadState::PENDING &&
                static_cast<int>(actors::cad_status::failed) + 1 == v1::CadState::FAILED);
  out->set_status(static_cast<v1::CadState::Status>(static_cast<int>(state.status) + 1));
  out->set_reason(state.reason);
  out->set_deviation_m(state.deviation);
}

void to_message(const actors::version_info& info, v1::VersionInfo* out) {
  out->set_number(info.number);
  out->set_version_id(to_hex(info.id));
  if (info.parent)
    out->set_parent(*info.parent);
  out->set_operation(info.operation);
  out->set_tets(info.tets);
  out->set_vertices(info.vertices);
  out->set_boundary_facets(info.boundary_facets);
  out->mutable_load_cases()->Assign(info.load_cases.begin(), info.load_cases.end());
  out->set_name(info.name);
  out->set_note(info.note);
  out->set_made_by(info.made_by);
  out->set_made_at(info.made_at);
  if (info.cad)
    to_message(*info.cad, out->mutable_cad());
}

void to_message(const actors::participant& who, v1::Participant* out) {
  out->set_id(who.id);
  out->set_client(who.name);
  out->set_since(who.since);
  out->set_only_looks(who.only_looks);
}

void add_report(const actors::shared_report& report, v1::VersionInfo* out) {
  if (report)
    protocol::to_message(*report, out->mutable_report());
}

void to_message(const actors::load_cases_changed& event, v1::LoadCasesChanged* out) {
  out->set_document(event.document);
  out->set_version_id(event.version);
  protocol::to_messages(*event.load_cases, out->mutable_load_cases());
}

void to_message(const actors::head_moved& moved, v1::Committed* out) {
  out->set_document(moved.document);
  to_message(moved.head, out->mutable_head());
  out->set_cause(moved.cause);
  if (moved.report)
    protocol::to_message(*moved.report, out->mutable_report());
  out->mutable_warnings()->Assign(moved.warnings.begin(), moved.warnings.end());
  out->set_can_undo(moved.can_undo);
  out->set_can_redo(moved.can_redo);
  out->set_commit_ms(moved.commit_ms);
  out->set_repeated(moved.repeated);
  protocol::to_messages(*moved.load_cases, out->mutable_load_cases());
}

void to_message(const actors::solve_note& note, v1::SolveStatus* out) {
  static_assert(static_cast<int>(actors::solve_phase::started) + 1 == v1::SolveStatus::STARTED &&
                static_cast<int>(actors::solve_phase::failed) + 1 == v1::SolveStatus::FAILED);
  out->set_document(note.document);
  out->set_version_id(note.version);
  if (note.load_cases.size() == 1)
    out->set_load_case(note.load_cases.front());
  else
    out->mutable_load_cases()->Assign(note.load_cases.begin(), note.load_cases.end());
  out->set_phase(static_cast<v1::SolveStatus::Phase>(static_cast<int>(note.phase) + 1));
  out->set_iterations(static_cast<std::uint32_t>(note.iterations));
  out->set_true_relative_residual(note.residual);
  out->set_message(note.message);
}

void to_message(const actors::solved& done, v1::Solved* out) {
  protocol::to_message(*done.outcome, out);
  out->set_document(done.document);
  out->set_solve(done.number);
}

void to_message(const error& e, v1::Error* out) {
  out->set_code(std::string(code_name(e.code)));
  out->set_message(e.message);
  out->set_remedy(e.remedy);
  out->set_where(e.where);
  if (!e.most)
    return;
  out->mutable_most_that_works()->set_parameter(e.most->parameter);
  out->mutable_most_that_works()->set_value(e.most->value);
}

void to_message(const actors::rival& other, v1::Conflict* out) {
  out->set_version_id(other.version);
  out->set_number(other.number);
  out->set_client(other.client);
  out->set_cause(other.cause);
  out->set_operation(other.operation);
  out->set_made_at(other.time);
}

void to_message(const file_format& format, v1::FileFormat* out) {
  out->set_name(std::string(format.name));
  out->set_title(std::string(format.title));
  out->set_reads(format.reads);
  out->set_writes(format.writes);
  out->set_keeps_tets(format.keeps.tets);
  out->set_keeps_surfaces(format.keeps.surfaces);
  out->set_keeps_fields(format.keeps.fields);
}

void to_message(const fem::result_array& array, v1::ResultArray* out) {
  out->set_name(std::string(array.name));
  out->set_unit(std::string(array.unit));
  out->set_components(static_cast<std::uint32_t>(array.components));
  out->set_sent(static_cast<v1::ResultArray::Sent>(array.sent));
  out->set_place(static_cast<v1::ResultArray::Place>(array.place));
  out->set_needs_yield(array.needs_yield);
}

void to_message(const actors::memory_use& use, v1::MemoryUse* out) {
  out->set_what(use.what);
  out->set_bytes(use.bytes);
  out->set_budget_bytes(use.budget);
}

void to_message(const actors::node_status& node, v1::NodeStatus* out) {
  out->set_name(node.name);
  out->set_address(node.address);
  out->set_role(node.role);
  out->set_state(node.state);
  out->set_device(node.device);
  out->set_version(node.version);
  out->set_threads(node.threads);
  out->set_memory_bytes(node.memory_bytes);
  out->set_connected_s(node.connected_s);
  out->set_jobs_done(node.jobs_done);
}

void to_message(const actors::server_status& status, v1::ServerStatus* out) {
  for (const auto& use : status.memory)
    to_message(use, out->add_memory());
  for (const auto& worker : status.workers) {
    auto* row = out->add_workers();
    row->set_role(worker.role);
    row->set_state(worker.state);
    row->set_pid(static_cast<std::uint32_t>(worker.pid));
    row->set_restarts(worker.restarts);
    row->set_jobs(worker.jobs);
    row->set_detail(worker.detail);
    for (const auto& node : worker.nodes)
      to_message(node, out->add_nodes());
  }
  out->set_documents(status.documents);
}

}  // namespace tedit::gateway
