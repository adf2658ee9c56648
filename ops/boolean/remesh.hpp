// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/builder.hpp"
#include "ops/boolean/cavity.hpp"
#include "ops/boolean/clean.hpp"
#include "ops/boolean/corefine.hpp"

namespace tedit::ops {

/// What the triangles of a boolean's result belong to: surfaces of the part first, then faces of
/// the tool.
struct surface_labels {
  /// A surface of the part, or an interface between two of its regions, which may have no id: as a
  /// wall it becomes a new surface.
  struct part_surface {
    std::optional<surface_id> id;
    bool between = false;
    std::string bare_name{};  ///< Where there is no id: what it is called then.
    friend bool operator==(const part_surface&, const part_surface&) = default;
  };
  std::vector<part_surface> part;
  std::size_t tool_faces = 0;

  static constexpr std::int32_t shell = -1;  ///< Against tets that stay.
  [[nodiscard]] bool is_tool(std::int32_t label) const {
    return label >= static_cast<std::int32_t>(part.size());
  }
  [[nodiscard]] std::size_t tool_face(std::int32_t label) const {
    return static_cast<std::size_t>(label) - part.size();
  }
};

struct labelled_surface {
  surface_mesh mesh;
  surface_labels labels;
};

/// The result of the exact boolean with labels, sizes and what must stay: the part's triangles
/// more than `free_steps` from anything new or, if `thin`, from where little is left to it. Errors:
/// `mesher_failed` where a triangle against a tet that stays was cut, or where what was taken does
/// not hang together with what goes.
/// @param continues what each face of the tool is a part of; may be empty.
[[nodiscard]] expected<labelled_surface> label_surface(
  const mesh_version& mesh, const cavity& hollow, const tool_surface& tool,
  const std::vector<std::optional<surface_id>>& continues, const corefined& cut, boolean_mode mode,
  double size, int free_steps, bool thin);

/// How far the points of the exact boolean are from the cleaned surface at most, m. Frozen faces
/// have not moved; points of facets with slack are left out, as their wall is elsewhere.
[[nodiscard]] double deviation_of(const surface_mesh& before, const surface_mesh& after);

/// What a cavity is filled with.
enum class filling {
  tets,  ///< By TetGen.
  fan,   ///< A tet from each triangle to one point: linked, but inside out where it is not convex.
};

/// The cavity's tets and those that go are replaced by a filling of the surface, each region by its
/// own. Returns the new tets, and the surface that each face of the tool became, if any of it is
/// left. Errors: those of the mesher.
struct replaced {
  std::vector<tet_id> tets;
  std::vector<std::optional<surface_id>> surfaces;  ///< By face of the tool.
};
[[nodiscard]] expected<replaced> replace_cavity(mesh_builder& builder, const cavity& hollow,
                                                const labelled_surface& surface,
                                                const tool_surface& tool, filling how,
                                                const execution& run);

/// Of what was touched, edges of the boundary that may go without a change of shape go, and the
/// tets are improved again. Errors: `cancelled`, `out_of_memory`. Cost: O(touched).
[[nodiscard]] expected<void> tidy_filling(mesh_builder& builder, const execution& run);

}  // namespace tedit::ops
