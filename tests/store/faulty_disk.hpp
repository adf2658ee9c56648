// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <sqlite3.h>

namespace tedit::store {

/// When and how a `faulty_disk` fails. Its operations are those that change something: writes,
/// truncations, syncs, removals and making files, counted from 0.
struct disk_faults {
  std::optional<std::int64_t> cut_at;    ///< From this operation on all fails: the power is gone.
  std::optional<std::int64_t> full_at;   ///< From this operation on a write finds no room.
  std::optional<std::int64_t> fails_at;  ///< This operation fails once, as an I/O error.
  bool lies = false;                     ///< A sync says that it is done and does nothing.
};

/// A disk under SQLite (its default VFS while this lives) that keeps what was not synced apart from
/// what was: real files show what a program sees, and `cut` turns them into what a power cut would
/// leave. Each write since a file's last sync is then there or not, whatever was written after it,
/// and some of its sectors may be: old, new, or rubbish. A file that was made or removed since its
/// folder was synced is there or not. Syncs cost nothing. One at a time, in one thread.
class faulty_disk {
public:
  explicit faulty_disk(disk_faults faults, std::uint64_t seed = 0);
  ~faulty_disk();
  faulty_disk(const faulty_disk&) = delete;
  faulty_disk& operator=(const faulty_disk&) = delete;

  /// Leaves in each file what survives. Whoever has one open must have closed it.
  void cut();

  /// There is room again.
  void empty() { faults_.full_at.reset(); }

  /// Operations so far.
  [[nodiscard]] std::int64_t operations() const noexcept { return operations_; }

  /// Whether a fault was met.
  [[nodiscard]] bool failed() const noexcept { return failed_; }

  // -- for the VFS's functions ---------------------------------------------------------------

  using content = std::vector<char>;

  /// What a sync has to bring to the disk.
  struct pending_write {
    std::int64_t offset = 0;  ///< A truncation: the file's length.
    content bytes;            ///< None: a truncation.
  };
  struct file {
    content durable;
    std::vector<pending_write> pending;
    bool entered = true;            ///< Its folder knows it.
    bool removed = false;           ///< Its folder does not know that.
    std::optional<content> before;  ///< Of one of this name that its folder knows instead.
  };

  /// Takes part in the next operation: SQLite's code of a failure, or SQLITE_OK.
  int next_operation(bool needs_room = false);
  [[nodiscard]] bool is_cut() const noexcept;
  void opened(const std::string& path, bool made);
  void wrote(const std::string& path, pending_write what);
  void synced(const std::string& path);
  void removed(const std::string& path, bool folder_synced);
  [[nodiscard]] sqlite3_vfs* below() const noexcept { return below_; }

private:
  bool chance(double of) { return std::bernoulli_distribution(of)(random_); }
  void survive(content& bytes, const pending_write& what);
  void folder_synced();

  disk_faults faults_;
  std::mt19937_64 random_;
  std::int64_t operations_ = 0;
  bool failed_ = false;
  std::map<std::string, file> files_;
  sqlite3_vfs* below_;
  sqlite3_vfs vfs_{};
};

}  // namespace tedit::store
