// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "tests/simulation/scenario.hpp"

namespace tedit::simulation {

/// What became of a scenario.
struct outcome {
  std::vector<std::string> faults;    ///< None when all promises were kept.
  std::uint64_t steps = 0;            ///< Messages that actors handled, and events.
  std::uint64_t answers = 0;          ///< That clients got.
  std::uint64_t trace = 0;            ///< Two runs of one scenario have one.
  milliseconds lasted{0};             ///< In virtual time.
  std::map<std::string, int> errors;  ///< Codes of refusals.
  std::map<int, int> cad;             ///< States on CAD models that were told, by their numbers.
};

/// A folder of this process for `play`: in memory where there is such a file system, as nothing is
/// to outlive the machine.
[[nodiscard]] std::filesystem::path scratch_folder();

/// Plays a scenario with a whole server in one thread, then lets all rest, and holds what clients
/// were told against what the documents have: an acknowledged change is there once, one that was
/// refused is not; versions are one tree; who watches saw every head in order and ends with the
/// head's surface, loads and fields; each request got one answer; nothing is left over.
[[nodiscard]] outcome play(const scenario& what, const std::filesystem::path& folder);

/// The least part of a scenario that still fails, found by leaving out steps. Cost: some hundred
/// plays.
[[nodiscard]] scenario shrink(scenario failing, const std::filesystem::path& folder);

}  // namespace tedit::simulation
