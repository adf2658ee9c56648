// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sweep/sweep_along.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::ops {

namespace {

/// As fine as drills: a round channel of 24 edges is within 1.2 % of the circle's area.
constexpr int least_segments = 24;

box extent_of_path(const std::vector<vec3>& path, double reach) {
  box extent;
  for (const auto& p : path)
    extent.add(p);
  return extent.grown(reach);
}

}  // namespace

expected<sweep_order> sweep_order_of(const mesh_version& mesh, const selection& picked,
                                     const parameters& values) {
  const auto number = [&](const char* id) { return std::get<double>(values.at(id)); };
  sweep_order order;
  order.path = points_of(values, "path");
  if (order.path.empty())
    return fail(ec::invalid_parameter, "no path was given",
                "Give its points, path_mm=0,0,10;40,0,10, or an edge of the part, path=edge:3,7");
  const double width = number("size");
  const double height = number("height") > 0 ? number("height") : width;
  const bool round = std::get<std::string>(values.at("profile")) == "circle";
  order.reach = round ? width / 2 : std::hypot(width, height) / 2;
  for (std::size_t i = 1; i < order.path.size(); ++i)
    order.length += norm(order.path[i] - order.path[i - 1]);
  order.local = local_size(mesh, extent_of_path(order.path, order.reach));
  const int segments = std::max(least_segments, segments_of(width, order.local));
  order.shape = round ? circle(width, segments) : rectangle(width, height);
  order.size = round ? std::min(order.local, 1.5 * std::numbers::pi * width / segments)
                     : std::min({order.local, width / 2, height / 2});
  // What reaches far beyond the part needs no triangles like the part's there.
  order.size = std::max(order.size, order.reach / 30);
  order.up = outward_at(mesh, order.path.front(), picked.surfaces);
  if (std::get<std::string>(values.at("mode")) == "add")
    order.mode = boolean_mode::add;
  const placement where{order.path.front(), order.up, order.local};
  if (auto ok = check_fineness(where, order.size, order.length + 2 * order.reach, 2000); !ok)
    return fail(ok.error());
  return order;
}

expected<edit_result> sweep_along(const version_ptr& mesh, const selection& picked,
                                  const parameters& values, context& ctx) {
  const auto order = sweep_order_of(*mesh, picked, values);
  if (!order)
    return fail(order.error());
  const auto tool = sweep(order->path, order->shape, order->up, order->size,
                          order->mode == boolean_mode::add ? "bead" : "groove", *ctx.host);
  if (!tool)
    return fail(tool.error());
  return apply_tool(mesh, *tool, order->mode, order->local, as_set(picked), ctx);
}

}  // namespace tedit::ops
