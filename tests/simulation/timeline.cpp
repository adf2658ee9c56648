// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/timeline.hpp"

#include <algorithm>

#include <caf/scheduled_actor.hpp>
#include <caf/scheduler/test_coordinator.hpp>

namespace tedit::simulation {

namespace {

caf::scheduler::test_coordinator& coordinator_of(caf::actor_system& system) {
  return dynamic_cast<caf::scheduler::test_coordinator&>(system.scheduler());
}

/// CAF's clock for tests, which does not tell when its next timeout is.
class read_clock : public caf::detail::test_actor_clock {
public:
  static time_point next_of(const caf::detail::test_actor_clock& clock) {
    const auto& all = clock.*&read_clock::schedule_;
    return all.empty() ? time_point::max() : all.begin()->first;
  }
};

}  // namespace

stage::stage(timeline& time)
    : time_(time), began_(time.now()), config_(std::make_unique<caf::actor_system_config>()) {
  config_->set("scheduler.policy", caf::atom("testing"));
  system_ = std::make_unique<caf::actor_system>(*config_);
  system_->await_actors_before_shutdown(false);
}

stage::~stage() {
  drain();
}

void stage::drain() {
  auto& coordinator = coordinator_of(*system_);
  while (coordinator.try_run_once()) {
  }
}

void stage::run_one() {
  auto& jobs = coordinator_of(*system_).jobs;
  const auto picked = jobs.begin() + static_cast<std::ptrdiff_t>(time_.random.below(jobs.size()));
  std::rotate(jobs.begin(), picked, picked + 1);
  coordinator_of(*system_).run_once();
}

milliseconds stage::next_timeout() const {
  auto& clock = coordinator_of(*system_).clock();
  const auto next = read_clock::next_of(clock);
  if (next == caf::actor_clock::time_point::max())
    return milliseconds::max();
  // Rounded up: a timeout must not be due before its time.
  const auto wait = std::chrono::ceil<milliseconds>(next - clock.current_time);
  return time_.now() + std::max(wait, milliseconds(0));
}

void stage::go_to(milliseconds when) {
  const auto passed = when - time_.now();
  time_.go_to(when);
  coordinator_of(*system_).clock().advance_time(passed);
}

bool stage::step(milliseconds limit) {
  // Most actors are quick, but now and then time passes while one has something to do.
  const bool busy = coordinator_of(*system_).has_job();
  if (busy && !time_.random.one_in(50)) {
    run_one();
    return true;
  }
  if (time_.run_due())
    return true;
  const auto next = std::min(time_.next(), next_timeout());
  if (next > limit) {
    if (busy)
      run_one();
    return busy;
  }
  go_to(next);
  time_.run_due();
  return true;
}

void cut_off(const caf::actor& who) {
  if (!who)
    return;
  auto* self = dynamic_cast<caf::scheduled_actor*>(caf::actor_cast<caf::abstract_actor*>(who));
  if (!self || self->getf(caf::abstract_actor::is_terminated_flag))
    return;
  const auto keep = who;
  self->cleanup(caf::make_error(caf::exit_reason::kill), nullptr);
  self->on_exit();  // Its state goes.
  // What it would have handled next is lost with it.
  auto& jobs = coordinator_of(self->home_system()).jobs;
  const auto at = std::ranges::find(jobs, static_cast<caf::resumable*>(self));
  if (at == jobs.end())
    return;
  jobs.erase(at);
  caf::intrusive_ptr_release(static_cast<caf::resumable*>(self));
}

}  // namespace tedit::simulation
