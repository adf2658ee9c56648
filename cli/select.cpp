// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>
#include <numbers>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/number_option.hpp"
#include "cli/part_input.hpp"
#include "mesh/features/select.hpp"

namespace tedit::cli {

namespace {

struct select_options {
  part_input part;
  std::vector<surface_id> hole;
  std::vector<surface_id> protrusion;
  std::vector<double> holes_mm;
  std::vector<surface_id> smooth;
  std::vector<surface_id> neighbours;
  double angle_degrees = 20;
};

/// The one question that was asked. Errors: `usage`.
expected<selection_query> query_of(const select_options& options) {
  selection_query query;
  query.angle = options.angle_degrees * std::numbers::pi / 180;
  int asked = 0;
  const auto ask = [&](feature_kind kind, const std::vector<surface_id>& surfaces) {
    if (surfaces.empty())
      return;
    ++asked;
    query.kind = kind;
    query.surfaces = surfaces;
  };
  ask(feature_kind::hole, options.hole);
  ask(feature_kind::protrusion, options.protrusion);
  ask(feature_kind::smooth, options.smooth);
  ask(feature_kind::neighbours, options.neighbours);
  if (!options.holes_mm.empty()) {
    ++asked;
    query.kind = feature_kind::holes;
    query.min_diameter = 1e-3 * options.holes_mm.front();
    query.max_diameter = 1e-3 * options.holes_mm.back();
  }
  if (asked != 1)
    return fail(ec::usage, "ask for one thing at a time",
                "Give one of --hole, --protrusion, --holes, --smooth, --neighbours");
  return query;
}

nlohmann::ordered_json to_json(const found_feature& found) {
  nlohmann::ordered_json json;
  json["kind"] = kind_name(found.kind);
  json["surfaces"] = found.surfaces;
  if (found.diameter > 0) {
    json["diameter_mm"] = 1e3 * found.diameter;
    json["centre_mm"] = {1e3 * found.centre.x, 1e3 * found.centre.y, 1e3 * found.centre.z};
    json["axis"] = {found.axis.x, found.axis.y, found.axis.z};
  }
  return json;
}

std::string describe(const found_feature& found) {
  std::string text = found.kind == feature_kind::smooth
                       ? std::to_string(found.surfaces.size()) + " surfaces"
                       : std::string(kind_name(found.kind));
  if (found.diameter > 0)
    text += ", diameter " + pretty(1e3 * found.diameter) + " mm at (" +
            pretty(1e3 * found.centre.x) + ", " + pretty(1e3 * found.centre.y) + ", " +
            pretty(1e3 * found.centre.z) + ") mm";
  return text + ": --surfaces " + list_of(found.surfaces, ",") + "\n";
}

int run_select(const select_options& options, session& s) {
  const auto query = query_of(options);
  if (!query)
    return print_error(s, query.error());
  const auto part = read_input(options.part, s);
  if (!part)
    return print_error(s, part.error());
  const auto features = select_surfaces(*part->mesh.version, *query, make_execution(s));
  if (!features)
    return print_error(s, features.error());
  nlohmann::ordered_json json;
  json["features"] = nlohmann::ordered_json::array();
  std::string text;
  for (const auto& found : *features) {
    json["features"].push_back(to_json(found));
    text += describe(found);
  }
  if (features->empty())
    text = "nothing was found\n";
  print_result(s, json, text);
  return 0;
}

}  // namespace

void add_select(CLI::App& app, action& chosen) {
  auto options = std::make_shared<select_options>();
  auto* command = app.add_subcommand("select", "Find surfaces that belong together");
  add_part_options(*command, options->part);
  command->add_option("--hole", options->hole, "The whole hole that this wall surface belongs to")
    ->expected(1);
  command
    ->add_option("--protrusion", options->protrusion,
                 "The boss, rib or fin that these surfaces belong to")
    ->delimiter(',');
  command
    ->add_option("--holes", options->holes_mm,
                 "All round holes with a diameter from MIN to MAX mm, as MIN,MAX")
    ->delimiter(',')
    ->expected(2)
    ->check(number_in({0, largest_number, "mm"}));
  command
    ->add_option("--smooth", options->smooth,
                 "All surfaces that hang together with these over edges of a small angle")
    ->delimiter(',');
  command
    ->add_option("--neighbours", options->neighbours,
                 "These surfaces and those next to them over edges of a small angle")
    ->delimiter(',');
  command
    ->add_option("--angle", options->angle_degrees,
                 "What counts as small for --smooth and --neighbours, degrees")
    ->check(number_in({0, 180, "degrees"}))
    ->capture_default_str();
  command->footer(
    "example:\n"
    "  tedit select part.msh --hole 12\n"
    "  tedit select part.msh --holes 3,8 --json");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_select(*options, s); }; });
}

}  // namespace tedit::cli
