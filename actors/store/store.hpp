// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <vector>

#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/interfaces.hpp"

namespace tedit::actors {

/// A disk actor, and how much waits for it.
struct disk {
  disk_actor actor;
  std::shared_ptr<std::atomic<int>> jobs = std::make_shared<std::atomic<int>>(0);
};

/// The disks of a server. A commit goes to the one with the least to do; the first one never opens
/// documents, so that none waits behind a large one that is read.
class disk_set {
public:
  disk_set() = default;
  /// Of these, at least two.
  explicit disk_set(std::vector<disk> disks) : disks_(std::move(disks)) {}

  /// Linked to `owner`; each has a thread of its own.
  template <class Owner>
  static disk_set spawn(Owner* owner);

  /// The one for a commit.
  [[nodiscard]] const disk& for_commit() const { return least_busy(0); }
  /// The one for an opening.
  [[nodiscard]] const disk& for_load() const { return least_busy(1); }

private:
  [[nodiscard]] const disk& least_busy(std::size_t from) const;

  std::vector<disk> disks_;
};

struct disk_state {
  static inline const char* name = "disk";
};

/// One disk; spawn it detached. `jobs` counts down with each piece of work that is done.
disk_actor::behavior_type make_disk(disk_actor::stateful_pointer<disk_state> self,
                                    std::shared_ptr<std::atomic<int>> jobs);

struct store_state {
  shared_file file;
  disk_set disks;
  std::uint64_t uses = 0;

  static inline const char* name = "store";
};

/// The actor of one document file: no thread, and no descriptor while nothing is asked of it.
store_actor::behavior_type make_store(store_actor::stateful_pointer<store_state> self,
                                      std::filesystem::path file, disk_set disks);

// -- without actors ----------------------------------------------------------------------

/// A node and the head moved to it, as one transaction; pages of `parent` are there already.
[[nodiscard]] store::change change_of(const graph_node& node, const mesh_version* parent);

template <class Owner>
disk_set disk_set::spawn(Owner* owner) {
  constexpr std::size_t threads = 4;  // fsyncs overlap; more only wait for each other
  disk_set result;
  result.disks_.resize(threads);
  for (auto& one : result.disks_)
    one.actor = owner->template spawn<caf::detached + caf::linked>(make_disk, one.jobs);
  return result;
}

/// Load cases as the one text in which a version stores them.
[[nodiscard]] std::string stored_form(const load_case_list& load_cases);

}  // namespace tedit::actors
