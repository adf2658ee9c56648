// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/part_document.hpp"

#include <algorithm>

#include "actors/cad/cad_rows.hpp"
#include "actors/session/change_log.hpp"
#include "actors/store/check.hpp"
#include "actors/store/document.hpp"
#include "actors/store/loading.hpp"
#include "actors/store/store.hpp"
#include "ops/loader/catalogue.hpp"
#include "protocol/forms.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

store::cad_row to_row(const cad_state& state, std::uint32_t number) {
  auto row = state.model ? actors::row_with(*state.model, state.deviation_m)
                         : actors::row_without_model(state.reason);
  row.number = number;
  return row;
}

expected<cad_state> from_row(const store::cad_row& row) {
  cad_state state{std::nullopt, row.reason, row.deviation};
  if (actors::cad_state_of(row).status != actors::cad_status::same)
    return state;
  auto model = actors::model_in(row);
  if (!model)
    return fail(model.error());
  state.model = std::move(*model);
  return state;
}

/// Follows the edits of a document on its CAD model.
class model_reader {
public:
  model_reader(const store::document_view& document, const store::contents& rows,
               const execution& run)
      : document_(document), rows_(rows), run_(run) {}

  /// None where no version on the way has a model.
  expected<std::optional<cad_state>> read(std::uint32_t number) {
    std::vector<std::uint32_t> open;  // Newest first: edits whose model is not kept.
    for (std::optional<std::uint32_t> at = number; at; at = row_of(*at)->parent) {
      const auto kept = document_.read_cad(*at);
      if (!kept)
        return fail(kept.error());
      if (*kept) {
        auto state = from_row(**kept);
        return state ? follow(std::move(*state), *at, open) : fail(state.error());
      }
      open.push_back(*at);
    }
    return std::optional<cad_state>();
  }

private:
  [[nodiscard]] const store::version_row* row_of(std::uint32_t number) const {
    return &*std::ranges::find(rows_.versions, number, &store::version_row::number);
  }

  expected<std::optional<cad_state>> follow(cad_state state, std::uint32_t at,
                                            const std::vector<std::uint32_t>& open) {
    for (auto next = open.rbegin(); next != open.rend() && state.model; ++next) {
      auto made = edit(*state.model, at, *next);
      if (!made)
        return fail(made.error());
      state = std::move(*made);
      at = *next;
    }
    return std::optional(std::move(state));
  }

  expected<cad_state> edit(const cad::cad_model& model, std::uint32_t from, std::uint32_t to) {
    actors::version_info version;
    version.number = to;
    version.operation = row_of(to)->operation;
    const auto mesh_only = [&](const std::string& reason) {
      return cad_state{std::nullopt, actors::reason_after(version, reason), 0};
    };
    const auto requests = actors::requests_in(rows_.log, {to});
    const auto report = actors::read_report(*row_of(to));
    if (!report)
      return fail(report.error());
    const auto found = plugins_.find(row_of(to)->operation);
    if (requests.empty() || !*report || !found)
      return mesh_only(actors::unknown_request);
    const auto before = actors::read_version(document_, from);
    const auto after = actors::read_version(document_, to);
    if (!before || !after)
      return fail(before ? after.error() : before.error());
    auto made = cad::replay_edit(
      {model, (*found)->description, *before, *after, requests.at(to), **report}, run_);
    if (!made)
      return fail(made.error());
    if (made->verdict.is_same)
      return cad_state{std::move(made->model), "", 1e-3 * made->verdict.deviation_mm};
    return mesh_only(made->verdict.reason);
  }

  const store::document_view& document_;
  const store::contents& rows_;
  const execution& run_;
  ops::catalogue plugins_ = ops::load_default_catalogue();
};

struct opened_document {
  std::unique_ptr<store::document_view> document;
  store::contents rows;
};

expected<opened_document> open_document(const fs::path& file) {
  auto document = store::document_view::open(file);
  if (!document)
    return fail(document.error());
  auto all = (*document)->read();
  if (!all)
    return fail(all.error());
  return opened_document{std::move(*document), std::move(all->rows)};
}

expected<document_part> version_in(const opened_document& opened,
                                   std::optional<std::uint32_t> number) {
  const auto& rows = opened.rows;
  auto mesh = actors::read_version(*opened.document, number);
  if (!mesh)
    return fail(mesh.error());
  document_part part;
  part.number = number.value_or(rows.head.value_or(0));
  part.mesh = std::move(*mesh);
  const auto row = std::ranges::find(rows.versions, part.number, &store::version_row::number);
  const auto cases = actors::read_load_cases(*row);
  if (!cases)
    return fail(cases.error());
  part.load_cases = **cases;
  return part;
}

}  // namespace

bool is_document(const fs::path& file) {
  return file.extension() == ".tedit";
}

expected<document_part> read_version_of(const fs::path& file, std::optional<std::uint32_t> number) {
  const auto opened = open_document(file);
  return opened ? version_in(*opened, number) : fail(opened.error());
}

expected<document_part> read_part(const fs::path& file, std::optional<std::uint32_t> number,
                                  const execution& run) {
  const auto opened = open_document(file);
  if (!opened)
    return fail(opened.error());
  auto part = version_in(*opened, number);
  if (!part)
    return part;
  auto state = model_reader(*opened->document, opened->rows, run).read(part->number);
  if (!state)
    return fail(state.error());
  part->cad = std::move(*state);
  return part;
}

expected<void> copy_with_edit(const fs::path& from, const fs::path& to, const next_version& next) {
  {
    const auto source = store::document_view::open(from);
    if (!source)
      return fail(source.error());
    if (auto copied = (*source)->copy_to(to); !copied)
      return fail(copied.error());
  }
  auto added = [&]() -> expected<void> {
    const auto document = store::document::open(to);
    if (!document)
      return fail(document.error());
    const auto stored = actors::load_head(**document);
    if (!stored)
      return fail(stored.error());
    actors::graph_node node;
    node.info.number = static_cast<std::uint32_t>(stored->nodes.size());
    node.info.parent = stored->head;
    node.info.operation = next.wanted.operation;
    node.load_cases = std::make_shared<const load_case_list>(next.made->load_cases);
    node.report = std::make_shared<const edit_report>(next.made->report);
    actors::describe_mesh(node, next.made->version);
    auto change = actors::change_of(node, stored->nodes[stored->head.value_or(0)].mesh.get());
    actors::past_change past;
    past.what = change.what = "edit";
    past.operation = next.wanted.operation;
    past.client = "tedit";
    past.time = actors::utc_now();
    past.version = node.info.number;
    change.details = past.to_details(protocol::to_json(next.wanted));
    if (next.cad)
      change.cad.push_back(to_row(*next.cad, node.info.number));
    return (*document)->commit(change);
  }();
  std::error_code code;
  if (!added)
    fs::remove(to, code);
  return added;
}

}  // namespace tedit::cli
