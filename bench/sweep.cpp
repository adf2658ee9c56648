// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/sweep.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <numbers>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "mesh/checks.hpp"

namespace tedit::bench {

namespace {

double cpu_ms() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage use{};
    getrusage(who, &use);
    for (const auto& t : {use.ru_utime, use.ru_stime})
      sum += 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

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

/// The base's tets at the corners of what an edit left touched, and those that it took away.
std::vector<tet_id> region_before(const mesh_version& base, const mesh_version& after) {
  std::unordered_set<vertex_id> corners;
  const auto slots = std::max(base.tet_slots(), after.tet_slots());
  for (tet_id t = 0; t < slots; ++t) {
    const bool was = t < base.tet_slots() && base.is_live_tet(t);
    const bool is = t < after.tet_slots() && after.is_live_tet(t);
    if (was && is && base.tet_at(t) == after.tet_at(t))
      continue;
    for (const auto* mesh : {was ? &base : nullptr, is ? &after : nullptr})
      if (mesh)
        corners.insert(mesh->tet_at(t).v.begin(), mesh->tet_at(t).v.end());
  }
  const std::vector<vertex_id> list(corners.begin(), corners.end());
  return tets_around(base, list);
}

double percentile(std::vector<double> values, double share) {
  if (values.empty())
    return 0;
  std::ranges::sort(values);
  const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  return values[std::min(values.size() - 1, place)];
}

/// How a map reads in a table: "-2 ~2": surfaces gone, new, changed.
std::string map_text(const std::vector<surface_change>& map) {
  using enum surface_fate;
  const auto count = [&](surface_fate one, surface_fate other) {
    return std::ranges::count_if(
      map, [&](const auto& change) { return change.fate == one || change.fate == other; });
  };
  std::string text;
  const auto add = [&](const char* sign, std::ptrdiff_t n) {
    if (n > 0)
      text += (text.empty() ? "" : " ") + std::string(sign) + std::to_string(n);
  };
  add("-", count(removed, merged_into));
  add("+", count(added, split_from));
  add("~", count(changed, changed));
  return text;
}

/// A plain bore's volume; none where a cone, a bottom of its own or a second wall belongs to it.
std::optional<double> cylinder_of(const nlohmann::json& hole) {
  if (hole["class"] != "through" || !hole["cones"].empty())
    return std::nullopt;
  const double r = 1e-3 * hole["radius"].get<double>();
  return std::numbers::pi * r * r * 1e-3 * hole["length"].get<double>();
}

}  // namespace

std::string name_of(const planned_feature& feature) {
  std::string text = feature.operation + " " + feature.kind;
  for (const auto id : feature.surfaces)
    text += (id == feature.surfaces.front() ? " " : ", ") + std::to_string(id);
  return text;
}

part_features read_features(const std::filesystem::path& folder) {
  std::ifstream in(folder / "features.json");
  const auto features = nlohmann::json::parse(in);
  part_features result;
  for (const auto& hole : features["holes"])
    result.holes.push_back({"fill_hole",
                            hole["surfaces"].get<std::vector<surface_id>>(),
                            {},
                            hole["class"].get<std::string>(),
                            cylinder_of(hole)});
  for (const auto& fin : features.value("fins", nlohmann::json::array()))
    result.fins.push_back({"remove_surfaces", {fin["faces"][0].get<surface_id>()}, {}, "fin", {}});
  for (const auto& plate : features["plates"])
    for (const auto* side : {"a", "b"}) {
      auto& thickness = result.planes[plate[side].get<surface_id>()];
      const double listed = 1e-3 * plate["thickness"].get<double>();
      thickness = thickness > 0 ? std::min(thickness, listed) : listed;
    }
  for (const auto& plane : features["largest_planes"])
    result.planes.try_emplace(plane["id"].get<surface_id>(), 0);
  return result;
}

double wall_thickness(const mesh_version& mesh, surface_id surface) {
  const auto own = facets_of(mesh, std::vector{surface});
  const std::size_t stride = own.size() / 100 + 1;
  double thinnest = 1e300;
  for (std::size_t i = 0; i < own.size(); i += stride) {
    const auto& v = mesh.facet(own[i]).v;
    const vec3 from = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
    const vec3 along = -normalized(area_vector(mesh, mesh.facet(own[i])));
    for (facet_id g = 0; g < mesh.facet_slots(); ++g)
      if (g != own[i] && mesh.is_live_facet(g)) {
        const auto& w = mesh.facet(g).v;
        thinnest = std::min(thinnest, hit(from, along, mesh.position(w[0]), mesh.position(w[1]),
                                          mesh.position(w[2])));
      }
  }
  return thinnest;
}

double area_of(const mesh_version& mesh, surface_id surface) {
  double sum = 0;
  for (const auto f : facets_of(mesh, std::vector{surface}))
    sum += norm(area_vector(mesh, mesh.facet(f)));
  return sum;
}

sweep::sweep(version_ptr base)
    : plugins_(ops::load_default_catalogue(ops::plugin_source::built_in)), base_(std::move(base)) {}

attempt_result sweep::attempt(const version_ptr& mesh, const planned_feature& feature) {
  attempt_result result;
  const auto id = mesh->id();
  edit_request request{feature.operation, feature.surfaces, feature.parameters};
  request.loads.policy = fem::load_policy::move;
  const double start = cpu_ms();
  auto outcome = make_edit(plugins_, mesh, request, loads, {}, {});
  result.cpu_ms = cpu_ms() - start;
  const auto fault = [&](const std::string& what) {
    ++faults_;
    std::cout << "  FAULT " << name_of(feature) << ": " << what << '\n';
  };
  if (mesh->id() != id)
    fault("the version before changed");
  if (!outcome) {
    result.refusal = outcome.error();
    return result;
  }
  const auto& after = *outcome->version;
  const double volume = total_volume(*mesh);
  result.claimed_error =
    std::abs(total_volume(after) - volume - outcome->report.volume_change) / volume;
  if (result.claimed_error > 1e-9)
    fault("its volume is not as claimed");
  if (const auto report = check_version(after);
      !report.ok() && check_version(*mesh).total < report.total)
    fault(to_error(report).message);
  result.median_before = radius_ratios(*mesh, region_before(*mesh, after)).median;
  result.median_after = outcome->report.ratios.value_or(touched_ratios{}).median_after;
  result.outcome = std::move(*outcome);
  return result;
}

std::string row_of(const planned_feature& feature, const attempt_result& tried) {
  std::string row = "| " + feature.operation + " | " + feature.kind;
  for (const auto id : feature.surfaces)
    row += (id == feature.surfaces.front() ? " " : ", ") + std::to_string(id);
  if (!tried.outcome)
    return row + " | " + std::string(code_name(tried.refusal.code)) + " | " +
           cli::pretty(tried.cpu_ms, 2) + " | | | | | |";
  const auto& done = tried.outcome->report;
  row += " | done | " + cli::pretty(tried.cpu_ms, 2) + " | +" + std::to_string(done.tets_added) +
         " -" + std::to_string(done.tets_removed) + " | " +
         (done.ratios ? cli::pretty(done.ratios->min_before, 2) + " -> " +
                          cli::pretty(done.ratios->min_after, 2)
                      : std::string()) +
         " | " + cli::pretty(tried.median_before, 2) + " -> " + cli::pretty(tried.median_after, 2) +
         " | ";
  if (feature.exact_volume)
    row += cli::pretty(100 * (done.volume_change / *feature.exact_volume - 1), 2) + " %";
  return row + " | " + map_text(done.surface_map) + " |";
}

void tally::add(const attempt_result& result) {
  ++tried;
  ms.push_back(result.cpu_ms);
  if (!result.outcome) {
    ++reasons[std::string(code_name(result.refusal.code))];
    return;
  }
  ++done;
  if (const auto& ratios = result.outcome->report.ratios)
    worst_after.push_back(ratios->min_after);
  claimed_error = std::max(claimed_error, result.claimed_error);
}

std::string tally::text(const std::string& what) const {
  std::string line =
    what + ": " + std::to_string(done + with_another) + " of " +
    std::to_string(tried + with_another) + " done" +
    (with_another > 0 ? ", " + std::to_string(with_another) + " with another" : "") +
    "; CPU ms median " + cli::pretty(percentile(ms, 0.5), 3) + ", worst " +
    cli::pretty(percentile(ms, 1), 3) + "; worst q " + cli::pretty(percentile(worst_after, 0), 3) +
    ", median of worst " + cli::pretty(percentile(worst_after, 0.5), 3) +
    "; volume as claimed to " + cli::pretty(claimed_error, 2);
  for (const auto& [reason, count] : reasons)
    line += "; " + reason + " " + std::to_string(count);
  return line;
}

}  // namespace tedit::bench
