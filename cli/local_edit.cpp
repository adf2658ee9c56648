// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/local_edit.hpp"

#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::cli {

namespace {

void count_tets(const mesh_version& base, edit_outcome& outcome) {
  const auto& after = *outcome.version;
  for (tet_id t = 0; t < std::max(base.tet_slots(), after.tet_slots()); ++t) {
    const bool was = t < base.tet_slots() && base.is_live_tet(t);
    const bool is = t < after.tet_slots() && after.is_live_tet(t);
    const bool same = was && is && base.tet_at(t) == after.tet_at(t);
    outcome.tets_removed += was && !same;
    outcome.tets_added += is && !same;
  }
}

nlohmann::ordered_json to_json(const surface_change& change) {
  nlohmann::ordered_json row{{"id", change.id},
                             {"name", change.name},
                             {"fate", fate_name(change.fate)},
                             {"area_before_m2", change.area_before},
                             {"area_after_m2", change.area_after}};
  if (change.fate == surface_fate::merged_into || change.fate == surface_fate::split_from)
    row["other"] = change.other;
  return row;
}

std::string list_ids(const std::vector<surface_change>& map,
                     const std::vector<surface_fate>& fates) {
  std::string text;
  for (const auto& change : map)
    if (std::ranges::find(fates, change.fate) != fates.end())
      text += (text.empty() ? "" : ", ") + std::to_string(change.id);
  return text.empty() ? "none" : text;
}

}  // namespace

expected<edit_outcome> apply_edit(const ops::catalogue& plugins, const version_ptr& base,
                                  const edit_request& request,
                                  const std::vector<fem::load_case>& load_cases,
                                  const execution& run) {
  const stopwatch total;
  stopwatch clock;
  const auto host = ops::make_host_services();
  ops::context ctx;
  ctx.host = host.get();
  ctx.run.cancel = run.cancel;
  ctx.run.progress = [&](double fraction, std::string_view stage) {
    run.report(0.8 * fraction, stage);
  };
  const auto edit = ops::run_operation(plugins, request.operation, *base, {request.surfaces},
                                       request.parameters, ctx);
  if (!edit)
    return fail(edit.error());
  edit_outcome outcome;
  outcome.operation_ms = clock.restart();
  run.report(0.85, "improving and checking");
  edit_claim claim;
  claim.touched = edit->touched;
  claim.volume_change = edit->volume_change;
  auto finished = finish_edit(base, edit->candidate, claim, edit->improve, {}, run);
  if (!finished)
    return fail(finished.error());
  outcome.finished = std::move(*finished);
  outcome.version = outcome.finished.version;
  outcome.notices = edit->notices;
  outcome.volume_change = edit->volume_change;
  outcome.surface_map = compare_surfaces(*base, *outcome.version);
  for (const auto& loads : load_cases) {
    auto carried = fem::carry_over(loads, *base, *outcome.version, outcome.surface_map);
    outcome.receipt.insert(outcome.receipt.end(), carried.lines.begin(), carried.lines.end());
    outcome.load_cases.push_back(std::move(carried.after));
  }
  count_tets(*base, outcome);
  outcome.total_ms = total.milliseconds();
  run.report(1, "done");
  return outcome;
}

nlohmann::ordered_json to_json(const mesh_version& base, const edit_outcome& outcome) {
  using json = nlohmann::ordered_json;
  json removed = json::array();
  json added = json::array();
  json changed = json::array();
  json map = json::array();
  for (const auto& change : outcome.surface_map) {
    map.push_back(to_json(change));
    if (change.fate == surface_fate::removed || change.fate == surface_fate::merged_into)
      removed.push_back(change.id);
    else if (change.fate == surface_fate::added || change.fate == surface_fate::split_from)
      added.push_back(change.id);
    else if (change.fate == surface_fate::changed)
      changed.push_back(change.id);
  }
  json receipt = json::array();
  for (const auto& line : outcome.receipt)
    receipt.push_back({{"load_case", line.load_case},
                       {"item", line.item},
                       {"fate", fem::fate_name(line.fate)},
                       {"surfaces_lost", line.surfaces_lost},
                       {"area_before_m2", line.area_before},
                       {"area_after_m2", line.area_after},
                       {"text", line.text}});
  const auto& done = outcome.finished;
  return {{"from_version", to_hex(base.id())},
          {"to_version", to_hex(outcome.version->id())},
          {"surfaces_removed", removed},
          {"surfaces_added", added},
          {"surfaces_changed", changed},
          {"surface_map", map},
          {"tets_added", outcome.tets_added},
          {"tets_removed", outcome.tets_removed},
          {"volume_change_m3", outcome.volume_change},
          {"radius_ratio_touched",
           {{"before_min", done.touched_min_before},
            {"after_min", done.touched_min_after},
            {"after_median", done.touched_median_after}}},
          {"receipt", receipt},
          {"notices", outcome.notices},
          {"timings_ms",
           {{"operation", outcome.operation_ms},
            {"improve", done.improve_ms},
            {"check", done.check_ms},
            {"total", outcome.total_ms}}}};
}

std::string describe(const edit_outcome& outcome) {
  const auto& done = outcome.finished;
  std::string text;
  const auto line = [&](const std::string& label, const std::string& value) {
    text += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  };
  using enum surface_fate;
  line("surfaces removed", list_ids(outcome.surface_map, {removed, merged_into}));
  line("surfaces added", list_ids(outcome.surface_map, {added, split_from}));
  line("surfaces changed", list_ids(outcome.surface_map, {changed}));
  line("tets",
       "+" + std::to_string(outcome.tets_added) + " -" + std::to_string(outcome.tets_removed));
  line("volume",
       (outcome.volume_change > 0 ? "+" : "") + pretty(1e9 * outcome.volume_change, 6) + " mm3");
  line("radius ratio", "worst touched " + pretty(done.touched_min_after, 3) + " (before " +
                         pretty(done.touched_min_before, 3) + "), median " +
                         pretty(done.touched_median_after, 3));
  line("time", pretty(outcome.total_ms, 3) + " ms (operation " + pretty(outcome.operation_ms, 3) +
                 ", improve " + pretty(done.improve_ms, 3) + ", check " + pretty(done.check_ms, 3) +
                 ")");
  for (const auto& row : outcome.receipt)
    line("load case", row.text);
  for (const auto& notice : outcome.notices)
    line("note", notice);
  return text;
}

expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs) {
  ops::parameters result;
  for (const auto& pair : pairs) {
    const auto split = pair.find('=');
    if (split == std::string::npos || split == 0)
      return fail(ec::usage, "\"" + pair + "\" is no parameter", "Write NAME=VALUE");
    result[pair.substr(0, split)] = pair.substr(split + 1);
  }
  return result;
}

}  // namespace tedit::cli
