// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "actors/interfaces.hpp"
#include "actors/pages/page_batch.hpp"
#include "actors/pages/page_cache.hpp"

namespace tedit::actors {

/// Batches asked for and not yet here, of one node (docs/decisions/0008).
inline constexpr std::size_t transfer_credit = 6;

/// What comes slower than this (bytes a second) is asked for packed: zstd is far quicker, and what
/// a link between processes of one machine carries is ten times as much.
inline constexpr double packing_rate = 25e6;

/// Whether a line is known to be so slow. @param rate as a store answers it.
[[nodiscard]] inline bool is_slow(double rate) {
  return rate > 0 && rate < packing_rate;
}

/// So much of a slow line's time may be asked for at once: others get their turn meanwhile, and no
/// batch is late for those before it.
inline constexpr std::chrono::seconds most_ahead{3};

/// Of so many lists of pages it is known where they lie; the oldest is forgotten first, as workers
/// forget results.
inline constexpr std::size_t places_kept = 64;

struct page_store_state {
  using clock = std::chrono::steady_clock;

  /// One pull of pages from another node.
  struct transfer {
    caf::actor remote;
    std::shared_ptr<page_map> pages = std::make_shared<page_map>();
    std::deque<hash_list> batches;  ///< Still to ask for.
    std::size_t in_flight = 0;      ///< Batches.
    std::size_t awaited = 0;        ///< Pages that other transfers bring.
    std::size_t moved = 0;
    caf::typed_response_promise<page_set> promise;
  };

  /// A page that is asked for: by whom, and which other transfers want it, too.
  struct coming_page {
    std::uint64_t brought_by = 0;
    std::vector<std::uint64_t> also_for;
  };

  /// What the way from another node is like.
  struct line {
    std::size_t in_flight = 0;  ///< Batches of all its transfers.
    clock::time_point since;    ///< Since when some are.
    double bytes = 0;           ///< That came in that time.
    double rate = 0;            ///< Bytes a second; 0: not known.

    /// Batches that may be in flight.
    [[nodiscard]] std::size_t credit() const;
    void note(double size, clock::time_point now);
  };

  /// Pages that lie with another node.
  struct place {
    caf::actor node;
    hash_list pages;  ///< Sorted.
  };

  /// The node that has a page, as somebody of this process said; null if nobody did.
  [[nodiscard]] caf::actor place_of(const hash128& id) const;

  std::shared_ptr<page_cache> cache;
  std::map<std::uint64_t, transfer> transfers;
  std::map<hash128, coming_page> coming;
  std::map<caf::actor_addr, line> lines;  ///< To stores whose end must be noticed.
  std::deque<place> places;               ///< The newest first.
  std::uint64_t next = 0;

  static inline const char* name = "page_store";
};

/// Answers for the pages of this process and pulls missing ones from other nodes: batches of at
/// most 256 KiB, `transfer_credit` at a time, each page checked against its hash. A page that
/// several want is asked for once; where that fails, the next of them asks its own node. What a
/// result of this process has elsewhere is pulled from there (docs/decisions/0066).
page_store_actor::behavior_type make_page_store(
  page_store_actor::stateful_pointer<page_store_state> self, std::shared_ptr<page_cache> cache);

}  // namespace tedit::actors
