// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "mesh/spline_surface.hpp"
#include "mesh/vec3.hpp"

namespace tedit {

// Indices are 32-bit slots, stable over an edit: removed slots become tombstones that later edits
// reuse. Surface and region ids are the CAD system's own numbers, sparse, never used as an index.
using vertex_id = std::uint32_t;
using tet_id = std::uint32_t;
using facet_id = std::uint32_t;
using surface_id = std::int64_t;
using region_id = std::int32_t;

inline constexpr std::uint32_t no_id = std::numeric_limits<std::uint32_t>::max();

/// At most this many slots of one kind: the top bit of an adjacency entry is a flag.
inline constexpr std::uint32_t max_slots = 0x7FFFFFF0;

/// A volume element by its corner vertices: det[v1-v0, v2-v0, v3-v0] > 0.
/// A tombstone has v[0] == no_id and the next free slot in v[1].
struct tet {
  std::array<vertex_id, 4> v{no_id, no_id, no_id, no_id};

  friend bool operator==(const tet&, const tet&) = default;
};

/// The corners of local face i (opposite corner i) in outward order.
inline constexpr std::array<std::array<int, 3>, 4> tet_faces{
  {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// What lies behind the four faces of a tet: a tet id, or a facet id with `facet_flag` set.
using adjacency = std::array<std::uint32_t, 4>;

inline constexpr std::uint32_t facet_flag = 0x80000000u;

[[nodiscard]] constexpr bool is_facet(std::uint32_t adjacent) {
  return (adjacent & facet_flag) != 0;
}

/// A triangle of the boundary: corners in outward order, the tet behind it and the surface it
/// belongs to. A tombstone has tet == no_id and the next free slot in v[0].
struct boundary_facet {
  std::array<vertex_id, 3> v{no_id, no_id, no_id};
  tet_id tet = no_id;
  surface_id surface = 0;

  friend bool operator==(const boundary_facet&, const boundary_facet&) = default;
};
static_assert(sizeof(boundary_facet) == 24);

/// A triangle between two regions that carries a surface id (bonded parts of an assembly).
struct interface_facet {
  std::array<vertex_id, 3> v{no_id, no_id, no_id};
  std::uint32_t reserved = 0;  ///< Keeps the bytes free of padding.
  surface_id surface = 0;

  friend bool operator==(const interface_facet&, const interface_facet&) = default;
};
static_assert(sizeof(interface_facet) == 24);

/// The exact shape that a CAD model, or a tool, has behind a surface. Facets tell less: two rows of
/// corners may be those of a cone or of a fillet.
struct surface_geometry {
  enum class kind : std::uint8_t { none, plane, cylinder, cone, sphere, torus, spline };

  kind type = kind::none;
  vec3 point;         ///< m: on the plane or the axis; the centre of a sphere or torus.
  vec3 axis;          ///< Unit: the plane's normal, or the direction of the axis; of no sphere.
  double radius = 0;  ///< m; of a cone at `point`, of a torus' ring.
  double slope = 0;   ///< By how much a cone's radius grows along the axis, m per m.
  double tube_radius = 0;  ///< m; of a torus.
  double tolerance = 0;    ///< m: so far may edges of the CAD model be off it.
  std::shared_ptr<const spline_surface> spline = nullptr;  ///< Of free form.

  friend bool operator==(const surface_geometry& a, const surface_geometry& b) {
    return a.type == b.type && a.point == b.point && a.axis == b.axis && a.radius == b.radius &&
           a.slope == b.slope && a.tube_radius == b.tube_radius && a.tolerance == b.tolerance &&
           (a.spline == b.spline || (a.spline && b.spline && *a.spline == *b.spline));
  }
};

/// Is it of a known kind, and each number finite? For what comes from outside.
[[nodiscard]] inline bool is_possible(const surface_geometry& g) {
  using kind = surface_geometry::kind;
  if (g.type > kind::spline || (g.type == kind::spline) != (g.spline != nullptr))
    return false;
  return is_finite(g.point) && is_finite(g.axis) && std::isfinite(g.radius) &&
         std::isfinite(g.slope) && std::isfinite(g.tube_radius) && std::isfinite(g.tolerance) &&
         (!g.spline || is_possible(*g.spline));
}

/// A named set of boundary facets: what a person picks.
struct surface_info {
  surface_id id = 0;
  std::string name;
  /// As it was imported, or as the tool had it that made it. An edit may have moved the facets
  /// since: see mesh/features/known_wall.hpp.
  surface_geometry geometry = {};

  friend bool operator==(const surface_info&, const surface_info&) = default;
};

/// A named set of tets with one material.
struct region_info {
  region_id id = 0;
  std::string name;

  friend bool operator==(const region_info&, const region_info&) = default;
};

}  // namespace tedit
