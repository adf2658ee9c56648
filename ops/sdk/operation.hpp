// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12
// At -O3 it takes `description.unit = "m"` for a copy of overlapping memory (GCC bug 105651): a
// plugin with warnings as errors would not build.
#pragma GCC diagnostic ignored "-Wrestrict"
#endif

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
#include "mesh/optimize/improve.hpp"
#include "mesh/version.hpp"

/// What a plugin author includes: everything else is internal. An operation is a pure function from
/// a mesh version, a selection and parameters to a candidate version. No actors, no protobuf, no
/// GPU: the host carries the result, checks it and throws it away when a check fails.
/// docs/plugins.md is the manual. The smallest plugin that does something:
///
///     class lift final : public tedit::ops::operation {
///       tedit::ops::operation_description describe() const override { ... }
///       tedit::expected<tedit::ops::edit_result> apply(
///         const tedit::mesh_version& mesh, const tedit::ops::selection& picked,
///         const tedit::ops::parameters& values, tedit::ops::context& ctx) const override {
///         tedit::mesh_builder builder(tedit::version_ptr(tedit::version_ptr{}, &mesh));
///         ...  // builder.set_position, builder.apply
///         tedit::ops::edit_result result;
///         result.touched = builder.touched();
///         result.candidate = builder.freeze();
///         return result;
///       }
///     };
///     TEDIT_PLUGIN("lift", "1.0.0", lift)
namespace tedit::ops {

// -- describing an operation ---------------------------------------------------

/// What a parameter holds; choice is one of the texts in `choices`.
enum class parameter_type { boolean, integer, real, text, choice };

/// By type: bool, std::int64_t, double; std::string for text and choice.
using parameter_value = std::variant<bool, std::int64_t, double, std::string>;

/// One parameter as data: the source of the form, the CLI's help, the protocol's catalogue and
/// the docs, and of the validation before `apply` is called.
struct parameter_description {
  std::string id;    ///< snake_case, stable.
  std::string name;  ///< For people: "Include the entry".
  std::string help;  ///< One or two sentences.
  parameter_type type = parameter_type::real;
  std::string unit;           ///< SI, for example "m"; empty when dimensionless.
  std::optional<double> min;  ///< Inclusive; for integer and real.
  std::optional<double> max;
  std::vector<std::string> choices;  ///< For choice.
  parameter_value default_value = false;
  /// Id of a number that this one stands in for: where a request gives this one and not that one,
  /// that one is 0 instead of its default.
  std::string instead_of = {};
};

/// What a person picks before the operation can run.
struct selection_description {
  std::string help;         ///< "The wall surfaces of one or more holes".
  std::size_t minimum = 1;  ///< Surfaces.
  std::size_t maximum = 0;  ///< 0: any number.
};

/// What people and programs see of an operation. Example: ops/fill_hole/operation.cpp.
struct operation_description {
  std::string id;       ///< snake_case, unique among all plugins.
  std::string name;     ///< "Fill hole".
  std::string summary;  ///< One sentence.
  std::string version;  ///< The operation's own, semantic.
  selection_description selection;
  std::vector<parameter_description> parameters;
};

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

/// Values by parameter id. The host fills in defaults and has checked types and ranges:
/// `std::get<double>(values.at("distance"))` needs no test.
using parameters = std::map<std::string, parameter_value>;

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
};

/// What `apply` works with beside its input.
struct context {
  execution run;             ///< `run.cancel.cancelled()` and `run.report(fraction, stage)`.
  services* host = nullptr;  ///< Never null when the host calls; lives as long as the call.
  /// Takes a line for whoever runs the program: the server's log, stderr of the command line. The
  /// host puts the operation's name before it. Thread-safe; never empty.
  std::function<void(std::string_view)> log = [](std::string_view) {};
  /// How long a refusal may look for what would work instead, beside the time of one trial; 0: not
  /// at all, as for a preview, whose answer must come at once.
  double search_s = 0;
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

/// One editing operation. Instances are stateless: `apply` may run on several threads at once.
class operation {
public:
  virtual ~operation() = default;

  /// The same answer every time.
  [[nodiscard]] virtual operation_description describe() const = 0;

  /// Makes a candidate from `mesh`, or says why not: an error with message and remedy. The same
  /// arguments give the same candidate. Polls `ctx.run.cancel` at least every 200 ms and then
  /// answers `cancelled`; throws nothing. `mesh` outlives the call; it may hold free slots, several
  /// regions, and the faults that it was imported with.
  [[nodiscard]] virtual expected<edit_result> apply(const mesh_version& mesh,
                                                    const selection& picked,
                                                    const parameters& values,
                                                    context& ctx) const = 0;
};

// -- handing it to the host --------------------------------------------------------

inline constexpr std::uint32_t plugin_magic = 0x54454450;  // "TEDP"
inline constexpr std::uint32_t sdk_major = 5;
inline constexpr std::uint32_t sdk_minor = 0;

/// Compiler and standard library that built the plugin: C++ types cross the border.
inline constexpr const char* compiler_tag =
#if defined(__clang__)
  "clang-" __clang_version__;
#else
  "gcc-" __VERSION__;
#endif

/// What the C entry `tedit_plugin_query` returns: plain data, readable before any C++ is trusted.
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
};

}  // namespace tedit::ops

/// Registers one operation class as a plugin; stands once in the plugin's operation.cpp, outside
/// all namespaces: TEDIT_PLUGIN("fill_hole", "1.1.0", fill_hole).
#define TEDIT_PLUGIN(name, version, operation_type)                                      \
  extern "C" __attribute__((visibility("default"))) const tedit::ops::plugin_descriptor* \
  tedit_plugin_query() {                                                                 \
    static const tedit::ops::plugin_descriptor descriptor{                               \
      tedit::ops::plugin_magic,                                                          \
      sizeof(tedit::ops::plugin_descriptor),                                             \
      tedit::ops::sdk_major,                                                             \
      tedit::ops::sdk_minor,                                                             \
      tedit::ops::compiler_tag,                                                          \
      name,                                                                              \
      version,                                                                           \
      1,                                                                                 \
      [](std::uint32_t) -> tedit::ops::operation* { return new operation_type(); },      \
      [](tedit::ops::operation* made) { delete made; }};                                 \
    return &descriptor;                                                                  \
  }
