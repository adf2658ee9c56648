// SPDX-License-Identifier: AGPL-3.0-or-later
// What operations that place a tool share: where, which way, and what they tell of it.
#pragma once

#include "ops/tools/tools.hpp"

namespace tedit::ops {

/// Where a tool is placed.
struct placement {
  vec3 at;          ///< m.
  vec3 outward;     ///< Unit: the direction that was given, else the wall's normal there.
  double size = 0;  ///< m: the part's mean edge length around.
};

/// The parameters "at" (a point) and `direction` as they were given; without them the middle of the
/// selected wall and its normal. Where an operation has the parameter "plane", that is both, if it
/// is given. `reach` (m): how far around the mesh matters. Errors: `empty_selection` where there is
/// neither a point nor a wall, `invalid_parameter` where a plane and one of the others are given.
[[nodiscard]] expected<placement> placement_of(const mesh_version& mesh, const selection& picked,
                                               const parameters& values,
                                               const std::string& direction, double reach);

/// The two descriptions: a place on a wall, and a direction that may be left to the operation.
[[nodiscard]] parameter_description at_parameter(const std::string& name, const std::string& help);
[[nodiscard]] parameter_description direction_parameter(const std::string& id,
                                                        const std::string& name,
                                                        const std::string& help);

/// The wall that a place lies on, or above or below it by at most `within` (m), and its normal.
/// Errors: `invalid_parameter` where there is none.
[[nodiscard]] expected<wall_middle> wall_near(const mesh_version& mesh, vec3 place, double within);

/// Has a point material around? By the boundary along a ray.
[[nodiscard]] bool in_material(const mesh_version& mesh, vec3 point);

/// How far the tool must reach back along `out` (unit) for all points of a rim to be outside, m; 0
/// where all are. The rim is a circle of this radius around `at`, across `out`.
[[nodiscard]] double clearance(const mesh_version& mesh, vec3 at, vec3 out, double radius);

/// How far from `at` along -`out` the material ends for the last time, for any point of that rim,
/// m.
[[nodiscard]] double depth_through(const mesh_version& mesh, vec3 at, vec3 out, double radius);

/// How far the points of that rim are off the material along -`out` at most, m; those that meet
/// none are passed over.
[[nodiscard]] double gap_below(const mesh_version& mesh, vec3 at, vec3 out, double radius);

/// Is what is asked for of a size that a mesh can have there? `edge` (m): how long its edges would
/// be; `length` (m): how far they would have to reach, in at most so many. Errors:
/// `invalid_parameter`.
[[nodiscard]] expected<void> check_fineness(const placement& where, double edge, double length,
                                            int most_edges = 250);

/// The boolean as an edit, with what a person should know of it. Errors: `invalid_argument` where
/// the part would fall apart, hold a closed void, or get a piece that does not touch it.
[[nodiscard]] expected<edit_result> as_edit(const mesh_version& mesh, const boolean_result& made,
                                            const tool_surface& tool,
                                            const std::vector<surface_id>& used);

/// The tool cut from the part or united with it, as an edit. `size` (m): the part's mean edge
/// there. Errors: those of `services::boolean` and of `as_edit`.
[[nodiscard]] expected<edit_result> apply_tool(const version_ptr& mesh, const tool_surface& tool,
                                               boolean_mode mode, double size,
                                               const std::vector<surface_id>& used, context& ctx);

/// How far a boolean of these operations may be off what was asked for where nothing else works:
/// a share of the local edge length.
inline constexpr double deviation_share = 0.02;

}  // namespace tedit::ops
