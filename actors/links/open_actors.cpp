// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/links/open_actors.hpp"

#include <mutex>
#include <set>
#include <unordered_set>

namespace tedit::actors {

namespace {

struct open_numbers {
  std::mutex mutex;
  std::unordered_set<std::uint64_t> all;
};

open_numbers& numbers() {
  static open_numbers one;
  return one;
}

}  // namespace

void open_to_workers(const caf::actor& one) {
  const std::lock_guard lock(numbers().mutex);
  numbers().all.insert(one.id());
}

reach reach_of_workers() {
  return [](std::uint64_t actor) {
    const std::lock_guard lock(numbers().mutex);
    return numbers().all.contains(actor);
  };
}

reach reach_of(const std::vector<caf::actor>& some) {
  std::set<std::uint64_t> numbers;
  for (const auto& one : some)
    numbers.insert(one.id());
  return [numbers](std::uint64_t actor) { return numbers.contains(actor); };
}

}  // namespace tedit::actors
