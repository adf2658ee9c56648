// SPDX-License-Identifier: AGPL-3.0-or-later
// Which job is next, which worker it goes to, and what those hear that wait meanwhile.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include <caf/send.hpp>

#include "actors/supervisor/pool.hpp"

namespace tedit::actors {

namespace {

/// A job that takes longer than it should has at least this part of it before it, for all we know.
constexpr double least_rest = .25;

/// What takes so many times as long as it should takes nobody knows how long.
constexpr double out_of_reckoning = 3;

/// A busy worker must be this much sooner than a free one.
constexpr double worth_waiting = 2;

double seconds_of(pool_state::clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

pool_state::job pool_state::take_next() {
  std::vector<turn> places;
  for (const auto& j : waiting)
    places.push_back(j.place);
  const auto at = waiting.begin() + static_cast<std::ptrdiff_t>(turns.take(places));
  auto next = std::move(*at);
  waiting.erase(at);
  return next;
}

std::optional<double> pool_state::expected_s(const job_cost& cost, const child* by) const {
  const auto own = by ? by->costs.seconds(cost) : std::nullopt;
  return own ? own : costs.seconds(cost);
}

std::optional<double> pool_state::remaining_s(const child& c) const {
  if (!c.work)
    return 0;
  const auto whole = expected_s(c.work->needs.cost, &c);
  const double so_far = seconds_of(now() - c.work_began);
  if (!whole || so_far > out_of_reckoning * *whole + seconds_of(later_notes))
    return std::nullopt;
  return std::max(*whole - so_far, least_rest * *whole);
}

pool_state::child* pool_state::choose_child(const job& wanted,
                                            std::map<std::uint64_t, double>& promised) {
  const auto has_room = [&](const child& c) {
    return c.node.memory_bytes == 0 ||
           static_cast<double>(c.node.memory_bytes) >= wanted.needs.memory_bytes;
  };
  const bool room_somewhere = std::ranges::any_of(
    children, [&](const child& c) { return c.is_there() && !c.work && has_room(c); });
  // Parts of one job are done in different places, as long as there are some.
  const auto has_part = [&](const child& c) {
    return std::ranges::any_of(children, [&](const child& other) {
      return other.node.name == c.node.name && other.work &&
             are_parts_of_one(other.work->id, wanted.id);
    });
  };
  const bool place_without = std::ranges::any_of(
    children, [&](const child& c) { return c.is_there() && !c.work && !has_part(c); });
  child* free = nullptr;
  double free_s = 0;
  for (auto& c : children) {
    if (!c.is_there() || c.work || (room_somewhere && !has_room(c)) ||
        (place_without && has_part(c)))
      continue;
    if (c.last_place == wanted.place.document && wanted.place.document != 0)
      return &c;
    // What a worker never did it is tried with: else nobody would learn that it is quick.
    const double takes = c.costs.seconds(wanted.needs.cost).value_or(0);
    if (!free || takes < free_s) {
      free = &c;
      free_s = takes;
    }
  }
  if (!free || free_s <= 0)
    return free;
  for (const auto& c : children) {
    if (!c.is_there() || !c.work || c.work->cancelled || !has_room(c))
      continue;
    const auto takes = c.costs.seconds(wanted.needs.cost);
    const auto rest = remaining_s(c);
    if (!takes || !rest || worth_waiting * (*rest + promised[c.number] + *takes) >= free_s)
      continue;
    promised[c.number] += *takes;
    return nullptr;
  }
  return free;
}

void pool_state::dispatch() {
  const auto is_free = [](const child& c) { return c.is_there() && !c.work; };
  std::map<std::uint64_t, double> promised;
  std::vector<job> held;  // For a worker that is busy yet.
  while (!waiting.empty() && std::ranges::any_of(children, is_free)) {
    auto next = take_next();
    if (const auto why = off.refusal(next.edit)) {
      next.refuse(*why);  // Switched off while it waited.
      continue;
    }
    auto* c = choose_child(next, promised);
    if (!c) {
      held.push_back(std::move(next));
      continue;
    }
    c->last_place = next.place.document;
    c->work = std::move(next);
    c->work_began = now();
    c->memory_kills = options.processes->memory_kills();
    c->work->deadline = now() + limit_of(*c->work);
    begin_stage(*c->work, "work", c);
    wake();
    c->work->send(c->worker, c->work->deaths);
  }
  std::move(held.rbegin(), held.rend(), std::front_inserter(waiting));
}

std::optional<double> pool_state::wait_s(std::size_t jobs_before) const {
  double work = 0;
  std::size_t workers = 0;
  double soonest = 0;
  for (const auto& c : children) {
    if (!c.is_there())
      continue;
    const auto rest = remaining_s(c);
    if (!rest)
      return std::nullopt;
    soonest = workers++ == 0 ? *rest : std::min(soonest, *rest);
    work += *rest;
  }
  if (workers == 0)
    return std::nullopt;
  for (std::size_t i = 0; i < std::min(jobs_before, waiting.size()); ++i) {
    const auto takes = expected_s(waiting[i].needs.cost, nullptr);
    if (!takes)
      return std::nullopt;
    work += *takes;
  }
  return jobs_before == 0 ? soonest : std::max(soonest, work / static_cast<double>(workers));
}

void pool_state::tell_waiting() {
  const auto at = now();
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    auto& j = waiting[i];
    const bool first = j.told == clock::time_point{};
    if (!j.listener || (first ? at - j.came < first_note : at - j.told < later_notes))
      continue;
    j.told = at;
    const auto before = std::to_string(i);
    const auto wait = wait_s(i);
    const auto seconds =
      std::to_string(std::max(1L, static_cast<long>(std::ceil(wait.value_or(0)))));
    std::string stage = "waiting for a free worker";
    if (std::ranges::none_of(children, &child::is_there))
      stage = "waiting for a worker to start";
    else if (i > 0 && wait)
      stage = "waiting for a free worker: " + before + " before it, about " + seconds + " s";
    else if (i > 0)
      stage = "waiting for a free worker: " + before + " before it";
    else if (wait)
      stage = "waiting for a free worker, about " + seconds + " s";
    caf::anon_send(j.listener, job_progress{j.id, 0, std::move(stage)});
  }
}

}  // namespace tedit::actors
