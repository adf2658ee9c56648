// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/virtual_display.hpp"
#include "cli/number_option.hpp"
#include "cli/render/scene.hpp"

namespace {

/// As the other commands of "tedit" report a failure.
int report(const tedit::error& e, bool json) {
  if (json) {
    const nlohmann::ordered_json body{{"error",
                                       {{"code", tedit::code_name(e.code)},
                                        {"message", e.message},
                                        {"remedy", e.remedy},
                                        {"where", e.where}}}};
    std::cout << body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  }
  std::cerr << "tedit render: " << tedit::render(e) << '\n';
  return tedit::exit_status(e.code);
}

}  // namespace

int main(int argc, char** argv) try {
  tedit::picture::picture_options options;
  std::vector<double> range;
  std::vector<int> size;
  std::vector<double> focus;
  bool json = false;
  CLI::App app{"Draw the boundary of a VTU file coloured by a field, as PNG."};
  app.name("tedit render");
  app.add_option("input", options.input, "VTU file, for example from \"tedit solve -o\"")
    ->required();
  app.add_option("-o,--output", options.output, "PNG file")->required();
  app.add_option("--field", options.field, "Point field; vectors show their length")
    ->capture_default_str();
  app.add_option("--unit", options.unit, "Unit in the legend")->capture_default_str();
  const auto any = tedit::cli::number_in(tedit::any_number());
  app.add_option("--scale", options.scale, "Field value times this is in the unit")
    ->check(any)
    ->capture_default_str();
  app.add_option("--range", range, "Legend from MIN to MAX, in the unit")
    ->expected(2)
    ->delimiter(',')
    ->check(any);
  app.add_flag("--diverging", options.diverging,
               "Blue below zero, red above it, as far on both sides; always so for a difference");
  app.add_option("--title", options.title, "Heading");
  app.add_option("--caption", options.caption, "Small print");
  app.add_option("--size", size, "WIDTH HEIGHT in pixels")
    ->expected(2)
    ->delimiter('x')
    ->check(CLI::Range(64, 8192));
  app.add_option("--view", options.view, "iso, x, y, z, -x, -y or -z")
    ->check(CLI::IsMember({"iso", "x", "y", "z", "-x", "-y", "-z"}));
  app.add_option("--zoom", options.zoom, "Nearer by this factor")
    ->check(tedit::cli::number_in({1e-6, 1e6, {}}));
  app.add_option("--focus", focus, "X,Y,Z in metres: what lies in the middle")
    ->expected(3)
    ->delimiter(',')
    ->check(any);
  app.add_option("--deform", options.deform, "Draw the displacement times this factor")->check(any);
  app.add_flag("--edges", options.edges, "Draw the mesh edges");
  app.add_flag("--json", json, "Print one JSON object on stdout");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0)
      return app.exit(e);
    return report({tedit::ec::usage, e.what(), "\"tedit render --help\" lists the options", {}},
                  app.count("--json") > 0);
  }
  if (range.size() == 2 && !(range[0] < range[1]))
    return report({tedit::ec::usage,
                   "--range goes from the smaller number to the larger one",
                   "Write MIN,MAX",
                   {}},
                  json);
  if (range.size() == 2)
    options.range = {range[0], range[1]};
  if (focus.size() == 3)
    options.focus = {focus[0], focus[1], focus[2]};
  if (size.size() == 2) {
    options.width = size[0];
    options.height = size[1];
  }
  const auto screen = tedit::virtual_display::open();
  if (!screen)
    return report(screen.error(), json);
  if (const auto drawn = tedit::picture::draw_picture(options); !drawn)
    return report(drawn.error(), json);
  if (json)
    std::cout << nlohmann::ordered_json{{"output", options.output},
                                        {"width", options.width},
                                        {"height", options.height}}
              << '\n';
  return 0;
} catch (const std::exception& why) {
  return std::fprintf(stderr, "tedit-render: %s\n", why.what()), 1;
}
