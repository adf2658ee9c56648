// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <vector>

#include "base/error.hpp"
#include "fem/load_case.hpp"

namespace tedit::desktop {

/// Reads a library of materials (config/materials.json says its form). Errors: `bad_input` naming
/// the material and what is wrong with it; `where` begins with `source`.
[[nodiscard]] expected<std::vector<fem::material>> materials_from_json(const QByteArray& json,
                                                                       const QString& source);

/// The library that came with the program: share/tedit/materials.json beside the installed one,
/// config/materials.json of the source tree beside a built one.
/// Errors: `io_error` when it is not there, as above.
[[nodiscard]] expected<std::vector<fem::material>> shipped_materials();

}  // namespace tedit::desktop
