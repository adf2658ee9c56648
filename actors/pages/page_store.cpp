// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/pages/page_store.hpp"

#include <algorithm>
#include <utility>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/links/open_actors.hpp"

namespace tedit::actors {

namespace {

using page_store_pointer = page_store_actor::stateful_pointer<page_store_state>;
using page_transfer = page_store_state::transfer;

/// Less says more about how long a message takes than about how much a line carries.
constexpr double least_measured = 128 * 1024;

error nobody_has_them() {
  return {ec::not_found, "pages are missing and no node is named that has them", {}, {}};
}

void pump(page_store_pointer self, std::uint64_t id);

bool is_done(const page_transfer& one) {
  return one.batches.empty() && one.in_flight == 0 && one.awaited == 0;
}

void finish(page_store_pointer self, std::uint64_t id) {
  auto done = std::move(self->state.transfers.extract(id).mapped());
  done.promise.deliver(page_set{std::move(done.pages), done.moved});
}

/// Those for whom another transfer would have brought pages, with these pages.
using orphans = std::map<std::uint64_t, hash_list>;

/// What a transfer would have brought is brought by the next one that wants it.
orphans leave_pages(page_store_state& state, std::uint64_t id) {
  orphans heirs;
  for (auto at = state.coming.begin(); at != state.coming.end();) {
    const auto page = at++;
    auto& [brought_by, also_for] = page->second;
    if (brought_by != id) {
      std::erase(also_for, id);
    } else if (also_for.empty()) {
      state.coming.erase(page);
    } else {
      brought_by = also_for.front();
      also_for.erase(also_for.begin());
      heirs[brought_by].push_back(page->first);
    }
  }
  return heirs;
}

void give_up(page_store_pointer self, std::uint64_t id, const error& e) {
  auto& state = self->state;
  auto ended = state.transfers.extract(id);
  if (ended.empty())
    return;
  ended.mapped().promise.deliver(to_caf(e));
  for (const auto& [heir, pages] : leave_pages(state, id)) {
    const auto found = state.transfers.find(heir);
    if (found == state.transfers.end())
      continue;  // It was given up meanwhile, by one of those before it.
    if (!found->second.remote) {
      give_up(self, heir, nobody_has_them());
      continue;
    }
    found->second.awaited -= pages.size();
    std::ranges::move(split(pages), std::back_inserter(found->second.batches));
    pump(self, heir);
  }
}

/// Null for a node that is gone.
page_store_state::line* line_of(page_store_state& state, const caf::actor_addr& node) {
  const auto found = state.lines.find(node);
  return found == state.lines.end() ? nullptr : &found->second;
}

/// The others that a page was awaited by have it now.
void hand_over(page_store_pointer self, std::uint64_t bringer, const page_ptr& p) {
  auto& state = self->state;
  const auto found = state.coming.find(p->id());
  if (found == state.coming.end() || found->second.brought_by != bringer)
    return;
  const auto also_for = std::move(found->second.also_for);
  state.coming.erase(found);
  for (const auto id : also_for) {
    auto& other = state.transfers.at(id);
    other.pages->emplace(p->id(), p);
    --other.awaited;
    if (is_done(other))
      finish(self, id);
  }
}

void receive(page_store_pointer self, std::uint64_t id, const hash_list& ids,
             const page_batch& batch) {
  const auto found = self->state.transfers.find(id);
  if (found == self->state.transfers.end())
    return;
  auto pages = unpack(batch, ids);
  if (!pages)
    return give_up(self, id, pages.error());
  auto& transfer = found->second;
  --transfer.in_flight;
  transfer.moved += pages->size();
  for (const auto& p : *pages) {
    self->state.cache->put(p);
    transfer.pages->emplace(p->id(), p);
    hand_over(self, id, p);
  }
}

/// One batch less is on its way from a node, so that others' may be.
void land(page_store_pointer self, const caf::actor_addr& from, std::size_t bytes) {
  if (auto* line = line_of(self->state, from)) {
    --line->in_flight;
    line->note(static_cast<double>(bytes), self->clock().now());
  }
}

void pump_all(page_store_pointer self, const caf::actor_addr& from) {
  std::vector<std::uint64_t> of_node;
  for (const auto& [id, transfer] : self->state.transfers)
    if (transfer.remote && transfer.remote.address() == from)
      of_node.push_back(id);
  for (const auto id : of_node)
    pump(self, id);
}

void ask_for(page_store_pointer self, std::uint64_t id, const hash_list& ids) {
  auto& transfer = self->state.transfers.at(id);
  const auto from = transfer.remote.address();
  ++transfer.in_flight;
  bool packed = false;
  if (auto* line = line_of(self->state, from)) {
    if (line->in_flight++ == 0) {
      line->since = self->clock().now();
      line->bytes = 0;
    }
    packed = is_slow(line->rate);
  }
  const auto remote = caf::actor_cast<page_store_actor>(transfer.remote);
  self->request(remote, std::chrono::seconds(20), get_atom::value, ids, packed)
    .then(
      [=](const page_batch& batch) {
        land(self, from, batch.bytes.size());
        receive(self, id, ids, batch);
        pump_all(self, from);
      },
      [=](const caf::error& e) {
        land(self, from, 0);
        give_up(self, id, from_caf(e, "a transfer of pages"));
        pump_all(self, from);
      });
}

/// Asks for more batches, or hands the pages over when all are there.
void pump(page_store_pointer self, std::uint64_t id) {
  auto& state = self->state;
  const auto found = state.transfers.find(id);
  if (found == state.transfers.end())
    return;
  auto& transfer = found->second;
  if (is_done(transfer))
    return finish(self, id);
  while (!transfer.batches.empty()) {
    const auto* line = line_of(state, transfer.remote.address());
    // Each transfer goes on, however busy the line is with others.
    if (line && transfer.in_flight > 0 && line->in_flight >= line->credit())
      return;
    const auto ids = std::move(transfer.batches.front());
    transfer.batches.pop_front();
    ask_for(self, id, ids);
  }
}

/// What is in the cache, on its way for others, and neither (which is returned).
hash_list sort_pages(page_store_state& state, std::uint64_t id, page_transfer& transfer,
                     const hash_list& ids) {
  hash_list missing;
  for (const auto& page : ids) {
    if (auto p = state.cache->find(page)) {
      transfer.pages->emplace(page, std::move(p));
      continue;
    }
    const auto [found, is_new] = state.coming.try_emplace(page);
    if (is_new) {
      found->second.brought_by = id;
      missing.push_back(page);
    } else if (found->second.brought_by != id &&
               std::ranges::count(found->second.also_for, id) == 0) {
      found->second.also_for.push_back(id);
      ++transfer.awaited;
    }
  }
  return missing;
}

/// From now on its end is noticed, and how quick it is.
void watch_line(page_store_pointer self, const caf::actor& remote) {
  if (remote && self->state.lines.try_emplace(remote.address()).second)
    self->monitor(remote);
}

caf::result<page_set> fetch(page_store_pointer self, const caf::actor& remote,
                            const hash_list& ids) {
  auto& state = self->state;
  const auto id = state.next++;
  page_store_state::transfer transfer;
  const auto missing = sort_pages(state, id, transfer, ids);
  if (!missing.empty() && !remote) {
    leave_pages(state, id);
    return to_caf(nobody_has_them());
  }
  if (missing.empty() && transfer.awaited == 0)
    return page_set{std::move(transfer.pages), 0};
  transfer.remote = remote;
  transfer.batches = split(missing);
  auto promise = self->template make_response_promise<page_set>();
  transfer.promise = promise;
  state.transfers.emplace(id, std::move(transfer));
  watch_line(self, remote);
  pump(self, id);
  return promise;
}

/// Pages of several places on their way.
struct gathering {
  std::shared_ptr<page_map> found = std::make_shared<page_map>();
  std::size_t moved = 0;
  std::size_t awaited = 0;
  caf::typed_response_promise<page_set> promise;
};

/// Pages that a result of this process names: each from where it lies.
caf::result<page_set> fetch_from_places(page_store_pointer self, const hash_list& ids) {
  std::map<caf::actor, hash_list> by_place;
  for (const auto& id : ids)
    by_place[self->state.place_of(id)].push_back(id);
  if (by_place.size() < 2)
    return fetch(self, by_place.empty() ? caf::actor() : by_place.begin()->first, ids);
  const auto all = std::make_shared<gathering>();
  all->awaited = by_place.size();
  all->promise = self->template make_response_promise<page_set>();
  const auto own = caf::actor_cast<page_store_actor>(self);
  for (const auto& [node, pages] : by_place)
    self->request(own, caf::infinite, fetch_atom::value, node, pages)
      .then(
        [=](const page_set& some) {
          all->found->insert(some.pages->begin(), some.pages->end());
          all->moved += some.moved;
          if (--all->awaited == 0)
            all->promise.deliver(page_set{all->found, all->moved});
        },
        [=](const caf::error& e) {
          if (all->promise.pending())
            all->promise.deliver(e);
        });
  return all->promise;
}

void note_place(page_store_pointer self, const caf::actor& node, hash_list pages) {
  if (!is_asked_from_here(self) || !node || pages.empty())
    return;
  std::ranges::sort(pages);
  auto& places = self->state.places;
  places.push_front({node, std::move(pages)});
  if (places.size() > places_kept)
    places.pop_back();
  watch_line(self, node);
}

double rate_of(page_store_pointer self, const caf::actor& remote) {
  if (remote && remote.address() != self->address()) {
    const auto* line = line_of(self->state, remote.address());
    return line ? line->rate : 0;
  }
  double least = 0;
  for (const auto& one : self->state.places)
    if (const auto* line = line_of(self->state, one.node.address()); line && line->rate > 0)
      least = least > 0 ? std::min(least, line->rate) : line->rate;
  return least;
}

/// A node is gone: what was to come from it is asked for elsewhere by those who can.
void drop_node(page_store_pointer self, const caf::actor_addr& node) {
  auto& state = self->state;
  state.lines.erase(node);
  std::erase_if(state.places, [&](const auto& one) { return one.node.address() == node; });
  std::vector<std::uint64_t> lost;
  for (auto& [id, transfer] : state.transfers) {
    if (!transfer.remote || transfer.remote.address() != node)
      continue;
    if (transfer.in_flight > 0 || !transfer.batches.empty())
      lost.push_back(id);
    else
      transfer.remote = nullptr;  // Others bring what it waits for.
  }
  for (const auto id : lost)
    give_up(self, id,
            {ec::service_unavailable, "the node that has the pages is gone", "Try again", {}});
}

}  // namespace

caf::actor page_store_state::place_of(const hash128& id) const {
  const auto found = std::ranges::find_if(
    places, [&](const place& one) { return std::ranges::binary_search(one.pages, id); });
  return found == places.end() ? caf::actor() : found->node;
}

std::size_t page_store_state::line::credit() const {
  if (rate <= 0)
    return transfer_credit;
  const auto batches =
    rate * std::chrono::duration<double>(most_ahead).count() / static_cast<double>(max_batch_bytes);
  return static_cast<std::size_t>(std::clamp(batches, 1.0, static_cast<double>(transfer_credit)));
}

void page_store_state::line::note(double size, clock::time_point now) {
  bytes += size;
  if (bytes < least_measured)
    return;
  const auto took = std::max(1e-6, std::chrono::duration<double>(now - since).count());
  rate = rate > 0 ? (rate + bytes / took) / 2 : bytes / took;
  bytes = 0;
  since = now;
}

page_store_actor::behavior_type make_page_store(
  page_store_actor::stateful_pointer<page_store_state> self, std::shared_ptr<page_cache> cache) {
  self->state.cache = std::move(cache);
  open_to_workers(caf::actor_cast<caf::actor>(self));
  self->set_down_handler([=](caf::down_msg& down) { drop_node(self, down.source); });
  heed_only_own_exits(self);
  return {[=](get_atom, const hash_list& ids, bool packed) -> caf::result<page_batch> {
            auto batch = pack(*self->state.cache, ids, packed);
            if (!batch)
              return to_caf(batch.error());
            return std::move(*batch);
          },
          [=](fetch_atom, const caf::actor& remote, const hash_list& ids) {
            return remote && remote.address() == self->address() ? fetch_from_places(self, ids)
                                                                 : fetch(self, remote, ids);
          },
          [=](rate_atom, const caf::actor& remote) { return rate_of(self, remote); },
          [=](lies_at_atom, const caf::actor& node, const hash_list& pages) {
            note_place(self, node, pages);
          }};
}

}  // namespace tedit::actors
