// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

#include "protocol/report.hpp"

namespace tedit::desktop {

/// What an operation says of itself, in the language of the window; of a plugin that no translation
/// knows, as it is.
[[nodiscard]] std::string in_users_language(const std::string& english);

/// What a figure of an edit is ("pieces, of 2 bodies"), likewise; numbers in it stay.
[[nodiscard]] QString figure_words(const std::string& english);

/// The same as the first words of a row.
[[nodiscard]] QString figure_title(const std::string& english);

/// Its value and unit; nothing of a count of what there is none of, as of "hinges repaired".
[[nodiscard]] QString figure_value(const ops::figure& one);

/// What computed: "cpu" is a word of command lines.
[[nodiscard]] QString device_words(const std::string& device);

/// One value of a parameter that is chosen from a list, as people read it.
[[nodiscard]] QString choice_words(const std::string& choice);

/// Whether an edit took over what its preview had made.
[[nodiscard]] bool was_previewed(const edit_report& report);

/// How long it took to make what the edit is, ms; also when that was done before, as a preview.
[[nodiscard]] double made_in_ms(const edit_report& report);

}  // namespace tedit::desktop
