// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "actors/local_messages.hpp"

namespace tedit::actors {

/// A change of a document as it was asked for.
struct asked_change {
  std::string what;  ///< As in the log: "edit", "undo", "load_case", ...
  std::string how;   ///< A JSON object, its keys in alphabetic order.

  /// Two that ask for the same have one.
  [[nodiscard]] hash128 id() const;
};

/// A change that was made, as its log row has it.
struct past_change {
  std::string what;
  std::string operation;                 ///< Of an edit.
  std::string client;                    ///< Who asked, by name.
  std::string time;                      ///< UTC, "2026-11-23T08:45:00Z".
  std::string edit_id;                   ///< May be empty.
  hash128 request;                       ///< `asked_change::id`.
  std::optional<std::uint32_t> version;  ///< The head that it led to, when it moved the head.
  std::vector<std::string> warnings;     ///< Of an import.

  /// The details of its log row; `how` as it was asked for.
  [[nodiscard]] std::string to_details(const std::string& how) const;

  /// The inverse; nothing for rows of older servers, which say less.
  [[nodiscard]] static std::optional<past_change> from_log(const store::log_row& row);
};

/// The present time as `past_change` has it.
[[nodiscard]] std::string utc_now();

/// Errors: `invalid_argument` for one that is too long or has odd characters.
[[nodiscard]] expected<void> check_edit_id(const std::string& id);

/// Fills in who made each version and when, as far as the newest `most_told` changes say.
/// Cost: O(those), some us each.
void tell_makers(const std::vector<store::log_row>& rows, std::vector<graph_node>& nodes);

/// What a session remembers of its document's past: who moved the head last, and the changes with
/// an edit id, the newest `most_remembered`.
class change_log {
public:
  static constexpr std::size_t most_remembered = 1000;

  change_log() = default;
  /// Cost: O(`most_remembered`), however long the log is.
  explicit change_log(const std::vector<store::log_row>& rows);

  void add(past_change made);

  /// The change with this edit id, or null. Valid until the next `add`.
  [[nodiscard]] const past_change* find(const std::string& edit_id) const;

  /// The last change that moved the head, when it is known.
  [[nodiscard]] const std::optional<past_change>& last_move() const { return last_move_; }

private:
  std::deque<past_change> with_id_;
  std::optional<past_change> last_move_;
};

}  // namespace tedit::actors
