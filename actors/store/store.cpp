// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/store.hpp"

#include <unordered_set>

#include <nlohmann/json.hpp>

#include "actors/errors.hpp"

namespace tedit::actors {

namespace {

struct named_load_cases {
  std::vector<std::string> texts;
  std::vector<std::string> names;
};

expected<named_load_cases> split_load_cases(const std::string& text) {
  const auto rows = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!rows.is_array())
    return fail(ec::storage_error, "the document's load cases are damaged",
                "Restore the document from a backup");
  named_load_cases result;
  for (const auto& row : rows) {
    result.texts.push_back(row.dump());
    result.names.push_back(row.value("name", ""));
  }
  return result;
}

expected<version_ptr> load_mesh(const store::version_row& row, const store::document& document,
                                page_map& known) {
  const auto list = manifest::from_bytes(row.manifest);
  if (!list)
    return fail(list.error());
  std::optional<error> failure;
  auto version = mesh_version::from_manifest(*list, [&](const hash128& id) -> page_ptr {
    auto& p = known[id];
    if (!p) {
      auto read = document.read_page(id);
      if (read)
        p = *read;
      else
        failure = read.error();
    }
    return p;
  });
  if (failure)
    return fail(*failure);
  return version;
}

}  // namespace

std::string join_load_cases(const std::vector<std::string>& load_cases) {
  std::string text = "[";
  for (const auto& one : load_cases)
    text += (text.size() > 1 ? "," : "") + one;
  return text + "]";
}

expected<stored_document> load(const store::document& document) {
  const auto contents = document.read();
  if (!contents)
    return fail(contents.error());
  stored_document result;
  result.head = contents->head;
  result.log = contents->log;
  page_map known;
  for (const auto& row : contents->versions) {
    if (row.number != result.nodes.size())
      return fail(ec::storage_error, "the document's versions have gaps",
                  "Restore the document from a backup");
    auto mesh = load_mesh(row, document, known);
    auto load_cases = split_load_cases(row.load_cases);
    if (!mesh || !load_cases)
      return fail(mesh ? load_cases.error() : mesh.error());
    graph_node node;
    node.mesh = *mesh;
    node.info = {row.number,
                 row.id,
                 row.parent,
                 row.operation,
                 (*mesh)->tet_count(),
                 (*mesh)->vertex_count(),
                 (*mesh)->facet_count(),
                 std::move(load_cases->names),
                 row.name,
                 row.note};
    node.load_cases = std::move(load_cases->texts);
    node.report = row.report;
    node.redo = row.redo;
    result.nodes.push_back(std::move(node));
  }
  return result;
}

store::change change_of(const graph_node& node, const mesh_version* parent) {
  store::change change;
  std::unordered_set<hash128> there;
  if (parent) {
    const auto ids = parent->pages().page_ids();
    there.insert(ids.begin(), ids.end());
  }
  node.mesh->for_each_page([&](const page_ptr& p) {
    if (!there.contains(p->id()))
      change.new_pages.push_back(p);
  });
  store::version_row row;
  row.number = node.info.number;
  row.parent = node.info.parent;
  row.id = node.info.id;
  row.manifest = node.mesh->pages().to_bytes();
  row.operation = node.info.operation;
  row.load_cases = join_load_cases(node.load_cases);
  row.report = node.report;
  change.new_version = std::move(row);
  change.head = node.info.number;
  if (node.info.parent)
    change.redo.emplace_back(*node.info.parent, node.info.number);
  return change;
}

store_actor::behavior_type make_store(store_actor::stateful_pointer<store_state> self,
                                      std::filesystem::path file) {
  return {[=](load_atom) -> caf::result<stored_document> {
            auto opened = store::document::open(file);
            if (!opened)
              return to_caf(opened.error());
            self->state.document = std::move(*opened);
            auto contents = load(*self->state.document);
            if (!contents)
              return to_caf(contents.error());
            return std::move(*contents);
          },
          [=](const stored_change& change) -> caf::result<acknowledged> {
            if (!self->state.document)
              return to_caf({ec::storage_error, "the document is not open", {}, {}});
            const auto done = self->state.document->commit(*change.change);
            if (!done)
              return to_caf(done.error());
            return acknowledged{};
          }};
}

}  // namespace tedit::actors
