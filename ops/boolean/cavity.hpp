// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "mesh/box_tree.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The tets that a tool makes anew, and the closed surface around them.
struct cavity {
  /// What lies behind a triangle of that surface: a tet that stays where it is or goes as a whole;
  /// or nothing, where it is a facet of the part; or the share of another region.
  struct side {
    tet_id behind = no_id;
    facet_id facet = no_id;
    std::uint32_t twin = no_id;  ///< The same triangle, as the other region has it.
    std::uint32_t bond = no_id;  ///< Of `twin`: the version's interface facet, where it has one.
  };

  /// What one region has of it: triangles `first` to before `last`, a closed surface.
  struct share {
    region_id region = 0;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool stays = false;  ///< The tool takes nothing of it and puts nothing on it.
  };

  [[nodiscard]] std::int32_t share_of(std::size_t triangle) const {
    std::int32_t share = 0;
    while (triangle >= shares[share].last)
      ++share;
    return share;
  }

  std::vector<tet_id> tets;
  std::vector<tet_id> gone;   ///< Beside those: tets that the boolean takes as they are.
  std::vector<share> shares;  ///< At least one; several where the tool crosses bonded regions.
  closed_surface surface;     ///< That of each share, one after the other, with common points.
  std::vector<vertex_id> vertices;  ///< Of the surface's points.
  std::vector<side> sides;          ///< Of its triangles.
};

/// Finds them: the tets that the tool's surface crosses, with rings of others around on the side
/// that stays, so that there is room for good tets.
class cavity_finder {
public:
  /// @param moved surfaces that faces of the tool continue. A tool that has facets of one for its
  /// own moves that wall: regions that none of these facets bounds stay as they are.
  /// @param near all live facets that meet the tool's box grown by a twentieth; there may be more.
  /// Cost: O(facets near + tets in the tool's box); O(tet slots) for a tool far within the part, or
  /// one as large as it.
  cavity_finder(const mesh_version& mesh, const tool_surface& tool, boolean_mode mode,
                const std::vector<facet_id>& near, const std::vector<surface_id>& moved);

  /// @param also tets that are made anew, too, with the same rings around.
  /// @param beyond also on the other side of interfaces that the tool comes near: else these stay
  /// as they are.
  /// Errors: `empty_selection` where the tool meets nothing, `mesher_failed` where the part itself
  /// is no clean solid. Cost: O(cavity), and O(interface facets) where there are several regions.
  [[nodiscard]] expected<cavity> find(int rings, const std::vector<tet_id>& also = {},
                                      bool beyond = false) const;

private:
  [[nodiscard]] box reach_of(const std::array<vec3, 4>& tet) const;
  void find_crossed(const std::vector<tet_id>& near);
  void sort_sides(const std::vector<tet_id>& near);
  [[nodiscard]] bool is_within(tet_id t) const;
  [[nodiscard]] std::vector<region_id> regions_of_edit(bool beyond) const;
  [[nodiscard]] std::vector<tet_id> changed() const;
  [[nodiscard]] std::vector<facet_id> facets_of_tool() const;
  void find_owners(const std::vector<surface_id>& moved);
  [[nodiscard]] bool stays(region_id region) const;

  const mesh_version& mesh_;
  const tool_surface& tool_;
  boolean_mode mode_;
  bool bonded_;    ///< The part has several regions.
  box_tree tree_;  ///< Of the tool's triangles.
  std::vector<tet_id> crossed_;
  std::vector<tet_id> within_;            ///< Wholly inside the tool, and taken by it.
  std::vector<tet_id> kept_within_;       ///< Wholly inside, of regions that stay.
  std::vector<facet_id> stuck_;           ///< Facets that the tool has for its own.
  std::vector<region_id> owners_;         ///< Regions that do not stay; none: all of them.
  std::vector<std::uint8_t> is_crossed_;  ///< By tet slot.
  std::vector<std::uint8_t> is_inside_;   ///< By tet slot: of `within_`.
};

/// The solid angle that the tool shows from a point is that of an inside one.
[[nodiscard]] bool is_inside(const tool_surface& tool, vec3 p);

}  // namespace tedit::ops
