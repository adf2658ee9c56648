// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/workers.hpp"

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>

#include "actors/pages/page_store.hpp"
#include "fem/quantities.hpp"
#include "mesh/builder.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::simulation {

// -- what the work is --------------------------------------------------------------------------

version_ptr imported_part(int number) {
  return test::box_mesh({1, 1, 1}, {1, 1, 1.0 + number});
}

version_ptr nudged(const version_ptr& base, std::int64_t vertex, double by) {
  if (vertex < 0 || vertex >= base->vertex_slots())
    return nullptr;
  mesh_builder builder(base);
  const auto v = static_cast<vertex_id>(vertex);
  builder.set_position(v, builder.position(v) + vec3{by, 0, 0});
  return builder.freeze();
}

namespace {

double number_in(const edit_request& wanted, const char* name) {
  const auto found = wanted.parameters.find(name);
  const auto* value =
    found == wanted.parameters.end() ? nullptr : std::get_if<double>(&found->second);
  return value ? *value : 0;
}

expected<job_output<import_result>> read_part(const import_order& order, const job_input& in) {
  const auto bytes = join(order.file, order.size, in.pages);
  if (!bytes)
    return fail(bytes.error());
  const std::string text(bytes->begin(), bytes->end());
  if (text.rfind("part ", 0) != 0)
    return fail(ec::bad_input, "this is no part");
  const auto mesh = imported_part(std::stoi(text.substr(5)));
  job_output<import_result> output;
  output.result.version = make_ref(mesh);
  output.keep_pages(mesh);
  return output;
}

expected<job_output<operation_result>> nudge(const edit_order& order, const job_input& in) {
  const auto wanted = order.wanted.get();
  if (!wanted)
    return fail(wanted.error());
  const auto mesh = nudged(in.mesh, static_cast<std::int64_t>(number_in(**wanted, "vertex")),
                           number_in(**wanted, "by"));
  if (!mesh)
    return fail(ec::invalid_argument, "there is no such vertex", "Name another");
  job_output<operation_result> output;
  output.result.version = make_ref(mesh);
  output.keep_pages(mesh);
  return output;
}

expected<job_output<check_result>> accept(const check_order& order, const job_input& in) {
  const auto mesh = open_version(order.candidate.version, in.pages);
  const auto wanted = order.wanted.get();
  const auto load_cases = order.load_cases.get();
  if (!mesh || !wanted || !load_cases)
    return fail(ec::internal, "the order cannot be read");
  edit_report report;
  report.from_version = to_hex(order.before.id);
  report.to_version = to_hex((*mesh)->id());
  report.operation = (*wanted)->operation;
  job_output<check_result> output;
  output.result.version = make_ref(*mesh);
  output.result.load_cases = wire_value(*load_cases);
  output.result.report = wire_value(std::move(report));
  output.keep_pages(*mesh);
  return output;
}

/// Every value of a field is the tenth part of its place: what is sent can be told from it.
field made_up_field(const mesh_version& mesh, const fem::result_array& array) {
  std::vector<double> values(mesh.vertex_slots() * static_cast<std::size_t>(array.components));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = 0.1 * static_cast<double>(i);
  return {std::string(array.name), field_location::vertex, array.components,
          paged_array<double>::from(values)};
}

expected<job_output<solve_result>> solve(const solve_order& order, const job_input& in) {
  const auto load_cases = order.load_cases.get();
  if (!load_cases)
    return fail(load_cases.error());
  solve_report report;
  report.version_id = to_hex(order.version.id);
  report.load_case = (*load_cases)->front().name;
  report.element_order = order.element_order;
  job_output<solve_result> output;
  for (const auto& array : fem::result_arrays)
    if (array.sent == fem::array_sent::always) {
      const auto made = made_up_field(*in.mesh, array);
      output.result.fields.push_back(make_ref(made));
      output.pages.insert(output.pages.end(), made.values.pages().begin(),
                          made.values.pages().end());
    }
  solve_outcome outcome;
  outcome.cases = {report};
  output.result.outcome = wire_value(std::move(outcome));
  return output;
}

expected<job_output<export_result>> write(const export_order& order) {
  job_output<export_result> output;
  const auto text = to_hex(order.version.id);
  output.result.size = text.size();
  output.pages = cut(text);
  for (const auto& p : output.pages)
    output.result.pages.push_back(p->id());
  return output;
}

// -- the actors of a process -------------------------------------------------------------------

struct role_state {
  worker_jobs jobs;
  static inline const char* name = "worker";
};

template <class Role>
using role_pointer = typename Role::template stateful_pointer<role_state>;

template <class Role, class Order, class Result, class Work>
auto handler(role_pointer<Role> self, Work work) {
  return [=](job_id job, const Order& order) -> caf::result<Result> {
    job_needs needs;
    if constexpr (requires { order.version; })
      needs.version = order.version;
    if constexpr (std::is_same_v<Order, import_order>)
      needs.pages = order.file;
    if constexpr (std::is_same_v<Order, check_order>) {
      needs.version = order.before;
      const auto candidate = pages_of(order.candidate.version);
      if (!candidate)
        return to_caf(candidate.error());
      needs.pages = *candidate;
    }
    return perform<Result>(
      self, job, order.base, needs,
      [=](const job_input& in, const execution& run) -> expected<job_output<Result>> {
        if (run.cancel.cancelled())
          return fail(ec::cancelled, "the work was cancelled");
        return work(order, in);
      });
  };
}

modeling_actor::behavior_type modeling(role_pointer<modeling_actor> self, worker_jobs jobs) {
  self->state.jobs = std::move(jobs);
  using role = modeling_actor;
  return {handler<role, import_order, import_result>(self, read_part),
          handler<role, edit_order, operation_result>(self, nudge),
          handler<role, export_order, export_result>(
            self, [](const export_order& order, const job_input&) { return write(order); }),
          handler<role, select_order, select_result>(
            self,
            [](const select_order&, const job_input&) -> expected<job_output<select_result>> {
              return fail(ec::internal, "selections are not simulated");
            }),
          [](catalog_atom) { return shared_catalogue(operation_catalogue()); },
          [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
          [=](status_atom) { return self->state.jobs.status(); }};
}

optimizer_actor::behavior_type optimizer(role_pointer<optimizer_actor> self, worker_jobs jobs) {
  self->state.jobs = std::move(jobs);
  return {handler<optimizer_actor, check_order, check_result>(self, accept),
          [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
          [=](status_atom) { return self->state.jobs.status(); }};
}

solver_actor::behavior_type solver(role_pointer<solver_actor> self, worker_jobs jobs) {
  self->state.jobs = std::move(jobs);
  return {handler<solver_actor, solve_order, solve_result>(self, solve),
          [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
          [=](status_atom) { return self->state.jobs.status(); }};
}

caf::actor spawn_role(caf::actor_system& system, worker_role role, worker_jobs jobs) {
  switch (role) {
    case worker_role::modeling:
      return caf::actor_cast<caf::actor>(system.spawn(modeling, std::move(jobs)));
    case worker_role::optimizer:
      return caf::actor_cast<caf::actor>(system.spawn(optimizer, std::move(jobs)));
    case worker_role::solver:
      break;
  }
  return caf::actor_cast<caf::actor>(system.spawn(solver, std::move(jobs)));
}

/// One piece of work after the other, each after its time.
struct thread_state {
  std::deque<std::pair<job_task, caf::typed_response_promise<acknowledged>>> waiting;
  static inline const char* name = "job_thread";
};

struct thread_plan {
  std::function<milliseconds()> duration;
  /// Called at the end of a piece of work; false: it never ends, or there is no answer.
  std::function<bool()> may_run;
  std::function<bool()> may_answer;
  std::function<void()> answered;
};

caf::behavior job_thread_of(caf::stateful_actor<thread_state>* self, const thread_plan& plan) {
  const auto begin = [=] { self->delayed_send(self, plan.duration(), tick_atom::value); };
  return {[=](const job_task& task) -> caf::result<acknowledged> {
            auto promise = self->make_response_promise<acknowledged>();
            self->state.waiting.emplace_back(task, promise);
            if (self->state.waiting.size() == 1)
              begin();
            return promise;
          },
          [=](tick_atom) {
            if (!plan.may_run())
              return;
            auto [task, promise] = std::move(self->state.waiting.front());
            task.run();
            if (!plan.may_answer())
              return;
            promise.deliver(acknowledged{});
            self->state.waiting.pop_front();
            if (!self->state.waiting.empty())
              begin();
            plan.answered();
          }};
}

}  // namespace

// -- processes -----------------------------------------------------------------------------------

expected<pid_t> simulated_processes::start(caf::actor_system& system,
                                           const std::vector<std::string>&,
                                           const caf::actor& enlister) {
  auto& p = processes_.emplace_back();
  p.pid = ++last_pid_;
  p.fate = std::exchange(pending_, std::nullopt);
  p.enlister = enlister;
  later(milliseconds(20 + time_.random.below(200)), p.pid,
        [&system](simulated_processes& all, process& one) { all.run(system, one); });
  return p.pid;
}

void simulated_processes::later(milliseconds wait, pid_t pid,
                                std::function<void(simulated_processes&, process&)> what) {
  time_.after(wait, [weak = weak_from_this(), pid, what = std::move(what)] {
    const auto all = weak.lock();
    if (!all)
      return;
    const auto p = std::ranges::find(all->processes_, pid, &process::pid);
    if (p != all->processes_.end() && !p->dead)
      what(*all, *p);
  });
}

void simulated_processes::run(caf::actor_system& system, process& p) {
  begin(system, p);
  caf::anon_send(p.enlister, enlistment{p.pid, p.worker});
}

void simulated_processes::begin(caf::actor_system& system, process& p) {
  auto cache = std::make_shared<page_cache>(std::size_t{1} << 20);
  const auto pages = system.spawn(make_page_store, cache);
  p.pages = caf::actor_cast<caf::actor>(pages);
  thread_plan plan;
  plan.duration = [this] {
    auto& random = time_.random;
    return milliseconds(random.one_in(20) ? 1000 + random.below(9000) : 1 + random.below(60));
  };
  plan.may_run = [&p] { return p.fate != worker_fault::hangs; };
  const auto die = [](simulated_processes& all, process& one) { all.end(one); };
  plan.may_answer = [this, &p, die] {
    if (p.fate == worker_fault::dies_with_job)
      later(milliseconds(0), p.pid, die);
    return p.fate != worker_fault::dies_with_job;
  };
  plan.answered = [this, &p, die] {
    // The answer is on its way, and a link delivers what was sent before its end.
    if (p.fate == worker_fault::dies_after_answer)
      later(milliseconds(1 + time_.random.below(4)), p.pid, die);
  };
  p.thread = system.spawn(job_thread_of, plan);
  worker_jobs jobs;
  jobs.role = role_;
  jobs.cache = cache;
  jobs.pages = pages;
  jobs.pages_handle = p.pages;
  jobs.thread = caf::actor_cast<job_thread_actor>(p.thread);
  p.worker = spawn_role(system, role_, std::move(jobs));
}

namespace {

/// To another machine: it ends with the process there.
class simulated_line final : public lifeline {
public:
  simulated_line(std::weak_ptr<simulated_processes> machines, pid_t pid)
      : machines_(std::move(machines)), pid_(pid) {}

  std::optional<std::string> ended() override {
    const auto all = machines_.lock();
    return all && !all->reap(pid_) ? std::nullopt
                                   : std::optional<std::string>("lost its connection");
  }
  void cut() override {
    if (const auto all = machines_.lock())
      all->kill(pid_);
  }
  [[nodiscard]] std::string name() const override { return "node rack-" + std::to_string(pid_); }

private:
  std::weak_ptr<simulated_processes> machines_;
  pid_t pid_;
};

}  // namespace

void simulated_processes::join(caf::actor_system& system, const caf::actor& pool) {
  if (stopped_)
    return;
  auto& p = processes_.emplace_back();
  p.pid = ++last_pid_;
  begin(system, p);
  p.come_back = [this, &system, pool] {
    time_.after(milliseconds(1000 + time_.random.below(8000)),
                [weak = weak_from_this(), &system, pool] {
                  if (const auto all = weak.lock())
                    all->join(system, pool);
                });
  };
  remote_worker guest;
  guest.worker = p.worker;
  guest.line = std::make_shared<simulated_line>(weak_from_this(), p.pid);
  guest.node.name = guest.line->name();
  caf::anon_send(pool, guest);
}

std::optional<std::string> simulated_processes::reap(pid_t pid) {
  const auto found = std::ranges::find(processes_, pid, &process::pid);
  if (found == processes_.end() || !found->dead)
    return std::nullopt;
  return "was killed by signal 9 (Killed)";
}

void simulated_processes::kill(pid_t pid) {
  const auto found = std::ranges::find(processes_, pid, &process::pid);
  if (found != processes_.end())
    end(*found);
}

void simulated_processes::end(process& p) {
  if (std::exchange(p.dead, true))
    return;
  cut_off(p.thread);
  cut_off(p.pages);
  cut_off(p.worker);
  p.enlister = p.thread = p.pages = p.worker = nullptr;
  if (const auto come_back = std::exchange(p.come_back, nullptr); come_back && !stopped_)
    come_back();
}

void simulated_processes::strike(worker_fault fault, std::size_t which) {
  std::vector<process*> there;
  for (auto& p : processes_)
    if (!p.dead)
      there.push_back(&p);
  if (there.empty()) {
    pending_ = fault;
    return;
  }
  auto& p = *there[which % there.size()];
  if (fault == worker_fault::dies)
    return end(p);
  // Of a process of this machine there is no line that could be silent.
  const bool silent = fault == worker_fault::falls_silent && p.come_back;
  p.fate = fault == worker_fault::falls_silent ? worker_fault::hangs : fault;
  if (silent)
    later(milliseconds(5000 + time_.random.below(1000)), p.pid,
          [](simulated_processes& all, process& one) { all.end(one); });
}

void simulated_processes::stop() {
  stopped_ = true;
  for (auto& p : processes_)
    end(p);
}

}  // namespace tedit::simulation
