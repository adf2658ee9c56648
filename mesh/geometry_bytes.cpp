// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry_bytes.hpp"

namespace tedit {

namespace {

void write_spline(const spline_surface& s, byte_writer& out) {
  for (const auto degree : s.degree)
    out.number(degree);
  for (const auto& knots : s.knots)
    out.list(std::span<const double>(knots));
  out.list(std::span<const vec3>(s.poles));
  out.list(std::span<const double>(s.weights));
}

spline_surface read_spline(byte_reader& in) {
  spline_surface s;
  for (auto& degree : s.degree)
    degree = in.number<std::uint32_t>();
  for (auto& knots : s.knots)
    knots = in.list<double>();
  s.poles = in.list<vec3>();
  s.weights = in.list<double>();
  return s;
}

}  // namespace

void write_geometry(const surface_geometry& g, byte_writer& out) {
  out.number(static_cast<std::uint8_t>(g.type));
  out.number(g.tolerance);
  if (g.spline)
    return write_spline(*g.spline, out);
  for (const double value : {g.point.x, g.point.y, g.point.z, g.axis.x, g.axis.y, g.axis.z,
                             g.radius, g.slope, g.tube_radius})
    out.number(value);
}

std::optional<surface_geometry> read_geometry(byte_reader& in) {
  surface_geometry g;
  g.type = static_cast<surface_geometry::kind>(in.number<std::uint8_t>());
  g.tolerance = in.number<double>();
  if (g.type == surface_geometry::kind::spline)
    g.spline = std::make_shared<const spline_surface>(read_spline(in));
  else
    for (double* value : {&g.point.x, &g.point.y, &g.point.z, &g.axis.x, &g.axis.y, &g.axis.z,
                          &g.radius, &g.slope, &g.tube_radius})
      *value = in.number<double>();
  return in.ok && is_possible(g) ? std::optional(std::move(g)) : std::nullopt;
}

}  // namespace tedit
