// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/worker_processes.hpp"

#include "actors/links/link.hpp"
#include "base/keeper.hpp"
#include "base/memory.hpp"
#include "base/process.hpp"

namespace tedit::actors {

namespace {

class linked_processes final : public worker_processes {
public:
  expected<pid_t> start(caf::actor_system& system, const std::vector<std::string>& command,
                        const caf::actor& enlister) override {
    auto link = make_link();
    if (!link)
      return fail(link.error());
    auto pid = spawn_process(command, link->theirs.get());
    if (pid)
      serve_link(system, std::move(link->ours), enlister, reach_of_workers());
    return pid;
  }

  std::optional<std::string> reap(pid_t pid) override {
    auto how = reap_process(pid);
    if (how)
      remove_temporary_folder(pid);
    return how;
  }

  void kill(pid_t pid) override {
    kill_process(pid);
    remove_temporary_folder(pid);
  }

  [[nodiscard]] std::uint64_t memory_kills() const override { return tedit::memory_kills(); }
};

}  // namespace

std::shared_ptr<worker_processes> system_processes() {
  return std::make_shared<linked_processes>();
}

}  // namespace tedit::actors
