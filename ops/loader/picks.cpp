// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/picks.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "base/number_range.hpp"
#include "mesh/features/edge_curve.hpp"
#include "mesh/features/wall_shape.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

namespace {

constexpr const char* wall_word = "surface:";
constexpr const char* edge_word = "edge:";
constexpr const char* corner_word = "corner:";

/// A wall is as round as the window says it is.
constexpr fit_limits round_walls{1e-2, true, true};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ')
    text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ')
    text.remove_suffix(1);
  return text;
}

/// Between commas; nothing for anything else, and for a surface that stands there twice.
std::optional<std::vector<surface_id>> ids_in(std::string_view text) {
  std::vector<surface_id> ids;
  while (true) {
    const auto comma = std::min(text.find(','), text.size());
    const auto word = trimmed(text.substr(0, comma));
    surface_id id = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (code != std::errc{} || end != word.data() + word.size() || ids.size() == 16 ||
        std::ranges::find(ids, id) != ids.end())
      return std::nullopt;
    ids.push_back(id);
    if (comma == text.size())
      return ids;
    text.remove_prefix(comma + 1);
  }
}

std::string words_of(const std::vector<surface_id>& ids) {
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i)
    text += (i == 0 ? "" : i + 1 == ids.size() ? " and " : ", ") + std::to_string(ids[i]);
  return text;
}

std::string in_mm(vec3 p) {
  return "(" + number_text(1e3 * p.x) + ", " + number_text(1e3 * p.y) + ", " +
         number_text(1e3 * p.z) + ") mm";
}

/// Half way along what the facets cover of an axis.
vec3 middle_of_axis(const mesh_version& mesh, const std::vector<facet_id>& facets,
                    const wall_shape& shape) {
  double least = largest_number;
  double most = -largest_number;
  for (const auto f : facets)
    for (const auto v : mesh.facet(f).v) {
      const double along = dot(mesh.position(v) - shape.point, shape.axis);
      least = std::min(least, along);
      most = std::max(most, along);
    }
  return shape.point + (least + most) / 2 * shape.axis;
}

expected<picked_place> wall_at(const mesh_version& mesh, surface_id id) {
  const auto facets = facets_of(mesh, std::array{id});
  const auto middle = middle_of(mesh, id);
  if (!middle)
    return fail(middle.error());
  const auto shape = fit_wall(mesh, facets, round_walls);
  if (!shape)
    return picked_place{middle->point, {}};
  if (shape->type == wall_shape::kind::plane)
    return picked_place{middle->point, shape->axis};
  return picked_place{middle_of_axis(mesh, facets, *shape), upright(shape->axis)};
}

/// Of several rows all that are arcs of one circle are one.
bool are_one_circle(const std::vector<edge_curve>& curves) {
  const auto& first = curves.front();
  return std::ranges::all_of(curves, [&](const edge_curve& c) {
    return c.type == edge_curve::kind::arc && norm(c.middle - first.middle) < 1e-2 * first.radius &&
           norm(cross(c.direction, first.direction)) < 1e-2;
  });
}

expected<picked_place> edge_at(const mesh_version& mesh, const std::vector<surface_id>& ids) {
  const auto curves = edges_between(mesh, ids[0], ids[1]);
  if (curves.empty())
    return fail(ec::invalid_parameter, "surfaces " + words_of(ids) + " have no edge in common",
                "Name two surfaces that meet");
  if (curves.size() > 1 && !are_one_circle(curves))
    return fail(ec::invalid_parameter,
                "surfaces " + words_of(ids) + " meet in " + std::to_string(curves.size()) +
                  " edges, at " + in_mm(curves[0].middle) + " and " + in_mm(curves[1].middle) +
                  (curves.size() > 2 ? " and others" : ""),
                "Give the numbers of the place that is meant");
  const auto& curve = curves.front();
  picked_place found{curve.middle, curve.direction};
  if (curves.size() == 1) {
    found.polyline = curve.points;
    if (curve.closed)
      found.polyline.push_back(curve.points.front());
  }
  return found;
}

std::set<vertex_id> corners_of_wall(const mesh_version& mesh, surface_id id) {
  std::set<vertex_id> result;
  for (const auto f : facets_of(mesh, std::array{id}))
    result.insert(mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  return result;
}

expected<picked_place> corner_at(const mesh_version& mesh, const std::vector<surface_id>& ids) {
  auto common = corners_of_wall(mesh, ids.front());
  for (const auto id : ids)
    std::erase_if(common,
                  [other = corners_of_wall(mesh, id)](vertex_id v) { return !other.contains(v); });
  if (common.size() != 1)
    return fail(ec::invalid_parameter,
                "surfaces " + words_of(ids) + " meet in " +
                  (common.empty() ? "no point" : std::to_string(common.size()) + " points"),
                "Name three surfaces or more that have one corner in common");
  return picked_place{mesh.position(*common.begin()), {}};
}

}  // namespace

bool is_pick(std::string_view text) {
  const auto plain = trimmed(text);
  return std::ranges::any_of(std::array{wall_word, edge_word, corner_word},
                             [&](const char* word) { return plain.starts_with(word); });
}

std::vector<surface_id> surfaces_of_picks(std::string_view text) {
  std::vector<surface_id> all;
  while (!text.empty()) {
    const auto one = text.substr(0, text.find(';'));
    text.remove_prefix(std::min(text.size(), one.size() + 1));
    if (!is_pick(one))
      continue;
    if (const auto ids = ids_in(one.substr(one.find(':') + 1)))
      all.insert(all.end(), ids->begin(), ids->end());
  }
  return all;
}

expected<picked_place> find_pick(const mesh_version& mesh, std::string_view text) {
  const auto plain = trimmed(text);
  const auto colon = std::min(plain.find(':'), plain.size());
  const auto ids = ids_in(plain.substr(std::min(colon + 1, plain.size())));
  const auto word = plain.substr(0, std::min(colon + 1, plain.size()));
  const bool fits = ids && (word == wall_word   ? ids->size() == 1
                            : word == edge_word ? ids->size() == 2
                                                : word == corner_word && ids->size() >= 3);
  if (!fits)
    return fail(ec::invalid_parameter,
                "\"" + std::string(plain.substr(0, 60)) + "\" names no place",
                "Write surface:12, edge:3,7 or corner:3,7,9");
  for (const auto id : *ids)
    if (!mesh.find_surface(id))
      return fail(ec::surface_not_found,
                  "surface " + std::to_string(id) + " is not in this version of the mesh",
                  "\"tedit info\" lists the surfaces");
  if (word == wall_word)
    return wall_at(mesh, ids->front());
  return word == edge_word ? edge_at(mesh, *ids) : corner_at(mesh, *ids);
}

}  // namespace tedit::ops
