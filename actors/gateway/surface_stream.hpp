// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <unordered_set>

#include "actors/gateway/bulk.hpp"
#include "actors/local_messages.hpp"
#include "fem/quantities.hpp"

namespace tedit::gateway {

/// Names of the arrays (`fem::result_arrays`) that a connection wants beside those that it gets
/// anyway.
using watched_quantities = std::set<std::string, std::less<>>;

/// Whether a connection gets an array of each load case.
[[nodiscard]] inline bool is_wanted(const fem::result_array& array,
                                    const watched_quantities& watched) {
  using enum fem::array_sent;
  return array.sent == always || (array.sent == on_request && watched.contains(array.name));
}

/// What a client holds of a document's surface: the next update is the difference to it.
class surface_stream {
public:
  /// The update from what the client holds to `mesh`; the whole surface when it holds nothing.
  /// Nothing when it holds `mesh` already, unless it was `resumed`: then an empty one says so.
  /// Cost: O(changed pages) for differences, else O(boundary).
  [[nodiscard]] std::optional<bulk> update_to(const std::string& document, const version_ptr& mesh);

  /// The client holds the surface of this version from an earlier connection. @pre nothing was sent
  /// yet. Cost: O(boundary).
  void resume(const version_ptr& held);

  [[nodiscard]] bool is_empty() const { return !held_; }

  /// The answer EditPreview with the difference from its base, which the client holds or is not
  /// interested in. What the client holds stays. Cost: as a difference, and O(boundary) for a
  /// client that holds nothing.
  [[nodiscard]] bulk preview(const actors::previewed& made) const;

  /// One field update of a solve: the arrays that are always sent and those that are watched of
  /// load case `index` at the boundary vertices, as far as it has them, after the last of several
  /// load cases the envelope of all. Nothing when there is no such update.
  [[nodiscard]] static std::optional<bulk> fields_of(const actors::solved& event, unsigned index,
                                                     const watched_quantities& watched);

  /// The answer VersionSurface; what the client holds stays. Cost: O(boundary).
  [[nodiscard]] static bulk of_version(const actors::session_version& version);

private:
  bulk whole(const std::string& document, const mesh_version& mesh);

  version_ptr held_;
  bool resumed_ = false;                    ///< And nothing was sent since.
  std::unordered_set<vertex_id> vertices_;  ///< Of `held_`; the client has their positions.
};

}  // namespace tedit::gateway
