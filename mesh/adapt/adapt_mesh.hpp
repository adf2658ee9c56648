// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/builder.hpp"

namespace tedit {

/// What a triangle is whose two sides are not the same material.
enum class skin_kind : std::uint8_t {
  outside,    ///< A boundary facet.
  interface,  ///< Between regions, with a surface of the table.
  border      ///< Between regions, without one.
};

/// What is known of such a triangle.
struct skin {
  surface_id surface = 0;
  skin_kind kind = skin_kind::outside;
  double deviation = 0;  ///< m: how far it is from where that surface was, at most.

  [[nodiscard]] bool same_wall(const skin& other) const {
    return surface == other.surface && kind == other.kind;
  }
};

/// A flat copy of a mesh whose edges are split and contracted many times: tets know their corners,
/// vertices their tets, and triangles of boundary and interfaces are found by their corners. What
/// was changed goes back as one change of a builder. Numbers of vertices and tets begin as the
/// version's slots. Not thread-safe.
class adapt_mesh {
public:
  /// Cost: O(mesh), 200 bytes a tet.
  explicit adapt_mesh(const mesh_version& mesh);

  // -- reading -----------------------------------------------------------------

  [[nodiscard]] std::size_t vertex_slots() const { return at_.size(); }
  [[nodiscard]] std::size_t tet_slots() const { return tets_.size(); }
  [[nodiscard]] std::size_t tet_count() const { return live_; }
  [[nodiscard]] bool is_live(std::uint32_t t) const { return tets_[t].v[0] != no_id; }
  [[nodiscard]] const tet& tet_at(std::uint32_t t) const { return tets_[t]; }
  [[nodiscard]] vec3 at(std::uint32_t v) const { return at_[v]; }
  [[nodiscard]] const std::vector<std::uint32_t>& star(std::uint32_t v) const { return stars_[v]; }
  [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const {
    return norm(at_[a] - at_[b]);
  }
  [[nodiscard]] std::array<vec3, 4> corners(std::uint32_t t) const;

  /// The tets that hold both. Cost: O(star of a).
  void ring(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& result) const;

  /// Null where the triangle is inside one material, or no triangle.
  [[nodiscard]] const skin* skin_at(const std::array<std::uint32_t, 3>& v) const;

  /// The triangles of the skin at a vertex, corners in the order of one of their tets, v first.
  struct skin_triangle {
    std::array<std::uint32_t, 3> v;
    skin what;
  };
  void skin_around(std::uint32_t v, std::vector<skin_triangle>& result) const;

  // -- changing ----------------------------------------------------------------

  /// A new vertex on the edge of these tets (its whole ring), at `place`; its number.
  std::uint32_t split(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> ring,
                      vec3 place);

  /// Draws `from` along an edge to `to`; the skin's triangles that move there get `deviation`. The
  /// link condition is for the caller to look at.
  void contract(std::uint32_t from, std::uint32_t to, double deviation);

  /// Makes all changes in a builder of the same version. Errors: `invalid_mesh`. Cost: O(changes).
  [[nodiscard]] expected<void> write(mesh_builder& mesh) const;

private:
  struct key_hash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& v) const noexcept {
      return (v[0] * 0x9E3779B97F4A7C15ull) ^ (v[1] * 0xC2B2AE3D27D4EB4Full) ^
             (v[2] * 0x165667B19E3779F9ull);
    }
  };

  void add_skin(const std::array<std::uint32_t, 3>& v, const skin& what);
  std::optional<skin> take_skin(const std::array<std::uint32_t, 3>& v);
  void add_tet(const tet& corners, region_id region);
  void remove_tet(std::uint32_t t);

  std::vector<vec3> at_;
  std::vector<tet> tets_;
  std::vector<region_id> regions_;
  std::vector<std::vector<std::uint32_t>> stars_;
  std::unordered_map<std::array<std::uint32_t, 3>, skin, key_hash> skin_;
  std::vector<std::uint32_t> skin_at_;                    ///< Triangles of the skin at each vertex.
  std::vector<tet_id> removed_;                           ///< Of the version.
  std::vector<std::array<std::uint32_t, 3>> fresh_skin_;  ///< Added since, some gone again.
  std::uint32_t first_new_vertex_ = 0;
  std::uint32_t first_new_tet_ = 0;  ///< 0 while the version is copied.
  std::size_t live_ = 0;
  bool interfaces_changed_ = false;
};

}  // namespace tedit
