// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

namespace tedit::ops {

/// A closed surface of triangles that is changed one edge at a time: what an exact boolean leaves,
/// on its way to a surface that tets fit on. Triangles have a label (the surface that they belong
/// to) and the normal of the triangle that they came from; an edge between two labels or with a
/// sharp bend is a crease and stays one. It may bound several regions that are bonded: more than
/// two triangles meet where an interface ends, which is a crease, too. Slots of triangles that went
/// are marked; vertices without triangles are just left.
class surface_mesh {
public:
  using triangle = std::array<std::uint32_t, 3>;

  struct face {
    triangle v;
    std::int32_t label = 0;
    /// The region that it bounds, and the one beyond it or -1: there it is an interface.
    std::array<std::int32_t, 2> sides{0, -1};
    bool frozen = false;  ///< It stays as it is, with its corners.
    bool alive = true;
    vec3 normal;  ///< Unit, outward, of what it is a part of.
    /// m: a facet of a round wall is no more than near that, and may be left by so much.
    double slack = 0;
  };

  struct vertex {
    vec3 position;
    double size = 0;           ///< m: how long edges here should be.
    std::int32_t origin = -1;  ///< The point of the part that it is, or -1.
    bool fixed = false;
  };

  /// How free a vertex is.
  enum class freedom {
    face,    ///< Within a face.
    crease,  ///< Along a crease.
    corner,  ///< Not at all, but it may be merged with what is next to it.
    fixed,   ///< Not at all.
  };

  std::vector<vertex> vertices;
  std::vector<face> faces;

  /// Cosine of the bend from which on an edge within a surface is a crease.
  static constexpr double sharp = 0.766;       // 40 degrees
  static constexpr double any_bend = 0.99999;  // 0.26 degrees
  double crease_cosine = sharp;

  /// After vertices and faces were filled in: finds what lies where, and fixes the corners of
  /// frozen faces and of edges at which a region has not two faces.
  void connect();

  [[nodiscard]] const std::vector<std::uint32_t>& faces_at(std::uint32_t v) const { return at_[v]; }
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  [[nodiscard]] freedom freedom_of(std::uint32_t v) const;
  /// The vertices at the other ends of the creases at v.
  [[nodiscard]] std::vector<std::uint32_t> creases_at(std::uint32_t v) const;
  /// The two faces at an edge; false when it has not two.
  [[nodiscard]] bool faces_of_edge(std::uint32_t a, std::uint32_t b,
                                   std::array<std::uint32_t, 2>& found) const;
  /// All faces at an edge, more than two where an interface ends; none where there is no edge.
  [[nodiscard]] std::vector<std::uint32_t> all_faces_of_edge(std::uint32_t a,
                                                             std::uint32_t b) const;
  /// There are two faces, or more where several regions are bounded.
  [[nodiscard]] bool is_edge(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool is_crease(std::uint32_t a, std::uint32_t b) const;
  /// May the edge go, with its faces: is none frozen, do its ends share no other neighbours than
  /// the opposite corners, and does no interface's end become another's?
  [[nodiscard]] bool may_go(std::uint32_t a, std::uint32_t b) const;

  [[nodiscard]] vec3 normal_of(const triangle& t) const;  ///< Twice the area long.
  /// 4 sqrt(3) area / sum of squared edges: 1 for the regular triangle.
  [[nodiscard]] double shape_of(const triangle& t) const;
  [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] double volume() const;  ///< m^3: of what it bounds, interfaces left out.
  [[nodiscard]] double size(std::uint32_t a, std::uint32_t b) const {
    return 0.5 * (vertices[a].size + vertices[b].size);
  }

  /// Takes the edge out: u's faces are v's afterwards. Whoever calls has asked `may_go`.
  void merge(std::uint32_t u, std::uint32_t v);
  /// A vertex at p on the edge, halving its faces; no_id where one is frozen.
  std::uint32_t split(std::uint32_t a, std::uint32_t b, vec3 p);
  /// Turns the edge within the quadrangle of its two faces. Whoever calls has seen that it may.
  void turn(std::uint32_t a, std::uint32_t b, const std::array<std::uint32_t, 2>& at);
  /// The corners of the two faces at an edge as they would be after `turn`; false where they must
  /// not be turned at all.
  [[nodiscard]] bool turned(std::uint32_t a, std::uint32_t b,
                            const std::array<std::uint32_t, 2>& at,
                            std::array<triangle, 2>& result) const;

private:
  [[nodiscard]] bool has(std::uint32_t f, std::uint32_t v) const {
    const auto& c = faces[f].v;
    return c[0] == v || c[1] == v || c[2] == v;
  }
  [[nodiscard]] bool bends(std::uint32_t f, std::uint32_t g) const;
  [[nodiscard]] bool is_regular(std::uint32_t v, std::int32_t side) const;
  [[nodiscard]] bool is_one_fan(std::vector<std::uint32_t> left) const;
  [[nodiscard]] bool is_at_interface_end(std::uint32_t v) const;
  [[nodiscard]] bool closes_pocket(std::uint32_t a, std::uint32_t b,
                                   const std::vector<std::uint32_t>& common) const;
  void drop(std::uint32_t f);
  void add(const triangle& t, std::uint32_t like);

  std::vector<std::vector<std::uint32_t>> at_;
  std::int32_t side_count_ = 1;
};

}  // namespace tedit::ops
