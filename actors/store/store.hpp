// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/interfaces.hpp"

namespace tedit::actors {

struct store_state {
  std::unique_ptr<store::document> document;

  static inline const char* name = "store";
};

/// The actor of one document file; spawn it detached, it waits for the disk.
store_actor::behavior_type make_store(store_actor::stateful_pointer<store_state> self,
                                      std::filesystem::path file);

// -- without actors ----------------------------------------------------------------------

/// Everything in a document; versions share the pages that they have in common.
[[nodiscard]] expected<stored_document> load(const store::document& document);

/// A node and the head moved to it, as one transaction; pages of `parent` are there already.
[[nodiscard]] store::change change_of(const graph_node& node, const mesh_version* parent);

/// Load cases as the one text in which a version stores them.
[[nodiscard]] std::string join_load_cases(const std::vector<std::string>& load_cases);

}  // namespace tedit::actors
