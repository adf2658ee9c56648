// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

#include "base/error.hpp"

/// What the server says, in the window's language.
///
/// A server writes English and knows nothing of who reads it. The window has a list of all
/// sentences that the sources can make, as templates: "surface %1 has no room for the rounding at
/// %2" (server_words.inc, made by scripts/translations.py), finds the one that a text was made from
/// and takes its translation from the catalogue. What stands for %1 may be made from templates,
/// too.
namespace tedit::desktop {

/// The same in the window's language; what no template fits, as of a plugin or a newer server, as
/// it was sent. Decimal points are left as they are (`words_of` turns them). Cost: some 0.1 ms.
[[nodiscard]] QString in_window_language(const std::string& said);

/// One line: message, place and remedy, in the window's language and with its decimal point.
[[nodiscard]] QString one_line(const error& reason);

}  // namespace tedit::desktop
