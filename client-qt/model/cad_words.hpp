// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

#include "client/types.hpp"

namespace tedit::desktop {

/// How a version stands on the CAD model, as a sentence: "On the CAD model, new vertices within
/// 3e-12 mm". Empty for a state that is not known here.
[[nodiscard]] QString cad_words(const client::version_info& version);

/// The same in a word or two, for a picture of the version: "CAD", "mesh only".
[[nodiscard]] QString cad_mark_words(const client::cad_state& state);

/// What a person is told when that has become known; empty where nothing is to be done about it.
/// @param before the state of the version that it was made from, where that has one.
[[nodiscard]] QString cad_news(const client::version_info& version,
                               const std::optional<client::cad_state>& before);

}  // namespace tedit::desktop
