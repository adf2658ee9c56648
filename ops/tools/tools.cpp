// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/tools.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ops/tools/extruder.hpp"

namespace tedit::ops {

namespace {

using point2 = std::array<double, 2>;

std::vector<point2> arc(point2 centre, double radius, double from, double to, int edges) {
  std::vector<point2> points;
  for (int i = 0; i < edges; ++i) {
    const double angle = from + (to - from) * i / edges;
    points.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  return points;
}

}  // namespace

frame make_frame(vec3 origin, vec3 z, vec3 up) {
  frame f;
  f.origin = origin;
  f.z = normalized(z);
  vec3 x = cross(up, f.z);
  if (norm(x) <= 1e-6 * norm(up) || norm(up) == 0) {
    const vec3 any = std::abs(f.z.z) < 0.9 ? vec3{0, 0, 1} : vec3{0, 1, 0};
    x = cross(any, f.z);
  }
  f.x = normalized(x);
  f.y = cross(f.z, f.x);
  return f;
}

int segments_of(double diameter, double size) {
  const double edges = std::numbers::pi * diameter / size;
  return std::clamp(static_cast<int>(std::lround(edges)), 16, 256);
}

profile circle(double diameter, int segments) {
  profile p;
  p.outlines.push_back({arc({0, 0}, diameter / 2, 0, 2 * std::numbers::pi, segments),
                        std::vector<std::uint32_t>(static_cast<std::size_t>(segments), 0)});
  p.sides = {"side"};
  return p;
}

profile polygon(const std::vector<point2>& points) {
  profile p;
  p.outlines.push_back({points, {}});
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    p.outlines[0].side.push_back(i);
    p.sides.push_back("side " + std::to_string(i + 1));
  }
  orient(p.outlines);
  return p;
}

profile rectangle(double width, double height) {
  const double x = width / 2;
  const double y = height / 2;
  return polygon({{-x, -y}, {x, -y}, {x, y}, {-x, y}});
}

profile slot(double length, double width, int segments) {
  constexpr double pi = std::numbers::pi;
  const double radius = width / 2;
  const double x = std::max(0.0, length / 2 - radius);
  profile p;
  outline o;
  const int half = std::max(4, segments / 2);
  const auto add_end = [&](point2 centre, double from, std::uint32_t side) {
    const auto round = arc(centre, radius, from, from + pi, half);
    o.points.insert(o.points.end(), round.begin(), round.end());
    o.side.insert(o.side.end(), round.size(), side);
    // The straight edge begins where the arc ends.
    o.points.push_back(
      {centre[0] + radius * std::cos(from + pi), centre[1] + radius * std::sin(from + pi)});
    o.side.push_back(side + 1);
  };
  add_end({x, 0}, -pi / 2, 0);
  add_end({-x, 0}, pi / 2, 2);
  p.outlines.push_back(std::move(o));
  p.sides = {"end 1", "side 1", "end 2", "side 2"};
  return p;
}

expected<tool_surface> extrude(const frame& place, const profile& what, double from, double to,
                               double size, const std::string& name, services& host) {
  const auto outlines = divided_outlines(what, size);
  const auto filling = fill_outlines(outlines, size, host);
  if (!filling)
    return fail(filling.error());
  std::uint32_t rim = 0;
  for (const auto& o : outlines)
    rim += static_cast<std::uint32_t>(o.points.size());
  const int layers = parts_of(to - from, size);
  extruder made;
  for (int k = 0; k <= layers; ++k)
    for (const auto& o : outlines)
      for (const auto& p : o.points)
        made.tool.points.push_back(place.at(p[0], p[1], from + (to - from) * k / layers));
  made.add_walls(outlines, rim, layers);
  const auto at_height = [&](double z) {
    return [&place, z](const point2& p) { return place.at(p[0], p[1], z); };
  };
  made.add_ends(*filling, rim, layers, at_height(from), at_height(to));
  made.tool.names = {name + " bottom", name + " top"};
  for (const auto& side : what.sides)
    made.tool.names.push_back(name + " " + side);
  return std::move(made.tool);
}

tool_surface revolve(const frame& place, const std::vector<section_point>& section, int segments,
                     double size) {
  tool_surface tool;
  const auto n = static_cast<std::uint32_t>(segments);
  /// A ring of points, or one on the axis.
  struct ring {
    std::uint32_t first = 0;
    bool point = false;
  };
  const auto add_ring = [&](double radius, double height) {
    const ring r{static_cast<std::uint32_t>(tool.points.size()), radius <= 0};
    for (std::uint32_t i = 0; i < (r.point ? 1 : n); ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      tool.points.push_back(place.at(radius * std::cos(angle), radius * std::sin(angle), height));
    }
    return r;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
    tool.triangles.push_back({a, b, c});
    tool.faces.push_back(face);
  };
  const auto join = [&](const ring& above, const ring& below, std::uint32_t face) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto j = (i + 1) % n;
      if (above.point)
        add(above.first, below.first + i, below.first + j, face);
      else if (below.point)
        add(above.first + i, below.first, above.first + j, face);
      else if (i % 2 == 0) {
        add(above.first + i, below.first + i, below.first + j, face);
        add(above.first + i, below.first + j, above.first + j, face);
      } else {
        add(above.first + i, below.first + i, above.first + j, face);
        add(above.first + j, below.first + i, below.first + j, face);
      }
    }
  };
  ring above = add_ring(section.front().radius, section.front().height);
  for (std::size_t k = 1; k < section.size(); ++k) {
    const auto& from = section[k - 1];
    const auto& to = section[k];
    auto named = std::ranges::find(tool.names, to.wall);
    if (named == tool.names.end())
      named = tool.names.insert(tool.names.end(), to.wall);
    const auto face = static_cast<std::uint32_t>(named - tool.names.begin());
    const int parts = parts_of(std::hypot(to.radius - from.radius, to.height - from.height), size);
    for (int i = 1; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      const bool last = i == parts;
      const ring below = add_ring(last ? to.radius : from.radius + t * (to.radius - from.radius),
                                  last ? to.height : from.height + t * (to.height - from.height));
      join(above, below, face);
      above = below;
    }
  }
  return tool;
}

expected<tool_surface> half_space(const box& extent, vec3 point, vec3 normal, double size,
                                  const std::string& name, services& host) {
  const double reach = norm(extent.high - extent.low);
  const vec3 middle = 0.5 * (extent.low + extent.high);
  const vec3 n = normalized(normal);
  const frame place = make_frame(middle + dot(point - middle, n) * n, n);
  const double grid = std::max(size, reach / 6);
  auto tool =
    extrude(place, rectangle(2.2 * reach, 2.2 * reach), -1.6 * reach, 0, grid, name, host);
  if (tool)
    tool->names[1] = name;
  return tool;
}

}  // namespace tedit::ops
