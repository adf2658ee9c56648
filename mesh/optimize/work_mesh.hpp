// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/sparse_numbers.hpp"
#include "mesh/builder.hpp"
#include "mesh/face_key.hpp"

namespace tedit {

/// What a vertex of a work mesh may do.
enum class vertex_kind : std::uint8_t {
  interior,  ///< No facet touches it and all its tets are here.
  boundary,  ///< On the part's boundary; all its tets are here and form one fan.
  fixed      ///< On a wall (tets beyond, another region) or where several fans meet.
};

/// One change of a work mesh, as `cavity_change` is one of a builder.
struct work_change {
  std::vector<std::uint32_t> removed;
  std::vector<std::array<std::uint32_t, 4>> added;
  std::vector<new_facet> facets;  ///< Surfaces of faces that become boundary.
  double worst = 0;               ///< q of the worst added tet.
  double deviation = 0;           ///< m: how far the new facets are from the original surface.
};

/// The tets around an edge in order, with the vertices of their opposite edges.
struct work_ring {
  std::vector<std::uint32_t> tets;
  std::vector<std::uint32_t> link;  ///< As many as tets when closed, else one more.
  bool closed = false;
  std::uint32_t first_facet =
    0;  ///< Open: the facets (a, b, link.front()) and (a, b, link.back()).
  std::uint32_t last_facet = 0;
};

/// A flat copy of those tets of a builder that may change, in numbers of its own: the optimizer
/// looks at each tet hundreds of times, and pages and hash sets would be what it spends its time
/// on. Faces to other tets and to other regions are walls and stay. Reading from several threads is
/// safe while nobody changes it; `move` of vertices that share no tet is, too.
class work_mesh {
public:
  /// What lies behind a face that must stay.
  static constexpr std::uint32_t wall = no_id;

  /// Copies the live ones among `tets`. With `keep_boundary` all vertices on it are fixed, which
  /// saves counting the tets at them. Cost: O(slots of the mesh), else O(tets) and 8 bytes a slot.
  work_mesh(const mesh_builder& mesh, std::span<const tet_id> tets, bool keep_boundary = false);

  // -- reading -------------------------------------------------------------------

  [[nodiscard]] std::uint32_t tet_slots() const { return static_cast<std::uint32_t>(tets_.size()); }
  [[nodiscard]] std::uint32_t vertices() const { return static_cast<std::uint32_t>(at_.size()); }
  [[nodiscard]] bool is_live(std::uint32_t t) const { return tets_[t][0] != no_id; }
  [[nodiscard]] const std::array<std::uint32_t, 4>& tet_at(std::uint32_t t) const {
    return tets_[t];
  }
  /// A tet, `wall`, or a facet's number with `facet_flag`.
  [[nodiscard]] const std::array<std::uint32_t, 4>& behind(std::uint32_t t) const {
    return behind_[t];
  }
  [[nodiscard]] vec3 at(std::uint32_t v) const { return at_[v]; }
  [[nodiscard]] vertex_kind kind(std::uint32_t v) const { return kind_[v]; }
  [[nodiscard]] bool is_live_vertex(std::uint32_t v) const { return vertex_tet_[v] != no_id; }
  [[nodiscard]] double quality(std::uint32_t t) const { return quality_[t]; }

  /// When something around one of the tet's corners last changed, counted in changes.
  [[nodiscard]] std::uint64_t changed_at(std::uint32_t t) const;
  [[nodiscard]] std::uint64_t now() const { return now_; }
  [[nodiscard]] surface_id surface_of(std::uint32_t facet) const { return surface_[facet]; }
  [[nodiscard]] double deviation_of(std::uint32_t facet) const { return deviation_[facet]; }
  [[nodiscard]] double largest_deviation() const;
  [[nodiscard]] std::array<vec3, 4> corners(std::uint32_t t) const {
    const auto& c = tets_[t];
    return {at_[c[0]], at_[c[1]], at_[c[2]], at_[c[3]]};
  }
  [[nodiscard]] double quality_of(const std::array<std::uint32_t, 4>& c) const;
  [[nodiscard]] bool positive(const std::array<std::uint32_t, 4>& c) const;
  [[nodiscard]] double worst(std::span<const std::uint32_t> tets) const;

  /// The tets around a vertex, those of its fan. Not for several threads at once. Cost: O(star).
  void star(std::uint32_t v, std::vector<std::uint32_t>& result) const;

  /// The ring of edge a-b of tet t, or false when a wall or a longer ring than `longest` is met.
  bool ring(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::size_t longest,
            work_ring& result) const;

  // -- changing --------------------------------------------------------------------

  std::uint32_t add_vertex(vec3 at, vertex_kind kind);

  /// Takes back the newest vertex, which no tet uses.
  void drop_vertex();

  /// Moves a vertex and takes the qualities of its star anew. `changed_at` does not notice.
  void move(std::uint32_t v, vec3 at, std::span<const std::uint32_t> star);

  /// For `changed_at`: these tets are not what they were.
  void note_change(std::span<const std::uint32_t> tets);

  /// Notes how far the facets around a moved vertex are from the original surface.
  void set_deviation(std::uint32_t facet, double deviation) { deviation_[facet] = deviation; }

  /// Applies a change if all its tets are positively oriented (exact) and all faces fit; the new
  /// tets' numbers stand in `fresh` afterwards. Else false, and nothing has changed.
  bool replace(const work_change& change, std::vector<std::uint32_t>& fresh);

  /// Brings all changes into the builder that this was copied from. Errors: `invalid_mesh`.
  [[nodiscard]] expected<void> write(mesh_builder& mesh) const;

private:
  /// One side of a face while a change is planned.
  struct face_entry {
    enum side : std::uint8_t {
      kept,   ///< A tet outside the change; index = tet.
      held,   ///< A facet or a wall of a removed tet; index = what lies behind.
      fresh,  ///< A face of an added tet; index = position in `added`.
      hint    ///< A surface for a new facet; index = position in `facets`.
    };
    face_key key;
    side what;
    std::uint8_t face;
    std::uint32_t index;

    friend bool operator<(const face_entry& a, const face_entry& b) {
      if (a.key.v != b.key.v)
        return a.key.v < b.key.v;
      return a.what != b.what ? a.what < b.what : a.index < b.index;
    }
  };

  void link_copied(const mesh_builder& mesh, const sparse_numbers& number);
  void find_kinds(const mesh_builder& mesh, bool keep_boundary);
  void gather_faces(const work_change& change);
  [[nodiscard]] bool plan(const work_change& change);
  std::uint32_t take_slot();

  std::vector<vec3> at_;
  std::vector<vertex_id> vertex_ids_;  ///< In the builder; `no_id` of new ones.
  std::vector<vertex_kind> kind_;
  std::vector<std::uint32_t> vertex_tet_;
  std::vector<std::array<std::uint32_t, 4>> tets_;
  std::vector<std::array<std::uint32_t, 4>> behind_;
  std::vector<double> quality_;
  std::vector<region_id> region_;
  std::vector<tet_id> original_;  ///< The builder's tet that a slot still is, else `no_id`.
  std::vector<tet_id> copied_;    ///< The builder's tet that was in each slot at first.
  std::vector<surface_id> surface_;
  std::vector<double> deviation_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint64_t> changed_;  ///< By vertex.
  std::uint64_t now_ = 0;

  // Room for walks and plans, kept between calls.
  mutable std::vector<std::uint32_t> mark_;
  mutable std::uint32_t generation_ = 0;
  std::vector<face_entry> faces_;
  std::vector<std::array<std::uint32_t, 4>> pairs_;        ///< Added tet, face, added tet, face.
  std::vector<std::array<std::uint32_t, 4>> outer_;        ///< Added tet, face, kept tet, its face.
  std::vector<std::array<std::uint32_t, 3>> kept_facets_;  ///< Added tet, face, what lies behind.
  std::vector<std::array<std::uint32_t, 3>> new_facets_;   ///< Added tet, face, hint.
  std::vector<std::array<std::uint32_t, 3>> bared_;        ///< Kept tet, face, hint.
};

}  // namespace tedit
