// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/pages/page_store.hpp"

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/links/open_actors.hpp"

namespace tedit::actors {

namespace {

constexpr std::size_t pages_per_batch = max_batch_bytes / max_page_bytes;

using page_store_pointer = page_store_actor::stateful_pointer<page_store_state>;

void pump(page_store_pointer self, std::uint64_t id);

void give_up(page_store_pointer self, std::uint64_t id, const error& e) {
  const auto found = self->state.transfers.find(id);
  if (found == self->state.transfers.end())
    return;
  auto promise = std::move(found->second.promise);
  self->state.transfers.erase(found);
  promise.deliver(to_caf(e));
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
  for (auto& p : *pages) {
    self->state.cache->put(p);
    transfer.pages->emplace(p->id(), p);
  }
  pump(self, id);
}

/// Asks for more batches, or hands the pages over when all are there.
void pump(page_store_pointer self, std::uint64_t id) {
  auto& transfer = self->state.transfers.at(id);
  if (transfer.batches.empty() && transfer.in_flight == 0) {
    auto done = std::move(transfer);
    self->state.transfers.erase(id);
    done.promise.deliver(page_set{std::move(done.pages), done.moved});
    return;
  }
  const auto remote = caf::actor_cast<page_store_actor>(transfer.remote);
  while (!transfer.batches.empty() && transfer.in_flight < transfer_credit) {
    const auto ids = std::move(transfer.batches.front());
    transfer.batches.pop_front();
    ++transfer.in_flight;
    self->request(remote, std::chrono::seconds(20), get_atom::value, ids)
      .then([=](const page_batch& batch) { receive(self, id, ids, batch); },
            [=](const caf::error& e) { give_up(self, id, from_caf(e, "a transfer of pages")); });
  }
}

caf::result<page_set> fetch(page_store_pointer self, const caf::actor& remote,
                            const hash_list& ids) {
  auto& state = self->state;
  page_store_state::transfer transfer;
  hash_list missing;
  for (const auto& id : ids) {
    if (auto p = state.cache->find(id))
      transfer.pages->emplace(id, std::move(p));
    else
      missing.push_back(id);
  }
  if (missing.empty())
    return page_set{std::move(transfer.pages), 0};
  if (!remote)
    return to_caf({ec::not_found, "pages are missing and no node is named that has them", {}, {}});
  transfer.remote = remote;
  transfer.batches = split(missing);
  auto promise = self->template make_response_promise<page_set>();
  transfer.promise = promise;
  const auto id = state.next++;
  state.transfers.emplace(id, std::move(transfer));
  if (state.watched.insert(remote.address()).second)
    self->monitor(remote);
  pump(self, id);
  return promise;
}

}  // namespace

std::deque<hash_list> split(const hash_list& ids) {
  std::deque<hash_list> batches;
  for (std::size_t first = 0; first < ids.size(); first += pages_per_batch) {
    const auto last = std::min(ids.size(), first + pages_per_batch);
    batches.emplace_back(ids.begin() + static_cast<std::ptrdiff_t>(first),
                         ids.begin() + static_cast<std::ptrdiff_t>(last));
  }
  return batches;
}

expected<page_batch> pack(page_cache& cache, const hash_list& ids) {
  if (ids.size() > pages_per_batch)
    return fail(ec::invalid_argument, "more pages are asked for than a batch may hold");
  page_batch batch;
  for (const auto& id : ids) {
    const auto p = cache.find(id);
    if (!p)
      return fail(ec::not_found, "page " + to_hex(id) + " is not here any more");
    const auto bytes = p->bytes();
    const auto* first = reinterpret_cast<const char*>(bytes.data());
    batch.sizes.push_back(static_cast<std::uint32_t>(bytes.size()));
    batch.bytes.insert(batch.bytes.end(), first, first + bytes.size());
  }
  return batch;
}

expected<std::vector<page_ptr>> unpack(const page_batch& batch, const hash_list& ids) {
  if (batch.sizes.size() != ids.size())
    return fail(ec::protocol_error, "a node sent another number of pages than asked for");
  std::vector<page_ptr> pages;
  std::size_t offset = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::size_t size = batch.sizes[i];
    if (size > max_page_bytes || size > batch.bytes.size() - offset)
      return fail(ec::protocol_error, "a node sent a page of a wrong size");
    const std::span bytes(batch.bytes.data() + offset, size);
    auto p = page::from_bytes(std::as_bytes(bytes));
    if (p->id() != ids[i])
      return fail(ec::protocol_error, "page " + to_hex(ids[i]) + " was damaged on its way");
    pages.push_back(std::move(p));
    offset += size;
  }
  return pages;
}

page_store_actor::behavior_type make_page_store(
  page_store_actor::stateful_pointer<page_store_state> self, std::shared_ptr<page_cache> cache) {
  self->state.cache = std::move(cache);
  open_to_workers(caf::actor_cast<caf::actor>(self));
  self->set_down_handler([=](caf::down_msg& down) {
    self->state.watched.erase(down.source);
    std::vector<std::uint64_t> lost;
    for (const auto& [id, transfer] : self->state.transfers)
      if (transfer.remote.address() == down.source)
        lost.push_back(id);
    for (const auto id : lost)
      give_up(self, id,
              {ec::service_unavailable, "the node that has the pages is gone", "Try again", {}});
  });
  heed_only_own_exits(self);
  return {[=](get_atom, const hash_list& ids) -> caf::result<page_batch> {
            auto batch = pack(*self->state.cache, ids);
            if (!batch)
              return to_caf(batch.error());
            return std::move(*batch);
          },
          [=](fetch_atom, const caf::actor& remote, const hash_list& ids) {
            return fetch(self, remote, ids);
          }};
}

}  // namespace tedit::actors
