// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/colours.hpp"

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "base/colour_map.hpp"
#include "cli/command.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/vtu_field.hpp"

namespace tedit::cli {

namespace {

constexpr std::size_t palette_steps = 256;

byte_colour in_bytes(const std::array<double, 3>& colour) {
  byte_colour result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround(255 * colour[k]));
  return result;
}

/// Hues that follow one another by the golden section stay apart, however many there are.
byte_colour colour_of(std::size_t place) {
  constexpr double lightest = 0.90;
  constexpr double least_tint = 0.45;
  const double turn = static_cast<double>(place) / std::numbers::phi;
  std::array<double, 3> rgb{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = 2 * std::numbers::pi * (turn - static_cast<double>(k) / 3);
    rgb[k] = lightest * (1 - least_tint * (1 - std::cos(angle)) / 2);
  }
  return in_bytes(rgb);
}

part_looks by_surfaces(const mesh_version& mesh) {
  part_looks looks;
  looks.by = "surface";
  for (const auto& row : mesh.surfaces())
    looks.colours.of_surfaces.emplace(row.id, colour_of(looks.colours.of_surfaces.size()));
  return looks;
}

/// The values of a file's points by vertex slot. Errors: `bad_input` where points belong to no tet.
expected<std::vector<double>> by_slots(const mesh_version& mesh, const point_field& field) {
  const std::size_t count = mesh.vertex_count();
  const auto& order = mesh.data().vertex_order;
  if (field.values.size() != count || mesh.vertex_slots() != count)
    return fail(ec::bad_input,
                "the file has " + std::to_string(field.values.size()) + " points, its tets " +
                  std::to_string(count),
                "Take the file that \"tedit solve -o\" writes");
  std::vector<double> result(count);
  for (vertex_id v = 0; v < count; ++v)
    result[v] = field.values[order.size() == count ? order[v] : v];
  return result;
}

/// From the least to the largest of the boundary.
void take_range(const mesh_version& mesh, const std::vector<double>& values, part_looks& looks) {
  looks.least = 1e300;
  looks.most = -1e300;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      for (const auto v : mesh.facet(f).v)
        if (std::isfinite(values[v])) {
          looks.least = std::min(looks.least, values[v]);
          looks.most = std::max(looks.most, values[v]);
        }
  if (looks.least > looks.most)
    looks.least = looks.most = 0;
}

expected<part_looks> by_field(const mesh_version& mesh, const point_field& field) {
  const auto values = by_slots(mesh, field);
  if (!values)
    return fail(values.error());
  part_looks looks;
  looks.of_field = true;
  looks.by = field.name;
  take_range(mesh, *values, looks);
  const bool is_difference = field.name.find("_difference") != std::string::npos;
  if (is_difference) {
    looks.most = std::max(std::abs(looks.least), std::abs(looks.most));
    looks.least = -looks.most;
  }
  constexpr double last = palette_steps - 1;
  for (std::size_t i = 0; i < palette_steps; ++i)
    looks.colours.palette.push_back(
      in_bytes(colour_at(is_difference ? cool_to_warm : viridis, static_cast<double>(i) / last)));
  const double width = looks.most - looks.least;
  for (const double value : *values) {
    const double share = width > 0 ? std::clamp((value - looks.least) / width, 0.0, 1.0) : 0;
    looks.colours.of_vertices.push_back(
      static_cast<std::uint8_t>(std::isfinite(value) ? std::lround(last * share) : 0));
  }
  return looks;
}

}  // namespace

expected<part_looks> make_looks(const mesh_version& mesh, const std::filesystem::path& file,
                                const std::string& by) {
  if (by == "surface")
    return by_surfaces(mesh);
  const auto bytes = read_file(file);
  if (!bytes)
    return fail(bytes.error());
  const auto field = read_point_field(*bytes, by);
  if (!field) {
    auto failure = field.error();
    failure.where = file.string();
    return fail(std::move(failure));
  }
  return by_field(mesh, *field);
}

nlohmann::ordered_json to_json(const part_looks& looks) {
  nlohmann::ordered_json json{{"by", looks.by}};
  if (looks.of_field) {
    json["least"] = looks.least;
    json["most"] = looks.most;
  }
  return json;
}

std::string describe(const part_looks& looks) {
  if (looks.by.empty())
    return {};
  auto text = ", coloured by " + looks.by;
  if (looks.of_field)
    text += " from " + pretty(looks.least) + " to " + pretty(looks.most);
  return text;
}

}  // namespace tedit::cli
