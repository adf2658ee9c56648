// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/server.hpp"

#include "actors/pages/page_store.hpp"
#include "tests/simulation/cad.hpp"

namespace tedit::simulation {

simulated_server::simulated_server(timeline& time, const std::filesystem::path& documents,
                                   std::shared_ptr<document_record> record)
    : stage_(time), cache_(std::make_shared<page_cache>(std::size_t{1} << 20)) {
  auto& system = stage_.system();
  disks_ = std::make_unique<simulated_disks>(time, system, std::move(record));
  pages_ = system.spawn(make_page_store, cache_);
  const auto options = [&](worker_role role) {
    pool_options result;
    result.role = role;
    auto& processes = processes_[static_cast<std::size_t>(role)];
    processes = std::make_shared<simulated_processes>(time, role);
    result.processes = processes;
    return result;
  };
  pools_ = {make_modeling_pool(system, options(worker_role::modeling)),
            make_optimizer_pool(system, options(worker_role::optimizer)),
            make_solver_pool(system, options(worker_role::solver))};
  hub_parts hub{documents, pools_, pages_, cache_};
  hub.disks = disks_->disks();
  hub.unused_limit = milliseconds(2000);
  hub.versions = std::make_shared<version_memory>(1);  // One beside the heads: most are read.
  hub.reader = system.spawn<job_thread>();
  cad_ = spawn_cad_editor(system, time);
  hub.cad = caf::actor_cast<cad_editor_actor>(cad_);
  hub_ = system.spawn(make_hub, hub);
  parts_.hub = hub_;
  parts_.guard = std::make_shared<gateway::token_guard>("token");
  parts_.server_name = "simulated";
  parts_.upload_bytes = std::uint64_t{1} << 20;
  parts_.all_uploads = std::make_shared<gateway::upload_account>(std::uint64_t{1} << 22);
  parts_.connections = [] { return std::size_t{0}; };
}

/// First what others could still see: disks, then all who would write or answer.
simulated_server::~simulated_server() {
  disks_->stop();
  for (const auto& one : clients_)
    cut_off(one);
  for (const auto& one : processes_)
    one->stop();
  cut_off(caf::actor_cast<caf::actor>(hub_));
  pools_.for_each(
    [](worker_role, const auto& pool) { cut_off(caf::actor_cast<caf::actor>(pool)); });
  cut_off(caf::actor_cast<caf::actor>(pages_));
  cut_off(cad_);
  stage_.drain();
}

void simulated_server::join(std::size_t role) {
  pools_.for_each([&](worker_role one, const auto& pool) {
    if (static_cast<std::size_t>(one) == role % 3)
      processes_[role % 3]->join(stage_.system(), caf::actor_cast<caf::actor>(pool));
  });
}

caf::actor simulated_server::connect(std::shared_ptr<gateway::connection> from) {
  const auto made = stage_.system().spawn(gateway::make_client, std::move(from), parts_);
  clients_.push_back(made);
  return made;
}

const std::map<std::string, session_actor>& simulated_server::sessions() const {
  return state_of<hub_state>(hub_).open;
}

template <class Pool>
void simulated_server::check_pool(const Pool& pool, const char* name,
                                  std::vector<std::string>& found) {
  const auto& state = state_of<pool_state>(pool);
  if (!state.waiting.empty() || !state.asked.empty())
    found.push_back(std::string("work waits in the pool of ") + name);
  for (const auto& child : state.children)
    if (child.work)
      found.push_back(std::string("a worker of ") + name + " still works");
}

std::vector<std::string> simulated_server::leftovers() {
  std::vector<std::string> found;
  const auto say = [&](bool there, const std::string& what) {
    if (there)
      found.push_back(what);
  };
  check_pool(pools_.modeling, "modeling", found);
  check_pool(pools_.optimizer, "optimizer", found);
  check_pool(pools_.solver, "solver", found);
  const auto& hub = state_of<hub_state>(hub_);
  say(!hub.opening.empty() || !hub.adding.empty() || !hub.renaming.empty(),
      "the hub still opens, adds or renames");
  say(!state_of<page_store_state>(pages_).transfers.empty(), "pages are still fetched");
  say(parts_.all_uploads->used() != 0, "uploads are still on the account");
  for (const auto& [name, session] : hub.open) {
    const auto& state = state_of<session_state>(session);
    say(state.running.has_value() || !state.waiting.empty(), name + ": commands are left");
    say(!state.previews.empty(), name + ": previews are left");
    say(state.active.has_value(), name + ": a solve is left");
    say(state.copying != 0, name + ": copies are left");
    say(!state.asides.empty(), name + ": comparisons or checks are left");
    say(state.cad_running.has_value() || (!state.cad_waiting.empty() && !state.cad_failure),
        name + ": edits on the CAD model are left");
    say(!state.progress_of.empty(), name + ": jobs are left in progress_of");
  }
  for (const auto& one : clients_) {
    auto* self = caf::actor_cast<caf::abstract_actor*>(one);
    if (self->getf(caf::abstract_actor::is_terminated_flag))
      continue;
    const auto& state = state_of<gateway::client_state>(one);
    say(!state.requests.empty(), "a client actor keeps requests");
    say(!state.exports.empty() || state.exporting != 0, "a client actor keeps exports");
  }
  return found;
}

}  // namespace tedit::simulation
