// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include "fem/receipt.hpp"

namespace tedit::desktop {

/// What became of a constraint or load, in the window's language: "Force (load 1): its surfaces
/// have 224 259 mm² now (+0.18 %); 20 kN in all, as before". Of a line that is written otherwise,
/// as a newer server may, its own sentence.
[[nodiscard]] QString receipt_words(const fem::receipt_line& line);

}  // namespace tedit::desktop
