// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/removal.hpp"

#include <algorithm>
#include <unordered_set>

#include "actors/store/reading.hpp"
#include "mesh/version.hpp"

namespace tedit::store {

namespace {

using new_number = std::optional<std::uint32_t>;

tl::unexpected<error> no_such_removal(const std::string& why) {
  return fail(ec::invalid_argument, "these versions cannot be removed: " + why,
              "Keep the current version and, with each version, the one that it was made from");
}

/// Whether what is left is a tree with its head, numbered from 0 without gaps.
expected<void> check_removal(const contents& all, const removal& what) {
  if (what.numbers.size() != all.versions.size())
    return no_such_removal("there are " + std::to_string(all.versions.size()) + " versions, not " +
                           std::to_string(what.numbers.size()));
  std::uint32_t next = 0;
  for (const auto& row : all.versions) {
    const auto name = "version " + std::to_string(row.number);
    if (row.number >= what.numbers.size())
      return no_such_removal("the versions have gaps before " + name);
    const auto& number = what.numbers[row.number];
    if (number && *number != next++)
      return no_such_removal(name + " would be version " + std::to_string(*number));
    if (number && row.parent && (*row.parent >= row.number || !what.numbers[*row.parent]))
      return no_such_removal(name + " would lose its parent");
  }
  if (all.head && (*all.head >= what.numbers.size() || !what.numbers[*all.head]))
    return no_such_removal("the current one would go");
  return {};
}

/// Statements of one removal.
struct row_writer {
  sqlite3* db;
  expected<void> done = {};

  /// Nothing after the first failure.
  template <class... Values>
  void run(const char* sql, const Values&... values) {
    if (!done)
      return;
    const auto made = prepare(db, sql);
    done = made ? query(*made, values...).run() : fail(made.error());
  }
};

/// Versions keep their order, so that a new number is free when its turn comes.
expected<void> renumber(sqlite3* db, const contents& all, const removal& what) {
  row_writer rows{db};
  const auto now = [&](const new_number& before) -> new_number {
    return before && *before < what.numbers.size() ? what.numbers[*before] : std::nullopt;
  };
  rows.run("PRAGMA defer_foreign_keys = ON");
  for (const auto& row : all.versions)
    if (!now(row.number)) {
      rows.run("DELETE FROM annotation WHERE version = ?", row.number);
      rows.run("DELETE FROM cad WHERE version = ?", row.number);
      rows.run("DELETE FROM version WHERE number = ?", row.number);
    }
  for (const auto& row : all.versions)
    if (const auto number = now(row.number);
        number && (number != row.number || now(row.redo) != row.redo)) {
      rows.run("UPDATE version SET number = ?2, parent = ?3, redo = ?4 WHERE number = ?1",
               row.number, *number, now(row.parent), now(row.redo));
      rows.run("UPDATE annotation SET version = ?2 WHERE version = ?1", row.number, *number);
      rows.run("UPDATE cad SET version = ?2 WHERE version = ?1", row.number, *number);
    }
  if (all.head)
    rows.run("UPDATE head SET version = ?", *now(all.head));
  for (const auto& line : what.log)
    rows.run("UPDATE log SET what = ?2, details = ?3 WHERE sequence = ?1",
             static_cast<std::int64_t>(line.sequence), line.what, line.details);
  return rows.done;
}

/// Reads all pages that the rest needs. Errors: those of `find_page`, and for a list of them that
/// cannot be read.
expected<std::unordered_set<hash128>> needed_pages(sqlite3* db, const contents& all,
                                                   const removal& what) {
  const auto by_id = prepare(db, page_query);
  if (!by_id)
    return fail(by_id.error());
  std::unordered_set<hash128> needed;
  for (const auto& row : all.versions) {
    if (!what.numbers[row.number])
      continue;
    const auto list = manifest::from_bytes(row.manifest);
    if (!list)
      return fail(ec::storage_error,
                  "version " + std::to_string(row.number) + ": " + list.error().message,
                  "Restore the document from a backup");
    for (const auto& id : list->page_ids())
      if (needed.insert(id).second)
        if (auto page = find_page(*by_id, id); !page)
          return fail(ec::storage_error, page.error().message, page.error().remedy);
  }
  return needed;
}

expected<std::int64_t> remove_pages(sqlite3* db, const std::unordered_set<hash128>& needed) {
  std::vector<std::string> unneeded;
  {
    const auto ids = prepare(db, "SELECT id FROM page");
    if (!ids)
      return fail(ids.error());
    query row(*ids);
    expected<bool> more;
    while ((more = row.next()) && *more) {
      const auto text = row.text(0);
      const auto id = hash_from_hex(text);
      if (!id || !needed.contains(*id))
        unneeded.push_back(text);
    }
    if (!more)
      return fail(more.error());
  }
  row_writer rows{db};
  for (const auto& id : unneeded)
    rows.run("DELETE FROM page WHERE id = ?", id);
  return rows.done.map([&] { return static_cast<std::int64_t>(unneeded.size()); });
}

}  // namespace

expected<std::int64_t> remove_rows(sqlite3* db, const seal_keeper& seals, const removal& what) {
  if (auto begun = execute(db, "BEGIN IMMEDIATE"); !begun)
    return fail(begun.error());
  const rollback_guard guard(db);
  const auto all = read_contents(db, seals);
  if (!all)
    return fail(all.error());
  if (auto good = check_removal(*all, what); !good)
    return fail(good.error());
  const auto needed = needed_pages(db, *all, what);
  if (!needed)
    return fail(needed.error());
  std::int64_t pages = 0;
  return renumber(db, *all, what)
    .and_then([&] { return remove_pages(db, *needed); })
    .and_then([&](std::int64_t count) {
      pages = count;
      return seals.seal_everything();
    })
    .and_then([&] { return read_contents(db, seals); })
    .and_then([&](const contents&) { return execute(db, "COMMIT"); })
    .map([&] { return pages; });
}

expected<void> squeeze(sqlite3* db) {
  return execute(db, "VACUUM").and_then([&] {
    return number_of(db, "PRAGMA wal_checkpoint(TRUNCATE)").map([](std::int64_t) {});
  });
}

}  // namespace tedit::store
