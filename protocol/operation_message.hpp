// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "edit/report.hpp"

namespace tedit::v1 {
class ApplyEdit;
class Catalogue;
class ParameterValue;
}  // namespace tedit::v1

namespace tedit {

/// An operation that a server offers: all that forms, menus and help need to know.
struct offered_operation {
  ops::operation_description about;
  std::string plugin;  ///< Name and version of the plugin that brings it.
};

/// A plugin that is not in use (message `tedit.v1.RefusedPlugin`).
struct refused_operation {
  std::string file;  ///< Its path on the server.
  std::string reason;
  // Only of a plugin in quarantine: it broke the process that ran or loaded it.
  std::string operation = {};  ///< The one that is switched off; empty: the whole file.
  unsigned crashes = 0;
  std::string remedy = {};
};

/// All operations that a server offers (message `tedit.v1.Catalogue`).
struct operation_catalogue {
  std::vector<offered_operation> operations;
  std::vector<refused_operation> refused;
};

namespace protocol {

void to_message(const ops::parameter_value& value, v1::ParameterValue* out);

/// An unset value becomes an empty text, which the parameter's type then judges.
[[nodiscard]] ops::parameter_value from_message(const v1::ParameterValue& message);

/// The document and `expected_version` are not set.
void to_message(const edit_request& wanted, v1::ApplyEdit* out);

/// Errors: `invalid_argument` for what becomes of loads.
[[nodiscard]] expected<edit_request> from_message(const v1::ApplyEdit& message);

void to_message(const operation_catalogue& all, v1::Catalogue* out);
[[nodiscard]] operation_catalogue from_message(const v1::Catalogue& message);

}  // namespace protocol

}  // namespace tedit
