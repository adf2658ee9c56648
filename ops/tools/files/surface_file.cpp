// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/files/surface_file.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <numeric>
#include <sstream>

#include "mesh/io/import.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

namespace {

constexpr std::size_t most_triangles = 200'000;
/// Faces of a surface that came without: edges that bend by less than 30 degrees are smooth.
constexpr double smooth_cosine = 0.8660254037844387;
/// More faces than this are a surface of free form in many facets: one.
constexpr std::size_t most_faces = 500;

using cgal_point = CGAL::Simple_cartesian<double>::Point_3;

tl::unexpected<error> unreadable(const attachment& file) {
  return fail(ec::bad_input, file.name + " cannot be read", "Save it again, as a binary STL");
}

expected<tool_surface> from_soup(const attachment& file, const std::vector<cgal_point>& points,
                                 const std::vector<std::vector<std::size_t>>& polygons) {
  tool_surface result;
  // Equal corners are one: STL has no others.
  std::map<std::array<double, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> place;
  for (const auto& p : points) {
    const vec3 at{p.x(), p.y(), p.z()};
    if (!is_finite(at) || norm(at) > 1e9)
      return fail(ec::bad_input, file.name + " has a corner that is no finite number");
    const auto [found, is_new] = known.emplace(std::array{at.x + 0.0, at.y + 0.0, at.z + 0.0},
                                               static_cast<std::uint32_t>(result.points.size()));
    if (is_new)
      result.points.push_back(at);
    place.push_back(found->second);
  }
  for (const auto& polygon : polygons) {
    if (std::ranges::any_of(polygon, [&](std::size_t v) { return v >= place.size(); }))
      return unreadable(file);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const std::array t{place[polygon[0]], place[polygon[i - 1]], place[polygon[i]]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        result.triangles.push_back(t);
    }
  }
  return result;
}

template <class Read>
expected<tool_surface> read_soup(const attachment& file, const Read& read) {
  std::istringstream in(file.bytes);
  std::vector<cgal_point> points;
  std::vector<std::vector<std::size_t>> polygons;
  try {
    if (!read(in, points, polygons))
      return unreadable(file);
  } catch (const std::exception&) {
    return unreadable(file);
  }
  return from_soup(file, points, polygons);
}

/// The boundary of a mesh, with its surfaces' names; its coordinates as they are in the file.
expected<tool_surface> from_mesh(const attachment& file) {
  const auto mesh = import_mesh_bytes(file.bytes, "m");
  if (!mesh)
    return fail(mesh.error());
  const auto& version = *mesh->version;
  tool_surface result;
  std::map<vertex_id, std::uint32_t> place;
  std::map<surface_id, std::uint32_t> faces;
  for (const auto& row : version.surfaces()) {
    faces.emplace(row.id, static_cast<std::uint32_t>(result.names.size()));
    result.names.push_back(row.name.empty() ? std::to_string(row.id) : row.name);
  }
  for (facet_id f = 0; f < version.facet_slots(); ++f) {
    if (!version.is_live_facet(f))
      continue;
    auto& t = result.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto v = version.facet(f).v[k];
      const auto [found, is_new] = place.emplace(v, static_cast<std::uint32_t>(place.size()));
      if (is_new)
        result.points.push_back(version.position(v));
      t[k] = found->second;
    }
    result.faces.push_back(faces.at(version.facet(f).surface));
  }
  return result;
}

std::string suffix_of(const attachment& file) {
  auto suffix = std::filesystem::path(file.name).extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix;
}

expected<tool_surface> read_any(const attachment& file) {
  const auto suffix = suffix_of(file);
  if (suffix == ".stl")
    return read_soup(file, [](auto& in, auto& p, auto& t) { return CGAL::IO::read_STL(in, p, t); });
  if (suffix == ".obj")
    return read_soup(file, [](auto& in, auto& p, auto& t) { return CGAL::IO::read_OBJ(in, p, t); });
  if (suffix == ".off")
    return read_soup(file, [](auto& in, auto& p, auto& t) { return CGAL::IO::read_OFF(in, p, t); });
  if (suffix == ".ply")
    return read_soup(file, [](auto& in, auto& p, auto& t) { return CGAL::IO::read_PLY(in, p, t); });
  if (suffix == ".msh")
    return from_mesh(file);
  return fail(ec::unsupported_format, "\"" + file.name + "\" is of no kind that can be combined",
              "Give a file that ends in .stl, .obj, .off, .ply or .msh");
}

using edge = std::array<std::uint32_t, 2>;

/// The triangle at each directed edge. Errors: `bad_input` where the surface is not closed.
expected<std::map<edge, std::uint32_t>> close_edges(const attachment& file,
                                                    const tool_surface& surface) {
  std::map<edge, std::uint32_t> at;
  std::size_t open = 0;
  vec3 first;
  const auto note = [&](edge e) {
    if (open++ == 0)
      first = 0.5 * (surface.points[e[0]] + surface.points[e[1]]);
  };
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (const edge e{surface.triangles[i][k], surface.triangles[i][(k + 1) % 3]};
          !at.emplace(e, i).second)
        note(e);
  for (const auto& [e, triangle] : at)
    if (!at.contains({e[1], e[0]}))
      note(e);
  if (open == 0)
    return at;
  char place[96];
  std::snprintf(place, sizeof(place), "(%.4g, %.4g, %.4g)", first.x, first.y, first.z);
  return fail(ec::bad_input,
              file.name + " is no closed surface: " + std::to_string(open) +
                " edges have not one triangle on each side, the first at " + place + " of the file",
              "Close it in the program that it comes from");
}

/// Of what hangs together over edges that hardly bend.
void name_faces(const attachment& file, const std::map<edge, std::uint32_t>& edges,
                tool_surface& surface) {
  const auto n = surface.triangles.size();
  std::vector<vec3> normals(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& t = surface.triangles[i];
    normals[i] =
      normalized(area_vector(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]));
  }
  std::vector<std::uint32_t> root(n);
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& [e, i] : edges)
    if (const auto other = edges.at({e[1], e[0]}); dot(normals[i], normals[other]) > smooth_cosine)
      root[find(i)] = find(other);
  std::map<std::uint32_t, std::uint32_t> faces;
  for (std::uint32_t i = 0; i < n; ++i)
    surface.faces.push_back(
      faces.emplace(find(i), static_cast<std::uint32_t>(faces.size())).first->second);
  const auto stem = std::filesystem::path(file.name).stem().string();
  if (faces.size() > most_faces) {
    surface.faces.assign(n, 0);
    surface.names = {stem};
    return;
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    surface.names.push_back(faces.size() == 1 ? stem : stem + " " + std::to_string(i + 1));
}

}  // namespace

expected<tool_surface> read_surface(const attachment& file) {
  auto surface = read_any(file);
  if (!surface)
    return surface;
  if (surface->triangles.size() > most_triangles)
    return fail(ec::bad_input,
                file.name + " has " + std::to_string(surface->triangles.size()) +
                  " triangles, more than 200,000",
                "Simplify it first");
  if (surface->triangles.size() < 4)
    return unreadable(file);
  const auto edges = close_edges(file, *surface);
  if (!edges)
    return fail(edges.error());
  if (surface->faces.empty())
    name_faces(file, *edges, *surface);
  if (enclosed_volume(surface->points, surface->triangles) < 0)
    for (auto& t : surface->triangles)
      std::swap(t[1], t[2]);
  return surface;
}

}  // namespace tedit::ops
