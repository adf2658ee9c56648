// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

/// Numbers with units as people type them.
namespace tedit::desktop {

/// A number: with a point or a comma, "1e-3", "1/4", "1 1/2"; nothing when it is none or not
/// finite.
[[nodiscard]] std::optional<double> read_number(const QString& text);

/// A number with or without a unit, in SI: for "m" "5" (mm, the unit that is shown), "0,5 cm",
/// "1/4 in"; for "N" "5 kN". Nothing for what is no number and for units of something else.
[[nodiscard]] std::optional<double> read_quantity(const QString& text, const QString& si_unit);

/// What may be typed instead of the unit that is shown: "µm, cm, m, in, ft"; empty where there is
/// no other.
[[nodiscard]] QString other_units(const QString& si_unit);

}  // namespace tedit::desktop
