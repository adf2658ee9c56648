// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/pool.hpp"

#include <random>
#include <thread>
#include <utility>

#include <spdlog/spdlog.h>
#include <caf/io/middleman.hpp>
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "base/process.hpp"

namespace tedit::actors {

namespace {

std::string random_ticket() {
  std::random_device source;
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += std::to_string(source());
  return text;
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
}

void pool_state::stop() {
  for (const auto& c : children)
    kill_process(c.pid);
  children.clear();
  refuse_waiting({ec::service_unavailable, "the server is stopping", {}, {}});
}

error pool_state::no_worker() const {
  return {ec::service_unavailable,
          "no " + options.role + " worker runs: " + last_failure,
          "They are started again within a minute; the server's log says more",
          {}};
}

void pool_state::refuse_waiting(const error& why) {
  for (const auto& j : std::exchange(waiting, {}))
    j.refuse(why);
  for (const auto& q : std::exchange(asked, {}))
    q.refuse(why);
}

void pool_state::ask(question q) {
  const auto there = std::ranges::find_if(children, [](const child& c) { return !!c.worker; });
  if (there != children.end())
    return q.ask(there->worker);
  if (degraded && children.empty())
    return q.refuse(no_worker());
  asked.push_back(std::move(q));
}

// -- jobs --------------------------------------------------------------------------------------

void pool_state::add(job j) {
  if (const auto why = off.refusal(j.operation))
    return j.refuse(*why);
  if (degraded && children.empty())
    return j.refuse(no_worker());
  waiting.push_back(std::move(j));
  dispatch();
  make_way();
}

void pool_state::make_way() {
  auto held_up =
    std::ranges::count_if(waiting, [](const job& j) { return j.place.what == urgency::edit; });
  for (const auto& c : children)
    held_up -= c.work && c.work->cancelled;
  for (auto& c : children)
    if (held_up > 0 && c.work && c.work->place.what == urgency::preview && !c.work->cancelled) {
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

pool_state::job pool_state::take_next() {
  std::vector<turn> places;
  for (const auto& j : waiting)
    places.push_back(j.place);
  const auto at = waiting.begin() + static_cast<std::ptrdiff_t>(turns.take(places));
  auto next = std::move(*at);
  waiting.erase(at);
  return next;
}

void pool_state::dispatch() {
  for (auto& c : children) {
    if (waiting.empty())
      return;
    if (!c.worker || c.work)
      continue;
    auto next = take_next();
    if (const auto why = off.refusal(next.operation)) {
      next.refuse(*why);  // Switched off while it waited.
      return dispatch();
    }
    c.work = std::move(next);
    c.work->deadline = clock::now() + limit_of(*c.work);
    c.work->send(c.worker, c.work->deaths);
  }
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
  c->work->deadline = std::min(c->work->deadline, clock::now() + options.cancel_grace);
  caf::anon_send<caf::message_priority::high>(c->worker, cancel_atom::value, id);
}

void pool_state::complete(job_id id) {
  const auto c = child_with(id);
  if (c == children.end())
    return;
  c->work.reset();
  dispatch();
}

void pool_state::give_up_on(job_id id, const std::string& why) {
  const auto c = child_with(id);
  if (c == children.end())
    return;
  kill_process(c->pid);
  bury(c, why);
}

// -- processes -----------------------------------------------------------------------------------

void pool_state::spawn_child() {
  child c;
  c.ticket = random_ticket();
  c.started = clock::now();
  auto command = options.command;
  command.push_back("--join");
  command.push_back(address);
  const auto pid = spawn_process(command, {"TEDIT_TICKET=" + c.ticket});
  if (!pid) {
    last_failure = pid.error().message;
    spdlog::error("{} worker: {}", options.role, render(pid.error()));
    return;
  }
  c.pid = *pid;
  spdlog::info("{} worker: process {} started", options.role, c.pid);
  children.push_back(std::move(c));
}

void pool_state::spawn_missing() {
  while (children.size() < options.workers) {
    const bool first = !started_once && restarts + children.size() < options.workers;
    if (!first && forgiven > 0) {
      --forgiven;  // An operation's plugin is to blame, which has a count of its own.
    } else if (!first && !budget->take(clock::now())) {
      if (!degraded)
        spdlog::error("{} worker: died {} times within {} s, giving up for now", options.role,
                      options.restart_budget + 1, options.restart_window.count() / 1000);
      degraded = true;
      break;
    }
    if (!first)
      ++restarts;
    degraded = false;
    const auto before = children.size();
    spawn_child();
    if (children.size() == before)
      break;  // Counted against the budget; the next tick tries again.
  }
  started_once = started_once || children.size() >= options.workers;
  if (degraded && children.empty())
    refuse_waiting(no_worker());
}

bool pool_state::enlist(const enlistment& who) {
  const auto c = std::ranges::find_if(
    children, [&](const child& one) { return !one.worker && one.ticket == who.ticket; });
  if (c == children.end() || !who.worker) {
    spdlog::warn("{} worker: process {} was turned away: it was not started by this server",
                 options.role, who.pid);
    return false;
  }
  c->worker = who.worker;
  self->monitor(c->worker);
  spdlog::info(
    "{} worker: process {} ready after {} ms", options.role, c->pid,
    std::chrono::duration_cast<std::chrono::milliseconds>(clock::now() - c->started).count());
  for (const auto& q : std::exchange(asked, {}))
    q.ask(c->worker);
  dispatch();
  return true;
}

std::chrono::milliseconds pool_state::limit_of(const job& work) const {
  const bool own = !work.operation.empty() && options.operation_limit.count() > 0;
  return own ? options.operation_limit : options.job_limit;
}

void pool_state::blame(const job& work, const std::string& how) {
  if (work.operation.empty() || !off.counts())
    return;
  ++forgiven;
  spdlog::warn("{} worker: the operation {} was running", options.role, work.operation);
  if (off.note(work.operation, how))
    spdlog::error("plugin: {}", off.refusal(work.operation)->message);
}

void pool_state::bury(std::list<child>::iterator dead, const std::string& how) {
  last_failure = "process " + std::to_string(dead->pid) + " " + how;
  spdlog::warn("{} worker: {}", options.role, last_failure);
  auto work = std::move(dead->work);
  children.erase(dead);
  if (work) {
    ++work->deaths;
    work->place.again = true;
    blame(*work, how);
    if (work->cancelled)
      work->refuse({ec::cancelled, "the work was cancelled", {}, {}});
    else if (const auto why = off.refusal(work->operation))
      work->refuse(*why);
    else if (work->deaths > options.retries)
      work->refuse({ec::internal,
                    "the " + options.role + " worker " + how + " while it worked on this" +
                      (work->operation.empty() ? "" : " (operation " + work->operation + ")") +
                      ", " + std::to_string(work->deaths) + " times",
                    "Try other values; if it goes on, report it with the server's log",
                    {}});
    else
      waiting.push_front(std::move(*work));
  }
  spawn_missing();
  dispatch();
}

void pool_state::on_down(const caf::actor_addr& source) {
  const auto c = std::ranges::find_if(
    children, [&](const child& one) { return one.worker && one.worker.address() == source; });
  if (c == children.end())
    return;
  // Gone from the network is not yet gone as a process: a frozen one must not come back.
  // One that has ended says how within moments, though its connection closed first.
  auto how = reap_process(c->pid);
  for (int wait = 0; !how && wait < 10; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    how = reap_process(c->pid);
  }
  if (!how)
    kill_process(c->pid);
  bury(c, how ? *how : "did not answer any more");
}

void pool_state::tick() {
  const auto now = clock::now();
  for (auto c = children.begin(); c != children.end();) {
    const auto current = c++;
    if (const auto how = reap_process(current->pid))
      return bury(current, *how);  // The list has changed; the rest waits for the next tick.
    const bool late_start = !current->worker && now - current->started > options.start_limit;
    const bool late_work = current->work && now > current->work->deadline;
    if (!late_start && !late_work)
      continue;
    kill_process(current->pid);
    if (late_work && !current->work->cancelled) {
      current->work->refuse(
        {ec::timeout,
         (current->work->operation.empty() ? "the work"
                                           : "the operation " + current->work->operation) +
           " did not end within " + std::to_string(limit_of(*current->work).count() / 1000) + " s",
         "Take a coarser mesh, or raise the limit in the server's configuration",
         {}});
      blame(*current->work, "hung and was killed");
      current->work.reset();
    }
    return bury(current, late_start ? "did not start in time" : "hung and was killed");
  }
  if (children.size() < options.workers)
    spawn_missing();
}

worker_status pool_state::status() const {
  worker_status result;
  result.role = options.role;
  result.restarts = restarts;
  result.jobs = static_cast<std::uint32_t>(waiting.size());
  result.state = degraded ? "degraded" : "starting";
  for (const auto& c : children) {
    if (c.worker) {
      result.state = "ready";
      result.pid = c.pid;
    }
    result.jobs += c.work.has_value();
  }
  result.detail = last_failure;
  return result;
}

}  // namespace tedit::actors
