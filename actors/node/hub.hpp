// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/interfaces.hpp"
#include "actors/pages/page_cache.hpp"
#include "actors/session/session.hpp"
#include "actors/store/library.hpp"
#include "actors/store/store.hpp"

namespace tedit::actors {

/// What all sessions of a server share.
struct hub_parts {
  std::filesystem::path documents;  ///< The folder of the document files.
  worker_set workers;
  page_store_actor pages;
  std::shared_ptr<page_cache> cache;
  std::string device = "auto";
  std::chrono::milliseconds unused_limit = actors::unused_limit;
  /// So long after its session ended goes a document that has no name of its own.
  std::chrono::milliseconds temporary_limit = std::chrono::hours(1);
  std::shared_ptr<result_memory> results = std::make_shared<result_memory>(result_bytes);
  std::shared_ptr<version_memory> versions = std::make_shared<version_memory>(version_bytes);
  std::optional<disk_set> disks = {};  ///< None: the hub makes its own.
  job_thread_actor reader = {};        ///< As `session_parts::reader`.
  cad_editor_actor cad = {};           ///< As `session_parts::cad`.
  part_importer_actor importer = {};   ///< Null: no CAD file is taken.
};

struct hub_state {
  using promise = caf::typed_response_promise<opened_document>;

  hub_parts parts;
  disk_set disks;
  std::map<std::string, session_actor> open;
  std::map<std::string, std::vector<promise>> opening;
  std::set<std::string> adding;      ///< Names of documents that are being checked or copied.
  std::set<session_actor> renaming;  ///< Whose name is being changed.
  std::uint64_t name_changes = 0;    ///< Documents that came, went or got another name.
  /// Names that documents had, oldest first, and their present ones: who comes back with one finds
  /// its document. Those of the last day are there again after a restart.
  std::deque<std::pair<std::string, std::string>> former;
  /// What sessions that ended left, by document, the latest first.
  std::list<std::pair<std::string, shared_remains>> remains;
  /// Documents without a name of their own that nobody has open: by what message each goes.
  std::map<std::string, std::uint64_t> temporary;
  std::uint64_t temporaries = 0;  ///< Names and messages for them so far.

  static inline const char* name = "hub";
};

/// Opens documents: each gets its store and its session once.
hub_actor::behavior_type make_hub(hub_actor::stateful_pointer<hub_state> self, hub_parts parts);

}  // namespace tedit::actors
