// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// The kinds of workers. A new one is a row here, its interface and place in `worker_set`
/// (actors/interfaces.hpp), its pool (actors/supervisor/pool_actors.cpp), and how it is made in a
/// process and on a thread (actors/node).
namespace tedit::actors {

enum class worker_role : std::uint8_t { modeling, optimizer, solver };

struct worker_role_facts {
  std::string_view name;      ///< On command lines, in status, configuration and logs.
  bool runs_plugins = false;  ///< Its process has a memory limit and may die of what it runs.
  /// It reaches no network, no other process and no file of this user (sandbox/sandbox.hpp). Not
  /// the solver: graphics drivers need devices, and what it runs is this program's own.
  bool confined = false;
};

/// By `worker_role`, in the order in which status lists them.
inline constexpr std::array<worker_role_facts, 3> worker_roles{{
  {"modeling", true, true},
  {"optimizer", false, true},
  {"solver"},
}};

[[nodiscard]] constexpr const worker_role_facts& facts_of(worker_role role) {
  return worker_roles[static_cast<std::size_t>(role)];
}

[[nodiscard]] inline std::string name_of(worker_role role) {
  return std::string(facts_of(role).name);
}

/// The role of this name, or nothing.
[[nodiscard]] constexpr std::optional<worker_role> role_named(std::string_view name) {
  for (std::size_t i = 0; i < worker_roles.size(); ++i)
    if (worker_roles[i].name == name)
      return static_cast<worker_role>(i);
  return std::nullopt;
}

}  // namespace tedit::actors
