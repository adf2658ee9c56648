// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/check.hpp"

#include <algorithm>
#include <unordered_set>

#include "actors/store/loading.hpp"
#include "base/guard.hpp"

namespace tedit::actors {

namespace {

/// A look at one document, as far as it has come.
struct inspection {
  const store::document_view& document;
  document_check result = {};
  page_map sound_pages = {};
  std::unordered_set<hash128> needed = {};

  expected<void> read_pages() {
    const auto ids = document.page_ids();
    if (!ids)
      return fail(ids.error());
    result.pages = ids->size();
    for (const auto& id : *ids) {
      check_cancelled();
      if (auto page = document.read_page(id))
        sound_pages[id] = *page;
      else
        result.damage.push_back(page.error());
    }
    return {};
  }

  /// Pages that are damaged were named already; those that are not there were not.
  expected<page_ptr> find(const store::version_row& row, const hash128& id) {
    const auto found = sound_pages.find(id);
    if (found != sound_pages.end())
      return found->second;
    auto why = document.read_page(id);
    if (why)
      return why;
    if (why.error().code == ec::not_found)
      result.damage.push_back({ec::storage_error,
                               "version " + std::to_string(row.number) + ": " + why.error().message,
                               why.error().remedy,
                               {}});
    return why;
  }

  /// Whether all of it can be read; else why not is among the damage.
  bool is_whole(const store::version_row& row) {
    if (const auto list = manifest::from_bytes(row.manifest))
      for (const auto& id : list->page_ids())
        needed.insert(id);
    bool pages = true;
    page_map known;
    const auto mesh = load_mesh(
      row,
      [&](const hash128& id) {
        auto found = find(row, id);
        pages = pages && found;
        return found;
      },
      known);
    const auto cases = read_load_cases(row);
    const auto report = read_report(row);
    if (!mesh && pages)
      result.damage.push_back(mesh.error());
    if (!cases)
      result.damage.push_back(cases.error());
    if (!report)
      result.damage.push_back(report.error());
    return mesh && cases && report;
  }

  void read_versions(const store::contents& rows) {
    for (const auto& row : rows.versions) {
      check_cancelled();
      if (is_whole(row))
        result.whole.push_back(row.number);
    }
    for (const auto& [id, page] : sound_pages)
      result.unneeded_pages += needed.contains(id) ? 0 : 1;
  }
};

}  // namespace

expected<document_check> check_document(const store::document_view& document) {
  const auto rows = document.read();
  if (!rows)
    return fail(rows.error());
  inspection look{document};
  auto& result = look.result;
  result.format = document.format();
  result.head = rows->rows.head;
  result.log_lines = rows->rows.log.size();
  result.damage = rows->damage;
  // Rows that are damaged are not there: then the rest need not be a tree.
  if (auto tree = check_tree(rows->rows); !tree && rows->damage.empty())
    result.damage.push_back(tree.error());
  if (auto done = look.read_pages(); !done)
    return fail(done.error());
  look.read_versions(rows->rows);
  result.versions = rows->rows.versions.empty() ? 0 : rows->rows.versions.back().number + 1;
  return std::move(result);
}

expected<version_ptr> read_version(const store::document_view& document,
                                   std::optional<std::uint32_t> number) {
  const auto read = document.read();
  if (!read)
    return fail(read.error());
  const auto& rows = read->rows;
  if (!number)
    number = rows.head;
  if (!number)
    return read->damage.empty()
             ? fail(ec::not_found, "the document holds nothing", "Open a part in it first")
             : fail(read->damage.front());
  const auto row = std::ranges::find(rows.versions, *number, &store::version_row::number);
  if (row == rows.versions.end()) {
    const auto name = "version " + std::to_string(*number);
    if (!read->damage.empty())
      return fail(ec::storage_error, name + " cannot be read: the document is damaged",
                  "\"tedit doc check\" says which versions are whole");
    return fail(ec::not_found, "there is no " + name,
                rows.versions.empty()
                  ? "Open a part in the document first"
                  : "The last one is " + std::to_string(rows.versions.back().number));
  }
  page_map known;
  return load_mesh(
    *row, [&](const hash128& id) { return document.read_page(id); }, known);
}

}  // namespace tedit::actors
