// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12
// At -O3 it takes `description.unit = "m"` for a copy of overlapping memory (GCC bug 105651): a
// plugin with warnings as errors would not build.
#pragma GCC diagnostic ignored "-Wrestrict"
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/execution.hpp"
#include "mesh/builder.hpp"
#include "mesh/layout.hpp"
#include "mesh/optimize/improvement.hpp"
#include "mesh/version.hpp"
#include "ops/sdk/description.hpp"

/// The SDK: what a plugin author includes, and all that a plugin's file depends on. An operation is
/// a pure function from a mesh version, a selection and parameters to a candidate version. No
/// actors, no protobuf, no GPU: the host carries the result, checks it and throws it away when a
/// check fails. docs/plugins.md is the manual. The smallest plugin that does something:
///
///     class lift final : public tedit::ops::operation {
///       tedit::ops::operation_description describe() const override { ... }
///       tedit::expected<tedit::ops::edit_result> apply(
///         const tedit::version_ptr& mesh, const tedit::ops::selection& picked,
///         const tedit::ops::parameters& values, tedit::ops::context& ctx) const override {
///         tedit::mesh_builder builder(mesh);
///         ...  // builder.set_position, builder.apply
///         tedit::ops::edit_result result;
///         result.touched = builder.touched();
///         result.candidate = builder.freeze();
///         return result;
///       }
///     };
///     TEDIT_PLUGIN("lift", "1.0.0", lift)
namespace tedit::ops {

// -- applying it ----------------------------------------------------------------

/// What a person picked: a set, its order means nothing. The host has checked that the surfaces are
/// in the version's table and as many as described; a row of the table may have no facet on the
/// boundary (an interface of two regions).
struct selection {
  std::vector<surface_id> surfaces;  ///< The CAD system's numbers: sparse, signed, never an index.
};

/// The selected surfaces ascending, each once: for operations that work on one after the other, so
/// that order and repeats of a selection mean nothing.
[[nodiscard]] inline std::vector<surface_id> as_set(const selection& picked) {
  const std::set<surface_id> ids(picked.surfaces.begin(), picked.surfaces.end());
  return {ids.begin(), ids.end()};
}

/// A closed triangulated surface to fill with tets, and what came out.
struct closed_surface {
  std::vector<vec3> points;                             ///< m.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Oriented outward.
};

/// What `services::tetrahedralise` gives back.
struct tet_filling {
  std::vector<vec3> points;  ///< The input points first, unmoved, then new interior ones.
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< Positively oriented.
};

/// A polygon with holes, in m, in axes of the plugin's own choice.
struct planar_polygon {
  std::vector<std::array<double, 2>> points;
  std::vector<std::vector<std::uint32_t>> loops;  ///< Closed, even-odd filled.
};

/// What `services::triangulate` gives back.
struct planar_filling {
  std::vector<std::array<double, 2>> points;  ///< The input points first, then interior ones.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise.
};

/// A closed surface that is cut from a part or united with it. Its faces become surfaces of the
/// part. Triangles should measure what the part's do where it is placed, round walls have at least
/// 16 of them around (ops/tools makes such ones).
struct tool_surface {
  std::vector<vec3> points;                             ///< m.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Oriented outward.
  std::vector<std::uint32_t> faces;                     ///< Of each triangle: an index of `names`.
  std::vector<std::string> names;  ///< What the surfaces are called that the faces become.
  /// What each face stands for, and its surface then does; of none, or without the list, corners
  /// tell whether it is round. New vertices lie on it, not on its chords.
  std::vector<surface_geometry> geometries;

  [[nodiscard]] surface_geometry geometry(std::size_t face) const {
    return face < geometries.size() ? geometries[face] : surface_geometry{};
  }
};

/// What is left: the part without the tool, both together, or what is common to both.
enum class boolean_mode { cut, add, keep };

struct boolean_request {
  boolean_mode mode = boolean_mode::cut;
  /// m: how far the part's surface may be off what was asked for where nothing else works. 0: not
  /// more than rounding.
  double max_deviation = 0;
};

/// What came of a boolean; `candidate` is a version like any other, so that another may follow.
struct boolean_result {
  version_ptr candidate;
  std::vector<tet_id> touched;  ///< Tets of the candidate that are new or changed.
  double volume_change = 0;     ///< m^3, by the boundary.
  double deviation = 0;         ///< m: how far the surface is off what was asked for, at most.
  double worst_before = 0;      ///< Radius ratio of the worst tet there.
  double worst_after = 0;
  std::vector<std::optional<surface_id>> surfaces;  ///< That each face of the tool became.
};

/// Radius ratio below which no boolean leaves a tet, unless the part had a worse one there.
inline constexpr double lowest_boolean_quality = 0.05;

/// Heavy algorithms that the host offers, so that plugins need no third-party code.
class services {
public:
  virtual ~services() = default;

  /// Fills a closed surface with tets and keeps every input triangle. Runs in a child process with
  /// a time limit, so that a crash or a hang costs one edit.
  /// Errors: `mesher_failed`, `timeout`, `cancelled`. Cost: 2 ms for the plug of a usual hole, at
  /// most 8 s.
  [[nodiscard]] virtual expected<tet_filling> tetrahedralise(const closed_surface& shell,
                                                             const execution& run) = 0;

  /// Constrained Delaunay triangulation of a polygon with holes, with interior points at `spacing`
  /// (none when 0) at least 0.6 spacing from the loops; no new point on a loop.
  /// Errors: `mesher_failed` when loops cross. Cost: O(n log n) in the points that come out.
  [[nodiscard]] virtual expected<planar_filling> triangulate(const planar_polygon& polygon,
                                                             double spacing) = 0;

  /// Cuts a closed tool from the part, unites both, or keeps what is common: exactly, with new tets
  /// only around the tool's surface; all other tets and vertices stay as they are. Surfaces of the
  /// part keep their ids, faces of the tool get new ones. Faces that are flush come out flush. Runs
  /// in child processes with time limits.
  /// Where regions are bonded each is cut, and stays bonded where both are left; an addition
  /// becomes part of the one that most of it stands on, and is bonded to the others. An interface
  /// without a surface id that is laid bare gets a new one. Errors: `invalid_argument` for a tool
  /// that is not closed or is turned inside out; `empty_selection` where it does not meet the part
  /// or leaves nothing of it; `mesher_failed` where no way led to a mesh, `postcondition_failed`
  /// where none led to good tets; `timeout`, `cancelled`. Cost: follows the tool's surface; 60 ms
  /// for a drill hole.
  [[nodiscard]] virtual expected<boolean_result> boolean(const version_ptr& mesh,
                                                         const tool_surface& tool,
                                                         const boolean_request& request,
                                                         const execution& run) = 0;

  /// The same with faces of the tool that become part of surfaces of the part: face i of
  /// `continues[i]`, of a new one where that is nothing, whether anything of it is left or not. An
  /// id that the part does not have (any more) becomes a surface, called as the face is. A tool
  /// with facets of a surface that it continues moves that wall: bonded regions without it stay.
  /// Errors: also `invalid_argument` where there is not one entry a face.
  [[nodiscard]] virtual expected<boolean_result> boolean_onto(
    const version_ptr& mesh, const tool_surface& tool,
    const std::vector<std::optional<surface_id>>& continues, const boolean_request& request,
    const execution& run) = 0;
};

/// A number that only this operation has, measured on the result: shown with the edit's report and
/// carried to the protocol and the JSON of `tedit edit` under its id.
struct figure {
  std::string id;    ///< snake_case with the unit, "thickness_change_mm"; no key of the report's.
  double value = 0;  ///< In `unit`.
  std::string unit;  ///< "mm"; empty for counts and ratios.
  std::string help;  ///< For people, a few words: "thickness taken off, mean".

  friend bool operator==(const figure&, const figure&) = default;
};

/// A candidate and what the operation says about it; the host checks all of it.
struct edit_result {
  version_ptr candidate;        ///< `mesh_builder::freeze()`.
  std::vector<tet_id> touched;  ///< Tets of the candidate that are new or changed.
  double volume_change = 0;  ///< m^3; computed apart from the tets, so that the host can check it.
  improvement improve = improvement::local;  ///< What the host's optimizer does to that region.
  thorough_settings thorough;                ///< For `improvement::thorough`.
  std::vector<surface_id> surfaces_used;     ///< The selection as completed by the operation.
  std::vector<std::string> notices;          ///< What a person should know.
  std::vector<figure> figures;
  /// Worst q that the touched region may have, unless it was worse before. Operations whose new
  /// surface the host's optimizer may not move can promise 0.1 only; below 0.05 nothing is taken.
  double quality_floor = 0.15;
  /// Separate bodies more than there were, where the person allowed that; else the edit is rolled
  /// back.
  std::size_t bodies_added = 0;
};

/// Both as one edit: `then` was made of `first`'s candidate. Tets of the first that the second has
/// taken away are left out, changes of volume and bodies add up, and what is asked of the host's
/// optimizer is the more of both. `surfaces_used` are the first's: others need not be the part's.
[[nodiscard]] inline edit_result followed_by(const edit_result& first, edit_result then) {
  std::set<tet_id> touched(then.touched.begin(), then.touched.end());
  for (const auto t : first.touched)
    if (t < then.candidate->tet_slots() && then.candidate->is_live_tet(t))
      touched.insert(t);
  then.touched.assign(touched.begin(), touched.end());
  then.volume_change += first.volume_change;
  then.bodies_added += first.bodies_added;
  then.quality_floor = std::min(first.quality_floor, then.quality_floor);
  if (first.improve > then.improve) {
    then.improve = first.improve;
    then.thorough = first.thorough;
  }
  then.notices.insert(then.notices.begin(), first.notices.begin(), first.notices.end());
  for (const auto& one : first.figures)
    if (std::ranges::find(then.figures, one.id, &figure::id) == then.figures.end())
      then.figures.push_back(one);
  then.surfaces_used = first.surfaces_used;
  return then;
}

/// What `apply` works with beside its input.
struct context {
  execution run;             ///< `run.cancel.cancelled()` and `run.report(fraction, stage)`.
  services* host = nullptr;  ///< Never null when the host calls; lives as long as the call.
  /// Takes a line for whoever runs the program: the server's log, stderr of the command line, what
  /// the conformance kit tells of a check. The host puts the operation's name before it.
  /// Thread-safe; never empty.
  std::function<void(std::string_view)> log = [](std::string_view) {};
  /// How long a refusal may look for what would work instead, s, beside the edit itself;
  /// 0: not at all, as for a preview, whose answer must come at once.
  double search_s = 0;

  /// Applies another operation of the host to a version, as a person would ask for it: values by
  /// the ids of its parameters, in SI units or as text, defaults for the rest, all checked. What
  /// comes back is what that operation made, neither improved nor checked by the host, which sees
  /// to that once for all: hand on what `followed_by` makes of several. Errors: of the other
  /// operation; `operation_not_found`; `invalid_argument` where operations ask for each other eight
  /// deep. Never empty when the host calls.
  std::function<expected<edit_result>(const std::string& operation, const version_ptr& mesh,
                                      const selection& picked, const parameters& values)>
    apply_other = [](const std::string& id, const version_ptr&, const selection&,
                     const parameters&) -> expected<edit_result> {
    return fail(ec::operation_not_found, "there is no operation \"" + id + "\" here",
                "Operations call others through a host");
  };
};

/// One editing operation. Instances are stateless: `apply` may run on several threads at once.
class operation {
public:
  virtual ~operation() = default;

  /// The same answer every time.
  [[nodiscard]] virtual operation_description describe() const = 0;

  /// Makes a candidate from `mesh`, or says why not: an error with message and remedy. The same
  /// arguments give the same candidate. Polls `ctx.run.cancel` at least every 200 ms and then
  /// answers `cancelled`; throws nothing. `mesh` is never null: the handle that the host holds, so
  /// that a builder or a candidate may keep it. The version may hold free slots, several regions,
  /// and the faults that it was imported with.
  [[nodiscard]] virtual expected<edit_result> apply(const version_ptr& mesh,
                                                    const selection& picked,
                                                    const parameters& values,
                                                    context& ctx) const = 0;
};

// -- handing it to the host --------------------------------------------------------

inline constexpr std::uint32_t plugin_magic = 0x54454450;  // "TEDP"
/// A host takes plugins of its own major number and at most its own minor number. The major number
/// goes up with any change of what plugins were compiled with; the minor one when `context` gets a
/// member, `services` a function or `parameter_type` a kind, each at its end. No number of a
/// release of the program is in a plugin: a patch release changes neither.
inline constexpr std::uint32_t sdk_major = 8;
inline constexpr std::uint32_t sdk_minor = 0;

#define TEDIT_TEXT_OF(x) #x
#define TEDIT_TEXT(x) TEDIT_TEXT_OF(x)

/// Compiler and standard library, as far as C++ types depend on them. Without minor and patch
/// numbers: within one series (12.1 to 12.5) GCC keeps the C++ ABI (-fabi-version) and libstdc++
/// the layout of its types, and the shared library is the newer one on the machine that loads both.
/// Between series neither is promised for C++20. The old std::string and debug mode's containers
/// are other types.
inline constexpr const char* compiler_tag =
#if defined(__clang__)
  "clang-" TEDIT_TEXT(__clang_major__)
#else
  "gcc-" TEDIT_TEXT(__GNUC__)
#endif
#if defined(_LIBCPP_VERSION)
    " libc++-" TEDIT_TEXT(_LIBCPP_ABI_VERSION)
#else
    " libstdc++-" TEDIT_TEXT(_GLIBCXX_RELEASE) " strings-" TEDIT_TEXT(_GLIBCXX_USE_CXX11_ABI)
#endif
#ifdef _GLIBCXX_DEBUG
      " debug"
#endif
  ;

/// What the C entry `tedit_plugin_query` returns: plain data, readable before any C++ is trusted.
/// Members are only ever added at its end.
struct plugin_descriptor {
  std::uint32_t magic;
  std::uint32_t descriptor_size;
  std::uint32_t sdk_major;
  std::uint32_t sdk_minor;
  const char* compiler;
  const char* plugin_name;
  const char* plugin_version;
  std::uint32_t operation_count;
  operation* (*create)(std::uint32_t index);
  void (*destroy)(operation*);
  const layout_fact* layout;  ///< `layout_facts()` of the plugin.
  std::uint32_t layout_count;
};

/// All types that cross the border. A plugin has mesh code of its own (the library is linked into
/// it), which works on what the host's made: where one of these differs, neither may touch what the
/// other holds. Types without a fact of their own lie in one that has. What a minor release adds is
/// a new fact. Cost: microseconds, once.
__attribute__((visibility("hidden"))) const std::vector<layout_fact>& layout_facts();

/// A descriptor with these operations; the entry returns it.
template <class... Operations>
[[nodiscard]] plugin_descriptor make_descriptor(const char* name, const char* version);

}  // namespace tedit::ops

/// Registers operation classes as a plugin; stands once in the plugin's operation.cpp, outside all
/// namespaces: TEDIT_PLUGIN("fill_hole", "1.1.0", fill_hole). Weak, so that one program (a test)
/// may link the code of several.
#define TEDIT_PLUGIN(name, version, ...)                                                       \
  extern "C" __attribute__((visibility("default"), weak)) const tedit::ops::plugin_descriptor* \
  tedit_plugin_query() {                                                                       \
    static const auto descriptor = tedit::ops::make_descriptor<__VA_ARGS__>(name, version);    \
    return &descriptor;                                                                        \
  }

// -- how that is done: nothing that an author needs ---------------------------------------------

namespace tedit::ops {
namespace layout {

using namespace tedit::layout;

inline void add_description(std::vector<layout_fact>& facts) {
  const operation_description d;
  const auto& [id, name, summary, version, selects, takes, icon, guide, rank, best_for] = d;
  facts.push_back(of("operation_description", d, id, name, summary, version, selects, takes, icon,
                     guide, rank, best_for));
  const auto& [help, minimum, maximum] = selects;
  facts.push_back(of("selection_description", selects, help, minimum, maximum));
  const parameter_description p;
  const auto& [p_id, p_name, p_help, type, unit, min, max, choices, default_value, instead] = p;
  facts.push_back(of("parameter_description", p, p_id, p_name, p_help, type, unit, min, max,
                     choices, default_value, instead));
  facts.push_back(last("parameter_type", parameter_type::list));
}

inline void add_edit(std::vector<layout_fact>& facts) {
  const context c;
  auto known = of("context", c, c.run, c.host, c.log, c.search_s, c.apply_other);
  known.size = 0;
  facts.push_back(known);
  const expected<edit_result> answer;
  const auto& r = *answer;
  const auto& [candidate, touched, change, improve, thorough, used, notices, figures, floor,
               bodies] = r;
  facts.push_back(of("edit_result", r, candidate, touched, change, improve, thorough, used, notices,
                     figures, floor, bodies));
  facts.push_back(of("expected<edit_result>", answer, r));
  const figure f;
  const auto& [id, value, unit, help] = f;
  facts.push_back(of("figure", f, id, value, unit, help));
  const auto& [target, insert_below, harmonic, tolerance, rounds] = thorough;
  facts.push_back(of("thorough_settings", thorough, target, insert_below, harmonic,
                     tolerance.absolute, tolerance.relative, rounds));
  facts.push_back(last("improvement", improvement::thorough));
}

inline void add_services(std::vector<layout_fact>& facts) {
  const closed_surface shell;
  facts.push_back(of("closed_surface", shell, shell.points, shell.triangles));
  const tet_filling tets;
  facts.push_back(of("tet_filling", tets, tets.points, tets.tets));
  const planar_polygon polygon;
  facts.push_back(of("planar_polygon", polygon, polygon.points, polygon.loops));
  const planar_filling plane;
  facts.push_back(of("planar_filling", plane, plane.points, plane.triangles));
  facts.push_back(table("services", &services::tetrahedralise, &services::triangulate,
                        &services::boolean, &services::boolean_onto));
  facts.push_back(table("operation", &operation::describe, &operation::apply));
  const tool_surface tool;
  facts.push_back(
    of("tool_surface", tool, tool.points, tool.triangles, tool.faces, tool.names, tool.geometries));
  const boolean_request request;
  facts.push_back(of("boolean_request", request, request.mode, request.max_deviation));
  facts.push_back(last("boolean_mode", boolean_mode::keep));
  const boolean_result made;
  const auto& [candidate, touched, change, deviation, before, after, surfaces] = made;
  facts.push_back(
    of("boolean_result", made, candidate, touched, change, deviation, before, after, surfaces));
}

template <class Operation>
operation* make_one() {
  return new Operation;
}

}  // namespace layout

inline const std::vector<layout_fact>& layout_facts() {
  static const auto facts = [] {
    std::vector<layout_fact> result;
    layout::add_base(result);
    layout::add_mesh(result);
    layout::add_description(result);
    layout::add_edit(result);
    layout::add_services(result);
    return result;
  }();
  return facts;
}

template <class... Operations>
plugin_descriptor make_descriptor(const char* name, const char* version) {
  const auto create = [](std::uint32_t index) -> operation* {
    static constexpr std::array makers{&layout::make_one<Operations>...};
    return index < makers.size() ? makers[index]() : nullptr;
  };
  const auto& facts = layout_facts();
  return {plugin_magic, sizeof(plugin_descriptor),
          sdk_major,    sdk_minor,
          compiler_tag, name,
          version,      sizeof...(Operations),
          create,       [](operation* made) { delete made; },
          facts.data(), static_cast<std::uint32_t>(facts.size())};
}

}  // namespace tedit::ops
