// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/recipes/values.hpp"

/// Steps that only a window knows how to carry out.
namespace tedit::client {

/// ", click, select, ...": all kinds.
[[nodiscard]] std::string window_kinds();
[[nodiscard]] bool is_window_kind(const std::string& name);

/// Refuses a step of such a kind that has not the fields that it needs, others, or one of another
/// type or size. `where` names the step.
void check_window_step(const json& step, const std::string& kind, const std::string& where);

}  // namespace tedit::client
