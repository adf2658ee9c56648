// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <limits>
#include <vector>

#include "client/surface.hpp"
#include "mesh/features/select.hpp"

/// Surfaces by words.
namespace tedit::desktop {

/// What a person's words ask for.
struct surface_search {
  enum class what {
    named,       ///< Surfaces whose name or number has `name` in it; all when it is empty.
    bores,       ///< Round holes from `low` to `high`.
    equal,       ///< What is as large as the selection.
    smooth,      ///< What continues the selection without an edge.
    neighbours,  ///< What is next to the selection.
  };
  what kind = what::named;
  QString name;
  double low = 0;  ///< Diameter, m.
  double high = std::numeric_limits<double>::max();
};

/// English and German words, in any case: "bores", "bores 8 to 12 mm", "bore 1/4 in" (2 % more or
/// less), "holes over 20", "bohrungen 8-12", "equal", "smooth", "neighbours", "12", "cover".
[[nodiscard]] surface_search read_search(const QString& words);

/// Surfaces each as large as one of these, by 0.5 % of its area, ascending. Cost: O(surfaces).
[[nodiscard]] std::vector<surface_id> equal_surfaces(
  const std::map<surface_id, client::surface_row>& rows, const std::vector<surface_id>& to);

}  // namespace tedit::desktop
