// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace tedit::actors {

/// What kind of work waits for a worker, the most urgent first.
enum class urgency {
  edit,     ///< Edits, imports, selections, solves: a person waits for them.
  preview,  ///< Edits that are only looked at; another value is already on its way.
  file,     ///< Exports: long, and nobody is in a hurry.
};

/// A job that waits, as far as its turn is concerned.
struct turn {
  urgency what = urgency::edit;
  std::uint64_t client = 0;    ///< Who asked; 0: nobody, it follows from the document.
  std::uint64_t document = 0;  ///< 0: none.
  bool again = false;          ///< Its worker died: it had its turn already.
};

/// Says whose turn it is: the more urgent first, among equally urgent ones the client that was
/// served longest ago, of that client the document, then whoever came first. Files do not wait for
/// ever: when `others_between` other jobs have gone before them, one of them goes.
class turn_order {
public:
  static constexpr int others_between = 4;

  /// The place of the next one in `waiting`, which is in the order of arrival and not empty; it
  /// counts as served. Cost: O(waiting).
  [[nodiscard]] std::size_t take(const std::vector<turn>& waiting);

private:
  using clock = std::uint64_t;

  [[nodiscard]] urgency level_of(const std::vector<turn>& waiting);
  [[nodiscard]] clock served(std::uint64_t who) const;

  clock now_ = 0;
  std::map<std::uint64_t, clock> served_;  ///< Clients and documents, by actor.
  int passed_ = 0;                         ///< Other jobs that went while a file waited.
};

}  // namespace tedit::actors
