// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "client/surface.hpp"
#include "fem/load_case.hpp"
#include "mesh/features/select.hpp"

namespace tedit::client {

/// Surfaces by what they are instead of by their numbers, so that a recipe fits another mesh of the
/// part, or another size of it. What is given holds together: of the surfaces that an edit made and
/// that have a name the one nearest to a point, and all of the hole that it belongs to.
struct surface_reference {
  std::string name;                     ///< Those that are called so; empty: whatever they are.
  std::string made_by;                  ///< Those that the edit with this label made; empty: all.
  std::optional<vec3> at_mm;            ///< The one nearest to this; none: all of them.
  double within_mm = 0;                 ///< How far that may be; 0: a hundredth of the part's size.
  std::optional<feature_kind> feature;  ///< All of the hole, protrusion or smooth wall instead.

  friend bool operator==(const surface_reference&, const surface_reference&) = default;
};

/// A reference that means this surface of the part and no other: by its name where no other surface
/// has that, else by a point within it, and by the edit that made it where `made_by` says one.
/// Nothing for a surface that is not there. Cost: O(boundary).
[[nodiscard]] std::optional<surface_reference> reference_to(surface_id surface,
                                                            const surface_model& part,
                                                            const std::string& made_by = {});

/// Puts places of references where numbers are, each surface one reference; a number without one
/// stays. What `reference_of` gives for the same number is the same.
void refer_to_surfaces(
  std::vector<surface_id>& ids, std::vector<surface_reference>& references,
  const std::function<std::optional<surface_reference>(surface_id)>& reference_of);
void refer_to_surfaces(
  fem::load_case& loads, std::vector<surface_reference>& references,
  const std::function<std::optional<surface_reference>(surface_id)>& reference_of);

/// For people: "hole at (1, 2.5, 3) mm", "what pin made".
[[nodiscard]] std::string words_of(const surface_reference& one);
/// "12, 13, hole at (1, 2.5, 3) mm".
[[nodiscard]] std::string words_of(const std::vector<surface_id>& ids,
                                   const std::vector<surface_reference>& references);

/// The number that stands for a step's k-th reference among the numbers of surfaces. No mesh has
/// such numbers.
[[nodiscard]] constexpr surface_id place_of_reference(std::size_t k) {
  return std::numeric_limits<surface_id>::min() + static_cast<surface_id>(k);
}

/// Which surfaces the references of a recipe mean, while its steps are carried out.
class surface_references {
public:
  /// Notes which surfaces an edit made: those of `after` that were not in `before`. No label:
  /// nothing to note.
  void note(const std::string& label, const surface_model& before, const surface_model& after);

  /// The surfaces that a reference means on a part, ascending, before it grows to a feature.
  /// Errors: `surface_not_found` where there are none, or none so near; `invalid_argument` for a
  /// point between surfaces, unless it stands for a feature. Cost: O(boundary).
  [[nodiscard]] expected<std::vector<surface_id>> find(const surface_reference& one,
                                                       const surface_model& part) const;

private:
  [[nodiscard]] expected<std::set<surface_id>> candidates(const surface_reference& one,
                                                          const surface_model& part) const;

  std::map<std::string, std::set<surface_id>> made_;
};

/// All that a feature has of which these are a part.
using feature_selector =
  std::function<expected<std::vector<found_feature>>(const selection_query&)>;

/// What a step's references mean, in their order: found, and grown to features by `select`. Errors:
/// those of both.
[[nodiscard]] expected<std::vector<std::vector<surface_id>>> meanings_of(
  const std::vector<surface_reference>& references, const surface_references& known,
  const surface_model& part, const feature_selector& select);

/// Puts surfaces where references are. A surface that is there already does not come twice.
void put_surfaces(std::vector<surface_id>& ids,
                  const std::vector<std::vector<surface_id>>& meanings);
void put_surfaces(fem::load_case& loads, const std::vector<std::vector<surface_id>>& meanings);

}  // namespace tedit::client
