// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/loading.hpp"

#include <unordered_map>

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

expected<stored_document> load(const store::document& document) {
  const auto contents = document.read();
  if (!contents)
    return fail(contents.error());
  if (auto ok = check_tree(*contents); !ok)
    return fail(ok.error());
  stored_document result;
  result.head = contents->head;
  result.log = contents->log;
  page_map known;
  const auto read = [&](const hash128& id) { return document.read_page(id); };
  std::unordered_map<std::string, shared_load_cases> known_cases;  // Most versions have the same.
  for (const auto& row : contents->versions) {
    auto mesh = load_mesh(row, read, known);
    if (!mesh)
      return fail(mesh.error());
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
    node.mesh = *mesh;
    node.info = {row.number,
                 row.id,
                 row.parent,
                 row.operation,
                 (*mesh)->tet_count(),
                 (*mesh)->vertex_count(),
                 (*mesh)->facet_count(),
                 names_of(*load_cases),
                 row.name,
                 row.note};
    node.load_cases = load_cases;
    node.report = std::move(*report);
    node.redo = row.redo;
    result.nodes.push_back(std::move(node));
  }
  return result;
}

}  // namespace tedit::actors
