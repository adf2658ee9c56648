// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/solver_choice.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) { return lower(c); });
  return text;
}

struct choice_state {
  solver_actor common;
  std::function<solver_actor(caf::actor_system&, const std::string&)> make_pool;
  std::map<std::string, solver_actor> own;  ///< By the device's name in small letters.

  static inline const char* name = "solver_choice";

  [[nodiscard]] const solver_actor& for_device(const std::string& device) const {
    const auto found = own.find(lower(device));
    return found == own.end() ? common : found->second;
  }
};

using choice_pointer = solver_actor::stateful_pointer<choice_state>;

/// The pool for a node that joins; null when there are too many already, or the name cannot be.
caf::actor pool_for(choice_pointer self, const std::string& device) {
  auto& state = self->state;
  if (device.empty())
    return caf::actor_cast<caf::actor>(state.common);
  const auto key = lower(device);
  if (const auto found = state.own.find(key); found != state.own.end())
    return caf::actor_cast<caf::actor>(found->second);
  if (!can_be_own_device(device) || state.own.size() >= most_own_devices)
    return nullptr;
  const auto made = state.make_pool(self->system(), device);
  state.own.emplace(key, made);
  return caf::actor_cast<caf::actor>(made);
}

/// All pools as one: what is said of the role is what the common one says.
caf::result<worker_status> status_of_all(choice_pointer self) {
  struct gathering {
    worker_status result;
    std::vector<node_status> others;
    std::uint32_t jobs = 0;
    std::size_t missing = 1;
    caf::typed_response_promise<worker_status> promise;

    void count() {
      if (--missing > 0)
        return;
      result.jobs += jobs;
      result.nodes.insert(result.nodes.end(), others.begin(), others.end());
      promise.deliver(result);
    }
  };
  const auto all = std::make_shared<gathering>();
  all->promise = self->make_response_promise<worker_status>();
  all->missing += self->state.own.size();
  self->request(self->state.common, std::chrono::seconds(1), status_atom::value)
    .then(
      [=](const worker_status& one) {
        all->result = one;
        all->count();
      },
      [=](const caf::error& e) {
        all->result = {"solver", "degraded", 0, 0, 0, from_caf(e, "solver").message};
        all->count();
      });
  for (const auto& [device, pool] : self->state.own)
    self->request(pool, std::chrono::seconds(1), status_atom::value)
      .then(
        [=](const worker_status& one) {
          all->jobs += one.jobs;
          all->others.insert(all->others.end(), one.nodes.begin(), one.nodes.end());
          all->count();
        },
        [=](const caf::error&) { all->count(); });
  return all->promise;
}

solver_actor::behavior_type solver_choice(
  choice_pointer self, solver_actor common,
  std::function<solver_actor(caf::actor_system&, const std::string&)> make_pool) {
  self->state.common = std::move(common);
  self->state.make_pool = std::move(make_pool);
  const auto for_each = [=](const auto& use) {
    use(self->state.common);
    for (const auto& [device, pool] : self->state.own)
      use(pool);
  };
  heed_only_own_exits(self, [=] {
    for_each(
      [](const solver_actor& pool) { caf::anon_send_exit(pool, caf::exit_reason::user_shutdown); });
  });
  // What enlisters say, for the pool that it is about.
  self->set_default_handler(
    [=](caf::scheduled_actor*, caf::message_view& view) -> caf::result<caf::message> {
      auto message = view.move_content_to_message();
      caf::message answer;
      message.apply({[&](const remote_worker& guest) {
                       if (const auto pool = pool_for(self, guest.node.own_device))
                         self->delegate(pool, guest);
                       else
                         answer = caf::make_message(false);
                     },
                     [&](const retirement& note, const caf::actor_addr& worker) {
                       if (!is_asked_from_here(self))
                         return;
                       for_each([&](const solver_actor& pool) {
                         caf::unsafe_send_as(self, caf::actor_cast<caf::actor>(pool), note, worker);
                       });
                     }});
      return answer;
    });
  return {[=](job_id job, const solve_order& order) {
            return self->delegate(self->state.for_device(order.device), job, order);
          },
          [=](cancel_atom cancel, job_id job) {
            for_each([&](const solver_actor& pool) { caf::anon_send(pool, cancel, job); });
          },
          [=](status_atom) { return status_of_all(self); }};
}

}  // namespace

bool can_be_own_device(const std::string& name) {
  constexpr std::array<std::string_view, 4> taken{"auto", "cpu", "gpu", "lavapipe"};
  const auto fits = [](char c) {
    return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
           c == '_';
  };
  return !name.empty() && name.size() <= 63 && std::ranges::all_of(name, fits) &&
         std::ranges::count(taken, std::string_view(lower(name))) == 0;
}

solver_actor make_solver_choice(
  caf::actor_system& system, solver_actor common,
  std::function<solver_actor(caf::actor_system&, const std::string& device)> make_pool) {
  return system.spawn(solver_choice, std::move(common), std::move(make_pool));
}

}  // namespace tedit::actors
