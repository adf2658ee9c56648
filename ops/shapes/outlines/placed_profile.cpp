// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/placed_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "base/number_range.hpp"

namespace tedit::ops {

namespace {

using plane_point = point2;

constexpr double most_corners = 1000;

double enclosed_area(const std::vector<plane_point>& points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += turn_of({0, 0}, points[i], points[(i + 1) % points.size()]);
  return twice / 2;
}

expected<void> check_outline(const std::vector<plane_point>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k)
      if ((k + 1) % n != i && edges_meet(points[i], points[i + 1], points[k], points[(k + 1) % n]))
        return fail(ec::invalid_parameter,
                    "the outline crosses itself between its points " + std::to_string(i + 1) +
                      " and " + std::to_string(k + 1),
                    "Give the points in the order in which they go around");
  double reach = 0;
  for (const auto& p : points)
    reach = std::max(reach, std::hypot(p[0], p[1]));
  if (!(shortest_edge(points) > 1e-9 * reach) ||
      !(std::abs(enclosed_area(points)) > 1e-6 * reach * reach))
    return fail(ec::invalid_parameter, "seen along the direction, the points enclose nothing",
                "Give points that lie around an area of the wall");
  return {};
}

/// The mean of the corners, each once.
vec3 middle_of_points(std::vector<vec3> points) {
  if (points.size() > 3 && points.front() == points.back())
    points.pop_back();
  return std::accumulate(points.begin(), points.end(), vec3{}) / static_cast<double>(points.size());
}

/// All digits.
std::string point_text(vec3 p) {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%.17g, %.17g, %.17g", p.x, p.y, p.z);
  return text.data();
}

/// What a file draws, on the place; a drawing has its own size.
expected<placed_profile> by_file(const mesh_version& mesh, const selection& picked,
                                 const parameters& values, double longest) {
  const auto file = outline_file_of(values);
  if (!file)
    return fail(file.error());
  auto sized = values;
  sized["size"] = file->longer_side(std::get<double>(values.at("size")));
  const double side = std::get<double>(sized.at("size"));
  const auto where = placement_of(mesh, picked, sized, "direction", side);
  if (!where)
    return fail(where.error());
  const double size = std::min(profile_size(*where, sized), longest);
  auto shape = file->outlines(side, size);
  if (!shape)
    return fail(std::move(shape.error()));
  if (auto ok = check_drawn_edges(*file, *shape, *where); !ok)
    return fail(ok.error());
  return placed_profile{*where, profile_frame(*where, values), std::move(*shape), size,
                        file->notices()};
}

expected<placed_profile> by_points(const mesh_version& mesh, const selection& picked,
                                   const parameters& values, const std::vector<vec3>& points,
                                   double longest) {
  const vec3 middle = middle_of_points(points);
  double reach = 0;
  for (const auto& p : points)
    reach = std::max(reach, norm(p - middle));
  auto with_place = values;
  if (picked.surfaces.empty() && !vector_of(values, "at"))
    with_place["at"] = point_text(middle);
  const auto where = placement_of(mesh, picked, with_place, "direction", 2 * reach);
  if (!where)
    return fail(where.error());
  placed_profile result{*where, {}, {}, 0, {}};
  const vec3 off = middle - where->at;
  result.where.at = where->at + off - dot(off, where->outward) * where->outward;
  result.place = profile_frame(result.where, values);
  std::vector<plane_point> corners;
  for (const auto& p : points) {
    const vec3 d = p - result.place.origin;
    corners.push_back({dot(d, result.place.x), dot(d, result.place.y)});
  }
  if (corners.size() > 3 && points.front() == points.back())
    corners.pop_back();
  if (auto ok = check_outline(corners); !ok)
    return fail(ok.error());
  if (auto ok = check_fineness(*where, shortest_edge(corners), 0); !ok)
    return fail(ok.error());
  result.shape = polygon(corners);
  const double radius = radius_of(result.shape);
  result.size = std::min(longest, std::max(std::min(where->size, radius / 2), radius / 30));
  return result;
}

}  // namespace

std::vector<parameter_description> placed_profile_parameters() {
  auto all = profiles_with_file();
  all.front().choices.emplace_back("points");
  all.push_back({"points",
                 "Points",
                 "For the profile \"points\": the corners of the outline on the wall, in the order "
                 "in which they go around.",
                 parameter_type::polyline,
                 "m",
                 3.0,
                 most_corners,
                 {},
                 std::string()});
  return all;
}

expected<placed_profile> placed_profile_of(const mesh_version& mesh, const selection& picked,
                                           const parameters& values, double longest) {
  const auto points = values.contains("points") ? points_of(values, "points") : std::vector<vec3>{};
  const bool wanted = std::get<std::string>(values.at("profile")) == "points";
  if (wanted && points.empty())
    return fail(ec::invalid_parameter, "the profile is to be points, and none were given",
                "Give the corners: points_mm=0,0,10;20,0,10;20,15,10");
  if (!wanted && !points.empty())
    return fail(ec::invalid_parameter, "points are given, and the profile is another one",
                "Set profile=points, or leave the points out");
  if (wanted)
    return by_points(mesh, picked, values, points, longest);
  if (std::get<std::string>(values.at("profile")) == "file")
    return by_file(mesh, picked, values, longest);
  const auto where =
    placement_of(mesh, picked, values, "direction", std::get<double>(values.at("size")));
  if (!where)
    return fail(where.error());
  const double size = std::min(profile_size(*where, values), longest);
  auto shape = profile_from(values, size);
  if (!shape)
    return fail(std::move(shape.error()));
  return placed_profile{*where, profile_frame(*where, values), std::move(*shape), size, {}};
}

expected<edit_result> apply_profile(const version_ptr& mesh, const selection& picked,
                                    const parameters& values, const profile_tool& how,
                                    context& ctx) {
  const bool places = values.contains("places") && !points_of(values, "places").empty();
  if (places && std::get<std::string>(values.at("profile")) == "points")
    return fail(ec::invalid_parameter,
                "an outline by its points is in one place, and more are given",
                "Leave the places out, or take another profile");
  std::vector<std::string> notices;
  auto tools = tools_at_places(values, [&](const parameters& here) -> expected<placed_tool> {
    const auto what = placed_profile_of(*mesh, picked, here, how.longest);
    if (!what)
      return fail(what.error());
    const double radius = radius_of(what->shape);
    const auto span = how.span(*what, radius);
    if (auto ok = check_fineness(what->where, what->size, span.to - span.from + 2 * radius); !ok)
      return fail(ok.error());
    auto tool =
      extrude(what->place, what->shape, span.from, span.to, what->size, how.name, *ctx.host);
    if (!tool)
      return fail(tool.error());
    notices = what->notices;
    return placed_tool{std::move(*tool), what->where.at, what->where.size};
  });
  if (!tools)
    return fail(tools.error());
  return with_notices(apply_tools(mesh, std::move(*tools), how.mode, as_set(picked), ctx), notices);
}

}  // namespace tedit::ops
