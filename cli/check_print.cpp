// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/number_option.hpp"
#include "cli/part_input.hpp"
#include "cli/reports.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/print/print_checks.hpp"

namespace tedit::cli {

namespace {

struct check_print_options {
  part_input part;
  std::vector<double> direction{0, 0, 1};
  double thinner_than_mm = 0;
  double overhang_degrees = 45;
  std::string output;
  bool strict = false;
};

/// Longer lists of places are cut for people.
constexpr std::size_t most_places = 10;
constexpr std::size_t most_surfaces = 6;

nlohmann::ordered_json triple_of(vec3 v) {
  return {v.x, v.y, v.z};
}

nlohmann::ordered_json to_json(const std::vector<print_place>& places, const char* worst) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& place : places)
    json.push_back({{"surfaces", place.surfaces},
                    {"facets", place.facets},
                    {"area_m2", place.area},
                    {worst, place.worst},
                    {"at_m", triple_of(place.at)}});
  return json;
}

nlohmann::ordered_json to_json(const check_print_options& options, const print_report& report) {
  nlohmann::ordered_json json{{"volume_m3", report.volume},
                              {"area_m2", report.area},
                              {"low_m", triple_of(report.extent.low)},
                              {"high_m", triple_of(report.extent.high)},
                              {"bodies", report.bodies},
                              {"closed_voids", report.closed_voids},
                              {"watertight", report.watertight()},
                              {"open_edges", report.open_edges},
                              {"hinge_edges", report.hinge_edges},
                              {"crossing_facets", report.crossing_facets},
                              {"direction", options.direction},
                              {"overhang_rad", options.overhang_degrees * degree},
                              {"overhang_area_m2", report.overhang_area},
                              {"plate_area_m2", report.plate_area},
                              {"overhangs", to_json(report.overhangs, "lean_rad")}};
  if (options.thinner_than_mm > 0) {
    json["thinner_than_m"] = 1e-3 * options.thinner_than_mm;
    json["thin_area_m2"] = report.thin_area;
    json["thin"] = to_json(report.thin, "thickness_m");
  }
  json["findings"] = report.has_findings();
  return json;
}

std::string surfaces_text(const std::vector<surface_id>& surfaces) {
  std::string text;
  for (std::size_t i = 0; i < std::min(surfaces.size(), most_surfaces); ++i)
    text += (text.empty() ? "" : ", ") + std::to_string(surfaces[i]);
  return text +
         (surfaces.size() > most_surfaces ? ", ... (" + std::to_string(surfaces.size()) + ")" : "");
}

std::string place_table(const std::vector<print_place>& places, const std::string& heading,
                        double scale) {
  std::vector<std::vector<std::string>> rows{{heading, "area mm2", "at mm", "surfaces"}};
  for (std::size_t i = 0; i < std::min(places.size(), most_places); ++i) {
    const auto& place = places[i];
    const auto at =
      pretty(1e3 * place.at.x) + ", " + pretty(1e3 * place.at.y) + ", " + pretty(1e3 * place.at.z);
    rows.push_back({pretty(scale * place.worst, 3), pretty(1e6 * place.area), at,
                    surfaces_text(place.surfaces)});
  }
  auto text = format_table(rows, {2, 3});
  if (places.size() > most_places)
    text +=
      "  ... and " + std::to_string(places.size() - most_places) + " smaller: --json lists them\n";
  return text;
}

std::string shell_text(const print_report& report) {
  std::string text =
    report.watertight() ? "yes" : "no: " + std::to_string(report.open_edges) + " open edges";
  if (report.hinge_edges > 0)
    text += "; " + std::to_string(report.hinge_edges) + " edges where more than two facets meet";
  if (report.crossing_facets > 0)
    text += "; " + std::to_string(report.crossing_facets) + " facets meet others they should not";
  return text;
}

std::string describe(const check_print_options& options, const print_report& report) {
  std::string text = options.part.file + "\n";
  const auto line = [&](const std::string& label, const std::string& value) {
    text += "  " + label + std::string(18 - label.size(), ' ') + value + "\n";
  };
  const auto size = 1e3 * (report.extent.high - report.extent.low);
  line("watertight", shell_text(report));
  line("bodies",
       std::to_string(report.bodies) +
         (report.closed_voids > 0 ? ", with closed voids: " + std::to_string(report.closed_voids)
                                  : ""));
  line("volume", pretty(1e9 * report.volume, 6) + " mm3");
  line("area", pretty(1e6 * report.area, 6) + " mm2");
  line("size", pretty(size.x) + " x " + pretty(size.y) + " x " + pretty(size.z) + " mm");
  line("on the plate", pretty(1e6 * report.plate_area) + " mm2");
  if (options.thinner_than_mm > 0)
    line("thin walls", report.thin.empty()
                         ? "none under " + pretty(options.thinner_than_mm) + " mm"
                         : pretty(1e6 * report.thin_area) + " mm2 under " +
                             pretty(options.thinner_than_mm) + " mm, both sides counted");
  line("overhangs", report.overhangs.empty()
                      ? "none beyond " + pretty(options.overhang_degrees) + " degrees"
                      : pretty(1e6 * report.overhang_area) + " mm2 lean more than " +
                          pretty(options.overhang_degrees) + " degrees from the build direction");
  if (!report.thin.empty())
    text += "\n" + place_table(report.thin, "thickness mm", 1e3);
  if (!report.overhangs.empty())
    text += "\n" + place_table(report.overhangs, "lean degrees", 1 / degree);
  return text;
}

/// 1 at the corners of what is marked, 0 elsewhere.
field marks_at_vertices(const mesh_version& mesh, const char* name,
                        const std::function<bool(facet_id)>& is_marked) {
  std::vector<double> values(mesh.vertex_slots());
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f) && is_marked(f))
      for (const auto v : mesh.facet(f).v)
        values[v] = 1;
  return {name, field_location::vertex, 1, paged_array<double>::from(values)};
}

/// Facets in colours where the format has some, else fields of 0 and 1.
file_terms marked_terms(const file_format& format, const mesh_version& mesh,
                        const print_report& report) {
  file_terms terms;
  if (format.keeps.fields)
    terms.fields = {
      marks_at_vertices(mesh, "thin_wall",
                        [&](facet_id f) { return std::isfinite(report.thickness[f]); }),
      marks_at_vertices(mesh, "overhang", [&](facet_id f) { return report.overhanging[f]; })};
  if (!format.keeps.colours)
    return terms;
  for (const auto& [red, green, blue] : print_mark_colours)
    terms.colours.palette.push_back({red, green, blue});
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    terms.colours.of_facets.push_back(
      static_cast<std::uint8_t>(mesh.is_live_facet(f) ? mark_of(report, f) : print_mark::sound));
  return terms;
}

expected<const file_format*> marked_format(const std::string& file) {
  auto format = output_format(file);
  if (format && !(*format)->keeps.fields && !(*format)->keeps.colours)
    return fail(ec::usage, "a ." + std::string((*format)->name) + " file cannot show marks",
                "Write .vtu, or " + coloured_formats_text());
  return format;
}

int run_check_print(const check_print_options& options, session& s) {
  const auto format =
    options.output.empty() ? expected<const file_format*>(nullptr) : marked_format(options.output);
  if (!format)
    return print_error(s, format.error());
  const auto part = read_input(options.part, s);
  if (!part)
    return print_error(s, part.error());
  const stopwatch clock;
  const auto& mesh = *part->mesh.version;
  const auto& d = options.direction;
  const auto report = check_print(mesh,
                                  {.up = {d[0], d[1], d[2]},
                                   .thinner_than = 1e-3 * options.thinner_than_mm,
                                   .lean = options.overhang_degrees * degree},
                                  make_execution(s));
  if (!report)
    return print_error(s, report.error());
  auto json = to_json(options, *report);
  json["check_ms"] = clock.milliseconds();
  auto text = describe(options, *report);
  if (*format) {
    const auto terms = marked_terms(**format, mesh, *report);
    if (const auto ok = write_as((*format)->name, options.output, mesh, terms); !ok)
      return print_error(s, ok.error());
    json["file"] = options.output;
    text += options.output + ": the part with its marks\n";
  }
  print_result(s, json, text);
  return options.strict && report->has_findings() ? 1 : 0;
}

}  // namespace

void add_check_print(CLI::App& app, action& chosen) {
  auto options = std::make_shared<check_print_options>();
  auto* command = app.add_subcommand(
    "check-print", "Look for what hinders 3D printing: open edges, thin walls, overhangs");
  add_part_options(*command, options->part);
  command->add_option("--direction", options->direction, "Build direction, from the plate on")
    ->delimiter(',')
    ->expected(3)
    ->check(number_in({-1e6, 1e6, {}}))
    ->capture_default_str();
  command
    ->add_option("--thinner-than", options->thinner_than_mm,
                 "Mark walls that are thinner, mm; not given: they are not looked for")
    ->check(number_in({1e-6, 1e6, {}}));
  command
    ->add_option("--overhang", options->overhang_degrees,
                 "Mark what looks down and leans further from the build direction, degrees: 0 is "
                 "an upright wall, 90 a ceiling")
    ->check(number_in({0, 90, {}}))
    ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "Write the part with its marks: " + coloured_formats_text() +
                        " (thin red, overhanging orange, both violet) or .vtu (fields thin_wall "
                        "and overhang, 0 or 1)");
  command->add_flag("--strict", options->strict, "Exit status 1 where something was found");
  command->callback([options, &chosen] {
    chosen = [options](session& s) { return run_check_print(*options, s); };
  });
}

}  // namespace tedit::cli
