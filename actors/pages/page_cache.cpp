// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/pages/page_cache.hpp"

#include "base/metrics.hpp"

namespace tedit::actors {

void page_cache::put(const page_ptr& p) {
  const auto& id = p->id();  // Hashes outside the lock.
  const std::lock_guard lock(mutex_);
  auto& e = entries_.try_emplace(id, entry{p, recent_.end()}).first->second;
  const auto known = e.alive.lock();
  if (!known)
    e.alive = p;
  keep(e, known ? known : p);
  if (++puts_ % 65536 == 0)
    forget_dead_entries();
}

void page_cache::put(const mesh_version& version) {
  version.for_each_page([&](const page_ptr& p) { put(p); });
}

page_ptr page_cache::find(const hash128& id) {
  const std::lock_guard lock(mutex_);
  static auto& hits = metrics::count_of("tedit_page_hits_total", "Pages asked for and known.");
  static auto& misses =
    metrics::count_of("tedit_page_misses_total", "Pages asked for and not known.");
  const auto found = entries_.find(id);
  auto p = found == entries_.end() ? nullptr : found->second.alive.lock();
  (p ? hits : misses).add();
  if (p)
    keep(found->second, p);
  return p;
}

page_cache::use page_cache::usage() const {
  const std::lock_guard lock(mutex_);
  use result{0, kept_, budget_};
  for (const auto& [id, e] : entries_)
    if (const auto p = e.alive.lock())
      result.known += p->bytes().size();
  return result;
}

void page_cache::keep(entry& e, const page_ptr& p) {
  if (e.kept != recent_.end()) {
    recent_.splice(recent_.begin(), recent_, e.kept);
    return;
  }
  recent_.push_front(p);
  e.kept = recent_.begin();
  kept_ += p->bytes().size();
  while (kept_ > budget_) {
    const auto last = recent_.back();
    kept_ -= last->bytes().size();
    entries_.at(last->id()).kept = recent_.end();
    recent_.pop_back();
  }
}

void page_cache::forget_dead_entries() {
  std::erase_if(entries_, [](const auto& row) { return row.second.alive.expired(); });
}

}  // namespace tedit::actors
