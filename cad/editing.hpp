// SPDX-License-Identifier: AGPL-3.0-or-later
// What passes between a replay of an edit and the program that does it on the B-rep: files of a
// folder that only the two know. Lengths are in mm, as in the B-rep.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::cad {

inline constexpr double mm_of_metre = 1e3;

// Files of the folder, beside `shape_file` and `facts_file`, which are read and written anew.
inline constexpr const char* step_file = "step.json";         ///< `cad_step`; the host's.
inline constexpr const char* edited_file = "edited.surface";  ///< `surface_header`; the host's.
inline constexpr const char* verdict_file = "verdict.json";   ///< `cad_verdict`; the program's.

enum class step_kind {
  none,    ///< The part keeps its shape.
  remove,  ///< The surfaces go; what is around them closes the gap.
  shift,   ///< The surfaces move outwards by `distance_mm`, below zero into the part.
  round,   ///< The edges between the surfaces get the radius `distance_mm`.
  cut,     ///< The tool is taken off.
  add,     ///< The tool is united with the part.
  keep,    ///< What part and tool share stays.
  split,   ///< Both sides of the tool's end at `to`, as solids of their own.
  copy,    ///< The hole or boss that the surfaces are is made again where motions bring it.
  hollow   ///< What is deeper than `distance_mm` below the walls goes; the surfaces are open.
};

/// A corner of a closed outline; the edge to the next one is straight, or an arc that turns by four
/// times the arc tangent of `bulge` (counterclockwise above zero, as in DXF).
struct outline_corner {
  double x = 0;
  double y = 0;
  double bulge = 0;
};

/// A tool by its exact shape: outlines along z, a half-section turned about z, or flat triangles.
struct exact_tool {
  std::array<std::array<double, 3>, 4> frame{};       ///< Origin, x, y, z.
  std::vector<std::vector<outline_corner>> outlines;  ///< Even-odd filled; arcs in a single one.
  double from = 0;                                    ///< Of the outlines, along z.
  double to = 0;
  std::vector<std::array<double, 2>> section;  ///< Radius and height; first and last on the axis.
  std::vector<std::array<double, 3>> points;   ///< Of the triangles: not in the frame.
  std::vector<std::array<int, 3>> triangles;   ///< Closed, looking outward.
};

/// p goes to the sum of its coordinates times the columns, plus the shift: a rigid motion, or a
/// reflection.
struct step_motion {
  std::array<std::array<double, 3>, 3> columns{};
  std::array<double, 3> shift{};
};

/// A surface that goes along with a wall, as it is: a fillet at the wall's border.
struct carried_surface {
  int surface = 0;
  std::array<double, 3> way_mm{};
};

/// An edit as it is to be made on the B-rep.
struct cad_step {
  step_kind kind = step_kind::remove;
  std::vector<int> surfaces;
  double distance_mm = 0;
  std::vector<carried_surface> carried;  ///< Of `shift`; some may be in `surfaces`, too.
  bool convex = false;                   ///< Of `round`: outer edges, else inner ones.
  exact_tool tool;
  std::vector<step_motion> motions;  ///< Of `copy`.
  bool leaves = false;               ///< Of `copy`: the one that was there goes.
  bool is_hole = false;              ///< Of `copy`: else a boss.
  double edge_mm = 0;                ///< Of `copy`: the mesh's mean edge there.
  std::vector<exact_tool> more;      ///< Of `cut` and `add`: as `tool`. Of `hollow`: taken off.
  // What the edit made of the mesh, to compare with.
  double volume_change_mm3 = 0;
  double size_mm = 0;      ///< The part's: the diagonal of its box.
  std::size_t bodies = 1;  ///< Pieces of the edited mesh that hang together, each region by itself.
};

[[nodiscard]] bool save_step(const cad_step& step, const std::filesystem::path& folder);
/// Errors: `io_error`, `internal`.
[[nodiscard]] expected<cad_step> load_step(const std::filesystem::path& folder);

/// Before the points (3 doubles each), and the triangles (3 indices, a surface id and a
/// `triangle_state`, 32 bits each).
struct surface_header {
  std::uint64_t magic = 0x3153454744455454;
  std::uint64_t points = 0;
  std::uint64_t fresh = 0;  ///< The last so many points were not there before the edit.
  std::uint64_t triangles = 0;
};

enum triangle_state : std::int32_t {
  triangle_kept = 0,
  triangle_made = 1,  ///< By the edit.
  triangle_gone = 2   ///< Was there before it, and is no longer.
};

/// The boundary of the edited mesh, and what of the boundary before is gone.
struct edited_surface {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::int32_t, 5>> triangles;
  std::size_t fresh = 0;
};

[[nodiscard]] bool save_surface(const edited_surface& surface, const std::filesystem::path& folder);
/// Errors: `io_error`, `internal` for a file that was not written so.
[[nodiscard]] expected<edited_surface> load_surface(const std::filesystem::path& folder);

/// What came of it.
struct cad_verdict {
  bool is_same = false;     ///< The B-rep has the edit; else it is as it was.
  std::string how;          ///< The way that did it: "inner outlines dropped".
  std::string reason;       ///< Why not, for a person.
  double deviation_mm = 0;  ///< Of new vertices of the mesh from the B-rep's faces, at most.
};

/// A way that did not do it.
struct failed_way {
  std::string name;
  std::string fault;  ///< Empty: what was asked for cannot be done so at all.
};

/// Why none did it, for a person: each fault once, behind the ways that had it, as in "layer, slab:
/// it has 2 solids, the model before 1; plug: ...". Those that could not do it at all are named
/// only where no other has a fault.
[[nodiscard]] std::string reason_of(const std::vector<failed_way>& ways);

[[nodiscard]] bool save_verdict(const cad_verdict& verdict, const std::filesystem::path& folder);
/// Errors: `io_error`, `internal`.
[[nodiscard]] expected<cad_verdict> load_verdict(const std::filesystem::path& folder);

}  // namespace tedit::cad
