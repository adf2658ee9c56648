// SPDX-License-Identifier: AGPL-3.0-or-later
// Which fields of a result are fetched, and when: docs/decisions/0066.
#include <algorithm>

#include "actors/pages/page_store.hpp"
#include "actors/session/result_check.hpp"
#include "actors/session/session.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"
#include "fem/quantities.hpp"

namespace tedit::actors {

namespace {

/// Adds fields whose pages have come. Errors: `protocol_error`.
expected<void> open_into(std::vector<field>& fields, const std::vector<field_ref>& refs,
                         const page_set& pages) {
  for (const auto& ref : refs) {
    auto f = open_field(ref, pages);
    if (!f)
      return fail(f.error());
    fields.push_back(std::move(*f));
  }
  return {};
}

/// `results.end()` once others have taken its place.
auto of_solve(std::list<session_state::kept_result>& results, std::uint64_t solve) {
  return std::ranges::find(results, solve, [](const auto& one) { return one.event.number; });
}

}  // namespace

/// A result on its way: what has come of it, and what may yet.
struct session_state::field_fetch {
  job_id job;
  solve_result result;
  bool slow = false;
  std::vector<field> fields;
  std::vector<field_ref> left;  ///< Not fetched.
  fields_taker use;
  std::function<void(const error&)> refuse;
};

bool session_state::is_watched(const field_ref& one) const {
  const auto* array = for_watchers(one);
  return !array || std::ranges::any_of(watched, [&](const auto& subscriber) {
    return subscriber.second.contains(array->name);
  });
}

void session_state::open_fields(job_id job, const solve_result& result, const fields_taker& use,
                                const std::function<void(const error&)>& refuse) {
  if (!active || active->job != job)
    return;  // Superseded meanwhile.
  if (const auto outcome = result.outcome.get(); !outcome)
    return refuse(outcome.error());
  auto fetch =
    std::make_shared<field_fetch>(field_fetch{job, result, false, {}, result.fields, use, refuse});
  self->request(parts.pages, short_limit, rate_atom::value, result.source)
    .then(
      [=, this](double rate) {
        fetch->slow = is_slow(rate);
        fetch_fields(fetch);
      },
      [=](const caf::error& e) { fetch->refuse(from_caf(e, "fetching the result")); });
}

/// Again until nothing is left that somebody wants: while some is on its way another may come who
/// watches more.
void session_state::fetch_fields(const std::shared_ptr<field_fetch>& fetch) {
  if (!active || active->job != fetch->job)
    return;
  auto& left = fetch->left;
  const auto not_wanted = std::ranges::stable_partition(
    left, [&](const field_ref& one) { return !fetch->slow || is_watched(one); });
  const std::vector<field_ref> wanted(left.begin(), not_wanted.begin());
  left.erase(left.begin(), not_wanted.begin());
  if (wanted.empty()) {
    if (const auto ok = check_solved(**fetch->result.outcome.get(), fetch->fields, *active->mesh,
                                     active->key.load_cases);
        !ok)
      return fetch->refuse(ok.error());
    return fetch->use(std::make_shared<const std::vector<field>>(std::move(fetch->fields)), left);
  }
  pull(
    fetch->result.source, pages_of(wanted),
    [=, this](const page_set& pages) {
      if (const auto ok = open_into(fetch->fields, wanted, pages); !ok)
        return fetch->refuse(ok.error());
      fetch_fields(fetch);
    },
    fetch->refuse);
}

caf::result<held_result> session_state::watch(const watch_request& request) {
  if (subscribers.contains(request.subscriber))
    watched[request.subscriber] = request.arrays;
  const auto now = held();
  const auto* head = graph.head();
  if (!now.result)
    return now;
  const auto promise = std::make_shared<caf::typed_response_promise<held_result>>(
    self->make_response_promise<held_result>());
  bring_watched(now.result->number, head->mesh, [=, this](bool there) {
    if (!there)
      solve_once_more(now.result->number);
    promise->deliver(held());
  });
  return *promise;
}

void session_state::bring_watched(std::uint64_t solve, const version_ptr& mesh,
                                  const std::function<void(bool)>& done) {
  const auto kept = of_solve(results, solve);
  std::vector<field_ref> wanted;
  if (kept != results.end())
    std::ranges::copy_if(kept->left, std::back_inserter(wanted),
                         [&](const field_ref& one) { return is_watched(one); });
  if (wanted.empty())
    return done(true);
  pull(
    kept->fields.source, pages_of(wanted),
    [=, this](const page_set& pages) { done(add_fields(solve, mesh, wanted, pages)); },
    [=, this](const error& e) {
      logging::info("{}: fields that are watched now are not there any more: {}", parts.document,
                    render(e));
      done(false);
    });
}

bool session_state::add_fields(std::uint64_t solve, const version_ptr& mesh,
                               const std::vector<field_ref>& wanted, const page_set& pages) {
  const auto kept = of_solve(results, solve);
  const auto before = kept == results.end() ? nullptr : parts.results->find(kept->shown);
  if (!before)
    return false;
  std::vector<field> fresh;
  auto ok = open_into(fresh, wanted, pages);
  if (ok)
    ok = check_solved(*kept->event.outcome, fresh, *mesh, kept->key.load_cases);
  if (!ok) {
    logging::warn("{}: {}", parts.document, render(ok.error()));
    return false;
  }
  auto all = std::make_shared<std::vector<field>>(*before);
  for (auto& one : fresh)
    if (!find_field(*all, one.name))  // Two may have asked for it at once.
      all->push_back(std::move(one));
  std::erase_if(kept->left, [&](const field_ref& one) { return find_field(*all, one.name); });
  kept->shown = parts.results->keep(all, bytes_of(*all));
  return true;
}

/// Of a result whose worker is gone, or has forgotten it, what was left there is made anew.
void session_state::solve_once_more(std::uint64_t solve) {
  const auto kept = of_solve(results, solve);
  const auto* head = graph.head();
  if (active || kept == results.end() || !head || kept->key.version != to_hex(head->info.id))
    return;
  active_solve next;
  next.mesh = head->mesh;
  next.names = names_of(kept->key.load_cases);
  next.key = std::move(kept->key);
  results.erase(kept);
  next.job = new_job(0, nullptr);
  launch(std::move(next));
}

}  // namespace tedit::actors
