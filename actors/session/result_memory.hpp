// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "mesh/field.hpp"

namespace tedit::actors {

/// The fields of results that a server keeps, of all its documents together: those used last stay,
/// up to a budget. Thread-safe.
class result_memory : public std::enable_shared_from_this<result_memory> {
public:
  using fields_ptr = std::shared_ptr<const std::vector<field>>;

  /// A place for one result's fields; they are given back with it.
  class slot;
  using handle = std::shared_ptr<slot>;

  explicit result_memory(std::uint64_t budget_bytes) : budget_(budget_bytes) {}

  /// Those used longest ago give way; these stay until others come, however large they are.
  [[nodiscard]] handle keep(fields_ptr fields);

  /// Null when they had to give way. Counts as a use.
  [[nodiscard]] fields_ptr find(const handle& place);

  [[nodiscard]] bool has(const handle& place) const;

  /// Bytes of what is kept.
  [[nodiscard]] std::uint64_t used() const;
  [[nodiscard]] std::uint64_t budget() const noexcept { return budget_; }

private:
  void release(slot& place);

  const std::uint64_t budget_;
  mutable std::mutex mutex_;  ///< Guards what follows, and all slots.
  std::uint64_t used_ = 0;
  std::list<slot*> recent_;  ///< Those with fields, used last at the front.
};

}  // namespace tedit::actors
