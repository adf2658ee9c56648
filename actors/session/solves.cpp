// SPDX-License-Identifier: AGPL-3.0-or-later

#include "actors/errors.hpp"
#include "actors/session/numbers.hpp"
#include "actors/session/session.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

/// Load cases whose results stay at hand, so that undo shows its field at once. The last solve's
/// stay however many it has.
constexpr std::size_t most_results = 8;

}  // namespace

void session_state::take_over(session_remains& before) {
  followed = before.followed;
  for (auto& one : before.results)
    if (graph.find(one.key.version)) {
      one.event.document = parts.document;
      results.push_back(std::move(one));
    }
}

caf::result<solved> session_state::solve(const solve_request& request) {
  auto promise = self->make_response_promise<solved>();
  followed = request;
  followed->ticket = 0;
  followed->client = nullptr;
  start_solve(request, promise);
  return promise;
}

const session_state::kept_result* session_state::result_of(const graph_node& node) const {
  const auto version = to_hex(node.info.id);
  const auto is_of_node = [&](const kept_result& one) {
    return one.key.version == version &&
           std::ranges::all_of(one.key.load_cases, [&](const fem::load_case& loads) {
             return std::ranges::count(*node.load_cases, loads) > 0;
           });
  };
  const auto found = std::ranges::find_if(results, is_of_node);
  return found == results.end() ? nullptr : &*found;
}

held_result session_state::held() const {
  const auto* head = graph.head();
  if (!head)
    return {};
  const auto version = to_hex(head->info.id);
  if (active && active->key.version == version)
    return {std::nullopt, true};
  const auto* found = result_of(*head);
  return {found ? with_fields(*found, head->mesh) : std::nullopt, false};
}

std::optional<solved> session_state::with_fields(const kept_result& result,
                                                 const version_ptr& mesh) const {
  auto fields = parts.results->find(result.shown);
  if (!fields)
    return std::nullopt;
  auto event = result.event;
  event.version = mesh;
  event.fields = std::move(fields);
  return event;
}

void session_state::follow_head() {
  if (followed)
    start_solve(*followed, std::nullopt);
}

expected<load_case_list> cases_named(const graph_node& node,
                                     const std::vector<std::string>& names) {
  load_case_list chosen;
  for (const auto& wanted : names) {
    const auto found = std::ranges::find(*node.load_cases, wanted, &fem::load_case::name);
    if (found == node.load_cases->end())
      return fail(ec::not_found, "there is no load case \"" + wanted + "\"",
                  "Set the load case first");
    chosen.push_back(*found);
  }
  return chosen;
}

expected<load_case_list> session_state::chosen_cases(const solve_request& request,
                                                     std::vector<std::string>& names) const {
  const auto* head = graph.head();
  if (!head)
    return fail(empty_document());
  const auto& known = head->info.load_cases;
  if (known.empty() && request.load_cases.empty())
    return fail(ec::not_found, "this version has no load case", "Set the load case first");
  names = request.load_cases;
  if (request.all_load_cases)
    names = known;
  else if (names.empty())
    names = {known.front()};
  return cases_named(*head, names);
}

void session_state::start_solve(const solve_request& request,
                                std::optional<caf::typed_response_promise<solved>> promise) {
  active_solve next;
  next.asked_for = promise.has_value();
  if (promise)
    next.waiting.push_back({request.ticket, request.client, *promise});
  auto chosen = chosen_cases(request, next.names);
  const auto* head = graph.head();
  if (head)
    next.mesh = head->mesh;
  next.key.version = head ? to_hex(head->info.id) : std::string();
  if (!chosen) {
    for (auto& waiter : next.waiting)
      waiter.promise.deliver(to_caf(chosen.error()));
    return tell(next, solve_phase::failed, render(chosen.error()));
  }
  next.key = {next.key.version,
              std::move(*chosen),
              request.device.empty() ? parts.device : request.device,
              request.tolerance,
              request.energy_tolerance,
              request.element_order};

  const auto kept = std::ranges::find(results, next.key, &kept_result::key);
  if (const auto event = kept == results.end() ? std::nullopt : with_fields(*kept, next.mesh)) {
    results.splice(results.begin(), results, kept);
    end_active_solve(ec::superseded, "a newer version is the head", solve_phase::superseded);
    broadcast(*event, next.askers());
    if (promise)
      promise->deliver(*event);
    return;
  }
  if (kept != results.end())
    results.erase(kept);
  if (active && active->key == next.key) {
    active->waiting.insert(active->waiting.end(), next.waiting.begin(), next.waiting.end());
    return tell_progress();
  }
  end_active_solve(ec::superseded, "a newer version is the head", solve_phase::superseded);
  next.job = new_job(request.ticket, request.client);
  launch(std::move(next));
}

void session_state::launch(active_solve next) {
  const auto job = next.job;
  active = std::move(next);
  tell(*active, solve_phase::started);
  self
    ->request(parts.workers.solver, answer_limit, job,
              order_of(active->key, active->mesh, base_order(job)))
    .then([=, this](const solve_result& result) { receive_result(job, result); },
          [=, this](const caf::error& e) { fail_solve(job, from_caf(e, "the solve")); });
}

solve_order session_state::order_of(const solve_key& key, const version_ptr& mesh,
                                    const order_base& base) const {
  return {base,          make_ref(mesh),       wire_value(key.load_cases), key.device,
          key.tolerance, key.energy_tolerance, key.element_order};
}

void session_state::fetch_all_fields(
  const kept_result& result, const version_ptr& mesh, const order_base& base,
  const std::function<void(const solve_result&, const page_set&)>& use,
  const std::function<void(const error&)>& refuse) {
  const auto take = [=, this](const solve_result& solved_now,
                              const std::function<void(const error&)>& failed) {
    auto ids = pages_of(solved_now.fields);
    const auto more = pages_of(solved_now.more);
    ids.insert(ids.end(), more.begin(), more.end());
    pull(
      solved_now.source, ids, [=](const page_set& pages) { use(solved_now, pages); }, failed);
  };
  const auto solve_again = [=, this,
                            order = order_of(result.key, mesh, base)](const error& e) mutable {
    logging::info("{}: solving again for a file: {}", parts.document, render(e));
    order.base.listener = nullptr;
    order.in_one_place = true;
    const auto job = new_job(0, nullptr);
    self->request(parts.workers.solver, answer_limit, job, order)
      .then(
        [=, this, held = mesh](const solve_result& again) {
          progress_of.erase(job);
          take(again, refuse);
        },
        [=, this](const caf::error& failure) {
          progress_of.erase(job);
          refuse(from_caf(failure, "the solve"));
        });
  };
  take(result.fields, solve_again);
}

bool session_state::leave_solve(std::uint64_t ticket) {
  if (!active)
    return false;
  auto& waiting_for_it = active->waiting;
  const auto found = std::ranges::find(waiting_for_it, ticket, &solve_waiter::ticket);
  if (found == waiting_for_it.end())
    return false;
  if (active->asked_for && waiting_for_it.size() == 1) {
    followed.reset();
    end_active_solve(ec::cancelled, "the solve was cancelled", solve_phase::cancelled);
    return true;
  }
  auto promise = std::move(found->promise);
  waiting_for_it.erase(found);
  tell_progress();
  promise.deliver(to_caf({ec::cancelled, "the request was cancelled", {}, {}}));
  return true;
}

/// Who waits longest hears how far the solve is.
void session_state::tell_progress() {
  auto& [ticket, client] = progress_of[active->job];
  ticket = active->waiting.empty() ? 0 : active->waiting.front().ticket;
  client = active->waiting.empty() ? caf::actor{} : active->waiting.front().client;
}

void session_state::end_active_solve(ec code, const std::string& why, solve_phase phase) {
  if (!active)
    return;
  auto ended = std::move(*active);
  active.reset();
  progress_of.erase(ended.job);
  caf::anon_send(parts.workers.solver, cancel_atom::value, ended.job);
  for (auto& waiter : ended.waiting)
    waiter.promise.deliver(to_caf({code, why, {}, {}}));
  tell(ended, phase);
}

acknowledged session_state::end_solve() {
  end_active_solve(ec::cancelled, "the solve was cancelled", solve_phase::cancelled);
  return {};
}

void session_state::keep_result(kept_result result) {
  results.push_front(std::move(result));
  std::size_t cases = 0;
  const auto full = [&](const kept_result& one) {
    return (cases += one.key.load_cases.size()) > most_results && &one != &results.front();
  };
  results.erase(std::ranges::find_if(results, full), results.end());
}

void session_state::receive_result(job_id job, const solve_result& result) {
  open_fields(
    job, result,
    [=, this](const std::shared_ptr<const std::vector<field>>& fields,
              const std::vector<field_ref>& left) {
      auto done = std::move(*active);
      active.reset();
      progress_of.erase(job);
      numbers::solves().add();
      const auto outcome = *result.outcome.get();  // Read when the fields were opened.
      const solved event{parts.document, done.mesh, outcome, fields, job.value};
      auto kept = event;
      kept.fields.reset();
      kept.version.reset();
      keep_result({std::move(done.key), std::move(kept), result,
                   parts.results->keep(fields, bytes_of(*fields)), left});
      broadcast(event, done.askers());
      for (auto& waiter : done.waiting)
        waiter.promise.deliver(event);
    },
    [=, this](const error& e) { retry_solve(job, e); });
}

/// Its worker may have died after it answered, and the fields with it.
void session_state::retry_solve(job_id job, const error& e) {
  if (!active || active->job != job || !worth_a_retry(e) || active->retries++ >= most_retries)
    return fail_solve(job, e);
  logging::warn("{}: {}: solving again", parts.document, render(e));
  auto again = std::move(*active);
  const auto [ticket, client] = std::move(progress_of.extract(job).mapped());
  again.job = new_job(ticket, client);
  launch(std::move(again));
}

void session_state::on_preview(const job_preview& preview) {
  open_fields(
    preview.job, preview.result,
    [=, this](const std::shared_ptr<const std::vector<field>>& fields,
              const std::vector<field_ref>&) {
      broadcast(solved{parts.document, active->mesh, *preview.result.outcome.get(), fields,
                       preview.job.value});
    },
    [=, this](const error& e) {
      // The result itself still comes.
      logging::debug("{}: no preview: {}", parts.document, render(e));
    });
}

void session_state::fail_solve(job_id job, const error& e) {
  progress_of.erase(job);
  if (!active || active->job != job)
    return;
  auto failed = std::move(*active);
  active.reset();
  numbers::failed_solves().add();
  logging::warn("{}: solve failed: {}", parts.document, render(e));
  for (auto& waiter : failed.waiting)
    waiter.promise.deliver(to_caf(e));
  tell(failed, solve_phase::failed, render(e));
}

void session_state::on_frame(const job_frame& frame) {
  if (!active || active->job != frame.job)
    return;
  broadcast(solve_note{parts.document,
                       active->key.version,
                       active->names,
                       solve_phase::converging,
                       frame.iterations,
                       frame.residual,
                       {}});
}

void session_state::tell(const active_solve& which, solve_phase phase, const std::string& message) {
  const bool over = phase != solve_phase::started && phase != solve_phase::converging;
  broadcast(solve_note{parts.document, which.key.version, which.names, phase, 0, 1, message},
            over ? which.askers() : std::set<caf::actor>());
}

}  // namespace tedit::actors
