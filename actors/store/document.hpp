// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "mesh/page.hpp"

namespace tedit::store {

/// A version of the document as it is stored. The texts are JSON that the store does not look into.
struct version_row {
  std::uint32_t number = 0;             ///< Unique in the document.
  std::optional<std::uint32_t> parent;  ///< The version it was made from; must be stored.
  hash128 id;                           ///< The hash of the manifest; two rows may share it.
  std::vector<std::byte> manifest;      ///< `manifest::to_bytes`.
  std::string operation;                ///< What made it.
  std::string load_cases;               ///< An array.
  std::string report;                   ///< What the operation reported.
  std::optional<std::uint32_t> redo;    ///< The child that a redo goes to.
  std::string name;                     ///< Read with the row; written by an annotation.
  std::string note;
};

/// A version's name and note; both empty: none.
struct annotation {
  std::uint32_t number = 0;
  std::string name;
  std::string note;
};

/// The CAD model of a version of a part that came from CAD. The store does not look into it.
struct cad_row {
  std::uint32_t number = 0;  ///< Of the version.
  std::string status;        ///< "same", "mesh_only".
  std::string reason;        ///< Why it is in the mesh only.
  double deviation = 0;      ///< m: of the mesh's new vertices from the model, at most.
  std::string facts;         ///< JSON.
  std::string shape;         ///< A BREP; empty, as `facts`, where it is in the mesh only.
};

/// One line of the document's history, oldest first by `sequence`, which is never reused.
struct log_row {
  std::uint64_t sequence = 0;
  std::string what;  ///< "import", "edit", "undo", "redo", "goto", "load_case", "annotate", ...
  std::string details;
};

/// What one transaction writes: all of it or nothing. Applied in declaration order.
struct change {
  std::vector<page_ptr> new_pages;         ///< Those that are stored already are skipped.
  std::optional<version_row> new_version;  ///< Its number must be new.
  std::optional<std::uint32_t> head;       ///< The new head; without it the head stays.
  /// Version number and the JSON that replaces its load cases.
  std::vector<std::pair<std::uint32_t, std::string>> load_cases;
  /// Version number and the child that its redo goes to from now on; none clears it.
  std::vector<std::pair<std::uint32_t, std::optional<std::uint32_t>>> redo;
  std::vector<annotation> annotations;  ///< Instead of those that the versions had.
  std::vector<cad_row> cad;             ///< Likewise.
  std::string what;  ///< Becomes a log row with `details`; an empty one is not logged.
  std::string details;
};

/// All that a document holds but its pages.
struct contents {
  std::vector<version_row> versions;  ///< Ascending by number.
  std::optional<std::uint32_t> head;  ///< None in a new document.
  std::vector<log_row> log;           ///< Ascending by sequence.
  std::vector<cad_row> cad;           ///< Ascending by number; without facts and shapes.
};

/// What is taken out of a document, and what the rest is called then.
struct removal {
  /// By the numbers before: the number that a version has from then on, none for one that goes.
  /// Those that stay keep their order, without gaps, and the parent of each stays, too.
  std::vector<std::optional<std::uint32_t>> numbers;
  std::vector<log_row> log;  ///< Lines that say something else from then on, by `sequence`.
};

/// What a copy of a document may have in memory.
inline constexpr std::int64_t most_bytes_of_a_copy = std::int64_t{2} << 30;

/// One session document in one SQLite file, its pages compressed with zstd. Every row has a hash
/// beside it and all rows together a seal, so that damage and careless edits are noticed
/// (docs/decisions/0018); a page's identity is its hash. While it is open an exclusive lock (see
/// document_lock.hpp) keeps every other `open` out. Not thread-safe: one thread at a time.
class document {
public:
  /// Opens the document in `file`. When the file is absent the document is a new one: its name is
  /// locked, and the first `commit` makes its file, whole or not at all. A file that is no document
  /// is left as it is; one of an older format is brought to the present one, which older programs
  /// refuse.
  /// Errors: `storage_error` when the file is empty, no SQLite database, no TEdit document, damaged
  /// or of a newer format; `io_error` when the system refuses to read or write it; `conflict` when
  /// it is open already, here or in another process.
  [[nodiscard]] static expected<std::unique_ptr<document>> open(const std::filesystem::path& file);

  ~document();
  document(const document&) = delete;
  document& operator=(const document&) = delete;

  /// Writes `c` in one transaction, which is durable when this returns.
  /// Errors: `storage_error` when a number is taken, names no stored version, a page is null or
  /// over `max_page_bytes`, another program holds or has changed the file, a row to change is
  /// damaged, or the disk fails; `conflict` when a new document's file is there meanwhile. Then
  /// nothing of `c` is stored. Cost: one compression per new page, two hashes of each changed row
  /// and one fsync, however long the history is; now and then a checkpoint.
  [[nodiscard]] expected<void> commit(const change& c);

  /// Reads all rows but the pages, and checks each and all together. Errors: `storage_error` naming
  /// what is damaged. Cost: O(rows), with all manifests.
  [[nodiscard]] expected<contents> read() const;

  /// Reads the manifest of one version; whoever takes it compares its hash with the version's id.
  /// Errors: `not_found`, `storage_error`. Cost: one look-up.
  [[nodiscard]] expected<std::vector<std::byte>> read_manifest(std::uint32_t number) const;

  /// Reads a page and checks its size and hash.
  /// Errors: `not_found`; `storage_error` when the stored bytes are damaged.
  [[nodiscard]] expected<page_ptr> read_page(const hash128& id) const;

  /// The CAD model of a version, or nothing. Errors: `storage_error`. Cost: unpacks it.
  [[nodiscard]] expected<std::optional<cad_row>> read_cad(std::uint32_t number) const;

  /// Whether a page with this identity is stored; its bytes are not checked. False, too, when the
  /// database cannot be read. Cost: one index look-up.
  [[nodiscard]] bool has_page(const hash128& id) const;

  /// All that is committed as the bytes of one file, which `open` takes. Errors: `not_found` before
  /// the first commit; `storage_error` beyond `most_bytes_of_a_copy`, and when the database cannot
  /// be read. Cost: its size.
  [[nodiscard]] expected<std::vector<std::byte>> copy() const;

  /// Writes all that is committed to a file that is not there, whole or not at all, and goes on
  /// with its own. Errors: `not_found` before the first commit; `storage_error` when another
  /// program has changed the document; those of `copy_database`. Cost: its size; needs no memory
  /// for it.
  [[nodiscard]] expected<void> copy_to(const std::filesystem::path& file) const;

  /// Takes the document away with all that lies beside it (`erase_files`). Nothing but the
  /// destructor may be called then; until that its name is locked. Errors: `conflict` when it is a
  /// link; `io_error`. Then it is as it was.
  [[nodiscard]] expected<void> erase();

  /// Gives its file another name in its folder, never one that something has. Closes the database
  /// first, so that all of the document is in the one file; a kill at any moment leaves it whole
  /// under one of the two names. A document without a file gets it under this name.
  /// @param file_name without a folder.
  /// Errors: `conflict` when the name is taken, or another program has the document open;
  /// `storage_error` when another program has changed it; `io_error`. Then it is as it was. Cost:
  /// that of `rest`, and an fsync.
  [[nodiscard]] expected<void> rename(const std::string& file_name);

  /// Takes versions out, then all pages that no version names, and gives the room back to the
  /// disk. All pages that stay are read before anything is written. A kill at any moment leaves
  /// the document as it was, or without what was to go. Returns how many pages went.
  /// Errors: `invalid_argument` for numbers that are not as `removal` says; those of `read` and
  /// `read_page`, then nothing is taken out; `storage_error` when the disk is full, also when only
  /// the room could not be given back. Cost: the whole document is read and written.
  [[nodiscard]] expected<std::int64_t> remove(const removal& what);

  /// Opens what `rest` closed, ahead of a call that is to be quick. Errors: those of `open`.
  [[nodiscard]] expected<void> wake();

  /// Closes the database's files until the next call that needs them, which opens them again (about
  /// 1 ms): a document that rests has no descriptor and keeps its lock. Cost: a checkpoint when
  /// something was written.
  void rest();

  /// How many documents of this process do not rest; each has three descriptors.
  [[nodiscard]] static int open_connections() noexcept;

private:
  struct impl;
  document();

  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::store
