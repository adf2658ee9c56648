// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "client/slot_table.hpp"
#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit::client {

/// A triangle of the boundary by its vertex slots, in outward order.
struct surface_facet {
  std::array<vertex_id, 3> v{no_id, no_id, no_id};
  surface_id surface = 0;

  friend bool operator==(const surface_facet&, const surface_facet&) = default;
};

/// What the server says about one surface.
struct surface_row {
  surface_id id = 0;
  std::string name;
  std::uint64_t facets = 0;
  double area_m2 = 0;
};

/// The message `tedit.v1.SurfaceUpdate` with its arrays.
struct surface_update {
  std::string version_id;
  std::string base_version_id;  ///< Empty: the whole surface.
  std::vector<surface_row> surfaces;
  std::vector<surface_id> removed;
  std::vector<std::uint32_t> removed_facets;  ///< Slots.
  std::vector<std::uint32_t> vertices;        ///< Slots.
  std::vector<double> positions;              ///< m, 3 per vertex.
  std::vector<std::uint32_t> facets;          ///< Slots.
  std::vector<std::uint32_t> facet_vertices;  ///< Vertex slots, 3 per facet.
  std::vector<surface_id> facet_surfaces;     ///< 1 per facet.
};

/// The boundary of a document's head as the client holds it, kept up to date by differences.
/// Copies are cheap (one pointer per 1024 slots) and independent. Not thread-safe by itself.
class surface_model {
public:
  /// Takes an update over: removals first, then vertices, then facets. On an error the model is as
  /// before. Removing what is not held is no error.
  /// Errors: `protocol_error` when the base is not the version that is held, array sizes do not
  /// match, a slot is out of range or a facet names a vertex that is not held.
  /// Cost: O(update), plus a copy of the touched pages.
  [[nodiscard]] expected<void> apply(const surface_update& update);

  /// 32 hexadecimal digits; empty before the first update.
  [[nodiscard]] const std::string& version_id() const noexcept { return version_id_; }

  /// By facet slot.
  [[nodiscard]] const slot_table<surface_facet>& facets() const noexcept { return facets_; }

  /// By vertex slot, m. Vertices that no facet uses any more stay until the next whole surface.
  [[nodiscard]] const slot_table<vec3>& positions() const noexcept { return positions_; }

  /// The server's rows by id.
  [[nodiscard]] const std::map<surface_id, surface_row>& surfaces() const noexcept {
    return surfaces_;
  }

  [[nodiscard]] std::size_t total_facets() const noexcept { return facets_.size(); }

  /// m^2, from the facets that are held, not from the server's row; 0 for an unknown surface.
  /// Cost: O(total_facets).
  [[nodiscard]] double area(surface_id surface) const;

private:
  void take(const surface_update& update);
  [[nodiscard]] expected<void> check_references(const surface_update& update) const;

  std::string version_id_;
  slot_table<surface_facet> facets_;
  slot_table<vec3> positions_;
  std::map<surface_id, surface_row> surfaces_;
};

}  // namespace tedit::client
