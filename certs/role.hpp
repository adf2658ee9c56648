// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace tedit::certs {

/// What the owner of a certificate may be. The names stand in certificates (OU of the subject), so
/// they are never renamed.
enum class role {
  server,     ///< Is dialled: documents, pools, clients.
  modeling,   ///< A worker that edits.
  optimizer,  ///< A worker that improves meshes.
  solver,     ///< A worker that solves.
  observer,   ///< Looks and changes nothing.
  client,     ///< A person's program.
};

struct role_row {
  role value;
  std::string_view name;
};

inline constexpr std::array all_roles{
  role_row{role::server, "server"},       role_row{role::modeling, "modeling"},
  role_row{role::optimizer, "optimizer"}, role_row{role::solver, "solver"},
  role_row{role::observer, "observer"},   role_row{role::client, "client"}};

[[nodiscard]] constexpr std::string_view role_name(role which) {
  for (const auto& row : all_roles)
    if (row.value == which)
      return row.name;
  return {};
}

[[nodiscard]] constexpr std::optional<role> role_named(std::string_view name) {
  for (const auto& row : all_roles)
    if (row.name == name)
      return row.value;
  return std::nullopt;
}

}  // namespace tedit::certs
