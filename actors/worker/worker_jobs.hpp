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
#include "actors/worker/job_thread.hpp"
#include "base/execution.hpp"
#include "base/process_usage.hpp"

namespace tedit::actors {

/// What a job yields, and the pages that others will fetch: they stay in memory until then.
template <class Result>
struct job_output {
  Result result;
  std::vector<page_ptr> pages;

  void keep_pages(const version_ptr& version) {
    version->for_each_page([&](const page_ptr& p) { pages.push_back(p); });
  }
};

/// What all kinds of workers share: fetching the pages of an order, running it on the thread,
/// progress, cancel, and keeping results alive until they are fetched.
struct worker_jobs {
  worker_role role = worker_role::modeling;
  std::shared_ptr<page_cache> cache;
  page_store_actor pages;
  caf::actor pages_handle;  ///< The same, as orders and results carry it.
  job_thread_actor thread;
  std::map<job_id, cancel_token> running;
  std::deque<std::vector<page_ptr>> kept;  ///< Of the last results.
  /// Of a worker's own process at its start: it is looked at after each job. Else none is.
  std::optional<process_usage> at_start;

  ~worker_jobs() {
    // The thread outlives the actor until its job notices.
    for (const auto& [id, token] : running)
      token.cancel();
  }

  void cancel(job_id job) const {
    if (const auto found = running.find(job); found != running.end())
      found->second.cancel();
  }

  void keep(std::vector<page_ptr> pages) {
    constexpr std::size_t most = 4;
    for (const auto& p : pages)
      cache->put(p);
    kept.push_back(std::move(pages));
    if (kept.size() > most)
      kept.pop_front();
  }

  [[nodiscard]] worker_status status() const;

  /// Why this process must not be given another job; nothing while it may.
  [[nodiscard]] std::optional<std::string> reason_to_retire() const {
    return at_start ? used_up(*at_start, usage_of_this_process()) : std::nullopt;
  }
};

/// An execution that reports to `tell`, on the working thread, at most 20 times a second.
[[nodiscard]] execution make_execution(
  cancel_token token, std::function<void(double fraction, std::string_view stage)> tell);

/// One that reports so to the listener of an order, if it has one.
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

/// What a job works on, as its order names it.
struct job_needs {
  std::optional<version_ref> version;
  hash_list pages;  ///< Beside those of the version.
};

/// The same, fetched and opened. Without a version in the order there is none.
struct job_input {
  version_ptr mesh;
  page_set pages;
};

/// Opens the version, then runs `work`.
template <class Result, class Work>
expected<job_output<Result>> open_and_run(const job_needs& needs, const page_set& pages,
                                          const Work& work, const execution& run) {
  job_input input{nullptr, pages};
  if (needs.version) {
    auto mesh = open_version(*needs.version, pages);
    if (!mesh)
      return fail(mesh.error());
    input.mesh = std::move(*mesh);
  }
  return work(input, run);
}

/// Fetches what is needed, opens the version, runs `work` on the thread and answers with its
/// result, whose pages others may fetch from here. `Self` is the pointer of a stateful actor whose
/// state has a member `jobs`.
template <class Result, class Self>
caf::result<Result> perform(
  Self self, job_id job, const order_base& order, job_needs needs,
  std::function<expected<job_output<Result>>(const job_input&, const execution&)> work) {
  using output = job_output<Result>;
  auto needed = needs.pages;
  if (needs.version) {
    const auto more = pages_of(*needs.version);
    if (!more)
      return to_caf(more.error());
    needed.insert(needed.end(), more->begin(), more->end());
  }
  // Before the promise, which takes the sender over.
  const auto pool = caf::actor_cast<caf::actor>(self->current_sender());
  const auto promise = std::make_shared<caf::typed_response_promise<Result>>(
    self->template make_response_promise<Result>());
  const cancel_token token;
  self->state.jobs.running.insert_or_assign(job, token);
  const auto refuse = [=](const error& e) {
    self->state.jobs.running.erase(job);
    promise->deliver(to_caf(e));
  };
  const auto run_on_thread = [=](const page_set& pages) {
    auto slot = std::make_shared<std::optional<expected<output>>>();
    const auto run = make_execution(job, order, token);
    job_task task{[=] {
      *slot = token.cancelled()
                ? expected<output>(fail(ec::cancelled, "the work was cancelled"))
                : guarded<output>([&] { return open_and_run<Result>(needs, pages, work, run); });
    }};
    self->request(self->state.jobs.thread, std::chrono::minutes(24 * 60), std::move(task))
      .then(
        [=](acknowledged) {
          if (const auto why = self->state.jobs.reason_to_retire())
            caf::unsafe_send_as(self, pool, retirement{*why});
          if (!(*slot)->has_value())
            return refuse((*slot)->error());
          self->state.jobs.running.erase(job);
          auto& done = ***slot;
          self->state.jobs.keep(std::move(done.pages));
          if constexpr (requires { done.result.source; })
            done.result.source = self->state.jobs.pages_handle;
          promise->deliver(std::move(done.result));
        },
        [=](const caf::error& e) { refuse(from_caf(e, "the work")); });
  };
  self
    ->request(self->state.jobs.pages, std::chrono::minutes(10), fetch_atom::value, order.source,
              needed)
    .then(run_on_thread, [=](const caf::error& e) { refuse(from_caf(e, "fetching pages")); });
  return *promise;
}

/// The jobs of a worker in this process; on a thread of their own unless one is given.
template <class Self>
worker_jobs make_jobs(Self self, worker_role role, std::shared_ptr<page_cache> cache,
                      const page_store_actor& pages, job_thread_actor thread = {}) {
  worker_jobs jobs;
  jobs.role = role;
  jobs.cache = std::move(cache);
  jobs.pages = pages;
  jobs.pages_handle = caf::actor_cast<caf::actor>(pages);
  jobs.thread = thread ? thread : self->template spawn<job_thread, caf::linked + caf::detached>();
  return jobs;
}

}  // namespace tedit::actors
