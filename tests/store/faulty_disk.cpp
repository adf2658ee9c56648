// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/store/faulty_disk.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>

namespace tedit::store {

namespace {

constexpr std::size_t sector = 512;

faulty_disk::content bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// -- SQLite's file methods ---------------------------------------------------------------------

/// A file as SQLite has it open; the one below follows it in memory.
struct open_file : sqlite3_file {
  faulty_disk* disk;
  std::string path;
  bool tracked;  ///< Not one of SQLite's own temporary files.

  [[nodiscard]] sqlite3_file* below() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

open_file& as_open(sqlite3_file* one) {
  return *static_cast<open_file*>(one);
}
sqlite3_file* below(sqlite3_file* one) {
  return as_open(one).below();
}

int close_file_of(sqlite3_file* one) {
  auto& self = as_open(one);
  const int code =
    self.below()->pMethods ? self.below()->pMethods->xClose(self.below()) : SQLITE_OK;
  self.path.~basic_string();
  return code;
}

int read_file(sqlite3_file* one, void* to, int size, sqlite3_int64 at) {
  if (as_open(one).disk->is_cut())
    return SQLITE_IOERR_READ;
  return below(one)->pMethods->xRead(below(one), to, size, at);
}

int write_file(sqlite3_file* one, const void* from, int size, sqlite3_int64 at) {
  auto& self = as_open(one);
  if (const int code = self.tracked ? self.disk->next_operation(true) : SQLITE_OK;
      code != SQLITE_OK)
    return code;
  const auto* start = static_cast<const char*>(from);
  if (self.tracked)
    self.disk->wrote(self.path, {at, {start, start + size}});
  return self.below()->pMethods->xWrite(self.below(), from, size, at);
}

int truncate_file(sqlite3_file* one, sqlite3_int64 size) {
  auto& self = as_open(one);
  if (const int code = self.tracked ? self.disk->next_operation() : SQLITE_OK; code != SQLITE_OK)
    return code;
  if (self.tracked)
    self.disk->wrote(self.path, {size, {}});
  return self.below()->pMethods->xTruncate(self.below(), size);
}

int sync_file(sqlite3_file* one, int) {
  auto& self = as_open(one);
  if (!self.tracked)
    return SQLITE_OK;
  const int code = self.disk->next_operation();
  if (code == SQLITE_OK)
    self.disk->synced(self.path);
  return code;
}

int size_of_file(sqlite3_file* one, sqlite3_int64* size) {
  return below(one)->pMethods->xFileSize(below(one), size);
}
int take_lock(sqlite3_file* one, int level) {
  return below(one)->pMethods->xLock(below(one), level);
}
int give_lock(sqlite3_file* one, int level) {
  return below(one)->pMethods->xUnlock(below(one), level);
}
int check_lock(sqlite3_file* one, int* result) {
  return below(one)->pMethods->xCheckReservedLock(below(one), result);
}
int control_file(sqlite3_file* one, int what, void* with) {
  return below(one)->pMethods->xFileControl(below(one), what, with);
}
int sector_size(sqlite3_file*) {
  return int(sector);
}
int traits_of(sqlite3_file* one) {
  return below(one)->pMethods->xDeviceCharacteristics(below(one));
}
int map_shared(sqlite3_file* one, int page, int size, int extend, void volatile** to) {
  return below(one)->pMethods->xShmMap(below(one), page, size, extend, to);
}
int lock_shared(sqlite3_file* one, int offset, int n, int flags) {
  return below(one)->pMethods->xShmLock(below(one), offset, n, flags);
}
void shared_fence(sqlite3_file* one) {
  below(one)->pMethods->xShmBarrier(below(one));
}
int unmap_shared(sqlite3_file* one, int remove) {
  return below(one)->pMethods->xShmUnmap(below(one), remove);
}

/// Without memory mapping: it would write past `xWrite`.
constexpr sqlite3_io_methods methods = {
  2,           close_file_of, read_file,    write_file,   truncate_file, sync_file, size_of_file,
  take_lock,   give_lock,     check_lock,   control_file, sector_size,   traits_of, map_shared,
  lock_shared, shared_fence,  unmap_shared, nullptr,      nullptr};

// -- SQLite's VFS methods ------------------------------------------------------------------------

faulty_disk& disk_of(sqlite3_vfs* vfs) {
  return *static_cast<faulty_disk*>(vfs->pAppData);
}

int open_one(sqlite3_vfs* vfs, const char* name, sqlite3_file* one, int flags, int* out) {
  auto& disk = disk_of(vfs);
  auto* self = new (one) open_file{{nullptr}, &disk, name ? name : "", name != nullptr};
  const bool is_there = name && ::access(name, F_OK) == 0;
  int code = disk.is_cut() ? SQLITE_IOERR : SQLITE_OK;
  if (code == SQLITE_OK && name && !is_there && (flags & SQLITE_OPEN_CREATE) != 0)
    code = disk.next_operation(true);
  self->below()->pMethods = nullptr;
  if (code == SQLITE_OK)
    code = disk.below()->xOpen(disk.below(), name, self->below(), flags, out);
  if (code == SQLITE_OK && name)
    disk.opened(name, !is_there);
  // SQLite closes only what has methods.
  if (code == SQLITE_OK)
    self->pMethods = &methods;
  else
    self->path.~basic_string();
  return code;
}

int remove_one(sqlite3_vfs* vfs, const char* name, int sync_folder) {
  auto& disk = disk_of(vfs);
  if (const int code = disk.next_operation(); code != SQLITE_OK)
    return code;
  disk.removed(name, sync_folder != 0);
  return disk.below()->xDelete(disk.below(), name, 0);
}

int access_one(sqlite3_vfs* vfs, const char* name, int flags, int* result) {
  return disk_of(vfs).below()->xAccess(disk_of(vfs).below(), name, flags, result);
}

int full_name(sqlite3_vfs* vfs, const char* name, int size, char* out) {
  return disk_of(vfs).below()->xFullPathname(disk_of(vfs).below(), name, size, out);
}

}  // namespace

faulty_disk::faulty_disk(disk_faults faults, std::uint64_t seed)
    : faults_(faults), random_(seed), below_(sqlite3_vfs_find(nullptr)) {
  vfs_ = *below_;
  vfs_.szOsFile = int(sizeof(open_file)) + below_->szOsFile;
  vfs_.zName = "faulty";
  vfs_.pAppData = this;
  vfs_.pNext = nullptr;
  vfs_.xOpen = open_one;
  vfs_.xDelete = remove_one;
  vfs_.xAccess = access_one;
  vfs_.xFullPathname = full_name;
  sqlite3_vfs_register(&vfs_, 1);
}

faulty_disk::~faulty_disk() {
  sqlite3_vfs_unregister(&vfs_);
  sqlite3_vfs_register(below_, 1);
}

bool faulty_disk::is_cut() const noexcept {
  return faults_.cut_at && operations_ > *faults_.cut_at;
}

int faulty_disk::next_operation(bool needs_room) {
  const auto number = operations_++;
  const auto met = [&](int code) {
    failed_ = true;
    return code;
  };
  if (faults_.cut_at && number >= *faults_.cut_at)
    return met(SQLITE_IOERR);
  if (needs_room && faults_.full_at && number >= *faults_.full_at)
    return met(SQLITE_FULL);
  if (faults_.fails_at == number)
    return met(SQLITE_IOERR);
  return SQLITE_OK;
}

void faulty_disk::opened(const std::string& path, bool made) {
  const auto known = files_.find(path);
  if (known == files_.end()) {
    file one;
    one.entered = !made;
    if (!made)
      one.durable = bytes_of(path);
    files_.emplace(path, std::move(one));
  } else if (made) {  // In the place of one that was removed, which a cut may bring back.
    auto& one = known->second;
    if (one.entered)
      one.before = std::move(one.durable);
    one = file{{}, {}, false, false, std::move(one.before)};
  }
}

void faulty_disk::wrote(const std::string& path, pending_write what) {
  files_.at(path).pending.push_back(std::move(what));
}

/// The first sync of a file that was made brings its folder along, as SQLite's own VFS does.
void faulty_disk::synced(const std::string& path) {
  if (faults_.lies)
    return;
  auto& one = files_.at(path);
  one.durable = bytes_of(path);
  one.pending.clear();
  if (!one.entered)
    folder_synced();
}

void faulty_disk::removed(const std::string& path, bool with_folder) {
  if (const auto known = files_.find(path); known != files_.end())
    known->second.removed = true;
  if (with_folder && !faults_.lies)
    folder_synced();
}

void faulty_disk::folder_synced() {
  std::erase_if(files_, [](const auto& one) { return one.second.removed; });
  for (auto& [path, one] : files_) {
    one.entered = true;
    one.before.reset();
  }
}

/// A write in part: each sector old, new or, where the power went, rubbish.
void faulty_disk::survive(content& bytes, const pending_write& what) {
  if (chance(.4))
    return;
  const auto at = static_cast<std::size_t>(what.offset);
  if (what.bytes.empty()) {
    bytes.resize(at);
    return;
  }
  const bool whole = chance(.6);
  for (std::size_t from = 0; from < what.bytes.size(); from += sector) {
    const auto n = std::min(sector, what.bytes.size() - from);
    if (!whole && chance(.5))
      continue;
    if (bytes.size() < at + from + n)
      bytes.resize(at + from + n);
    std::copy_n(what.bytes.begin() + std::ptrdiff_t(from), n,
                bytes.begin() + std::ptrdiff_t(at + from));
    if (!whole && chance(.1))
      std::generate_n(bytes.begin() + std::ptrdiff_t(at + from), n,
                      [&] { return static_cast<char>(random_()); });
  }
}

void faulty_disk::cut() {
  for (auto& [path, one] : files_) {
    ::unlink(path.c_str());
    ::unlink((path + "-shm").c_str());  // It lives in memory, not on a disk.
    const bool folder_is_behind = (one.removed || !one.entered) && chance(.5);
    std::optional<content> left = folder_is_behind && !one.entered ? one.before : one.durable;
    if (one.removed && !folder_is_behind)
      left.reset();
    else if (one.entered || !folder_is_behind)
      for (const auto& what : one.pending)
        survive(*left, what);
    if (left)
      std::ofstream(path, std::ios::binary)
        .write(left->data(), static_cast<std::streamsize>(left->size()));
  }
}

}  // namespace tedit::store
