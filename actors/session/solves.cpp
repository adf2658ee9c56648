// SPDX-License-Identifier: AGPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "actors/errors.hpp"
#include "actors/session/session.hpp"
#include "actors/versions.hpp"

namespace tedit::actors {

namespace {

/// Results that stay at hand, so that undo shows its field at once.
constexpr std::size_t most_results = 8;

/// Two orders with one key have one result.
std::string key_of(const solve_order& order, const std::string& version) {
  char numbers[48];
  std::snprintf(numbers, sizeof(numbers), "|%.17g|%d|", order.tolerance, order.element_order);
  return version + "|" + order.device + numbers + order.load_case;
}

}  // namespace

caf::result<solved> session_state::solve(const solve_request& request) {
  auto promise = self->make_response_promise<solved>();
  solve_settings settings{request.load_case, request.tolerance, request.device,
                          request.element_order};
  followed = settings;
  start_solve(settings, request.ticket, request.client, promise);
  return promise;
}

void session_state::follow_head() {
  if (followed)
    start_solve(*followed, 0, nullptr, std::nullopt);
}

void session_state::start_solve(const solve_settings& settings, std::uint64_t ticket,
                                const caf::actor& client,
                                std::optional<caf::typed_response_promise<solved>> promise) {
  active_solve next;
  next.ticket = ticket;
  if (promise)
    next.waiting.push_back(*promise);
  const auto refuse = [&](const error& e) {
    for (auto& waiting_promise : next.waiting)
      waiting_promise.deliver(to_caf(e));
    note(next, solve_phase::failed, render(e));
  };
  const auto* head = graph.head();
  if (!head)
    return refuse({ec::conflict, "the document is empty", "Import a mesh first", {}});
  next.version = to_hex(head->info.id);
  next.mesh = head->mesh;
  const auto& names = head->info.load_cases;
  const auto found =
    settings.load_case.empty() ? names.begin() : std::ranges::find(names, settings.load_case);
  if (found == names.end())
    return refuse({ec::not_found,
                   settings.load_case.empty()
                     ? "this version has no load case"
                     : "there is no load case \"" + settings.load_case + "\"",
                   "Set the load case first",
                   {}});
  next.load_case = *found;
  const auto& text = head->load_cases[static_cast<std::size_t>(found - names.begin())];
  solve_order order{base_order(),
                    make_ref(*head->mesh),
                    text,
                    settings.device.empty() ? parts.device : settings.device,
                    settings.tolerance,
                    settings.element_order};
  next.key = key_of(order, next.version);

  const auto kept = std::ranges::find(results, next.key, &kept_result::key);
  if (kept != results.end()) {
    results.splice(results.begin(), results, kept);
    end_active_solve(ec::superseded, "a newer version is the head", solve_phase::superseded);
    broadcast(results.front().event);
    if (promise)
      promise->deliver(results.front().event);
    return;
  }
  if (active && active->key == next.key) {
    active->waiting.insert(active->waiting.end(), next.waiting.begin(), next.waiting.end());
    return;
  }
  end_active_solve(ec::superseded, "a newer version is the head", solve_phase::superseded);
  next.job = new_job(ticket, client);
  launch(std::move(next), order);
}

void session_state::launch(active_solve next, const solve_order& order) {
  const auto job = next.job;
  active = std::move(next);
  note(*active, solve_phase::started);
  self->request(parts.workers.solver, answer_limit, job, order)
    .then([=, this](const solve_result& result) { receive_result(job, result); },
          [=, this](const caf::error& e) { fail_solve(job, from_caf(e, "the solve")); });
}

void session_state::end_active_solve(ec code, const std::string& why, solve_phase phase) {
  if (!active)
    return;
  auto ended = std::move(*active);
  active.reset();
  progress_of.erase(ended.job);
  caf::anon_send(parts.workers.solver, cancel_atom::value, ended.job);
  for (auto& promise : ended.waiting)
    promise.deliver(to_caf({code, why, {}, {}}));
  note(ended, phase);
}

void session_state::open_fields(job_id job, const solve_result& result,
                                std::function<void(std::shared_ptr<const std::vector<field>>)> use,
                                std::function<void(const error&)> refuse) {
  if (!active || active->job != job)
    return;  // Superseded meanwhile.
  hash_list ids;
  for (const auto& f : result.fields)
    ids.insert(ids.end(), f.pages.begin(), f.pages.end());
  const auto open = [=, this](const page_set& pages) {
    if (!active || active->job != job)
      return;
    auto fields = std::make_shared<std::vector<field>>();
    for (const auto& ref : result.fields) {
      auto f = open_field(ref, pages);
      if (!f)
        return refuse(f.error());
      fields->push_back(std::move(*f));
    }
    use(std::move(fields));
  };
  pull(result.source, ids, open, refuse);
}

void session_state::receive_result(job_id job, const solve_result& result) {
  open_fields(
    job, result,
    [=, this](const std::shared_ptr<const std::vector<field>>& fields) {
      auto done = std::move(*active);
      active.reset();
      progress_of.erase(job);
      solved event{parts.document, done.mesh, result.report, fields};
      results.push_front({done.key, done.version, event, result.fields});
      if (results.size() > most_results)
        results.pop_back();
      broadcast(event);
      for (auto& promise : done.waiting)
        promise.deliver(event);
    },
    [=, this](const error& e) { fail_solve(job, e); });
}

void session_state::on_preview(const job_preview& preview) {
  open_fields(
    preview.job, preview.result,
    [=, this](const std::shared_ptr<const std::vector<field>>& fields) {
      broadcast(solved{parts.document, active->mesh, preview.result.report, fields});
    },
    [=, this](const error& e) {
      // The result itself still comes.
      spdlog::debug("{}: no preview: {}", parts.document, render(e));
    });
}

void session_state::fail_solve(job_id job, const error& e) {
  progress_of.erase(job);
  if (!active || active->job != job)
    return;
  auto failed = std::move(*active);
  active.reset();
  spdlog::warn("{}: solve failed: {}", parts.document, render(e));
  for (auto& promise : failed.waiting)
    promise.deliver(to_caf(e));
  note(failed, solve_phase::failed, render(e));
}

void session_state::on_frame(const job_frame& frame) {
  if (!active || active->job != frame.job)
    return;
  broadcast(solve_note{parts.document,
                       active->version,
                       active->load_case,
                       solve_phase::converging,
                       frame.iterations,
                       frame.residual,
                       {}});
}

void session_state::note(const active_solve& which, solve_phase phase, const std::string& message) {
  broadcast(solve_note{parts.document, which.version, which.load_case, phase, 0, 1, message});
}

}  // namespace tedit::actors
