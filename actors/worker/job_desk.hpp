// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <optional>

#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/interfaces.hpp"
#include "actors/pages/page_cache.hpp"
#include "actors/versions.hpp"
#include "base/execution.hpp"
#include "base/process_usage.hpp"

namespace tedit::actors {

/// Work for a bench. Runs on the bench's own thread and must not throw.
struct job_task {
  std::function<void()> run;
};

/// A thread that does one piece of work after the other, so that the actor that owns it always
/// answers at once.
using bench_actor = caf::typed_actor<caf::replies_to<job_task>::with<acknowledged>>;

/// A class, since CAF 0.17 dereferences a null pointer when it starts a function without arguments.
class bench final : public bench_actor::base {
public:
  using bench_actor::base::base;
  behavior_type make_behavior() override;
};

/// What a job yields, and what must stay in memory until others have fetched it.
template <class Result>
struct job_output {
  Result result;
  std::shared_ptr<const void> keep;
};

/// What all kinds of workers share: fetching the pages of an order, running it on the bench,
/// progress, cancel, and keeping results alive until they are fetched.
struct job_desk {
  std::string role;
  std::shared_ptr<page_cache> cache;
  page_store_actor pages;
  caf::actor pages_handle;  ///< The same, as orders and results carry it.
  bench_actor bench;
  std::map<job_id, cancel_token> running;
  std::deque<std::shared_ptr<const void>> kept;
  /// Of a worker's own process at its start: it is looked at after each job. Else none is.
  std::optional<process_usage> at_start;

  ~job_desk() {
    // The thread of the bench outlives the actor until its job notices.
    for (const auto& [id, token] : running)
      token.cancel();
  }

  void cancel(job_id job) const {
    if (const auto found = running.find(job); found != running.end())
      found->second.cancel();
  }

  void keep(std::shared_ptr<const void> result) {
    constexpr std::size_t most = 4;
    kept.push_back(std::move(result));
    if (kept.size() > most)
      kept.pop_front();
  }

  [[nodiscard]] worker_status status() const;

  /// Why this process must not be given another job; nothing while it may.
  [[nodiscard]] std::optional<std::string> reason_to_retire() const {
    return at_start ? used_up(*at_start, usage_of_this_process()) : std::nullopt;
  }
};

/// An execution that reports to the listener of an order at most 20 times a second.
[[nodiscard]] execution make_execution(job_id job, const order_base& order, cancel_token token);

/// Calls `work` and turns what it throws into errors.
template <class Output>
expected<Output> guarded(const std::function<expected<Output>()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "a worker has not enough memory for this",
                "Take a coarser mesh, or a machine with more memory");
  } catch (const std::exception& e) {
    return fail(ec::internal, e.what(), "This is a defect of TEdit: please report it");
  }
}

/// Fetches `needed`, runs `work` on the bench and answers with its result. `Self` is the pointer
/// of a stateful actor whose state has a member `desk`.
template <class Result, class Self>
caf::result<Result> perform(
  Self self, job_id job, const order_base& order, const hash_list& needed,
  std::function<expected<job_output<Result>>(const page_set&, const execution&)> work) {
  using output = job_output<Result>;
  // Before the promise, which takes the sender over.
  const auto pool = caf::actor_cast<caf::actor>(self->current_sender());
  const auto promise = std::make_shared<caf::typed_response_promise<Result>>(
    self->template make_response_promise<Result>());
  const cancel_token token;
  self->state.desk.running.insert_or_assign(job, token);
  const auto refuse = [=](const error& e) {
    self->state.desk.running.erase(job);
    promise->deliver(to_caf(e));
  };
  const auto run_on_bench = [=](const page_set& pages) {
    auto slot = std::make_shared<std::optional<expected<output>>>();
    const auto run = make_execution(job, order, token);
    job_task task{[=] {
      *slot = token.cancelled() ? expected<output>(fail(ec::cancelled, "the work was cancelled"))
                                : guarded<output>([&] { return work(pages, run); });
    }};
    self->request(self->state.desk.bench, std::chrono::minutes(24 * 60), std::move(task))
      .then(
        [=](acknowledged) {
          if (const auto why = self->state.desk.reason_to_retire())
            caf::unsafe_send_as(self, pool, retirement{*why});
          if (!(*slot)->has_value())
            return refuse((*slot)->error());
          self->state.desk.running.erase(job);
          self->state.desk.keep((**slot)->keep);
          promise->deliver(std::move((**slot)->result));
        },
        [=](const caf::error& e) { refuse(from_caf(e, "the work")); });
  };
  self
    ->request(self->state.desk.pages, std::chrono::minutes(10), fetch_atom::value, order.source,
              needed)
    .then(run_on_bench, [=](const caf::error& e) { refuse(from_caf(e, "fetching pages")); });
  return *promise;
}

/// The desk of a worker in this process.
template <class Self>
job_desk make_desk(Self self, std::string role, std::shared_ptr<page_cache> cache,
                   page_store_actor pages) {
  job_desk desk;
  desk.role = std::move(role);
  desk.cache = std::move(cache);
  desk.pages = pages;
  desk.pages_handle = caf::actor_cast<caf::actor>(pages);
  desk.bench = self->template spawn<bench, caf::linked + caf::detached>();
  return desk;
}

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::job_task)
