// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include "fem/load_case.hpp"

namespace tedit::desktop {

/// A constraint or load in a few words with its size: "Fixed", "Force 500 N along −z".
[[nodiscard]] QString words(const fem::constraint& held);
[[nodiscard]] QString words(const fem::load& acting);

}  // namespace tedit::desktop
