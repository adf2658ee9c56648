// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/pool.hpp"

#include <utility>

#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "base/logging/logging.hpp"
#include "base/misdeed.hpp"

namespace tedit::actors {

namespace {

/// What is said of a worker that the system ended for want of memory.
constexpr const char* as_memory_ran_out = ", as memory ran out";

error refusal_of_starved(const std::string& role, int times) {
  return {
    ec::out_of_memory,
    "memory ran out while the " + role + " worker worked on this, " + std::to_string(times) +
      " times: the system ended it",
    "Give the machine or its container more memory (\"tedit doctor\" says what there is), take "
    "a coarser mesh or linear tets, or let fewer work at once",
    {}};
}

bool is_preview(const pool_state::job& work) {
  return work.place.what == urgency::preview;
}

}  // namespace

bool restart_budget::take(clock::time_point now) {
  while (!taken_.empty() && now - taken_.front() > window_)
    taken_.pop_front();
  if (taken_.size() >= most_)
    return false;
  taken_.push_back(now);
  return true;
}

void pool_state::start(caf::scheduled_actor* owner, pool_options with) {
  self = owner;
  options = std::move(with);
  budget.emplace(options.restart_budget, options.restart_window);
  off = quarantine(options.quarantine_after);
  numbers.emplace(name_of(options.role) +
                  (options.device.empty() ? "" : " (" + options.device + ")"));
}

void pool_state::stop() {
  const error stopping{ec::service_unavailable, "the server is stopping", {}, {}};
  stopped = true;
  for (const auto& c : std::exchange(children, {})) {
    caf::anon_send_exit(c.enlister, caf::exit_reason::user_shutdown);
    c.line->cut();
    if (c.work)
      c.work->refuse(stopping);
  }
  refuse_waiting(stopping);
}

error pool_state::no_worker() const {
  if (!options.device.empty())
    return {ec::service_unavailable,
            "nobody who solves on \"" + options.device + "\" is joined to this server now",
            "Start that solver again, or choose another device",
            {}};
  if (options.workers == 0)
    return {ec::service_unavailable,
            "no " + name_of(options.role) + " worker has joined this server",
            "Start one with \"tedit worker --join\", or set work." + name_of(options.role) +
              "_workers in the server's configuration",
            {}};
  return {ec::service_unavailable,
          "no " + name_of(options.role) + " worker runs: " + last_failure,
          "They are started again within a minute; the server's log says more",
          {}};
}

void pool_state::refuse_waiting(const error& why) {
  for (const auto& j : std::exchange(waiting, {}))
    j.refuse(why);
  for (const auto& q : std::exchange(asked, {}))
    q.refuse(why);
}

bool pool_state::nobody_comes() const {
  return children.empty() && (degraded || (options.workers == 0 && now() >= expected_back));
}

void pool_state::ask(question q) {
  const auto there = std::ranges::find_if(children, &child::is_there);
  if (there != children.end())
    return q.ask(there->worker);
  if (nobody_comes())
    return q.refuse(no_worker());
  asked.push_back(std::move(q));
  wake();
}

// -- jobs --------------------------------------------------------------------------------------

void pool_state::add(job j) {
  if (const auto why = off.refusal(j.edit))
    return j.refuse(*why);
  if (nobody_comes())
    return j.refuse(no_worker());
  j.came = now();
  begin_stage(j, "wait");
  waiting.push_back(std::move(j));
  wake();
  dispatch();
  make_way();
}

void pool_state::begin_stage(job& j, const std::string& what, const child* by) const {
  j.stage = tracing::begin_part(name_of(options.role) + " " + what, j.trace);
  if (!by)
    return;
  j.stage.note("tedit.worker", by->line->name());
  if (j.deaths > 0)
    j.stage.note("tedit.attempt", j.deaths + 1);
  if (!j.edit.operation.empty())
    j.stage.note("tedit.operation", j.edit.operation);
}

void pool_state::make_way() {
  auto held_up =
    std::ranges::count_if(waiting, [](const job& j) { return j.place.what == urgency::edit; });
  for (const auto& c : children)
    held_up -= c.work && c.work->cancelled;
  for (auto& c : children)
    if (held_up > 0 && c.work && is_preview(*c.work) && !c.work->cancelled) {
      c.work->superseded = true;
      cancel(c.work->id);
      --held_up;
    }
}

error pool_state::reason_of(job_id id, const error& said) {
  const auto c = child_with(id);
  if (c == children.end() || !c->work->superseded || said.code != ec::cancelled)
    return said;
  return {ec::superseded, "the preview gave way to other work", "Ask for it again", {}};
}

std::list<pool_state::child>::iterator pool_state::child_with(job_id id) {
  return std::ranges::find_if(children, [&](const child& c) { return c.work && c.work->id == id; });
}

bool pool_state::is_current(job_id id, int attempt) {
  const auto c = child_with(id);
  return c != children.end() && c->work->deaths == attempt;
}

void pool_state::cancel(job_id id) {
  const auto found = std::ranges::find(waiting, id, &job::id);
  if (found != waiting.end()) {
    const auto refuse = std::move(found->refuse);
    waiting.erase(found);
    return refuse({ec::cancelled, "the work was cancelled before it began", {}, {}});
  }
  const auto c = child_with(id);
  if (c == children.end() || c->work->cancelled)
    return;
  c->work->cancelled = true;
  c->work->deadline = std::min(c->work->deadline, now() + options.cancel_grace);
  caf::anon_send<caf::message_priority::high>(c->worker, cancel_atom::value, id);
}

void pool_state::complete(job_id id, bool done) {
  const auto c = child_with(id);
  if (c == children.end())
    return;
  const auto took = now() - c->work_began;
  numbers->done.note(took);
  if (done) {
    const auto seconds = std::chrono::duration<double>(took).count();
    c->costs.note(c->work->needs.cost, seconds);
    costs.note(c->work->needs.cost, seconds);
  } else {
    c->work->stage.fail("refused");
  }
  c->work.reset();
  ++c->jobs_done;
  dispatch();
}

void pool_state::give_up_on(job_id id, const std::string& why) {
  const auto c = child_with(id);
  if (c == children.end())
    return;
  c->line->cut();
  bury(c, why);
}

// -- processes -----------------------------------------------------------------------------------

expected<pool_state::child> pool_state::make_child() {
  child c;
  c.number = ++started;
  c.started = now();
  c.enlister = make_enlister(c.number);
  const auto pid = options.processes->start(self->system(), options.command, c.enlister);
  if (!pid) {
    caf::anon_send_exit(c.enlister, caf::exit_reason::user_shutdown);
    return fail(pid.error());
  }
  c.line = own_process(options.processes, *pid);
  return c;
}

void pool_state::spawn_child() {
  auto made = make_child();
  if (!made) {
    last_failure = made.error().message;
    logging::error("{} worker: {}", name_of(options.role), render(made.error()));
    return;
  }
  logging::info("{} worker: {} started", name_of(options.role), made->line->name());
  wake();
  children.push_back(std::move(*made));
}

void pool_state::spawn_missing() {
  while (active() < options.workers) {
    const bool first = !started_once && restarts + active() < options.workers;
    if (!first && forgiven > 0) {
      --forgiven;  // An operation's plugin is to blame, which has a count of its own.
    } else if (!first && !budget->take(now())) {
      if (!degraded)
        logging::error("{} worker: died {} times within {} s, giving up for now",
                       name_of(options.role), options.restart_budget + 1,
                       options.restart_window.count() / 1000);
      degraded = true;
      break;
    }
    if (!first)
      ++restarts;
    degraded = false;
    const auto before = children.size();
    spawn_child();
    if (children.size() == before) {
      started_once = true;  // The next tick tries again, and pays for it like any restart.
      break;
    }
  }
  started_once = started_once || active() >= options.workers;
  if (nobody_comes())
    refuse_waiting(no_worker());
}

bool pool_state::enlist(std::uint64_t number, const enlistment& who) {
  const auto c = std::ranges::find(children, number, &child::number);
  if (c == children.end() || c->worker || !who.worker) {
    logging::warn("{} worker: process {} was turned away: nobody waits for it",
                  name_of(options.role), who.pid);
    return false;
  }
  c->worker = who.worker;
  c->worker_pid = who.pid;
  self->monitor(c->worker);
  logging::info("{} worker: {} ready after {} ms", name_of(options.role), c->line->name(),
                std::chrono::duration_cast<std::chrono::milliseconds>(now() - c->started).count());
  serve_new(*c);
  return true;
}

void pool_state::serve_new(child& c) {
  for (const auto& q : std::exchange(asked, {}))
    q.ask(c.worker);
  dispatch();
  say_health();
}

std::chrono::milliseconds pool_state::limit_of(const job& work) const {
  const bool own = !work.edit.operation.empty() && options.operation_limit.count() > 0;
  return own ? options.operation_limit : options.job_limit;
}

void pool_state::forgive(const job& work) {
  if (work.edit.operation.empty() || !off.counts())
    return;
  ++forgiven;
  logging::warn("{} worker: the operation {} was running{}", name_of(options.role),
                work.edit.operation, is_preview(work) ? ", for a preview" : "");
}

void pool_state::blame(const job& work, const std::string& how) {
  if (work.edit.operation.empty() || is_preview(work) || !off.note(work.edit, how))
    return;
  if (const auto why = off.refusal(work.edit))
    logging::error("plugin: {}", why->message);
}

void pool_state::try_again(job work, const std::string& how) {
  ++work.deaths;
  work.stage.fail("the worker " + how);
  numbers->retries.add();
  forgive(work);
  if (work.cancelled)
    return work.refuse({ec::cancelled, "the work was cancelled", {}, {}});
  // Nobody waits long for a preview: the next one is as good.
  const bool misdeed = is_misdeed(how);
  const bool starved = how.ends_with(as_memory_ran_out);
  if (!misdeed && work.deaths <= (is_preview(work) || starved ? 1 : options.retries)) {
    work.place.again = true;
    begin_stage(work, "wait");
    return waiting.push_front(std::move(work));
  }
  blame(work, how);
  if (const auto why = off.refusal(work.edit))
    return work.refuse(*why);
  if (misdeed)
    return work.refuse(refusal_of_misdeed(work.edit, how, catalogue.get()));
  if (starved)
    return work.refuse(refusal_of_starved(name_of(options.role), work.deaths));
  work.refuse({ec::internal,
               "the " + name_of(options.role) + " worker " + how + " while it worked on this" +
                 (work.edit.operation.empty() ? "" : " (operation " + work.edit.operation + ")") +
                 ", " + std::to_string(work.deaths) + " times",
               "Try other values; if it goes on, report it with the server's log",
               {}});
}

void pool_state::bury(std::list<child>::iterator dead, const std::string& how) {
  last_failure = dead->line->name() + " " + how;
  logging::warn("{} worker: {}", name_of(options.role), last_failure);
  numbers->deaths.add();
  auto work = std::move(dead->work);
  const bool starved = work && !dead->is_remote() && how.find("signal 9") != std::string::npos &&
                       options.processes->memory_kills() > dead->memory_kills;
  if (dead->is_remote() && !dead->retired)
    expected_back = now() + options.comeback;
  caf::anon_send_exit(dead->enlister, caf::exit_reason::user_shutdown);
  children.erase(dead);
  wake();
  if (work)
    try_again(std::move(*work), starved ? how + as_memory_ran_out : how);
  spawn_missing();
  dispatch();
  say_health();
}

std::size_t pool_state::active() const {
  return static_cast<std::size_t>(
    std::ranges::count_if(children, [](const child& c) { return !c.retired && !c.is_remote(); }));
}

void pool_state::retire(const caf::actor_addr& source, const std::string& why) {
  const auto c = std::ranges::find_if(
    children, [&](const child& one) { return one.worker && one.worker.address() == source; });
  if (c == children.end() || c->retired)
    return;
  logging::info("{} worker: {} gets no more work: {}", name_of(options.role), c->line->name(), why);
  c->retired = now();
  wake();
  if (c->is_remote())
    return;  // Whoever keeps it there sees to another.
  ++forgiven;
  spawn_missing();
}

void pool_state::dismiss_retired(clock::time_point at) {
  constexpr std::ptrdiff_t most = 2;
  auto too_many =
    std::ranges::count_if(children, [](const child& c) { return !!c.retired; }) - most;
  for (auto c = children.begin(); c != children.end();) {
    const auto current = c++;
    if (!current->retired || current->work)
      continue;
    const bool has_results = current->jobs_done > 0;
    if (too_many-- <= 0 && has_results && at - *current->retired < options.retired_stay)
      continue;
    current->line->cut();
    caf::anon_send_exit(current->enlister, caf::exit_reason::user_shutdown);
    children.erase(current);
  }
}

void pool_state::on_down(const caf::actor_addr& source) {
  const auto c = std::ranges::find_if(
    children, [&](const child& one) { return one.worker && one.worker.address() == source; });
  if (c == children.end())
    return;
  // Gone from the network is not yet gone as a process. One that has ended says how within moments,
  // though its connection closed first; a frozen one must not come back.
  if (const auto how = c->line->ended())
    return bury(c, *how);
  c->lost = now();
  resting = false;
  tick_after(lost_interval);
  say_health();
}

bool pool_state::at_rest() const {
  return waiting.empty() && asked.empty() && active() == options.workers &&
         std::ranges::all_of(children, [](const child& c) { return c.is_there() && !c.work; });
}

void pool_state::wake() {
  if (std::exchange(resting, false))
    tick_after(tick_interval);
}

void pool_state::tick_after(std::chrono::milliseconds wait) {
  call_tick(wait, ++last_tick);
}

void pool_state::on_tick(std::uint64_t number) {
  if (number != last_tick)
    return;
  tick();
  resting = at_rest();
  const bool some_lost = std::ranges::any_of(children, [](const child& c) { return !!c.lost; });
  tick_after(some_lost ? lost_interval : resting ? rest_interval : tick_interval);
}

void pool_state::tick() {
  say_health();
  const auto at = now();
  for (auto c = children.begin(); c != children.end();) {
    const auto current = c++;
    if (const auto how = current->line->ended())
      return bury(current, *how);  // The list has changed; the rest waits for the next tick.
    const bool late_start = !current->worker && at - current->started > options.start_limit;
    const bool late_work = current->work && at > current->work->deadline;
    const bool frozen = current->lost && at - *current->lost > options.last_moments;
    if (!late_start && !late_work && !frozen)
      continue;
    current->line->cut();
    if (frozen)
      return bury(current, "did not answer any more");
    if (late_work && !current->work->cancelled) {
      current->work->refuse(
        {ec::timeout,
         (current->work->edit.operation.empty()
            ? "the work"
            : "the operation " + current->work->edit.operation) +
           " did not end within " + std::to_string(limit_of(*current->work).count() / 1000) + " s",
         "Take a coarser mesh, or raise the limit in the server's configuration",
         {}});
      forgive(*current->work);
      blame(*current->work, "hung and was killed");
      current->work.reset();
    } else if (late_work) {
      blame(*current->work, "did not end when it was cancelled");
    }
    return bury(current, late_start ? "did not start in time" : "hung and was killed");
  }
  dismiss_retired(at);
  dispatch();  // Who waits for a busy worker does so only while that keeps to its time.
  tell_waiting();
  if (active() < options.workers)
    spawn_missing();
  else if (nobody_comes())
    refuse_waiting(no_worker());
}

const char* to_string(role_state state) {
  switch (state) {
    case role_state::ready:
      return "ready";
    case role_state::degraded:
      return "degraded";
    case role_state::starting:
      break;
  }
  return "starting";
}

role_state pool_state::state() const {
  const bool served = std::ranges::any_of(children, &child::is_there);
  return served                       ? role_state::ready
         : degraded || nobody_comes() ? role_state::degraded
                                      : role_state::starting;
}

void pool_state::say_health() const {
  measure();
  if (options.health)
    options.health->say(state());
}

}  // namespace tedit::actors
