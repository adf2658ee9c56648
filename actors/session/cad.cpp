// SPDX-License-Identifier: AGPL-3.0-or-later
// Edits of a part that came from CAD are made on its model, too: one after the other, as each needs
// the model of the version before it, and never before who edits (docs/decisions/0058).
#include "actors/cad/cad_rows.hpp"

#include <atomic>

#include "actors/errors.hpp"
#include "actors/session/session.hpp"

namespace tedit::actors {

namespace {

job_id new_cad_job() {
  static std::atomic<std::uint64_t> last{0};
  return {++last};
}

cad_state failed_with(const error& why) {
  return {cad_status::failed, why.remedy.empty() ? why.message : why.message + ". " + why.remedy,
          0};
}

}  // namespace

void session_state::begin_cad(const std::vector<store::log_row>& log) {
  if (!parts.cad)
    return;
  std::set<std::uint32_t> open;
  for (const auto& node : graph.nodes()) {
    if (node.info.cad)
      continue;
    graph.set_cad(node.info.number, cad_of_child(node));
    if (node.info.cad)
      open.insert(node.info.number);
  }
  auto known = requests_in(log, open);
  for (const auto number : open) {
    const auto found = known.find(number);
    cad_waiting.emplace(
      number, found == known.end() ? std::nullopt : std::optional(std::move(found->second)));
  }
  next_cad();
}

/// A mesh that is imported over another one is of another part.
std::optional<cad_state> session_state::cad_of_child(const graph_node& child) const {
  if (!parts.cad || !child.info.parent || child.info.operation == "import" ||
      !graph.nodes()[*child.info.parent].info.cad)
    return std::nullopt;
  return cad_failure ? failed_with(*cad_failure) : cad_state{};
}

void session_state::add_to_cad(std::uint32_t number, const edit_request& wanted) {
  if (!graph.nodes()[number].info.cad)
    return;
  cad_waiting.emplace(number, wanted);
  if (cad_failure && graph.nodes()[number].info.cad->status == cad_status::pending)
    return show_cad(number, failed_with(*cad_failure));  // It failed during the commit.
  next_cad();
}

/// By their numbers: a parent has a lower one.
void session_state::next_cad() {
  if (!parts.cad || cad_running || cad_failure || cad_waiting.empty() || ended)
    return;
  const auto& [number, wanted] = *cad_waiting.begin();
  cad_running = cad_run{number, new_cad_job(), nullptr};
  const auto& parent = graph.nodes()[*graph.nodes()[number].info.parent].info;
  if (parent.cad->status == cad_status::mesh_only) {
    // Of several after each other the first one is named.
    const auto& before = parent.parent ? graph.nodes()[*parent.parent].info.cad : std::nullopt;
    const bool first = !before || before->status != cad_status::mesh_only;
    return keep_cad(
      row_without_model(first ? reason_after(parent, parent.cad->reason) : parent.cad->reason));
  }
  if (!wanted)
    return keep_cad(row_without_model(unknown_request));
  self->request(parts.store, answer_limit, load_atom::value, cad_query{parent.number})
    .then(
      [=, this, job = cad_running->job](const stored_cad& model) {
        if (!cad_running || cad_running->job != job)
          return;
        if (model.row)
          return send_to_cad(model.row);
        fail_cad({ec::storage_error,
                  "the CAD model of version " + std::to_string(parent.number) + " is gone",
                  "Restore the document from a backup",
                  {}});
      },
      [=, this, job = cad_running->job](const caf::error& e) {
        if (cad_running && cad_running->job == job)
          fail_cad(from_caf(e, "reading the CAD model"));
      });
}

void session_state::send_to_cad(const std::shared_ptr<const store::cad_row>& model) {
  const auto job = cad_running->job;
  const auto number = cad_running->number;
  const auto ours = [=, this] { return cad_running && cad_running->job == job; };
  const auto refuse = [=, this](const error& e) {
    if (ours())
      fail_cad(e);
  };
  const auto send = [=, this](const version_ptr& before, const version_ptr& after) {
    if (!ours())
      return;
    self
      ->request(
        parts.cad, answer_limit, job,
        cad_order{model, before, after, *cad_waiting.at(number), graph.nodes()[number].report})
      .then(
        [=, this](const cad_outcome& made) {
          if (ours())
            keep_cad(*made.row);
        },
        [=](const caf::error& e) { refuse(from_caf(e, "the edit on the CAD model")); });
  };
  with_mesh(
    *graph.nodes()[number].info.parent,
    [=, this](const version_ptr& before) {
      with_mesh(
        number, [=](const version_ptr& after) { send(before, after); }, refuse);
    },
    refuse);
}

void session_state::keep_cad(store::cad_row row) {
  row.number = cad_running->number;
  cad_running->result = std::make_shared<const store::cad_row>(std::move(row));
  store_cad();
}

/// Not while a command runs: its commit would wait for this one.
void session_state::store_cad() {
  if (running || ended || !cad_running || !cad_running->result || cad_running->storing)
    return;
  cad_running->storing = true;
  store::change change;
  change.cad.push_back(*cad_running->result);
  const auto ours = [this, job = cad_running->job] {
    return cad_running && cad_running->job == job;
  };
  commit(
    std::move(change),
    [=, this](double) {
      if (!ours())
        return;
      const auto done = *std::exchange(cad_running, std::nullopt);
      cad_waiting.erase(done.number);
      show_cad(done.number, cad_state_of(*done.result));
      next_cad();
    },
    [=, this](const error& e) {
      if (ours())
        fail_cad(e);
    });
}

void session_state::show_cad(std::uint32_t number, cad_state state) {
  graph.set_cad(number, std::move(state));
  broadcast(cad_known{parts.document, graph.nodes()[number].info});
}

void session_state::fail_cad(const error& why) {
  cad_running.reset();
  cad_failure = why;
  for (const auto& [number, wanted] : cad_waiting)
    show_cad(number, failed_with(why));
}

void session_state::stop_cad() {
  if (cad_running)
    caf::anon_send(parts.cad, cancel_atom::value, cad_running->job);
  cad_running.reset();
}

}  // namespace tedit::actors
