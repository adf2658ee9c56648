// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/cad/cad_rows.hpp"

#include <nlohmann/json.hpp>

#include "actors/session/change_log.hpp"
#include "protocol/forms.hpp"

namespace tedit::actors {

namespace {

constexpr const char* same = "same";
constexpr const char* mesh_only = "mesh_only";

}  // namespace

store::cad_row row_with(const cad::cad_model& model, double deviation_m) {
  store::cad_row row;
  row.status = same;
  row.deviation = deviation_m;
  row.facts = cad::to_text(model.facts);
  row.shape = *model.shape;
  return row;
}

store::cad_row row_without_model(std::string reason) {
  store::cad_row row;
  row.status = mesh_only;
  row.reason = std::move(reason);
  return row;
}

expected<cad::cad_model> model_in(const store::cad_row& row) {
  if (row.status != same)
    return fail(ec::not_found, "version " + std::to_string(row.number) + " is in the mesh only");
  auto facts = cad::facts_from(row.facts);
  if (!facts)
    return fail(facts.error());
  return cad::cad_model{std::make_shared<const std::string>(row.shape), std::move(*facts)};
}

cad_state cad_state_of(const store::cad_row& row) {
  if (row.status == same)
    return {cad_status::same, {}, row.deviation};
  return {cad_status::mesh_only, row.reason, 0};
}

std::string reason_after(const version_info& mesh_only_version, const std::string& reason) {
  return "version " + std::to_string(mesh_only_version.number) + " (" +
         mesh_only_version.operation + ") is in the mesh only: " + reason;
}

std::map<std::uint32_t, edit_request> requests_in(const std::vector<store::log_row>& log,
                                                  const std::set<std::uint32_t>& versions) {
  std::map<std::uint32_t, edit_request> found;
  for (const auto& line : log) {
    if (versions.empty() || line.what != "edit")
      continue;
    const auto past = past_change::from_log(line);
    if (!past || !past->version || !versions.contains(*past->version))
      continue;
    auto details = nlohmann::json::parse(line.details, nullptr, false);
    for (const char* key : {"client", "time", "head", "warnings", "edit_id", "request"})
      details.erase(key);
    if (auto wanted = protocol::from_json<edit_request>(details.dump()))
      found.insert_or_assign(*past->version, std::move(*wanted));
  }
  return found;
}

}  // namespace tedit::actors
