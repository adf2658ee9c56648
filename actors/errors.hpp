// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <caf/error.hpp>

#include "base/error.hpp"

namespace tedit::actors {

/// An error of ours as CAF carries it, over the network too.
[[nodiscard]] caf::error to_caf(const error& e);

/// Whose change a request did not know of.
struct rival {
  std::string version;  ///< Of the head as it is, hexadecimal.
  std::uint32_t number = 0;
  std::string client;  ///< What follows is empty when it is not known.
  std::string cause;
  std::string operation;
  std::string time;  ///< UTC.
};

/// A `conflict` that says with whom; never sent over the network.
[[nodiscard]] caf::error to_caf(const error& e, const rival& other);
[[nodiscard]] std::optional<rival> rival_in(const caf::error& e);

/// The inverse. What CAF itself reports becomes `timeout` or `service_unavailable`; `what` names
/// the work that failed.
[[nodiscard]] error from_caf(const caf::error& e, const std::string& what);

/// What any request is told that needs a mesh where none was imported yet.
[[nodiscard]] inline error empty_document() {
  return {ec::conflict, "the document is empty", "Import a mesh first", {}};
}

/// True for failures that another worker may not have: the worker died or did not answer.
[[nodiscard]] bool worth_a_retry(const error& e);

/// How often it is then made again.
inline constexpr int most_retries = 2;

}  // namespace tedit::actors
