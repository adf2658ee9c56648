// SPDX-License-Identifier: AGPL-3.0-or-later
#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/links/open_actors.hpp"
#include "actors/supervisor/job_estimate.hpp"
#include "actors/supervisor/pool.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

template <class Role>
using pool_pointer = typename Role::template stateful_pointer<pool_state>;

/// The handler of one kind of order: queues it and answers when some worker has done it.
template <class Role, class Order, class Result>
auto job_handler(pool_pointer<Role> self) {
  return [=](job_id id, const Order& order) -> caf::result<Result> {
    using promise_type = caf::typed_response_promise<Result>;
    auto promise = std::make_shared<promise_type>(self->template make_response_promise<Result>());
    pool_state::job job;
    job.id = id;
    if constexpr (std::is_same_v<Order, edit_order>)
      if (const auto wanted = order.wanted.get())
        job.edit = {(*wanted)->operation, order.document, order.client};
    job.needs = estimate(order);
    const auto& listener = order.base.listener;
    job.listener = listener;
    job.place = {urgency::edit, order.base.client, listener ? listener.id() : 0};
    job.trace = order.base.trace;
    if constexpr (std::is_same_v<Order, export_order>)
      job.place.what = urgency::file;
    if constexpr (requires { order.preview; })
      if (order.preview)
        job.place.what = urgency::preview;
    job.refuse = [=](const error& e) { promise->deliver(to_caf(e)); };
    job.send = [=](const caf::actor& worker, int attempt) {
      // The pool's own clock ends what takes too long; this limit is only a net below it.
      const auto limit = self->state.options.job_limit + std::chrono::minutes(1);
      self->request(caf::actor_cast<Role>(worker), limit, id, order)
        .then(
          [=](Result& result) {
            if (!self->state.is_current(id, attempt))
              return;
            promise->deliver(std::move(result));
            self->state.complete(id, true);
          },
          [=](const caf::error& e) {
            if (!self->state.is_current(id, attempt))
              return;  // Its worker died long ago and another has the job.
            const auto failure = from_caf(e, "the work");
            if (e.category() != caf::atom("tedit"))
              return self->state.give_up_on(id, "failed: " + failure.message);
            promise->deliver(to_caf(self->state.reason_of(id, failure)));
            self->state.complete(id, false);
          });
    };
    self->state.add(std::move(job));
    return *promise;
  };
}

/// What the process behind one link talks to before it is a worker. A process cannot speak for
/// another: `number` is the child that inherited the other end.
caf::behavior make_enlister(caf::event_based_actor* self, const caf::actor& pool,
                            std::uint64_t number) {
  heed_only_own_exits(self);
  return {[=](const enlistment& who) {
    auto promise = self->make_response_promise<bool>();
    self->request(pool, std::chrono::seconds(5), number, who)
      .then([=](bool accepted) mutable { promise.deliver(accepted); },
            [=](const caf::error&) mutable { promise.deliver(false); });
    return promise;
  }};
}

/// Notes, processes and time: what a pool handles beside its role.
template <class Role>
void start_pool(pool_pointer<Role> self, pool_options options) {
  auto& state = self->state;
  state.start(self, std::move(options));
  const auto own = caf::actor_cast<caf::actor>(self);
  open_to_workers(own);
  self->set_down_handler([=](caf::down_msg& down) { self->state.on_down(down.source); });
  heed_only_own_exits(self, [=] { self->state.stop(); });
  self->set_default_handler([=](caf::scheduled_actor*,
                                caf::message_view& view) -> caf::result<caf::message> {
    auto message = view.move_content_to_message();
    caf::message answer;
    message.apply(
      {[&](std::uint64_t number, const enlistment& who) {
         answer = caf::make_message(is_asked_from_here(self) && self->state.enlist(number, who));
       },
       [&](const remote_worker& guest) { answer = caf::make_message(self->state.welcome(guest)); },
       [&](const retirement& note) {
         self->state.retire(caf::actor_cast<caf::actor_addr>(self->current_sender()), note.why);
       },
       [&](const retirement& note, const caf::actor_addr& worker) {
         if (is_asked_from_here(self))
           self->state.retire(worker, note.why);
       },
       [&](tick_atom, std::uint64_t number) { self->state.on_tick(number); }});
    return answer;
  });
  state.make_enlister = [=](std::uint64_t number) {
    return self->spawn(make_enlister, own, number);
  };
  state.call_tick = [=](std::chrono::milliseconds wait, std::uint64_t number) {
    caf::delayed_anon_send(own, wait, tick_atom::value, number);
  };
  state.spawn_missing();
  state.tick_after(pool_state::tick_interval);
}

/// What the first worker said, without the operations that are switched off since. All workers of a
/// server say the same.
caf::result<shared_catalogue> catalogue_of(pool_pointer<modeling_actor> self) {
  auto& state = self->state;
  if (state.catalogue)
    return shared_catalogue(state.off.apply_to(*state.catalogue));
  const auto promise = std::make_shared<caf::typed_response_promise<shared_catalogue>>(
    self->make_response_promise<shared_catalogue>());
  const auto refuse = [=](const error& e) { promise->deliver(to_caf(e)); };
  const auto ask = [=](const caf::actor& worker) {
    self
      ->request(caf::actor_cast<modeling_actor>(worker), std::chrono::seconds(30),
                catalog_atom::value)
      .then(
        [=](const shared_catalogue& said) {
          const auto all = said.get();
          if (!all)
            return refuse(all.error());
          self->state.catalogue = *all;
          promise->deliver(shared_catalogue(self->state.off.apply_to(**all)));
        },
        [=](const caf::error& e) { refuse(from_caf(e, "the catalogue")); });
  };
  state.ask({ask, refuse});
  return *promise;
}

modeling_actor::behavior_type modeling_pool(pool_pointer<modeling_actor> self,
                                            pool_options options) {
  start_pool<modeling_actor>(self, std::move(options));
  return {job_handler<modeling_actor, import_order, import_result>(self),
          job_handler<modeling_actor, edit_order, operation_result>(self),
          job_handler<modeling_actor, export_order, export_result>(self),
          job_handler<modeling_actor, select_order, select_result>(self),
          [=](catalog_atom) { return catalogue_of(self); },
          [=](cancel_atom, job_id id) { self->state.cancel(id); },
          [=](status_atom) { return self->state.status(); }};
}

optimizer_actor::behavior_type optimizer_pool(pool_pointer<optimizer_actor> self,
                                              pool_options options) {
  start_pool<optimizer_actor>(self, std::move(options));
  return {job_handler<optimizer_actor, check_order, check_result>(self),
          [=](cancel_atom, job_id id) { self->state.cancel(id); },
          [=](status_atom) { return self->state.status(); }};
}

solver_actor::behavior_type solver_pool(pool_pointer<solver_actor> self, pool_options options) {
  start_pool<solver_actor>(self, std::move(options));
  return {job_handler<solver_actor, solve_order, solve_result>(self),
          [=](cancel_atom, job_id id) { self->state.cancel(id); },
          [=](status_atom) { return self->state.status(); }};
}

}  // namespace

modeling_actor make_modeling_pool(caf::actor_system& system, pool_options options) {
  return system.spawn(modeling_pool, std::move(options));
}

optimizer_actor make_optimizer_pool(caf::actor_system& system, pool_options options) {
  return system.spawn(optimizer_pool, std::move(options));
}

solver_actor make_solver_pool(caf::actor_system& system, pool_options options) {
  return system.spawn(solver_pool, std::move(options));
}

}  // namespace tedit::actors
