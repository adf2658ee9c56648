// SPDX-License-Identifier: AGPL-3.0-or-later
// From an operation to a checked candidate, and the previews that show one.
#include "actors/session/candidate.hpp"

#include "actors/errors.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

error cancelled_edit() {
  return {ec::cancelled, "the edit was cancelled", {}, {}};
}

}  // namespace

// -- the operation, then the checks --------------------------------------------------------------

void session_state::make_candidate(const std::shared_ptr<candidate_run>& run) {
  const auto& request = run->request;
  const auto job = new_job(request.ticket, request.client);
  edit_order order{base_order(job), make_ref(run->base), wire_value(request.wanted),
                   run->preview,    run->find_most,      run->draft,
                   parts.document,  request.terms.client};
  run->cancel_job = [=, this] { caf::anon_send(parts.workers.modeling, cancel_atom::value, job); };
  self->request(parts.workers.modeling, answer_limit, job, std::move(order))
    .then(
      [=, this](const operation_result& candidate) {
        progress_of.erase(job);
        if (run->ended)
          return;
        const auto ids = pages_of(candidate.version);
        if (!ids)
          return run->refuse(ids.error());
        // The pages are taken over at once: the plugin's process may die now.
        pull(
          candidate.source, *ids,
          [=, this](const page_set& pages) {
            run->pages = pages;
            check_candidate(run, candidate);
          },
          [=, this](const error& e) { retry_candidate(run, e); });
      },
      [=, this](const caf::error& e) {
        progress_of.erase(job);
        if (!run->ended)
          run->refuse(from_caf(e, "the operation " + run->request.wanted.operation));
      });
}

void session_state::check_candidate(const std::shared_ptr<candidate_run>& run,
                                    const operation_result& candidate) {
  if (run->ended)
    return;
  if (run->cancelled)
    return run->refuse(cancelled_edit());
  const auto job = new_job(run->request.ticket, run->request.client);
  check_order order{base_order(job),
                    make_ref(run->base),
                    candidate,
                    wire_value(run->request.wanted),
                    wire_value(run->load_cases),
                    run->preview,
                    run->draft};
  order.candidate.source = nullptr;
  run->cancel_job = [=, this] { caf::anon_send(parts.workers.optimizer, cancel_atom::value, job); };
  self->request(parts.workers.optimizer, answer_limit, job, std::move(order))
    .then(
      [=, this](const check_result& result) {
        progress_of.erase(job);
        if (!run->ended)
          accept_candidate(run, result);
      },
      [=, this](const caf::error& e) {
        progress_of.erase(job);
        retry_candidate(run, from_caf(e, "checking the edit"));
      });
}

void session_state::accept_candidate(const std::shared_ptr<candidate_run>& run,
                                     const check_result& result) {
  const auto ids = pages_of(result.version);
  const auto report = result.report.get();
  const auto load_cases = result.load_cases.get();
  if (!ids || !report || !load_cases)
    return retry_candidate(run, !ids ? ids.error() : !report ? report.error() : load_cases.error());
  const auto use = [=, this](const page_set& pages) {
    if (run->ended)
      return;
    auto mesh = open_version(result.version, pages);
    if (!mesh)
      return retry_candidate(run, mesh.error());
    run->done(
      std::make_shared<const checked_candidate>(checked_candidate{*mesh, *load_cases, *report}));
  };
  pull(result.source, *ids, use, [=, this](const error& e) { retry_candidate(run, e); });
}

void session_state::retry_candidate(const std::shared_ptr<candidate_run>& run, const error& e) {
  if (run->ended)
    return;
  if (worth_a_retry(e) && !run->cancelled && run->retries++ < most_retries) {
    logging::warn("{}: {}: doing the edit again", parts.document, render(e));
    return make_candidate(run);
  }
  run->refuse(e);
}

// -- previews ------------------------------------------------------------------------------------

/// A preview waits behind nothing: while something changes the document it would show what nobody
/// gets, so it is refused, and what comes later ends it.
caf::result<previewed> session_state::preview(const preview_request& wanted) {
  const auto& request = wanted.edit;
  if (const auto refusal = check_expected(request.terms))
    return *refusal;
  const auto* head = graph.head();
  if (!head)
    return to_caf(empty_document());
  if (running || !waiting.empty())
    return to_caf({ec::superseded,
                   "the document is being changed",
                   "Ask for the preview again when that is done",
                   {}});
  if (last_preview && last_preview->serves(request, *head))
    return describe_preview(*last_preview);
  auto run = std::make_shared<preview_run>();
  run->promise = self->make_response_promise<previewed>();
  run->work = std::make_shared<candidate_run>();
  run->work->request = request;
  run->work->base = head->mesh;
  run->work->load_cases = head->load_cases;
  run->work->preview = true;
  run->work->find_most = wanted.find_most;
  run->work->draft = wanted.draft;
  const auto ticket = request.ticket;
  run->work->done = [=, this,
                     clock = stopwatch()](const std::shared_ptr<const checked_candidate>& made) {
    finish_preview(ticket, made, clock.milliseconds());
  };
  run->work->refuse = [=, this](const error& e) { end_preview(ticket, e); };
  previews[ticket] = run;
  make_candidate(run->work);
  return run->promise;
}

void session_state::finish_preview(std::uint64_t ticket,
                                   const std::shared_ptr<const checked_candidate>& made,
                                   double ms) {
  const auto run = std::move(previews.extract(ticket).mapped());
  auto timed = std::make_shared<checked_candidate>(*made);
  timed->report = made->timed_report(ms);
  const kept_candidate candidate{run->work->request, run->work->base, run->work->load_cases,
                                 std::move(timed)};
  auto answer = describe_preview(candidate);
  answer.draft = run->work->draft;
  if (!answer.draft)
    last_preview = std::make_shared<const kept_candidate>(candidate);
  run->promise.deliver(std::move(answer));
}

/// Answers at once; the worker ends when it notices, and nobody hears of it.
void session_state::end_preview(std::uint64_t ticket, const error& why) {
  const auto found = previews.find(ticket);
  if (found == previews.end())
    return;
  const auto run = found->second;
  previews.erase(found);
  run->work->ended = true;
  run->work->cancel();
  run->promise.deliver(to_caf(why));
}

void session_state::end_previews(const error& why) {
  while (!previews.empty())
    end_preview(previews.begin()->first, why);
}

previewed session_state::describe_preview(const kept_candidate& candidate) const {
  return {parts.document, candidate.base, candidate.made->mesh, candidate.made->report,
          candidate.made->load_cases};
}

}  // namespace tedit::actors
