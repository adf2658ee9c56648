// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/reports.hpp"

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace tedit::cli {

namespace {

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

nlohmann::ordered_json triple(vec3 v) {
  return {v.x, v.y, v.z};
}

std::string place(vec3 p) {
  return "(" + pretty(1e3 * p.x) + ", " + pretty(1e3 * p.y) + ", " + pretty(1e3 * p.z) + ") mm";
}

/// Lines of "label  value", aligned.
class labelled_lines {
public:
  void add(const std::string& label, const std::string& value) {
    text_ += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

private:
  std::string text_;
};

}  // namespace

nlohmann::ordered_json to_json(const edit_report& report) {
  using json = nlohmann::ordered_json;
  json removed = json::array();
  json added = json::array();
  json changed = json::array();
  json map = json::array();
  for (const auto& change : report.surface_map) {
    map.push_back(to_json(change));
    if (change.fate == surface_fate::removed || change.fate == surface_fate::merged_into)
      removed.push_back(change.id);
    else if (change.fate == surface_fate::added || change.fate == surface_fate::split_from)
      added.push_back(change.id);
    else if (change.fate == surface_fate::changed)
      changed.push_back(change.id);
  }
  json receipt = json::array();
  for (const auto& line : report.receipt)
    receipt.push_back({{"load_case", line.load_case},
                       {"item", line.item},
                       {"fate", fem::fate_name(line.fate)},
                       {"surfaces_lost", line.surfaces_lost},
                       {"area_before_m2", line.area_before},
                       {"area_after_m2", line.area_after},
                       {"text", line.text}});
  return {{"from_version", report.from_version},
          {"to_version", report.to_version},
          {"surfaces_removed", removed},
          {"surfaces_added", added},
          {"surfaces_changed", changed},
          {"surface_map", map},
          {"tets_added", report.tets_added},
          {"tets_removed", report.tets_removed},
          {"volume_change_m3", report.volume_change},
          {"radius_ratio_touched",
           {{"before_min", report.touched_min_before},
            {"after_min", report.touched_min_after},
            {"after_median", report.touched_median_after}}},
          {"receipt", receipt},
          {"notices", report.notices},
          {"timings_ms",
           {{"operation", report.operation_ms},
            {"improve", report.improve_ms},
            {"check", report.check_ms},
            {"total", report.total_ms}}}};
}

std::string describe(const edit_report& report) {
  labelled_lines lines;
  using enum surface_fate;
  lines.add("surfaces removed", list_ids(report.surface_map, {removed, merged_into}));
  lines.add("surfaces added", list_ids(report.surface_map, {added, split_from}));
  lines.add("surfaces changed", list_ids(report.surface_map, {changed}));
  lines.add("tets",
            "+" + std::to_string(report.tets_added) + " -" + std::to_string(report.tets_removed));
  lines.add("volume",
            (report.volume_change > 0 ? "+" : "") + pretty(1e9 * report.volume_change, 6) + " mm3");
  lines.add("radius ratio", "worst touched " + pretty(report.touched_min_after, 3) + " (before " +
                              pretty(report.touched_min_before, 3) + "), median " +
                              pretty(report.touched_median_after, 3));
  lines.add("time", pretty(report.total_ms, 3) + " ms (operation " +
                      pretty(report.operation_ms, 3) + ", improve " + pretty(report.improve_ms, 3) +
                      ", check " + pretty(report.check_ms, 3) + ")");
  for (const auto& row : report.receipt)
    lines.add("load case", row.text);
  for (const auto& notice : report.notices)
    lines.add("note", notice);
  return lines.text();
}

nlohmann::ordered_json to_json(const solve_report& report) {
  return {{"version_id", report.version_id},
          {"load_case", report.load_case},
          {"device", report.device},
          {"element_order", report.element_order},
          {"preview", report.preview},
          {"dofs", report.dofs},
          {"iterations", report.iterations},
          {"true_relative_residual", report.true_relative_residual},
          {"max_displacement_m", report.max_displacement_m},
          {"max_displacement_at_m", triple(report.max_displacement_at)},
          {"compliance_j", report.compliance_j},
          {"max_von_mises_pa", report.max_von_mises_pa},
          {"max_von_mises_at_m", triple(report.max_von_mises_at)},
          {"reaction_n", triple(report.reaction_n)},
          {"applied_n", triple(report.applied_n)},
          {"timings_ms",
           {{"assembly", report.assembly_ms},
            {"setup", report.setup_ms},
            {"solve", report.solve_ms},
            {"recovery", report.recovery_ms},
            {"total", report.total_ms}}}};
}

std::string describe(const solve_report& report) {
  labelled_lines lines;
  lines.add("device", report.device);
  lines.add("unknowns", std::to_string(report.dofs) +
                          (report.element_order == 1 ? " (linear tets)" : " (quadratic tets)"));
  lines.add("iterations", std::to_string(report.iterations));
  lines.add("residual", pretty(report.true_relative_residual, 2) + " (true, relative)");
  lines.add("max displacement", pretty(1e3 * report.max_displacement_m, 6) + " mm at " +
                                  place(report.max_displacement_at));
  lines.add("max von Mises", pretty(1e-6 * report.max_von_mises_pa, 5) + " MPa at " +
                               place(report.max_von_mises_at));
  lines.add("compliance", pretty(report.compliance_j, 6) + " J");
  const auto force = [](vec3 f) {
    return pretty(f.x, 6) + ", " + pretty(f.y, 6) + ", " + pretty(f.z, 6) + " N";
  };
  lines.add("reaction", force(report.reaction_n));
  lines.add("applied", force(report.applied_n));
  return lines.text();
}

}  // namespace tedit::cli
