// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>
#include <unordered_map>

#include "mesh/version.hpp"

namespace tedit::actors {

/// The pages that a process knows. A page is found for as long as somebody holds it; beyond that
/// the pages used last stay, up to a budget. Thread-safe.
class page_cache {
public:
  explicit page_cache(std::size_t budget_bytes) : budget_(budget_bytes) {}

  void put(const page_ptr& p);

  /// All pages of a version. Cost: O(pages).
  void put(const mesh_version& version);

  /// Null when it is not known.
  [[nodiscard]] page_ptr find(const hash128& id);

  /// Bytes of pages.
  struct use {
    std::uint64_t known = 0;   ///< Whoever holds them.
    std::uint64_t recent = 0;  ///< Of these, that stay for having been used last.
    std::uint64_t budget = 0;  ///< For those.
  };
  /// Cost: O(pages).
  [[nodiscard]] use usage() const;

private:
  using order = std::list<page_ptr>;
  struct entry {
    std::weak_ptr<const page> alive;
    order::iterator kept;  ///< `recent_.end()` when only others hold it.
  };

  void keep(entry& e, const page_ptr& p);
  void forget_dead_entries();

  mutable std::mutex mutex_;
  std::size_t budget_;
  std::size_t kept_ = 0;
  std::size_t puts_ = 0;
  order recent_;  ///< Used last at the front.
  std::unordered_map<hash128, entry> entries_;
};

}  // namespace tedit::actors
