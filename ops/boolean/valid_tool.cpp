// SPDX-License-Identifier: AGPL-3.0-or-later
#include <map>

#include "ops/boolean/boolean.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

expected<void> validate(const tool_surface& tool) {
  const auto wrong = [](const std::string& why) {
    return fail(ec::invalid_argument, "the tool is no closed surface: " + why);
  };
  if (tool.triangles.size() < 4 || tool.faces.size() != tool.triangles.size())
    return wrong("it has too few triangles, or not a face for each");
  for (const auto& p : tool.points)
    if (!is_finite(p))
      return wrong("a point is not finite");
  if (!tool.geometries.empty() && tool.geometries.size() != tool.names.size())
    return wrong("not each face has a geometry, or none");
  for (const auto& one : tool.geometries)
    if (!is_possible(one))
      return wrong("the geometry of a face is of no known kind, or not finite");
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i) {
    const auto& t = tool.triangles[i];
    if (tool.faces[i] >= tool.names.size())
      return wrong("a triangle has no face");
    for (int k = 0; k < 3; ++k) {
      if (t[k] >= tool.points.size() || t[k] == t[(k + 1) % 3])
        return wrong("a triangle has no three corners");
      ++edges[{t[k], t[(k + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges)
    if (const auto back = edges.find({edge.second, edge.first});
        count != 1 || back == edges.end() || back->second != 1)
      return wrong("an edge has not one triangle on each side");
  if (!(enclosed_volume(tool.points, tool.triangles) > 0))
    return wrong("it is turned inside out, or flat");
  return {};
}

expected<void> validate(const tool_surface& tool,
                        const std::vector<std::optional<surface_id>>& continues) {
  if (auto ok = validate(tool); !ok)
    return fail(ok.error());
  if (!continues.empty() && continues.size() != tool.names.size())
    return fail(ec::invalid_argument, "not each face of the tool is told what it continues");
  return {};
}

}  // namespace tedit::ops
