// SPDX-License-Identifier: AGPL-3.0-or-later
// erode_sweep PART_FOLDER MESH [OPERATION] [--layers | --all] [--verbose]: erodes (or thickens)
// every surface that PART_FOLDER/features.json lists under plates and largest_planes, one by one on
// the original mesh: by 20 % of the wall's thickness, or with --layers by one layer of tets. With
// --all every surface of the mesh instead. Prints a line for each refusal that an invariant caused
// and a summary; ends with status 1 when an invariant broke.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/local_edit.hpp"
#include "mesh/io/import.hpp"

namespace {

using namespace tedit;

struct tally {
  int tried = 0;
  int refused = 0;
  int faults = 0;
  int rolled_back = 0;
  int below_tenth = 0;  ///< Worst q after < min(.1, before).
  std::vector<double> ms;
  std::vector<double> worst_after;
  std::vector<double> thickness_error;  ///< Relative.
  double worst_volume_error = 0;
  std::map<std::string, int> reasons;
};

/// Distance along the ray to the triangle, or a large number.
double hit(vec3 from, vec3 along, vec3 a, vec3 b, vec3 c) {
  const vec3 e = b - a;
  const vec3 g = c - a;
  const vec3 p = cross(along, g);
  const double det = dot(e, p);
  if (std::abs(det) < 1e-30)
    return 1e300;
  const vec3 s = from - a;
  const double u = dot(s, p) / det;
  const vec3 q = cross(s, e);
  const double v = dot(along, q) / det;
  const double t = dot(g, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 1e-9 ? t : 1e300;
}

/// The thinnest place of the wall below a surface, from the middle of each of its facets.
double wall_thickness(const mesh_version& mesh, surface_id surface) {
  double thinnest = 1e300;
  for (const auto f : facets_of(mesh, std::vector{surface})) {
    const auto& v = mesh.facet(f).v;
    const vec3 from = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
    const vec3 along = -normalized(area_vector(mesh, mesh.facet(f)));
    for (facet_id g = 0; g < mesh.facet_slots(); ++g)
      if (g != f && mesh.is_live_facet(g)) {
        const auto& w = mesh.facet(g).v;
        thinnest = std::min(thinnest, hit(from, along, mesh.position(w[0]), mesh.position(w[1]),
                                          mesh.position(w[2])));
      }
  }
  return thinnest;
}

void try_surface(const ops::catalogue& plugins, const version_ptr& base, double base_volume,
                 const cli::edit_request& request, double depth, bool verbose, tally& sum) {
  ++sum.tried;
  const stopwatch clock;
  const auto before_id = base->id();
  const auto outcome = cli::apply_edit(plugins, base, request, {}, {});
  const double ms = clock.milliseconds();
  const auto name = "surface " + std::to_string(request.surfaces.front());
  if (base->id() != before_id)
    ++sum.faults;
  if (!outcome) {
    ++sum.refused;
    ++sum.reasons[std::string(code_name(outcome.error().code))];
    const bool rolled_back = outcome.error().code == ec::postcondition_failed;
    sum.rolled_back += rolled_back;
    if (rolled_back || verbose)
      std::cout << (rolled_back ? "  ROLLED BACK " : "  refused ") << name << ": "
                << outcome.error().message << '\n';
    return;
  }
  sum.ms.push_back(ms);
  const auto& done = outcome->report;
  sum.worst_after.push_back(done.touched_min_after);
  if (done.touched_min_after < std::min(0.1, done.touched_min_before) * (1 - 1e-9))
    ++sum.below_tenth;
  const double volume = total_volume(*outcome->version);
  sum.worst_volume_error = std::max(
    sum.worst_volume_error, std::abs(volume - base_volume - done.volume_change) / base_volume);
  double change = depth;
  for (const auto& f : done.figures)
    if (f.id == "thickness_change_mm")
      change = 1e-3 * f.value;
  if (depth > 0)
    sum.thickness_error.push_back(std::abs(change - depth) / depth);
  if (verbose)
    std::cout << "  " << name << ": q " << cli::pretty(done.touched_min_before, 3) << " -> "
              << cli::pretty(done.touched_min_after, 3) << ", " << cli::pretty(ms, 3) << " ms\n";
  if (const auto report = check_version(*outcome->version);
      !report.ok() && check_version(*base).total < report.total) {
    ++sum.faults;
    std::cout << "  FAULT " << name << ": " << to_error(report).message << '\n';
  }
}

double percentile(std::vector<double> values, double share) {
  if (values.empty())
    return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * values.size()))];
}

/// Listed surfaces with the thickness (m) that the list knows, else 0.
std::map<surface_id, double> listed(const std::filesystem::path& part) {
  std::ifstream in(part / "features.json");
  const auto features = nlohmann::json::parse(in);
  std::map<surface_id, double> result;
  for (const auto& plate : features["plates"])
    for (const auto* side : {"a", "b"}) {
      auto& thickness = result[plate[side].get<surface_id>()];
      const double listed = 1e-3 * plate["thickness"].get<double>();
      thickness = thickness > 0 ? std::min(thickness, listed) : listed;
    }
  for (const auto& plane : features["largest_planes"])
    result.try_emplace(plane["id"].get<surface_id>(), 0);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: erode_sweep PART_FOLDER MESH [OPERATION] [--layers | --all] [--verbose]\n";
    return 2;
  }
  std::set<std::string> options;
  std::string operation = "erode";
  for (int i = 3; i < argc; ++i)
    if (std::string(argv[i]).starts_with("--"))
      options.insert(argv[i]);
    else
      operation = argv[i];
  const auto imported = import_mesh(std::filesystem::path(argv[2]), "mm");
  if (!imported) {
    std::cerr << render(imported.error()) << '\n';
    return 65;
  }
  const auto& base = imported->version;
  const auto plugins = ops::load_default_catalogue();
  std::map<surface_id, double> surfaces;
  if (options.contains("--all"))
    for (const auto& row : base->surfaces())
      surfaces[row.id] = 0;
  else
    surfaces = listed(argv[1]);
  tally sum;
  for (const auto& [id, thickness] : surfaces) {
    cli::edit_request request{operation, {id}, {}};
    double depth = 0;
    if (!options.contains("--layers")) {
      depth =
        0.2 * std::min(1.0, std::min(wall_thickness(*base, id), thickness > 0 ? thickness : 1.0));
      request.parameters["depth"] = depth;
    }
    try_surface(plugins, base, total_volume(*base), request, depth, options.contains("--verbose"),
                sum);
  }
  std::cout << std::filesystem::path(argv[2]).filename().string() << ": tried " << sum.tried
            << ", done " << sum.ms.size() << ", refused " << sum.refused << " (rolled back "
            << sum.rolled_back << "), faults " << sum.faults << ", below min(.1, before) "
            << sum.below_tenth << "; ms median " << cli::pretty(percentile(sum.ms, 0.5), 3)
            << " max " << cli::pretty(percentile(sum.ms, 1), 3) << "; worst q min "
            << cli::pretty(percentile(sum.worst_after, 0), 3) << " median "
            << cli::pretty(percentile(sum.worst_after, 0.5), 3) << "; thickness error "
            << cli::pretty(percentile(sum.thickness_error, 1), 2) << "; volume error "
            << cli::pretty(sum.worst_volume_error, 2);
  for (const auto& [reason, count] : sum.reasons)
    std::cout << "; " << reason << " " << count;
  std::cout << '\n';
  return sum.faults > 0 ? 1 : 0;
}
