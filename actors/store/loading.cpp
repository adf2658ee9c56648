// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/loading.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "actors/cad/cad_rows.hpp"
#include "actors/pages/page_cache.hpp"
#include "protocol/forms.hpp"

namespace tedit::actors {

namespace {

tl::unexpected<error> damaged_row(const std::string& what) {
  return fail(ec::storage_error, "the document is damaged: " + what,
              "Restore the document from a backup");
}

}  // namespace

expected<shared_load_cases> read_load_cases(const store::version_row& row) {
  auto read = protocol::from_json<load_case_list>("{\"load_cases\":" + row.load_cases + "}");
  if (!read)
    return damaged_row("the load cases of version " + std::to_string(row.number) + ": " +
                       read.error().message);
  return std::make_shared<const load_case_list>(std::move(*read));
}

expected<shared_report> read_report(const store::version_row& row) {
  if (row.report.empty())
    return shared_report();
  auto read = protocol::from_json<edit_report>(row.report);
  if (!read)
    return damaged_row("the report of version " + std::to_string(row.number) + ": " +
                       read.error().message);
  return std::make_shared<const edit_report>(std::move(*read));
}

expected<void> check_tree(const store::contents& all) {
  const auto& rows = all.versions;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const auto& row = rows[n];
    const auto name = "version " + std::to_string(row.number);
    if (row.number != n)
      return damaged_row("the versions have gaps before " + name);
    if (row.parent && *row.parent >= row.number)
      return damaged_row(name + " has no parent before it");
    if (row.redo && (*row.redo >= rows.size() || rows[*row.redo].parent != row.number))
      return damaged_row("the redo of " + name);
  }
  if (all.head ? *all.head >= rows.size() : !rows.empty())
    return damaged_row("no version is the current one");
  return {};
}

expected<version_ptr> load_mesh(const store::version_row& row, const page_reader& read,
                                page_map& known) {
  const auto list = manifest::from_bytes(row.manifest);
  if (!list)
    return fail(list.error());
  std::optional<error> failure;
  auto version = mesh_version::from_manifest(*list, [&](const hash128& id) -> page_ptr {
    auto& p = known[id];
    if (!p) {
      auto found = read(id);
      if (found)
        p = *found;
      else
        failure = found.error();
    }
    return p;
  });
  if (failure)
    return damaged_row(failure->message);
  if (version && (*version)->id() != row.id)
    return damaged_row("the mesh of version " + std::to_string(row.number) + " is another one");
  return version;
}

namespace {

/// What a version is told by without its mesh. Errors: `storage_error` when its manifest is not the
/// one that it is named by, or when one of its pages is missing; those in `there` are not.
expected<void> describe_unread(const store::document& document, const store::version_row& row,
                               std::unordered_set<hash128>& there, version_info& info) {
  const auto list = manifest::from_bytes(row.manifest);
  if (!list || hash_bytes(row.manifest) != row.id)
    return damaged_row("the mesh of version " + std::to_string(row.number) + " is another one");
  for (const auto& id : list->page_ids())
    if (there.insert(id).second && !document.has_page(id))
      return damaged_row("page " + to_hex(id) + " of version " + std::to_string(row.number) +
                         " is missing");
  info.vertices = list->counts[0];
  info.tets = list->counts[1];
  info.boundary_facets = list->counts[2];
  return {};
}

expected<stored_document> load(const store::document& document, bool only_head) {
  const auto contents = document.read();
  if (!contents)
    return fail(contents.error());
  if (auto ok = check_tree(*contents); !ok)
    return fail(ok.error());
  stored_document result;
  result.head = contents->head;
  result.log = contents->log;
  page_map known;
  std::unordered_set<hash128> there;
  const auto read = [&](const hash128& id) { return document.read_page(id); };
  std::unordered_map<std::string, shared_load_cases> known_cases;  // Most versions have the same.
  for (const auto& row : contents->versions) {
    auto& load_cases = known_cases[row.load_cases];
    if (!load_cases) {
      auto found = read_load_cases(row);
      if (!found)
        return fail(found.error());
      load_cases = std::move(*found);
    }
    auto report = read_report(row);
    if (!report)
      return fail(report.error());
    graph_node node;
    const auto cad = std::ranges::find(contents->cad, row.number, &store::cad_row::number);
    node.info = {row.number, row.id,  row.parent, row.operation, 0, 0, 0, names_of(*load_cases),
                 row.name,   row.note};
    if (cad != contents->cad.end())
      node.info.cad = cad_state_of(*cad);
    node.load_cases = load_cases;
    node.report = std::move(*report);
    node.redo = row.redo;
    if (only_head && row.number != contents->head) {
      if (auto ok = describe_unread(document, row, there, node.info); !ok)
        return fail(ok.error());
    } else {
      auto mesh = load_mesh(row, read, known);
      if (!mesh)
        return fail(mesh.error());
      describe_mesh(node, std::move(*mesh));
    }
    result.nodes.push_back(std::move(node));
  }
  return result;
}

}  // namespace

void describe_mesh(graph_node& node, version_ptr mesh) {
  node.info.id = mesh->id();
  node.info.tets = mesh->tet_count();
  node.info.vertices = mesh->vertex_count();
  node.info.boundary_facets = mesh->facet_count();
  node.mesh = std::move(mesh);
}

expected<stored_document> load(const store::document& document) {
  return load(document, false);
}

expected<stored_document> load_head(const store::document& document) {
  return load(document, true);
}

expected<stored_version> load_version(const store::document& document,
                                      const version_query& wanted) {
  auto list = document.read_manifest(wanted.number);
  if (!list)
    return fail(list.error());
  store::version_row row;
  row.number = wanted.number;
  row.id = wanted.id;
  row.manifest = std::move(*list);
  stored_version result;
  page_map known;
  const auto find = [&](const hash128& id) -> expected<page_ptr> {
    if (auto there = wanted.known->find(id))
      return there;
    auto read = document.read_page(id);
    if (read)
      result.read_bytes += (*read)->bytes().size();
    return read;
  };
  auto mesh = load_mesh(row, find, known);
  if (!mesh)
    return fail(mesh.error());
  result.mesh = std::move(*mesh);
  return result;
}

}  // namespace tedit::actors
