// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::v1 {
class Operation;
class ParameterValue;
}  // namespace tedit::v1

namespace tedit::protocol {

/// The catalogue's row for an operation; `plugin` is the plugin's name and version.
void to_message(const ops::operation_description& description, const std::string& plugin,
                v1::Operation* out);

void to_message(const ops::parameter_value& value, v1::ParameterValue* out);

/// An unset value becomes an empty text, which the parameter's type then judges.
[[nodiscard]] ops::parameter_value from_message(const v1::ParameterValue& message);

/// Parameters as JSON, the form in which they travel between actors and stand in the operation log.
[[nodiscard]] std::string parameters_to_json(const ops::parameters& values);

/// Errors: `protocol_error`.
[[nodiscard]] expected<ops::parameters> parameters_from_json(const std::string& json);

/// The message Catalogue as JSON: operations with their plugins, and refused files with reasons.
[[nodiscard]] std::string catalogue_to_json(
  const std::vector<std::pair<ops::operation_description, std::string>>& operations,
  const std::vector<std::pair<std::string, std::string>>& refused);

/// The operations of such a JSON, with their plugins, in its order. Errors: `protocol_error`.
[[nodiscard]] expected<std::vector<std::pair<ops::operation_description, std::string>>>
catalogue_from_json(const std::string& json);

}  // namespace tedit::protocol
