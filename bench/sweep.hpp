// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "edit/make_edit.hpp"
#include "mesh/quality.hpp"

/// Edits of a part's listed features, each checked and measured (bench/feature_sweep).
namespace tedit::bench {

/// One edit that a part's list of features suggests.
struct planned_feature {
  std::string operation;
  std::vector<surface_id> surfaces;
  ops::parameters parameters;
  std::string kind;                    ///< "through", "blind", "fin", "plane".
  std::optional<double> exact_volume;  ///< m^3 that it should change; of a cylinder or a slab.
};

/// "fill_hole through 1, 2".
[[nodiscard]] std::string name_of(const planned_feature& feature);

/// What features.json lists.
struct part_features {
  std::vector<planned_feature> holes;
  std::vector<planned_feature> fins;
  std::map<surface_id, double> planes;  ///< Flat surfaces with the wall's thickness, m; 0: unknown.
};

[[nodiscard]] part_features read_features(const std::filesystem::path& folder);

/// m: the thinnest place of the wall below a surface, from the middle of at most 100 of its facets.
[[nodiscard]] double wall_thickness(const mesh_version& mesh, surface_id surface);

/// m^2.
[[nodiscard]] double area_of(const mesh_version& mesh, surface_id surface);

/// An edit with what was measured of it.
struct attempt_result {
  std::optional<checked_edit> outcome;
  error refusal;             ///< When there is none.
  double cpu_ms = 0;         ///< Of this process and the mesher's.
  double median_before = 0;  ///< q of the base's tets in and around what was touched.
  double median_after = 0;   ///< q of what was touched.
  double claimed_error = 0;  ///< |volume change of the tets - claim| / volume.
};

/// One part and what was tried on it.
class sweep {
public:
  explicit sweep(version_ptr base);

  [[nodiscard]] const version_ptr& base() const { return base_; }
  [[nodiscard]] int faults() const { return faults_; }

  /// Applies an edit; a broken invariant is printed and counted.
  [[nodiscard]] attempt_result attempt(const version_ptr& mesh, const planned_feature& feature);

  std::vector<fem::load_case> loads;  ///< Carried over; what loses its surface moves.

private:
  ops::catalogue plugins_;
  version_ptr base_;
  int faults_ = 0;
};

/// One row of a Markdown table: operation, feature, result, CPU ms, tets, q, volume, surfaces.
[[nodiscard]] std::string row_of(const planned_feature& feature, const attempt_result& tried);

/// Many attempts in one line.
struct tally {
  int tried = 0;
  int done = 0;
  int with_another = 0;  ///< Holes that were gone with one that they belong to: done, too.
  std::vector<double> ms;
  std::vector<double> worst_after;
  double claimed_error = 0;
  std::map<std::string, int> reasons;

  void add(const attempt_result& result);
  [[nodiscard]] std::string text(const std::string& what) const;
};

}  // namespace tedit::bench
