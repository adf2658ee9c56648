// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/disks.hpp"

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>

#include "actors/errors.hpp"

namespace tedit::simulation {

namespace {

struct queue_state {
  std::deque<std::function<void()>> waiting;
  static inline const char* name = "slow_disk";
};

using queue_pointer = caf::stateful_actor<queue_state>*;

/// Before a real disk: one request after the other, each after its time.
caf::behavior make_slow_disk(queue_pointer self, const disk_actor& real,
                             const std::shared_ptr<simulated_disks::mood>& mood,
                             const std::shared_ptr<std::atomic<int>>& jobs) {
  const auto begin = [=] {
    auto& random = mood->time->random;
    const bool slow = mood->time->now() < mood->slow_until;
    self->delayed_send(self, milliseconds(slow ? 1000 + random.below(4000) : random.below(8)),
                       tick_atom::value);
  };
  const auto add = [=](std::function<void()> work) {
    self->state.waiting.push_back(std::move(work));
    if (self->state.waiting.size() == 1)
      begin();
  };
  const auto forward = [=]<class Result, class... Args>(std::in_place_type_t<Result>,
                                                        Args... args) {
    auto promise =
      std::make_shared<caf::typed_response_promise<Result>>(self->make_response_promise<Result>());
    add([=] {
      self->request(real, caf::infinite, args...)
        .then([=](Result& result) { promise->deliver(std::move(result)); },
              [=](caf::error& e) { promise->deliver(std::move(e)); });
    });
    return *promise;
  };
  return {
    [=](load_atom atom, const shared_file& file) {
      return forward(std::in_place_type<stored_document>, atom, file);
    },
    [=](const shared_file& file, const stored_change& change) -> caf::result<acknowledged> {
      if (mood->failing > 0) {
        --mood->failing;
        --*jobs;
        return to_caf({ec::storage_error, "the disk is full", "Make room", {}});
      }
      return forward(std::in_place_type<acknowledged>, file, change);
    },
    [=](copy_atom atom, const shared_file& file) {
      return forward(std::in_place_type<exported>, atom, file);
    },
    [=](const adoption& one) { return forward(std::in_place_type<acknowledged>, one); },
    [=](rename_atom atom, const shared_file& file, const std::string& name) {
      return forward(std::in_place_type<acknowledged>, atom, file, name);
    },
    [=](close_atom atom, const shared_file& file) {
      return forward(std::in_place_type<acknowledged>, atom, file);
    },
    [=](wake_atom atom, const shared_file& file) { add([=] { self->send(real, atom, file); }); },
    [=](rest_atom atom, const shared_file& file) { add([=] { self->send(real, atom, file); }); },
    [=](tick_atom) {
      const auto work = std::move(self->state.waiting.front());
      self->state.waiting.pop_front();
      if (!self->state.waiting.empty())
        begin();
      work();
    }};
}

}  // namespace

simulated_disks::simulated_disks(timeline& time, caf::actor_system& system) {
  mood_->time = &time;
  std::vector<disk> made(2);
  for (auto& one : made) {
    const auto real = system.spawn(make_disk, one.jobs);
    const auto slow = system.spawn(make_slow_disk, real, mood_, one.jobs);
    one.actor = caf::actor_cast<disk_actor>(slow);
    all_.push_back(slow);
    all_.push_back(caf::actor_cast<caf::actor>(real));
  }
  disks_ = disk_set(std::move(made));
}

void simulated_disks::stop() {
  for (const auto& one : all_)
    cut_off(one);
}

}  // namespace tedit::simulation
