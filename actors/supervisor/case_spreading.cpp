// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/case_spreading.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/links/open_actors.hpp"
#include "actors/pages/page_store.hpp"
#include "actors/supervisor/merge_cases.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

/// Whoever asked fetches the fields at once; until then somebody must hold them.
constexpr std::chrono::seconds time_to_fetch{10};

constexpr std::chrono::minutes longest{24 * 60};

struct spread_solve {
  struct part {
    job_id id;
    std::optional<solve_result> result;
    std::optional<solve_result> preview;
    std::optional<job_frame> frame;
  };

  job_id id;
  solve_order order;
  std::vector<std::string> load_cases;
  std::vector<part> parts;
  bool shown = false;  ///< A preview was sent.
  caf::typed_response_promise<solve_result> promise;
};
using spread_ptr = std::shared_ptr<spread_solve>;

struct spreading_state {
  solver_actor solvers;
  page_store_actor pages;
  std::shared_ptr<page_cache> cache;
  caf::actor ear;  ///< Hears for it what workers tell; they can send nothing else.
  std::map<job_id, spread_ptr> running;
  std::map<job_id, solve_order> asking;  ///< It is not known yet who is free for them.

  static inline const char* name = "case_spreading";
};

using spreading_pointer = solver_actor::stateful_pointer<spreading_state>;

void end(spreading_pointer self, const spread_ptr& run) {
  self->state.running.erase(run->id);
  for (const auto& part : run->parts)
    if (!part.result)
      caf::anon_send(self->state.solvers, cancel_atom::value, part.id);
}

void fail_all(spreading_pointer self, const spread_ptr& run, const error& e) {
  if (!self->state.running.contains(run->id))
    return;
  end(self, run);
  run->promise.deliver(to_caf(e));
}

/// Of a part's fields those to bring here: over a slow line not what only watchers need.
std::vector<field_ref> to_bring(const solve_result& part, double rate) {
  auto arrays = arrays_of_cases(part);
  if (is_slow(rate))
    std::erase_if(arrays, [](const field_ref& one) { return for_watchers(one) != nullptr; });
  return arrays;
}

/// What is to be here of the fields of all parts, one part after the other as each has its own
/// place; then `use`.
void gather(spreading_pointer self, const std::shared_ptr<std::vector<solve_result>>& parts,
            const std::shared_ptr<page_map>& found, std::size_t next,
            const std::function<void(const page_set&)>& use,
            const std::function<void(const error&)>& refuse) {
  if (next == parts->size())
    return use(page_set{found, found->size()});
  const auto& part = (*parts)[next];
  const auto failed = [=](const caf::error& e) {
    refuse(from_caf(e, "fetching a part of the result"));
  };
  const auto bring = [=, &part](double rate) {
    self
      ->request(self->state.pages, longest, fetch_atom::value, part.source,
                pages_of(to_bring(part, rate)))
      .then(
        [=](const page_set& pages) {
          found->insert(pages.pages->begin(), pages.pages->end());
          gather(self, parts, found, next + 1, use, refuse);
        },
        failed);
  };
  self->request(self->state.pages, longest, rate_atom::value, part.source).then(bring, failed);
}

/// Whoever asks this process for what stayed with a part gets it from there.
void tell_places(spreading_pointer self, const std::vector<solve_result>& parts) {
  for (const auto& part : parts) {
    auto pages = pages_of(part.fields);
    const auto more = pages_of(part.more);
    pages.insert(pages.end(), more.begin(), more.end());
    self->send(self->state.pages, lies_at_atom::value, part.source, std::move(pages));
  }
}

/// Merges what all parts have and holds the pages for a while.
void merge(spreading_pointer self, const spread_ptr& run, std::vector<solve_result> parts,
           const std::function<void(solve_result)>& use,
           const std::function<void(const error&)>& refuse) {
  const auto all = std::make_shared<std::vector<solve_result>>(std::move(parts));
  gather(
    self, all, std::make_shared<page_map>(), 0,
    [=](const page_set& pages) {
      auto merged = merge_cases(*all, run->load_cases, pages);
      if (!merged)
        return refuse(merged.error());
      for (const auto& p : merged->pages)
        self->state.cache->put(p);
      tell_places(self, *all);
      merged->result.source = caf::actor_cast<caf::actor>(self->state.pages);
      caf::delayed_anon_send(self->state.ear, time_to_fetch, held_pages{std::move(merged->pages)});
      use(std::move(merged->result));
    },
    refuse);
}

void finish(spreading_pointer self, const spread_ptr& run) {
  std::vector<solve_result> parts;
  for (const auto& part : run->parts)
    parts.push_back(*part.result);
  merge(
    self, run, std::move(parts),
    [=](solve_result result) {
      if (self->state.running.erase(run->id) > 0)
        run->promise.deliver(std::move(result));
    },
    [=](const error& e) {
      // A machine may have gone after it answered, and the fields with it.
      if (!worth_a_retry(e))
        return fail_all(self, run, e);
      logging::warn("solve {}: {}: solving once more, in one place", run->id.value, render(e));
      if (self->state.running.erase(run->id) > 0)
        run->promise.delegate(self->state.solvers, run->id, run->order);
    });
}

void send_part(spreading_pointer self, const spread_ptr& run, std::size_t i,
               const load_case_list& load_cases) {
  auto order = run->order;
  order.base.listener = order.base.listener ? self->state.ear : nullptr;
  order.load_cases = wire_value(load_cases);
  order.of_several = true;
  self->request(self->state.solvers, longest, run->parts[i].id, order)
    .then(
      [=](const solve_result& result) {
        run->parts[i].result = result;
        if (self->state.running.contains(run->id) &&
            std::ranges::all_of(run->parts, [](const auto& part) { return !!part.result; }))
          finish(self, run);
      },
      [=](const caf::error& e) { fail_all(self, run, from_caf(e, "the solve")); });
}

void spread(spreading_pointer self, const spread_ptr& run,
            const std::vector<load_case_list>& shares) {
  logging::info("solve {}: {} load cases on {} machines", run->id.value, run->load_cases.size(),
                shares.size());
  self->state.running.emplace(run->id, run);
  for (std::size_t i = 0; i < shares.size(); ++i)
    run->parts.push_back({part_of(run->id, i), {}, {}, {}});
  for (std::size_t i = 0; i < shares.size(); ++i)
    send_part(self, run, i, shares[i]);
}

spread_solve::part* part_with(spreading_pointer self, job_id id, spread_ptr& run) {
  for (const auto& [whole, one] : self->state.running)
    for (auto& part : one->parts)
      if (part.id == id) {
        run = one;
        return &part;
      }
  return nullptr;
}

void on_frame(spreading_pointer self, const job_frame& frame) {
  spread_ptr run;
  auto* part = part_with(self, frame.job, run);
  if (!part)
    return;
  part->frame = frame;
  job_frame all{run->id, 0, 0};
  for (const auto& one : run->parts) {
    if (!one.frame)
      return;  // A residual is that of the worst one, which may be this.
    all.iterations = std::max(all.iterations, one.frame->iterations);
    all.residual = std::max(all.residual, one.frame->residual);
  }
  caf::anon_send(run->order.base.listener, all);
}

void on_progress(spreading_pointer self, const job_progress& note) {
  spread_ptr run;
  if (part_with(self, note.job, run))
    caf::anon_send(run->order.base.listener, job_progress{run->id, note.fraction, note.stage});
}

/// Once each part has one; a part that is done shows its result.
void on_preview(spreading_pointer self, const job_preview& preview) {
  spread_ptr run;
  auto* part = part_with(self, preview.job, run);
  if (!part)
    return;
  part->preview = preview.result;
  std::vector<solve_result> parts;
  for (const auto& one : run->parts)
    if (const auto& has = one.preview ? one.preview : one.result)
      parts.push_back(*has);
  if (parts.size() < run->parts.size() || std::exchange(run->shown, true))
    return;
  merge(
    self, run, std::move(parts),
    [=](solve_result result) {
      if (self->state.running.contains(run->id))
        caf::anon_send(run->order.base.listener, job_preview{run->id, std::move(result)});
    },
    [=](const error& e) { logging::debug("no preview: {}", render(e)); });
}

caf::behavior make_case_ear(caf::event_based_actor* self, const caf::actor_addr& owner) {
  open_to_workers(caf::actor_cast<caf::actor>(self));
  heed_only_own_exits(self);
  const auto pass_on = [=](const auto& note) {
    if (const auto to = caf::actor_cast<caf::actor>(owner))
      caf::anon_send(to, note);
  };
  return {[=](const job_progress& note) { pass_on(note); },
          [=](const job_frame& note) { pass_on(note); },
          [=](const job_preview& note) { pass_on(note); }, [](const held_pages&) {}};
}

caf::result<solve_result> on_order(spreading_pointer self, job_id id, const solve_order& order) {
  auto& state = self->state;
  const auto loads = order.load_cases.get();
  if (!loads || (*loads)->size() < 2 || order.in_one_place ||
      tets_of(order.version) * static_cast<double>((*loads)->size()) < least_to_spread)
    return self->delegate(state.solvers, id, order);
  auto run = std::make_shared<spread_solve>();
  run->id = id;
  run->order = order;
  for (const auto& one : **loads)
    run->load_cases.push_back(one.name);
  run->promise = self->make_response_promise<solve_result>();
  state.asking.emplace(id, order);
  const auto decide = [=, cases = *loads](std::uint32_t machines) {
    if (self->state.asking.erase(id) == 0)
      run->promise.deliver(to_caf({ec::cancelled, "the solve was cancelled", {}, {}}));
    else if (machines < 2)
      run->promise.delegate(self->state.solvers, id, order);
    else
      spread(self, run, spread_cases(*cases, machines));
  };
  self->request(state.solvers, std::chrono::seconds(1), status_atom::value)
    .then([=](const worker_status& status) { decide(status.free_machines); },
          [=](const caf::error&) { decide(0); });
  return run->promise;
}

void cancel(spreading_pointer self, job_id id) {
  auto& state = self->state;
  if (state.asking.erase(id) > 0)
    return;
  const auto found = state.running.find(id);
  if (found == state.running.end())
    return caf::anon_send(state.solvers, cancel_atom::value, id);
  const auto run = found->second;  // The row goes.
  fail_all(self, run, {ec::cancelled, "the solve was cancelled", {}, {}});
}

solver_actor::behavior_type case_spreading(spreading_pointer self, solver_actor solvers,
                                           page_store_actor pages,
                                           std::shared_ptr<page_cache> cache) {
  auto& state = self->state;
  state.solvers = std::move(solvers);
  state.pages = std::move(pages);
  state.cache = std::move(cache);
  state.ear = self->spawn(make_case_ear, caf::actor_cast<caf::actor_addr>(self));
  heed_only_own_exits(self, [=] {
    caf::anon_send_exit(self->state.ear, caf::exit_reason::user_shutdown);
    caf::anon_send_exit(self->state.solvers, caf::exit_reason::user_shutdown);
  });
  self->set_default_handler(
    [=](caf::scheduled_actor*, caf::message_view& view) -> caf::result<caf::message> {
      auto message = view.move_content_to_message();
      message.apply({[&](const job_progress& note) { on_progress(self, note); },
                     [&](const job_frame& note) { on_frame(self, note); },
                     [&](const job_preview& note) { on_preview(self, note); },
                     [&](const remote_worker& guest) {
                       self->delegate(caf::actor_cast<caf::actor>(self->state.solvers), guest);
                     },
                     [&](const retirement& note, const caf::actor_addr& worker) {
                       if (is_asked_from_here(self))
                         caf::unsafe_send_as(self, caf::actor_cast<caf::actor>(self->state.solvers),
                                             note, worker);
                     }});
      return caf::message{};
    });
  return {[=](job_id id, const solve_order& order) { return on_order(self, id, order); },
          [=](cancel_atom, job_id id) { cancel(self, id); },
          [=](status_atom) { return self->delegate(self->state.solvers, status_atom::value); }};
}

}  // namespace

solver_actor make_case_spreading(caf::actor_system& system, solver_actor solvers,
                                 page_store_actor pages, std::shared_ptr<page_cache> cache) {
  return system.spawn(case_spreading, std::move(solvers), std::move(pages), std::move(cache));
}

}  // namespace tedit::actors
