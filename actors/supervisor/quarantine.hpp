// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "protocol/operation_message.hpp"

namespace tedit::actors {

/// An edit as far as others are told of it.
struct edit_origin {
  std::string operation;  ///< Whose plugin it runs; empty: no plugin's.
  std::string document;
  std::string client;  ///< Who asked for it, as that client calls itself; may be empty.
};

/// Counts the edits that an operation's plugin failed by ending the process that ran it, by a crash
/// or a hang. An operation that failed too many edits in one document is switched off there; one
/// that is switched off in too many documents, everywhere: each of its edits costs others restarts.
/// What is off stays off until the server starts anew. Previews and deaths that another attempt
/// made good are not counted.
class quarantine {
public:
  /// `limit` edits, and documents, are too many; 0 switches nothing off.
  explicit quarantine(unsigned limit = 3) : limit_(limit) {}

  /// Notes that an edit failed: `how` is "was killed by signal 11 (Segmentation fault)". True when
  /// this was one too many.
  bool note(const edit_origin& edit, const std::string& how);

  /// Why the operation is not run in this document; nothing while it may.
  [[nodiscard]] std::optional<error> refusal(const edit_origin& edit) const;

  /// Whether edits are counted here; else their deaths belong to the pool's restart budget.
  [[nodiscard]] bool counts() const { return limit_ > 0; }

  /// A catalogue with the operations that are off everywhere among the refused.
  [[nodiscard]] operation_catalogue apply_to(const operation_catalogue& all) const;

private:
  /// The failed edits of one operation in one document.
  struct row {
    unsigned edits = 0;
    std::string last_client;
    std::string last_end;
  };
  using rows = std::map<std::string, row>;  ///< By document.

  [[nodiscard]] bool is_off(const row& r) const { return limit_ > 0 && r.edits >= limit_; }
  [[nodiscard]] bool is_off_everywhere(const rows& of) const;
  [[nodiscard]] std::string reason(const std::string& operation, const rows& in) const;

  unsigned limit_;
  std::map<std::string, rows> operations_;
};

/// Why work is refused whose worker did what it may not (base/misdeed.hpp): `how`, and whose doing
/// it was. `known` names the plugin of the operation and may be null.
[[nodiscard]] error refusal_of_misdeed(const edit_origin& work, const std::string& how,
                                       const operation_catalogue* known);

}  // namespace tedit::actors
