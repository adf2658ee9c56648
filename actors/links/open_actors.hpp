// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include <caf/actor.hpp>

#include "actors/links/basp_guard.hpp"

namespace tedit::actors {

/// Whether a node may send to the actor of this process with this number. CAF lets any peer send to
/// each actor that any peer has heard of, by its number.
using reach = basp_guard::reach;

/// The actor may be sent to by workers. The number of one that has ended stays open: an answer that
/// comes late must not cost its sender the link, and CAF never uses a number again. Thread-safe.
void open_to_workers(const caf::actor& one);

/// All of those, in whichever system of the process.
[[nodiscard]] reach reach_of_workers();

/// These alone.
[[nodiscard]] reach reach_of(const std::vector<caf::actor>& some);

}  // namespace tedit::actors
