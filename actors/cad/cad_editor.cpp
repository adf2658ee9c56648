// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/cad/cad_editor.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "actors/cad/cad_rows.hpp"
#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/session/session.hpp"
#include "actors/worker/worker_jobs.hpp"
#include "cad/replay.hpp"

namespace tedit::actors {

namespace {

using editor_pointer = cad_editor_actor::stateful_pointer<cad_editor_state>;

/// So much CPU as in the commands of files. By the clock it may take far longer, as it gives way to
/// all others; beyond that it is no verdict: what is in a document must not depend on how busy the
/// machine was.
constexpr cad::program_limits edit_limits{std::chrono::seconds(20), std::uint64_t{2} << 30,
                                          std::uint64_t{1} << 28, std::chrono::minutes(20)};

/// This thread, and the programs that it starts: they run where nobody else wants to, and leave the
/// processor the moment that somebody does.
void give_way() {
  const char* wanted = std::getenv("TEDIT_CAD_PRIORITY");
  if (wanted && std::string_view(wanted) == "normal")
    return;
  constexpr int last_of_all = 19;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), last_of_all);
  const sched_param none{};
  sched_setscheduler(0, SCHED_IDLE, &none);
}

expected<cad_outcome> carry_out(const cad_order& order, const ops::operation_description* about,
                                const cancel_token& token) {
  if (token.cancelled())
    return fail(ec::cancelled, "the edit on the CAD model was cancelled");
  const auto outcome = [](store::cad_row row) {
    return cad_outcome{std::make_shared<const store::cad_row>(std::move(row))};
  };
  if (!about || !order.report)
    return outcome(row_without_model(unknown_request));
  const auto model = model_in(*order.model);
  if (!model)
    return fail(model.error());
  auto made = cad::replay_edit(
    {*model, *about, order.before, order.after, order.wanted, *order.report, edit_limits},
    execution{token, {}});
  if (!made)
    return fail(made.error());
  if (!made->verdict.is_same)
    return outcome(row_without_model(std::move(made->verdict.reason)));
  return outcome(row_with(made->model, 1e-3 * made->verdict.deviation_mm));
}

void begin_tasks(editor_pointer self);

void start(editor_pointer self, cad_editor_state::task task, const cancel_token& token) {
  auto& state = self->state;
  const auto thread = state.free_threads.back();
  state.free_threads.pop_back();
  auto slot = std::make_shared<std::optional<expected<cad_outcome>>>();
  job_task work{[slot, token, order = task.order, operations = state.operations] {
    const auto& all = operations->operations;
    const auto offered = std::ranges::find_if(
      all, [&](const auto& one) { return one.about.id == order->wanted.operation; });
    const auto* about = offered == all.end() ? nullptr : &offered->about;
    *slot = guarded<cad_outcome>([&] { return carry_out(*order, about, token); });
  }};
  auto finish = [=](const error* failure) mutable {
    self->state.running.erase(task.job);
    self->state.free_threads.push_back(thread);
    if (failure)
      task.promise.deliver(to_caf(*failure));
    else if (!(*slot)->has_value())
      task.promise.deliver(to_caf((*slot)->error()));
    else
      task.promise.deliver(std::move(***slot));
    begin_tasks(self);
  };
  self->request(thread, answer_limit, std::move(work))
    .then([=](acknowledged) mutable { finish(nullptr); },
          [=](const caf::error& e) mutable {
            const auto failure = from_caf(e, "the edit on the CAD model");
            finish(&failure);
          });
}

/// Asked for when they are first needed: the workers may still be starting with the server.
void ask_for_operations(editor_pointer self) {
  self->request(self->state.modeling, std::chrono::minutes(10), catalog_atom::value)
    .then(
      [=](const shared_catalogue& all) {
        if (auto known = all.get()) {
          self->state.operations = *known;
          return begin_tasks(self);
        }
        for (auto& task : std::exchange(self->state.waiting, {}))
          task.promise.deliver(to_caf(all.get().error()));
      },
      [=](const caf::error& e) {
        for (auto& task : std::exchange(self->state.waiting, {}))
          task.promise.deliver(to_caf(from_caf(e, "listing the operations")));
      });
}

void begin_tasks(editor_pointer self) {
  auto& state = self->state;
  while (state.operations && !state.waiting.empty() && !state.free_threads.empty()) {
    auto task = std::move(state.waiting.front());
    state.waiting.pop_front();
    const cancel_token token;
    state.running.insert_or_assign(task.job, token);
    start(self, std::move(task), token);
  }
}

void cancel(cad_editor_state& state, job_id job) {
  if (const auto found = state.running.find(job); found != state.running.end())
    return found->second.cancel();
  const auto found = std::ranges::find(state.waiting, job, &cad_editor_state::task::job);
  if (found == state.waiting.end())
    return;
  auto promise = std::move(found->promise);
  state.waiting.erase(found);
  promise.deliver(to_caf({ec::cancelled, "the edit on the CAD model was cancelled", {}, {}}));
}

}  // namespace

cad_editor_state::~cad_editor_state() {
  for (const auto& [job, token] : running)
    token.cancel();
}

job_thread_actor spawn_background_thread(caf::actor_system& system) {
  auto thread = system.spawn<job_thread, caf::detached>();
  caf::anon_send(thread, job_task{give_way});
  return thread;
}

cad_editor_actor::behavior_type make_cad_editor(editor_pointer self, modeling_actor modeling,
                                                std::vector<job_thread_actor> threads) {
  heed_only_own_exits(self);
  self->state.modeling = std::move(modeling);
  for (const auto& one : threads)
    self->link_to(one);
  self->state.free_threads = std::move(threads);
  return {[=](job_id job, const cad_order& order) -> caf::result<cad_outcome> {
            auto promise = self->make_response_promise<cad_outcome>();
            auto& state = self->state;
            state.waiting.push_back({job, std::make_shared<const cad_order>(order), promise});
            if (state.operations)
              begin_tasks(self);
            else if (state.waiting.size() == 1)
              ask_for_operations(self);
            return promise;
          },
          [=](cancel_atom, job_id job) { cancel(self->state, job); }};
}

}  // namespace tedit::actors
