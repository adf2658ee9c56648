// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <caf/send.hpp>

#include "actors/supervisor/pool.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {

/// A worker that answers when a test says so.
struct puppet_state {
  struct task {
    job_id job;
    std::string operation;
    caf::typed_response_promise<operation_result> promise;
  };
  std::deque<task> tasks;
  std::deque<caf::typed_response_promise<export_result>> files;
  std::vector<std::uint64_t> cancelled;
  static inline const char* name = "puppet";
};
using puppet_actor = caf::stateful_actor<puppet_state>;

inline caf::behavior make_puppet(puppet_actor* self, int /*number*/) {
  return {[=](job_id job, const edit_order& order) {
            auto promise = self->make_response_promise<operation_result>();
            self->state.tasks.push_back({job, (*order.wanted.get())->operation, promise});
            return promise;
          },
          [=](job_id, const export_order&) {
            auto promise = self->make_response_promise<export_result>();
            self->state.files.push_back(promise);
            return promise;
          },
          [=](cancel_atom, job_id job) { self->state.cancelled.push_back(job.value); },
          [](const doing& that) { that.what(); }};
}

/// Processes that a test starts, starves and kills.
class puppet_processes final : public worker_processes {
public:
  struct process {
    caf::actor enlister;
    caf::actor worker;
    std::string how;  ///< It ended; empty while it runs.
    bool killed = false;
  };

  expected<pid_t> start(caf::actor_system& system, const std::vector<std::string>&,
                        const caf::actor& enlister) override {
    if (!refusal.empty())
      return fail(ec::service_unavailable, refusal);
    const auto worker = system.spawn(make_puppet, 0);
    all.push_back({enlister, worker, {}});
    if (enlists)
      caf::anon_send(enlister, enlistment{static_cast<std::int32_t>(all.size()), worker});
    return static_cast<pid_t>(all.size());
  }

  std::optional<std::string> reap(pid_t pid) override {
    const auto& how = all.at(static_cast<std::size_t>(pid - 1)).how;
    return how.empty() ? std::nullopt : std::optional(how);
  }

  void kill(pid_t pid) override {
    auto& one = all.at(static_cast<std::size_t>(pid - 1));
    one.killed = true;
    end(one, "was killed by signal 9 (Killed)");
  }

  [[nodiscard]] std::uint64_t memory_kills() const override { return starved; }

  static void end(process& one, const std::string& how) {
    if (!one.how.empty())
      return;
    one.how = how;
    simulation::cut_off(one.worker);
  }

  bool enlists = true;
  std::string refusal;
  std::uint64_t starved = 0;  ///< Processes that the system ended.
  std::deque<process> all;
};

class Pool : public States {
protected:
  ~Pool() override {
    caf::anon_send_exit(pool_, caf::exit_reason::user_shutdown);
    pass(milliseconds(1));
  }

  void start(pool_options options = {}) {
    options.processes = processes_;
    pool_ = make_modeling_pool(stage_.system(), std::move(options));
    pass(milliseconds(10));
  }

  answer<operation_result> edit(std::uint64_t id, const std::string& operation = "fill",
                                std::uint64_t client = 0, bool preview = false) {
    edit_order order;
    edit_request wanted;
    wanted.operation = operation;
    order.wanted = wire_value(wanted);
    order.document = "part";
    order.preview = preview;
    order.base.client = client;
    auto result = ask<operation_result>(pool_, job_id{id}, order);
    pass(milliseconds(1));
    return result;
  }

  answer<export_result> file(std::uint64_t id) {
    auto result = ask<export_result>(pool_, job_id{id}, export_order{});
    pass(milliseconds(1));
    return result;
  }

  /// The process that was started last, or so many before it.
  puppet_processes::process& process(std::size_t before = 0) {
    return processes_->all.at(processes_->all.size() - 1 - before);
  }
  puppet_state& worker(std::size_t before = 0) {
    auto* self = caf::actor_cast<caf::abstract_actor*>(process(before).worker);
    return dynamic_cast<puppet_actor&>(*self).state;
  }

  /// The worker answers the job that it got first.
  void finish(std::size_t before = 0) {
    auto promise = worker(before).tasks.front().promise;
    worker(before).tasks.pop_front();
    within(process(before).worker, [=]() mutable { promise.deliver(operation_result{}); });
  }

  void refuse(const error& why) {
    auto promise = worker().tasks.front().promise;
    worker().tasks.pop_front();
    within(process().worker, [=]() mutable { promise.deliver(to_caf(why)); });
  }

  void crash(const std::string& how = "was killed by signal 11 (Segmentation fault)") {
    puppet_processes::end(process(), how);
    pass(milliseconds(200));
  }

  worker_status status() {
    const auto got = ask<worker_status>(pool_, status_atom::value);
    pass(milliseconds(1));
    return got.value();
  }

  std::shared_ptr<puppet_processes> processes_ = std::make_shared<puppet_processes>();
  modeling_actor pool_;
};

}  // namespace tedit::actors
