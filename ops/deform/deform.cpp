// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/deform/deform.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "mesh/box.hpp"
#include "ops/deform/drag.hpp"
#include "ops/shapes/most_that_works.hpp"

namespace tedit::ops {

namespace {

/// A reach of less bends nothing but one layer of tets.
constexpr double least_edges = 4;

std::string list_of(const std::vector<surface_id>& ids) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), most); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(ids[i]);
  return ids.size() > most ? text + " and " + std::to_string(ids.size() - most) + " more" : text;
}

/// Mean length of the edges of the facets.
double mean_edge(const mesh_version& mesh, const drag_handle& handle) {
  double sum = 0;
  for (const auto f : handle.facets)
    for (int i = 0; i < 3; ++i)
      sum += norm(mesh.position(mesh.facet(f).v[(i + 1) % 3]) - mesh.position(mesh.facet(f).v[i]));
  return sum / (3.0 * static_cast<double>(handle.facets.size()));
}

/// How far a point is off a box, m.
double outside(const box& b, vec3 p) {
  const auto off = [](double low, double high, double x) {
    return std::max({low - x, x - high, 0.0});
  };
  return norm(
    {off(b.low.x, b.high.x, p.x), off(b.low.y, b.high.y, p.y), off(b.low.z, b.high.z, p.z)});
}

/// The reach that is chosen, m: the side of a square as large as what is dragged, four edges at
/// least, and no more than half the way to the far end of the part: that stays.
double usual_reach(const mesh_version& mesh, const drag_handle& handle) {
  box extent;
  for (const auto v : handle.vertices)
    extent.add(mesh.position(v));
  double furthest = 0;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_live_vertex(v))
      furthest = std::max(furthest, outside(extent, mesh.position(v)));
  const double wanted = std::max(std::sqrt(handle.area), least_edges * mean_edge(mesh, handle));
  return furthest > 0 ? std::min(wanted, furthest / 2) : wanted;
}

/// The whole way, m. Errors: `invalid_parameter`.
expected<vec3> way_of(const drag_handle& handle, const deform_settings& settings) {
  if (settings.by) {
    if (norm(*settings.by) == 0)
      return fail(ec::invalid_parameter, "the way is 0, 0, 0: nothing would move",
                  "Give a way: by_mm=x,y,z");
    return *settings.by;
  }
  if (settings.distance == 0)
    return fail(ec::invalid_parameter, "the distance is 0: nothing would move",
                "Give a distance, or a way: by_mm=x,y,z");
  const auto normal = handle.normal();
  if (!normal)
    return fail(normal.error());
  return settings.distance * *normal;
}

expected<drag_handle> picked(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                             const deform_settings& settings) {
  if (settings.at)
    return handle_at(mesh, *settings.at, settings.radius, surfaces);
  if (surfaces.empty())
    return fail(ec::empty_selection, "neither a wall nor a place was given",
                "Select the wall to drag, or give a place on it: at_mm=10,20,5");
  return handle_of(mesh, surfaces);
}

/// What `at_most` says of lengths, said of what was asked for.
error as_asked(error refused, const deform_settings& settings, vec3 way) {
  if (!refused.most)
    return refused;
  // "Take 3.1 mm: ..." or "Take 3.1 mm, which ...".
  const auto told = refused.remedy.find(" mm");
  if (settings.by && told != std::string::npos) {
    const vec3 part = 1e3 * refused.most->value / norm(way) * way;
    refused.remedy.replace(5, told - 2,
                           "by_mm=" + format_number("%.6g", part.x) + "," +
                             format_number("%.6g", part.y) + "," + format_number("%.6g", part.z));
    refused.most.reset();
  } else if (settings.distance < 0) {
    refused.most->value = -refused.most->value;
    refused.remedy.insert(5, "-");
  }
  return refused;
}

void tell(const deform_zone& zone, double reach, bool all_moves, edit_result& result) {
  result.figures.push_back({"reach_mm", 1e3 * reach, "mm", "how far around the part follows"});
  if (all_moves)
    result.notices.push_back("nothing is beyond the reach: the whole part moves");
  if (!zone.kept.empty())
    result.notices.push_back("within reach these surfaces stay: " + list_of(zone.kept));
}

}  // namespace

expected<edit_result> deform(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                             const deform_settings& settings, context& ctx) {
  const auto handle = picked(*mesh, surfaces, settings);
  if (!handle)
    return fail(handle.error());
  const auto way = way_of(*handle, settings);
  if (!way)
    return fail(way.error());
  const double reach = settings.reach > 0 ? settings.reach : usual_reach(*mesh, *handle);
  ctx.run.report(0.1, "looking at what is around");
  const auto zone = zone_around(*mesh, *handle, {reach, settings.kept, settings.stay}, ctx.run);
  if (!zone)
    return fail(zone.error());
  ctx.run.report(0.3, "bending");
  const auto dragged =
    drag::prepare(mesh, *handle, *zone, normalized(*way), settings.keep_volume, ctx.run);
  if (!dragged)
    return fail(dragged.error());
  ctx.run.report(0.7, "moving");
  auto result = at_most(
    mesh, {"distance", settings.by ? "way" : "distance", norm(*way)},
    [&](double distance, context& trial) { return dragged->by(distance, trial.run); }, ctx);
  if (!result)
    return fail(as_asked(std::move(result.error()), settings, *way));
  result->surfaces_used = surfaces;
  tell(*zone, reach, dragged->moves_all(), *result);
  ctx.run.report(1, "deformed");
  return result;
}

}  // namespace tedit::ops
