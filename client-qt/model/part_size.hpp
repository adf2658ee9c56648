// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <array>

#include "client/surface.hpp"

namespace tedit::desktop {

/// The box around a part.
struct part_size {
  std::array<double, 3> edges{};  ///< m, along x, y, z.

  [[nodiscard]] double diagonal() const;
  /// Whether no usual part is so large: below a millimetre, above five metres. A mesh file says no
  /// unit of length, so such a one was read in the wrong one.
  [[nodiscard]] bool is_odd() const;
  /// "160 x 90 x 25 mm".
  [[nodiscard]] QString words() const;
};

/// Cost: O(vertices).
[[nodiscard]] part_size size_of(const client::surface_model& surface);

}  // namespace tedit::desktop
