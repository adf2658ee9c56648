// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/reports.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "fem/solver.hpp"

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

/// The surfaces that the operation took instead of those that were given; empty when it took these.
std::string completed_selection(const edit_report& report) {
  const std::set given(report.surfaces.begin(), report.surfaces.end());
  const std::set used(report.surfaces_used.begin(), report.surfaces_used.end());
  std::string text;
  for (const auto id : used)
    text += (text.empty() ? "" : ", ") + std::to_string(id);
  return used == given ? "" : text;
}

nlohmann::ordered_json triple(vec3 v) {
  return {v.x, v.y, v.z};
}

double largest_component(vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A place in mm, in brackets. A coordinate beyond the digits of the largest is shown as 0.
std::string place(vec3 p) {
  return "(" + components(1e3 * p, 4, 1e3 * largest_component(p), 5e-5) + ") mm";
}

std::string force(vec3 f, double scale) {
  return components(f, 6, scale) + " N";
}

/// Lines of "label  value", aligned.
class labelled_lines {
public:
  void add(const std::string& label, const std::string& value) {
    constexpr std::size_t width = 18;
    const std::size_t gap = label.size() < width ? width - label.size() : 1;
    text_ += "  " + label + std::string(gap, ' ') + value + "\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

private:
  std::string text_;
};

/// "72", or "72 bore" for a surface with a name of its own.
std::string title_of(const named_reaction& r) {
  const auto id = std::to_string(r.surface);
  return r.name.empty() || r.name == id ? id : id + " " + r.name;
}

/// The reactions of all surfaces as a table, rows indented as the lines above it.
std::string reaction_table(const std::vector<named_reaction>& reactions, double scale) {
  std::vector<std::vector<std::string>> rows{{"reaction of surface", "x N", "y N", "z N"}};
  for (const auto& r : reactions)
    rows.push_back({title_of(r), without_noise(r.force_n.x, scale, 5),
                    without_noise(r.force_n.y, scale, 5), without_noise(r.force_n.z, scale, 5)});
  return format_table(rows);
}

/// The largest of all forces: what their noise is measured against.
double force_scale(const solve_report& report) {
  double scale =
    std::max(largest_component(report.reaction_n), largest_component(report.applied_n));
  for (const auto& r : report.surface_reactions)
    scale = std::max(scale, largest_component(r.force_n));
  return scale;
}

/// Of order 1 the largest stress is an element's, but the safety factor comes from nodal means: it
/// says so, for the two do not fit together.
std::string safety_text(const solve_report& report) {
  if (*report.min_safety_factor >= fem::solution::most_safety)
    return "over " + pretty(fem::solution::most_safety);
  return pretty(*report.min_safety_factor, 3) + " at " + place(report.min_safety_factor_at) +
         (report.element_order == 1 ? " (nodal means)" : "");
}

void add_judgement(const solve_report& report, labelled_lines& lines) {
  if (report.min_safety_factor)
    lines.add("safety factor", safety_text(report));
  lines.add("error estimate", pretty(100 * report.relative_error_estimate, 2) + " % (energy norm)");
  if (report.singular_places_count > 0)
    lines.add("singular places", std::to_string(report.singular_places_count) +
                                   (report.singular_places_count == 1 ? " node" : " nodes") +
                                   " at clamps' rims or re-entrant edges");
}

void add_sums(const solve_report& report, double scale, labelled_lines& lines) {
  lines.add("compliance", pretty(report.compliance_j, 6) + " J");
  lines.add("strain energy", pretty(report.strain_energy_j, 6) + " J");
  if (report.mass_kg)
    lines.add("mass", pretty(*report.mass_kg) + " kg");
  lines.add("reaction", force(report.reaction_n, scale));
  lines.add("applied", force(report.applied_n, scale));
}

/// How it was computed, where that is not as asked for.
std::string notice_line(const solve_report& report) {
  return report.notice.empty() ? "" : "  NOTE: " + report.notice + "\n";
}

/// What its load case warns of, and a line when the largest stress sits at a singular place and
/// says nothing about strength.
std::string warning_lines(const solve_report& report) {
  std::string text;
  for (const auto& warning : report.warnings)
    text += "  WARNING: " + warning + "\n";
  if (!report.max_von_mises_singularity)
    return text;
  const bool rim = *report.max_von_mises_singularity == fem::singularity::clamp_rim;
  const bool safety = report.min_safety_factor &&
                      std::ranges::find(report.singular_places, report.min_safety_factor_at,
                                        &stress_peak::at) != report.singular_places.end();
  return text + "  WARNING: the largest stress is at a " +
         (rim ? "clamp's rim" : "re-entrant edge") +
         ", where it grows with every refinement: do not read it" +
         (safety ? ", nor the safety factor there," : "") + " as strength\n";
}

nlohmann::ordered_json reactions_json(const solve_report& report) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& r : report.surface_reactions)
    rows.push_back({{"surface", r.surface}, {"name", r.name}, {"force_n", triple(r.force_n)}});
  return rows;
}

nlohmann::ordered_json singular_json(const solve_report& report) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& peak : report.singular_places)
    rows.push_back({{"kind", singularity_name(peak.kind)},
                    {"at_m", triple(peak.at)},
                    {"von_mises_pa", peak.von_mises_pa}});
  return rows;
}

void add_judgement(const solve_report& report, nlohmann::ordered_json& json) {
  json["strain_energy_j"] = report.strain_energy_j;
  if (report.mass_kg)
    json["mass_kg"] = *report.mass_kg;
  json["relative_error_estimate"] = report.relative_error_estimate;
  if (report.min_safety_factor) {
    json["min_safety_factor"] = *report.min_safety_factor;
    json["min_safety_factor_at_m"] = triple(report.min_safety_factor_at);
  }
  json["surface_reactions"] = reactions_json(report);
  json["singular_places"] = singular_json(report);
  json["singular_places_count"] = report.singular_places_count;
  if (report.max_von_mises_singularity)
    json["max_von_mises_singularity"] = singularity_name(*report.max_von_mises_singularity);
  if (!report.notice.empty())
    json["notice"] = report.notice;
  if (!report.warnings.empty())
    json["warnings"] = report.warnings;
}

/// One row for each case; safety factors where they are known.
std::string case_table(const std::vector<solve_report>& cases) {
  std::vector<std::vector<std::string>> rows{{"load case", "iterations", "max displacement mm",
                                              "max von Mises MPa", "safety factor", "error %"}};
  for (const auto& report : cases)
    rows.push_back({report.load_case, std::to_string(report.iterations),
                    pretty(1e3 * report.max_displacement_m, 6),
                    pretty(1e-6 * report.max_von_mises_pa, 5),
                    report.min_safety_factor ? pretty(*report.min_safety_factor, 3) : "-",
                    pretty(100 * report.relative_error_estimate, 2)});
  return format_table(rows);
}

/// " at PLACE in CASE".
std::string origin(const worst_value& worst) {
  return " at " + place(worst.at) + " in " + worst.load_case;
}

/// What is worst over all load cases, and the warnings about each.
std::string worst_lines(const solve_outcome& outcome) {
  const auto& worst = *outcome.envelope;
  const bool linear = worst.element_order == 1;
  labelled_lines lines;
  lines.add("max displacement",
            pretty(1e3 * worst.max_displacement.value, 6) + " mm" + origin(worst.max_displacement));
  lines.add("max von Mises", pretty(1e-6 * worst.max_von_mises.value, 5) + " MPa" +
                               origin(worst.max_von_mises) + (linear ? " (element)" : " (node)"));
  if (worst.min_safety_factor)
    lines.add("safety factor", pretty(worst.min_safety_factor->value, 3) +
                                 origin(*worst.min_safety_factor) +
                                 (linear ? " (nodal means)" : ""));
  std::string text = "  worst of all load cases:\n" + lines.text();
  for (const auto& report : outcome.cases)
    if (const auto warning = warning_lines(report); !warning.empty())
      text += "  " + report.load_case + ":\n" + warning;
  return text + notice_line(outcome.cases.front());
}

bool is_count(const ops::figure& f) {
  return f.unit.empty() && f.value == std::floor(f.value) && std::abs(f.value) < 1e15;
}

}  // namespace

std::string without_noise(double value, double scale, int digits, double noise) {
  return std::abs(value) <= noise * scale ? "0" : pretty(value, digits);
}

std::string components(vec3 v, int digits, double scale, double noise) {
  return without_noise(v.x, scale, digits, noise) + ", " +
         without_noise(v.y, scale, digits, noise) + ", " + without_noise(v.z, scale, digits, noise);
}

namespace {

nlohmann::ordered_json to_json(const quality_figures& q) {
  return {{"tets", q.tets},
          {"dihedral_counts_10_deg", q.dihedral},
          {"radius_ratio_counts_0.1", q.ratio},
          {"min_radius_ratio", q.min_ratio},
          {"radius_ratio_1pct", q.ratio_1pct},
          {"mean_radius_ratio", q.mean_ratio},
          {"min_dihedral_deg", q.min_dihedral_deg},
          {"max_dihedral_deg", q.max_dihedral_deg},
          {"dihedral_1pct_deg", q.dihedral_1pct_deg}};
}

nlohmann::ordered_json to_json(const improve_report& report) {
  const auto& m = report.moves;
  return {{"before", to_json(report.before.value_or(quality_figures{}))},
          {"after", to_json(report.after.value_or(quality_figures{}))},
          {"surface_deviation_m", report.surface_deviation},
          {"moves",
           {{"flips", m.flips},
            {"relocations", m.relocations},
            {"collapses", m.collapses},
            {"insertions", m.insertions},
            {"harmonic_flips", m.harmonic_flips},
            {"harmonic_relocations", m.harmonic_relocations},
            {"boundary_flips", m.boundary_flips},
            {"boundary_relocations", m.boundary_relocations},
            {"boundary_collapses", m.boundary_collapses}}}};
}

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
  for (const auto& line : report.receipt) {
    receipt.push_back({{"load_case", line.load_case},
                       {"item", line.item},
                       {"fate", fem::fate_name(line.fate)},
                       {"surfaces_lost", line.surfaces_lost},
                       {"area_before_m2", line.area_before},
                       {"area_after_m2", line.area_after},
                       {"moved_to", line.moved_to},
                       {"total_before_n", line.total_before},
                       {"total_after_n", line.total_after},
                       {"text", line.text}});
    if (!line.warning.empty())
      receipt.back()["warning"] = line.warning;
  }
  json result{{"from_version", report.from_version},
              {"to_version", report.to_version},
              {"surfaces_used", report.surfaces_used},
              {"surfaces_removed", removed},
              {"surfaces_added", added},
              {"surfaces_changed", changed},
              {"surface_map", map},
              {"tets_added", report.tets_added},
              {"tets_removed", report.tets_removed},
              {"volume_change_m3", report.volume_change},
              {"loads", fem::policy_name(report.loads.policy)},
              {"keep_traction", report.loads.keep_traction},
              {"receipt", receipt},
              {"notices", report.notices},
              {"timings_ms",
               {{"operation", report.operation_ms},
                {"improve", report.improve_ms},
                {"check", report.check_ms},
                {"total", report.total_ms}}}};
  if (report.ratios)
    result["radius_ratio_touched"] = {{"before_min", report.ratios->min_before},
                                      {"after_min", report.ratios->min_after},
                                      {"after_median", report.ratios->median_after}};
  for (const auto& f : report.figures)
    if (!result.contains(f.id))
      result[f.id] = is_count(f) ? json(std::llround(f.value)) : json(f.value);
  if (report.optimisation)
    result["optimisation"] = to_json(*report.optimisation);
  return result;
}

std::string describe(const edit_report& report) {
  labelled_lines lines;
  using enum surface_fate;
  if (const auto used = completed_selection(report); !used.empty())
    lines.add("surfaces used", used);
  lines.add("surfaces removed", list_ids(report.surface_map, {removed, merged_into}));
  lines.add("surfaces added", list_ids(report.surface_map, {added, split_from}));
  lines.add("surfaces changed", list_ids(report.surface_map, {changed}));
  lines.add("tets",
            "+" + std::to_string(report.tets_added) + " -" + std::to_string(report.tets_removed));
  lines.add("volume",
            (report.volume_change > 0 ? "+" : "") + pretty(1e9 * report.volume_change, 6) + " mm3");
  if (const auto& ratios = report.ratios)
    lines.add("radius ratio", "worst touched " + pretty(ratios->min_after, 3) + " (before " +
                                pretty(ratios->min_before, 3) + "), median " +
                                pretty(ratios->median_after, 3));
  for (const auto& f : report.figures)
    lines.add(f.help, pretty(f.value, 6) + (f.unit.empty() ? "" : " " + f.unit));
  if (report.optimisation && report.optimisation->before && report.optimisation->after) {
    const auto& before = *report.optimisation->before;
    const auto& after = *report.optimisation->after;
    lines.add("dihedral angles", pretty(after.min_dihedral_deg, 3) + " to " +
                                   pretty(after.max_dihedral_deg, 4) + " deg (before " +
                                   pretty(before.min_dihedral_deg, 3) + " to " +
                                   pretty(before.max_dihedral_deg, 4) + ")");
    lines.add("surface", "at most " + pretty(1e3 * report.optimisation->surface_deviation, 3) +
                           " mm from where it was");
  }
  lines.add("time", pretty(report.total_ms, 3) + " ms (operation " +
                      pretty(report.operation_ms, 3) + ", improve " + pretty(report.improve_ms, 3) +
                      ", check " + pretty(report.check_ms, 3) + ")");
  const bool several = std::ranges::any_of(report.receipt, [&](const auto& row) {
    return row.load_case != report.receipt.front().load_case;
  });
  for (const auto& row : report.receipt)
    lines.add("load case", several ? row.load_case + ": " + row.text : row.text);
  for (const auto& row : report.receipt)
    if (!row.warning.empty())
      lines.add("WARNING", several ? row.load_case + ": " + row.warning : row.warning);
  for (const auto& notice : report.notices)
    lines.add("note", notice);
  return lines.text();
}

nlohmann::ordered_json to_json(const solve_report& report) {
  nlohmann::ordered_json json{{"version_id", report.version_id},
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
                              {"applied_n", triple(report.applied_n)}};
  add_judgement(report, json);
  json["timings_ms"] = {{"assembly", report.assembly_ms},
                        {"setup", report.setup_ms},
                        {"solve", report.solve_ms},
                        {"recovery", report.recovery_ms},
                        {"total", report.total_ms}};
  return json;
}

std::string summarize(const solve_report& report) {
  labelled_lines lines;
  add_judgement(report, lines);
  if (report.mass_kg)
    lines.add("mass", pretty(*report.mass_kg) + " kg");
  return lines.text() + notice_line(report) + warning_lines(report);
}

std::string describe(const solve_report& report) {
  labelled_lines lines;
  const bool linear = report.element_order == 1;
  const double scale = force_scale(report);
  lines.add("device", report.device);
  lines.add("unknowns",
            std::to_string(report.dofs) + (linear ? " (linear tets)" : " (quadratic tets)"));
  lines.add("iterations", std::to_string(report.iterations));
  lines.add("residual", pretty(report.true_relative_residual, 2) + " (true, relative)");
  lines.add("max displacement", pretty(1e3 * report.max_displacement_m, 6) + " mm at " +
                                  place(report.max_displacement_at));
  lines.add("max von Mises", pretty(1e-6 * report.max_von_mises_pa, 5) + " MPa at " +
                               place(report.max_von_mises_at) +
                               (linear ? " (element)" : " (node)"));
  add_judgement(report, lines);
  add_sums(report, scale, lines);
  return lines.text();
}

nlohmann::ordered_json to_json(const solve_outcome& outcome) {
  if (!outcome.envelope)
    return to_json(outcome.cases.front());
  nlohmann::ordered_json json;
  json["cases"] = nlohmann::ordered_json::array();
  for (const auto& report : outcome.cases) {
    auto one = to_json(report);
    one.erase("timings_ms");
    json["cases"].push_back(std::move(one));
  }
  auto& envelope = json["envelope"];
  const auto add = [&](const std::string& name, const std::string& unit, const worst_value& worst) {
    envelope[name + unit] = worst.value;
    envelope[name + "_at_m"] = triple(worst.at);
    envelope[name + "_case"] = worst.load_case;
  };
  add("max_displacement", "_m", outcome.envelope->max_displacement);
  add("max_von_mises", "_pa", outcome.envelope->max_von_mises);
  if (outcome.envelope->min_safety_factor)
    add("min_safety_factor", "", *outcome.envelope->min_safety_factor);
  return json;
}

std::string describe(const solve_outcome& outcome) {
  const auto& first = outcome.cases.front();
  if (!outcome.envelope)
    return describe(first);
  labelled_lines head;
  head.add("device", first.device);
  head.add("unknowns", std::to_string(first.dofs) +
                         (first.element_order == 1 ? " (linear tets)" : " (quadratic tets)"));
  return head.text() + summarize(outcome);
}

std::string summarize(const solve_outcome& outcome) {
  if (!outcome.envelope)
    return summarize(outcome.cases.front());
  return case_table(outcome.cases) + worst_lines(outcome);
}

std::string preview_text(const solve_outcome& outcome) {
  const auto& first = outcome.cases.front();
  if (first.element_order < 2)
    return "  PREVIEW: linear tets are too stiff in bending; displacements of thin parts can be\n"
           "  several times too small.\n";
  if (outcome.envelope ? outcome.envelope->preview : first.preview)
    return "  PREVIEW: stopped at the energy tolerance, before the residual's.\n";
  return {};
}

std::string remarks(const solve_report& report) {
  std::string text;
  if (report.surface_reactions.size() > 1)
    text += reaction_table(report.surface_reactions, force_scale(report));
  return text + notice_line(report) + warning_lines(report);
}

}  // namespace tedit::cli
