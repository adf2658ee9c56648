// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

#include "client-qt/model/document.hpp"
#include "client-qt/model/legend.hpp"

/// Two versions of a document beside each other.
namespace tedit::desktop {

/// The field `after` minus `before`, on the surface of `after`: at vertices that both versions have
/// in the same slot at the same position; elsewhere it has no value. The quantity `wanted` of the
/// result is the difference of that quantity; what is made of several components, as a size or a
/// principal value, is then in the first of them: see `difference_field`.
/// @pre each field is one of its surface's version. Cost: O(vertices).
[[nodiscard]] shared_field difference(const version_record& before,
                                      const shared_field& before_field, const version_record& after,
                                      const shared_field& after_field, shown_field wanted);

/// The same as the server made it, also at vertices where the value before is interpolated; none
/// outside of the version before. Null when the answer does not have it: only a component of an
/// array is a difference of one, and where 0 means "not known" it would not be told from none.
[[nodiscard]] shared_field difference(const client::comparison& made, shown_field wanted);

/// The quantity under which `difference` is shown.
[[nodiscard]] shown_field difference_field(shown_field wanted);

/// The field of a version for a load case by its name; an empty name means the envelope, or the
/// only one. Null when it is not held.
[[nodiscard]] shared_field field_of(const version_record& version, const std::string& load_case);

/// Why a version cannot be shown now; empty when its surface and the quantity are held.
[[nodiscard]] QString not_held(const version_record& version, const std::string& load_case,
                               shown_field wanted = shown_field::von_mises);

/// A version as it is compared: its surface, and the field on it.
struct compared {
  const client::surface_model& surface;
  const client::field_event& field;
};

/// A legend that fits the values of both versions together, as it would fit those of one, and then
/// stays; one whose range does not follow values is given back. Cost: O(vertices and facets).
[[nodiscard]] legend common_legend(legend by, const compared& a, const compared& b);

/// Figures of a version: the largest stress of all its load cases, Pa, and its mass, kg.
struct version_figures {
  std::optional<double> stress;
  std::optional<double> mass;
};
[[nodiscard]] version_figures figures_of(const version_record& version);

/// "v2  max 13.4 MPa (+3.2 %)  mass 120 g (−1.0 %)"; changes against `before` when it is given.
[[nodiscard]] QString title_of(const version_record& version, const version_record* before);

}  // namespace tedit::desktop
