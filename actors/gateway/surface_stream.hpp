// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <unordered_set>

#include "actors/gateway/bulk.hpp"
#include "actors/local_messages.hpp"

namespace tedit::gateway {

/// What a connection wants beside displacement and von Mises stress.
struct watched_quantities {
  bool stress = false;
  bool safety_factor = false;
  bool relative_error = false;
};

/// What a client holds of a document's surface: the next update is the difference to it.
class surface_stream {
public:
  /// The update from what the client holds to `mesh`; the whole surface when it holds nothing.
  /// Nothing when it holds `mesh` already. Cost: O(changed pages) for differences, else
  /// O(boundary).
  [[nodiscard]] std::optional<bulk> update_to(const std::string& document, const version_ptr& mesh);

  /// The answer EditPreview with the difference from its base, which the client holds or is not
  /// interested in. What the client holds stays. Cost: as a difference, and O(boundary) for a
  /// client that holds nothing.
  [[nodiscard]] bulk preview(const actors::previewed& made) const;

  /// One field update of a solve: displacement, von Mises stress and what is watched of load case
  /// `index` at the boundary vertices, after the last of several load cases the envelope of all.
  /// Nothing when there is no such update.
  [[nodiscard]] static std::optional<bulk> fields_of(const actors::solved& event, unsigned index,
                                                     const watched_quantities& watched);

  /// The answer VersionSurface; what the client holds stays. Cost: O(boundary).
  [[nodiscard]] static bulk of_version(const actors::session_version& version);

private:
  bulk whole(const std::string& document, const mesh_version& mesh);

  version_ptr held_;
  std::unordered_set<vertex_id> vertices_;  ///< Of `held_`; the client has their positions.
};

}  // namespace tedit::gateway
