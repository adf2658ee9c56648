// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/cad/first_version.hpp"

#include <memory>

#include <nlohmann/json.hpp>

#include "actors/cad/cad_rows.hpp"
#include "actors/session/change_log.hpp"
#include "actors/store/document.hpp"
#include "actors/store/loading.hpp"
#include "actors/store/store.hpp"
#include "base/text.hpp"

namespace tedit::actors {

namespace {

expected<std::unique_ptr<store::document>> open_new(const std::filesystem::path& file) {
  auto document = store::document::open(file);
  if (!document)
    return fail(document.error());
  const auto rows = (*document)->read();
  if (!rows)
    return fail(rows.error());
  if (!rows->versions.empty())
    return fail(ec::conflict, "there is a document " + file.string() + " already",
                "Give another name: a document is not written over");
  return document;
}

}  // namespace

expected<void> create_document(const std::filesystem::path& file, const first_version& first) {
  const auto document = open_new(file);
  if (!document)
    return fail(document.error());
  graph_node node;
  node.info.operation = "import";
  node.load_cases = std::make_shared<const load_case_list>(first.load_cases);
  describe_mesh(node, first.mesh);
  auto change = change_of(node, nullptr);
  past_change past;
  past.what = past.operation = change.what = "import";
  past.client = first.client;
  past.time = utc_now();
  past.version = 0;
  past.warnings = first.warnings;
  change.details = past.to_details(
    nlohmann::json{{"file", to_utf8(first.file_name)}, {"length_unit", first.length_unit}}.dump());
  if (first.model)
    change.cad.push_back(row_with(*first.model, 0));  // Of version 0, as it stands there.
  return (*document)->commit(change);
}

}  // namespace tedit::actors
