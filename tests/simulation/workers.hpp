// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <list>
#include <map>
#include <set>
#include <string>

#include "actors/supervisor/worker_processes.hpp"
#include "actors/worker/worker_jobs.hpp"
#include "tests/simulation/timeline.hpp"

namespace tedit::simulation {

using namespace actors;

/// What happens to a worker's process.
enum class worker_fault {
  dies,               ///< At once, whatever it does.
  dies_with_job,      ///< At the end of its next job, before the answer.
  dies_after_answer,  ///< Its next job is answered, and nobody has fetched the result.
  hangs,              ///< In its next job, which never ends.
  falls_silent,       ///< Nothing comes over its line, which after some seconds is taken as cut.
};

/// The part that a file "part N" holds, as the workers of a simulation read it.
[[nodiscard]] version_ptr imported_part(int number);

/// What the operation "nudge" makes of a version, or null for a vertex that is not there.
[[nodiscard]] version_ptr nudged(const version_ptr& base, std::int64_t vertex, double by);

/// Processes that live in the test: each with actors of its own, of which the coordinator, the page
/// cache and the page store are the program's, and only the work itself is made up. It takes time:
/// mostly some milliseconds, now and then many seconds.
class simulated_processes final : public worker_processes,
                                  public std::enable_shared_from_this<simulated_processes> {
public:
  simulated_processes(timeline& time, worker_role role) : time_(time), role_(role) {}

  expected<pid_t> start(caf::actor_system& system, const std::vector<std::string>& command,
                        const caf::actor& enlister) override;
  std::optional<std::string> reap(pid_t pid) override;
  void kill(pid_t pid) override;

  /// A worker on another machine joins this pool; after each of its ends it comes back.
  void join(caf::actor_system& system, const caf::actor& pool);

  /// For one of those that run, `which` of them; for the next one when none does.
  void strike(worker_fault fault, std::size_t which);

  /// Ends all.
  void stop();

  struct process {
    pid_t pid = 0;
    caf::actor enlister;
    caf::actor worker;
    caf::actor pages;
    caf::actor thread;
    std::optional<worker_fault> fate;  ///< Of the next job.
    std::function<void()> come_back;   ///< Of one on another machine.
    bool dead = false;
  };

private:
  void run(caf::actor_system& system, process& p);
  /// Its actors.
  void begin(caf::actor_system& system, process& p);
  void end(process& p);
  /// After a while, if there is still such a process, and a server.
  void later(milliseconds wait, pid_t pid,
             std::function<void(simulated_processes&, process&)> what);

  timeline& time_;
  const worker_role role_;
  pid_t last_pid_ = 0;
  std::list<process> processes_;
  std::optional<worker_fault> pending_;
  bool stopped_ = false;
};

}  // namespace tedit::simulation
