// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace tedit::actors {

/// Counts how often an operation ended the process that ran it, by a crash or a hang. One that did
/// so too often is switched off until the server starts anew: each of its edits would cost the
/// others a restart.
class quarantine {
public:
  /// `limit` deaths are too many; 0 switches nothing off.
  explicit quarantine(unsigned limit = 3) : limit_(limit) {}

  /// Notes that the process died or hung while the operation ran: `how` is "was killed by signal 11
  /// (Segmentation fault)". True when this was one too many.
  bool note(const std::string& operation, const std::string& how);

  /// Why the operation is not run; nothing while it may.
  [[nodiscard]] std::optional<error> refusal(const std::string& operation) const;

  /// Whether deaths are counted here; else they belong to the pool's restart budget.
  [[nodiscard]] bool counts() const { return limit_ > 0; }

  /// A catalogue (the protocol's JSON) with the operations that are off among the refused.
  [[nodiscard]] std::string apply_to(const std::string& catalogue) const;

private:
  struct row {
    unsigned deaths = 0;
    std::string last;
  };

  [[nodiscard]] bool is_off(const row& r) const { return limit_ > 0 && r.deaths >= limit_; }
  [[nodiscard]] std::string reason(const std::string& operation, const row& r) const;

  unsigned limit_;
  std::map<std::string, row> rows_;
};

}  // namespace tedit::actors
