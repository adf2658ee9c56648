// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/types.hpp"
#include "mesh/vec3.hpp"

/// What two versions of a part have in common, and what not: the value that `compare_versions` and
/// `compare_fields` give. "Before" is the version that is compared with, "after" the other one;
/// neither needs to descend from the other. SI units.
namespace tedit {

/// In which of the two versions something is.
enum class presence { only_before, only_after, both };

[[nodiscard]] constexpr std::string_view presence_name(presence where) noexcept {
  return where == presence::both          ? "both"
         : where == presence::only_before ? "only_before"
                                          : "only_after";
}

/// A surface of one of the versions or of both, by its id.
struct compared_surface {
  surface_id id = 0;
  std::string name;  ///< After; of one that is only before: before.
  presence where = presence::both;
  bool changed = false;  ///< Some facet of it is not in the other version, or of another surface.
  /// Of one that is only in one version: the surface of the other one that holds most of the area
  /// of the same facets; nothing when there is none.
  std::optional<surface_id> kin;
  double area_before_m2 = 0;  ///< Those between regions included; 0 when it is not there.
  double area_after_m2 = 0;

  friend bool operator==(const compared_surface&, const compared_surface&) = default;
};

/// A load case by its name, and what of it differs.
struct compared_load_case {
  std::string name;
  presence where = presence::both;
  /// With the materials that the version's own load case has; nothing when a density is unknown.
  std::optional<double> mass_before_kg;
  std::optional<double> mass_after_kg;
  /// One line each, by the names of a load case's file: "loads[0].force.total_n.z: -1000 -> -500".
  std::vector<std::string> differences;

  friend bool operator==(const compared_load_case&, const compared_load_case&) = default;
};

/// Numbers of one version.
struct compared_size {
  std::uint64_t vertices = 0;
  std::uint64_t tets = 0;
  double volume_m3 = 0;

  friend bool operator==(const compared_size&, const compared_size&) = default;
};

/// How far one boundary is from the other where it is farthest: at a corner or in the middle of a
/// facet that only one of them has.
struct boundary_deviation {
  double distance_m = 0;  ///< 0: the boundaries are the same.
  vec3 at_m;              ///< On the boundary of the version that `of` says.
  presence of = presence::only_after;

  friend bool operator==(const boundary_deviation&, const boundary_deviation&) = default;
};

/// What the difference of a field at a vertex of the version after is made of.
enum class difference_mark : std::uint8_t {
  same,          ///< The version before has a vertex there: both values are its solver's own.
  interpolated,  ///< It lies within a tet of the version before, whose corner values are weighted.
  outside  ///< It lies outside the version before: there is no difference; it is written as 0.
};

/// The array that says of each vertex how its difference was made: the numbers of
/// `difference_mark`.
inline constexpr std::string_view mark_array = "difference_mark";

/// What the names of differences end in: "von_mises_pa_difference".
inline constexpr std::string_view difference_ending = "_difference";

/// A value of both versions at a place; `change` is after minus before.
struct value_change {
  double before = 0;
  double after = 0;
  vec3 at_m;

  [[nodiscard]] double change() const { return after - before; }

  friend bool operator==(const value_change&, const value_change&) = default;
};

/// What a load case's fields differ in; stresses in Pa. Largest and smallest values are those of
/// vertices, each in its own version, wherever they are.
struct field_comparison {
  std::string load_case;
  std::uint64_t same = 0;  ///< Vertices of the version after, by their mark.
  std::uint64_t interpolated = 0;
  std::uint64_t outside = 0;
  value_change rise;  ///< Where the von Mises stress grows most; where it grows least if nowhere.
  value_change fall;  ///< Where it falls most; where it falls least if nowhere.
  double max_von_mises_before_pa = 0;
  double max_von_mises_after_pa = 0;
  std::optional<double> min_safety_before;  ///< Nothing when no yield strength is known.
  std::optional<double> min_safety_after;
  bool preview = false;  ///< One of the results is said to be of linear tets, or stopped early.

  friend bool operator==(const field_comparison&, const field_comparison&) = default;
};

/// A load case whose fields could not be compared, and what can be done about it.
struct uncompared_fields {
  std::string load_case;
  std::string reason;  ///< "version 2 has no field of it".
  std::string remedy;

  friend bool operator==(const uncompared_fields&, const uncompared_fields&) = default;
};

struct version_comparison {
  std::string before_id;  ///< `mesh_version::id`, hexadecimal.
  std::string after_id;
  compared_size before;
  compared_size after;
  std::uint64_t tets_in_common = 0;        ///< Same corners at the same places.
  std::uint64_t vertices_in_common = 0;    ///< Vertices at the same place.
  std::vector<compared_surface> surfaces;  ///< All of both, ascending by id.
  boundary_deviation deviation;
  std::vector<compared_load_case> load_cases;  ///< In the order of after, then those only before.
  std::vector<field_comparison> fields;        ///< As far as fields were compared.
  /// Those that somebody wanted compared, and that could not be.
  std::vector<uncompared_fields> not_compared;

  friend bool operator==(const version_comparison&, const version_comparison&) = default;
};

}  // namespace tedit
