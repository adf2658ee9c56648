// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/server_comparison.hpp"

#include <algorithm>

#include "cli/compare_report.hpp"
#include "fem/quantities.hpp"
#include "mesh/io/vtu_writer.hpp"

namespace tedit::cli {

namespace {

/// The triangles of a boundary whose corners are places in a list of vertices.
struct boundary_triangles {
  std::vector<vec3> points;  ///< One for each vertex, m.
  std::vector<std::uint32_t> corners;
};

/// Errors: `protocol_error` when the surface has a vertex that is not in the list, or lacks one.
expected<boundary_triangles> triangles_of(const client::surface_model& surface,
                                          const std::vector<std::uint32_t>& vertices) {
  boundary_triangles result;
  for (const auto v : vertices) {
    const auto* at = surface.positions().find(v);
    if (!at)
      return fail(ec::protocol_error, "the surface has no vertex " + std::to_string(v));
    result.points.push_back(*at);
  }
  bool complete = true;
  surface.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    for (const auto v : facet.v) {
      const auto found = std::ranges::lower_bound(vertices, v);
      complete = complete && found != vertices.end() && *found == v;
      result.corners.push_back(static_cast<std::uint32_t>(found - vertices.begin()));
    }
  });
  if (!complete)
    return fail(ec::protocol_error, "the comparison does not have all vertices of the surface");
  return result;
}

/// The arrays of a file, each with its values.
std::vector<std::pair<vtu_array, std::vector<double>>> arrays_of(const client::comparison& made) {
  std::vector<std::pair<vtu_array, std::vector<double>>> result;
  std::vector<double> marks;
  for (const auto mark : made.marks)
    marks.push_back(static_cast<double>(mark));
  result.emplace_back(vtu_array{std::string(mark_array), 1, {}}, std::move(marks));
  for (const auto& [name, values] : made.differences)
    result.push_back({{name + std::string(difference_ending),
                       static_cast<int>(values.size() / made.vertices.size()),
                       {}},
                      {values.begin(), values.end()}});
  return result;
}

}  // namespace

expected<client::comparison> compare_on_server(client::client& server,
                                               const compared_versions& wanted, session& s) {
  auto made = server.compare(wanted.before, wanted.after, wanted.load_case, make_execution(s));
  if (!made)
    return made;
  const auto& absent = made->what.not_compared;
  const auto found = std::ranges::find(absent, wanted.load_case, &uncompared_fields::load_case);
  if (!wanted.load_case.empty() && found != absent.end())
    return fail(ec::not_found,
                "the fields of \"" + wanted.load_case + "\" cannot be compared: " + found->reason,
                found->remedy);
  return made;
}

expected<void> write_difference(client::client& server, const client::comparison& made,
                                const std::filesystem::path& file, session& s) {
  if (made.vertices.empty())
    return fail(ec::invalid_argument, "there is no difference of fields to write",
                "Name a load case that is solved in both versions");
  const auto surface = server.surface_of(made.after, make_execution(s));
  if (!surface)
    return fail(surface.error());
  const auto triangles = triangles_of(*surface, made.vertices);
  if (!triangles)
    return fail(triangles.error());
  const auto arrays = arrays_of(made);
  vtu_grid grid;
  grid.points = triangles->points;
  grid.cells = triangles->corners;
  grid.nodes_per_cell = 3;
  for (const auto& [about, values] : arrays)
    grid.point_data.push_back({about.name, about.components, values});
  grid.notes = {{"before_id", made.what.before_id},
                {"version_id", made.what.after_id},
                {"load_case", made.load_case}};
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  return write_vtu(file, grid);
}

std::string describe_comparison(const client::comparison& made) {
  return "version " + std::to_string(made.before) + " -> version " + std::to_string(made.after) +
         "\n" + describe_comparison(made.what);
}

}  // namespace tedit::cli
