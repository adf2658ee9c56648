// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::desktop {

/// An operation that the server offers: all that forms, menus and help need to know.
struct offered_operation {
  ops::operation_description about;
  QString plugin;  ///< Name and version.
};

/// A plugin that the server does not use, and why.
struct refused_plugin {
  QString file;
  QString reason;
};

struct catalogue {
  std::vector<offered_operation> operations;
  std::vector<refused_plugin> refused;

  /// Null when there is none with this id.
  [[nodiscard]] const offered_operation* find(const QString& id) const;
};

/// Reads the message Catalogue as canonical JSON. Errors: `protocol_error`.
[[nodiscard]] expected<catalogue> catalogue_from_json(const std::string& json);

}  // namespace tedit::desktop
