// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QStringList>

#include <vector>

#include "client/types.hpp"

namespace tedit::desktop {

/// What a format is called, in the language of the window where a translation knows it.
[[nodiscard]] QString title_of(const client::offered_format& format);

/// For a file dialog: "Mesh (*.msh)", one for each format that is written.
[[nodiscard]] QStringList filters_to_write(const std::vector<client::offered_format>& offered);

/// The patterns of files that a mesh is read from: "*.msh *.inp *.bdf *.nas".
[[nodiscard]] QString patterns_to_read(const std::vector<client::offered_format>& offered);

}  // namespace tedit::desktop
