// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace tedit::desktop {

/// What an operation says of itself, in the language of the window; of a plugin that no translation
/// knows, as it is.
[[nodiscard]] std::string in_users_language(const std::string& english);

}  // namespace tedit::desktop
