// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <set>

#include "actors/interfaces.hpp"
#include "actors/pages/page_cache.hpp"

namespace tedit::actors {

/// A batch holds at most this many bytes, so that control messages never wait long behind it.
inline constexpr std::size_t max_batch_bytes = 256 * 1024;

/// Batches asked for and not yet here, per transfer (docs/decisions/0008).
inline constexpr std::size_t transfer_credit = 6;

struct page_store_state {
  /// One pull of pages from another node.
  struct transfer {
    caf::actor remote;
    std::shared_ptr<page_map> pages = std::make_shared<page_map>();
    std::deque<hash_list> batches;  ///< Still to ask for.
    std::size_t in_flight = 0;
    std::size_t moved = 0;
    caf::typed_response_promise<page_set> promise;
  };

  std::shared_ptr<page_cache> cache;
  std::map<std::uint64_t, transfer> transfers;
  std::uint64_t next = 0;
  std::set<caf::actor_addr> watched;  ///< Stores whose end must be noticed.

  static inline const char* name = "page_store";
};

/// Answers for the pages of this process and pulls missing ones from other nodes: batches of at
/// most 256 KiB, `transfer_credit` at a time, each page checked against its hash.
page_store_actor::behavior_type make_page_store(
  page_store_actor::stateful_pointer<page_store_state> self, std::shared_ptr<page_cache> cache);

/// The pages of a list packed into one batch. Errors: `not_found`, `invalid_argument` when the
/// batch would be too large.
[[nodiscard]] expected<page_batch> pack(page_cache& cache, const hash_list& ids);

/// Checks sizes and hashes and returns the pages. Errors: `protocol_error`.
[[nodiscard]] expected<std::vector<page_ptr>> unpack(const page_batch& batch, const hash_list& ids);

/// Splits a list into batches that fit, at most `max_batch_bytes / max_page_bytes` pages each.
[[nodiscard]] std::deque<hash_list> split(const hash_list& ids);

}  // namespace tedit::actors
