// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/compare_report.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace tedit::cli {

namespace {

using nlohmann::ordered_json;

ordered_json json_of(const vec3& v) {
  return {v.x, v.y, v.z};
}

ordered_json json_of(const compared_size& size) {
  return {{"vertices", size.vertices}, {"tets", size.tets}, {"volume_m3", size.volume_m3}};
}

ordered_json json_of(const value_change& here) {
  return {{"change_pa", here.change()},
          {"before_pa", here.before},
          {"after_pa", here.after},
          {"at_m", json_of(here.at_m)}};
}

void add(ordered_json& to, const char* key, const std::optional<double>& value) {
  if (value)
    to[key] = *value;
}

ordered_json json_of(const compared_surface& one) {
  ordered_json row{{"surface", one.id},
                   {"name", one.name},
                   {"where", presence_name(one.where)},
                   {"changed", one.changed}};
  if (one.kin)
    row["kin"] = *one.kin;
  if (one.where != presence::only_after)
    row["area_before_m2"] = one.area_before_m2;
  if (one.where != presence::only_before)
    row["area_after_m2"] = one.area_after_m2;
  return row;
}

ordered_json json_of(const compared_load_case& one) {
  ordered_json row{
    {"name", one.name}, {"where", presence_name(one.where)}, {"differences", one.differences}};
  add(row, "mass_before_kg", one.mass_before_kg);
  add(row, "mass_after_kg", one.mass_after_kg);
  return row;
}

ordered_json json_of(const field_comparison& one) {
  ordered_json row{
    {"load_case", one.load_case},
    {"vertices",
     {{"same", one.same}, {"interpolated", one.interpolated}, {"outside", one.outside}}},
    {"max_von_mises_before_pa", one.max_von_mises_before_pa},
    {"max_von_mises_after_pa", one.max_von_mises_after_pa}};
  if (one.same + one.interpolated > 0) {
    row["von_mises_rise"] = json_of(one.rise);
    row["von_mises_fall"] = json_of(one.fall);
  }
  if (one.preview)
    row["preview"] = true;
  add(row, "min_safety_factor_before", one.min_safety_before);
  add(row, "min_safety_factor_after", one.min_safety_after);
  return row;
}

/// "(+1.2 %)"; empty where it says nothing, as of a change in digits that are not shown.
std::string per_cent(double before, double after) {
  constexpr double least = 1e-4;
  const double by = before > 0 ? 100 * (after / before - 1) : 0;
  if (std::abs(by) < least)
    return {};
  return std::string(" (") + (by > 0 ? "+" : "") + pretty(by, 3) + " %)";
}

std::string row(std::string name, const std::string& value) {
  name.resize(18, ' ');
  return "  " + name + value + "\n";
}

std::string from_to(double before, double after, double scale, const std::string& unit) {
  return pretty(scale * before, 6) + " -> " + pretty(scale * after, 6) + " " + unit +
         per_cent(before, after);
}

std::string coordinates(const vec3& at) {
  return pretty(1e3 * at.x) + ", " + pretty(1e3 * at.y) + ", " + pretty(1e3 * at.z) + " mm";
}

std::string surface_table(const version_comparison& all) {
  std::vector<std::vector<std::string>> rows{{"surface", "before mm2", "after mm2", "", "name"}};
  for (const auto& one : all.surfaces) {
    if (!one.changed && one.where == presence::both)
      continue;
    const bool was = one.where != presence::only_after;
    const bool is = one.where != presence::only_before;
    std::string what = was && is ? "changed" : is ? "new" : "gone";
    if (one.kin)
      what += (is ? ", from " : ", now ") + std::to_string(*one.kin);
    rows.push_back({std::to_string(one.id), was ? pretty(1e6 * one.area_before_m2, 6) : "",
                    is ? pretty(1e6 * one.area_after_m2, 6) : "", what, one.name});
  }
  return rows.size() > 1 ? format_table(rows, {3, 4}) : std::string();
}

std::string case_text(const compared_load_case& one) {
  std::string text;
  if (one.mass_before_kg && one.mass_after_kg)
    text +=
      row("mass", from_to(*one.mass_before_kg, *one.mass_after_kg, 1, "kg") + ", " + one.name);
  if (one.where != presence::both)
    text += row("load case", "\"" + one.name + "\" is only " +
                               (one.where == presence::only_after ? "after" : "before"));
  for (const auto& line : one.differences)
    text += row("load case", "\"" + one.name + "\" " + line);
  return text;
}

std::string field_text(const field_comparison& one) {
  const auto change = [](const value_change& here) {
    return (here.change() > 0 ? "+" : "") + pretty(1e-6 * here.change()) + " MPa (" +
           pretty(1e-6 * here.before) + " -> " + pretty(1e-6 * here.after) + ") at " +
           coordinates(here.at_m);
  };
  auto text =
    "stress" + (one.load_case.empty() ? "" : ", " + one.load_case) + "\n" +
    row("largest", from_to(one.max_von_mises_before_pa, one.max_von_mises_after_pa, 1e-6, "MPa"));
  if (one.min_safety_before && one.min_safety_after)
    text += row("safety factor", from_to(*one.min_safety_before, *one.min_safety_after, 1, ""));
  if (one.same + one.interpolated > 0)
    text += row("largest rise", change(one.rise)) + row("largest fall", change(one.fall));
  return text + row("vertices", std::to_string(one.same) + " the same, " +
                                  std::to_string(one.interpolated) + " interpolated, " +
                                  std::to_string(one.outside) + " outside");
}

}  // namespace

ordered_json to_json(const version_comparison& all) {
  ordered_json result{{"before_id", all.before_id},
                      {"after_id", all.after_id},
                      {"before", json_of(all.before)},
                      {"after", json_of(all.after)},
                      {"tets_in_common", all.tets_in_common},
                      {"vertices_in_common", all.vertices_in_common},
                      {"deviation_m", all.deviation.distance_m}};
  if (all.deviation.distance_m > 0) {
    result["deviation_at_m"] = json_of(all.deviation.at_m);
    result["deviation_of"] = presence_name(all.deviation.of);
  }
  const auto add_list = [&](const char* key, const auto& list) {
    result[key] = ordered_json::array();
    for (const auto& one : list)
      result[key].push_back(json_of(one));
  };
  add_list("surfaces", all.surfaces);
  add_list("load_cases", all.load_cases);
  add_list("fields", all.fields);
  for (const auto& one : all.not_compared)
    result["not_compared"].push_back(
      {{"load_case", one.load_case}, {"reason", one.reason}, {"remedy", one.remedy}});
  return result;
}

std::string describe_comparison(const version_comparison& all) {
  const auto unchanged = std::ranges::count_if(
    all.surfaces, [](const auto& one) { return one.where == presence::both && !one.changed; });
  auto text =
    row("volume", from_to(all.before.volume_m3, all.after.volume_m3, 1e9, "mm3")) +
    row("tets", std::to_string(all.before.tets) + " -> " + std::to_string(all.after.tets) + ", " +
                  std::to_string(all.tets_in_common) + " in common") +
    row("vertices", std::to_string(all.before.vertices) + " -> " +
                      std::to_string(all.after.vertices) + ", " +
                      std::to_string(all.vertices_in_common) + " in common") +
    row("boundary", all.deviation.distance_m > 0
                      ? "apart by up to " + pretty(1e3 * all.deviation.distance_m) + " mm, at " +
                          coordinates(all.deviation.at_m)
                      : "the same");
  for (const auto& one : all.load_cases)
    text += case_text(one);
  text += row("surfaces", std::to_string(unchanged) + " the same, " +
                            std::to_string(all.surfaces.size() - unchanged) + " not") +
          surface_table(all);
  for (const auto& one : all.fields)
    text += field_text(one);
  for (const auto& one : all.not_compared)
    text += "stress, " + one.load_case + "\n" + row("not compared", one.reason);
  return text;
}

}  // namespace tedit::cli
