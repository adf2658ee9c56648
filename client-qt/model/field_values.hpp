// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "client-qt/model/legend.hpp"
#include "client/types.hpp"

namespace tedit::desktop {

/// Eigenvalues of a stress (xx, yy, zz, xy, yz, zx), descending, in its unit. In closed form (Smith
/// 1961): values that coincide come out apart by up to 1e-7 of the largest one.
[[nodiscard]] std::array<double, 3> principal_values(const float* stress);

/// Reads a quantity from the arrays of a field or a section. Who reads it at many places makes one
/// of these for all.
class value_reader {
public:
  /// The arrays must stay as they are while it is used.
  value_reader(const client::named_arrays<float>& from, shown_field wanted);

  /// At row `i`, SI; NaN where there is none.
  [[nodiscard]] float operator()(std::size_t i) const;

private:
  const std::vector<float>* array_ = nullptr;
  const fem::shown_quantity* what_ = nullptr;
  std::size_t components_ = 1;
  bool zero_is_none_ = false;
};

/// What a field must bring, beside the usual, for a quantity to be shown.
[[nodiscard]] client::watched_quantities needs(shown_field wanted);

/// Whether a field was sent with what the quantity needs.
[[nodiscard]] bool has(const client::field_event& field, shown_field wanted);

/// The shown quantity at place `i` of a field's arrays, SI; NaN where it has none.
[[nodiscard]] float value_in(const client::field_event& field, std::size_t i, shown_field wanted);

/// The same at a point of a section.
[[nodiscard]] float value_in(const client::section& cut, std::size_t i, shown_field wanted);

/// The same at a vertex slot; NaN when the field has no value there. Cost: O(log vertices).
[[nodiscard]] float value_at(const client::field_event& field, std::uint32_t slot,
                             shown_field wanted);

}  // namespace tedit::desktop
