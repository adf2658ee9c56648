// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/thin_remains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>

#include "base/number_range.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/distances.hpp"
#include "mesh/place_text.hpp"
#include "ops/boolean/remesh.hpp"

namespace tedit::ops {

namespace {

/// Sides that meet within so many gaps are a wedge, of two degrees or more.
constexpr double wedge_gaps = 30;

/// Cosine from which on two faces look away from each other.
constexpr double opposite = -0.5;

/// Of an edge: what is thinner is worth telling people, but not what is rounding.
constexpr double told_share = 0.1;
constexpr double rounding_share = 1e-4;

/// Sizes grow by so much a length from where it is thin, as `clean_surface` lets them grow.
constexpr double growth = 0.7;

class thin_finder {
public:
  explicit thin_finder(const surface_mesh& mesh)
      : mesh_(mesh), walls_(walls_of(mesh)), tree_(boxes_of(mesh, walls_)) {
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      std::set<std::int32_t> labels;
      for (const auto f : mesh.faces_at(v))
        labels.insert(mesh.faces[f].label);
      for (const auto one : labels)
        for (const auto other : labels)
          if (one < other)
            meetings_[{one, other}].push_back(mesh.vertices[v].position);
    }
  }

  std::vector<thin_place> find() const {
    std::vector<thin_place> result;
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v)
      if (!mesh_.faces_at(v).empty())
        if (const auto place = nearest_behind(v))
          result.push_back(*place);
    return result;
  }

private:
  static std::vector<std::uint32_t> walls_of(const surface_mesh& mesh) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
      if (mesh.faces[f].alive && mesh.faces[f].label != surface_labels::shell)
        result.push_back(f);
    return result;
  }

  static std::vector<box> boxes_of(const surface_mesh& mesh,
                                   const std::vector<std::uint32_t>& walls) {
    std::vector<box> result(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i)
      for (const auto v : mesh.faces[walls[i]].v)
        result[i].add(mesh.vertices[v].position);
    return result;
  }

  [[nodiscard]] vec3 at(std::uint32_t v) const { return mesh_.vertices[v].position; }

  std::optional<thin_place> nearest_behind(std::uint32_t v) const {
    thin_place best{v, 0, {}, thin_share * mesh_.vertices[v].size};
    bool any = false;
    box around;
    around.add(at(v));
    (void)tree_.any_meeting(around.grown(best.gap), [&](std::size_t i) {
      const auto f = walls_[i];
      const auto& t = mesh_.faces[f].v;
      if (t[0] == v || t[1] == v || t[2] == v)
        return false;
      const auto weights = nearest_on_triangle(at(v), at(t[0]), at(t[1]), at(t[2]));
      const vec3 foot = weights[0] * at(t[0]) + weights[1] * at(t[1]) + weights[2] * at(t[2]);
      const double gap = norm(foot - at(v));
      if (gap > 0 && gap < best.gap && is_behind(v, f, (foot - at(v)) / gap) &&
          !is_wedge(v, f, gap)) {
        best = {v, f, foot, gap};
        any = true;
      }
      return false;
    });
    return any ? std::optional(best) : std::nullopt;
  }

  /// Does the way go into the material of a region at v, and out of it at the face?
  [[nodiscard]] bool is_behind(std::uint32_t v, std::uint32_t f, vec3 way) const {
    const auto& far = mesh_.faces[f];
    return std::ranges::any_of(far.sides, [&](auto region) {
      return region >= 0 && leaves(far, region, way) > -opposite &&
             std::ranges::any_of(mesh_.faces_at(v), [&](auto g) {
               const auto& near = mesh_.faces[g];
               return std::ranges::find(near.sides, region) != near.sides.end() &&
                      leaves(near, region, way) < opposite;
             });
    });
  }

  /// Cosine between the way and the normal that points out of the region.
  [[nodiscard]] static double leaves(const surface_mesh::face& f, std::int32_t region, vec3 way) {
    return (f.sides[0] == region ? 1 : -1) * dot(f.normal, way);
  }

  [[nodiscard]] bool is_wedge(std::uint32_t v, std::uint32_t f, double gap) const {
    const auto far = mesh_.faces[f].label;
    return std::ranges::any_of(mesh_.faces_at(v), [&](auto g) {
      const auto near = mesh_.faces[g].label;
      const auto found = meetings_.find({std::min(near, far), std::max(near, far)});
      return found != meetings_.end() && std::ranges::any_of(found->second, [&](vec3 p) {
               return norm(p - at(v)) < wedge_gaps * gap;
             });
    });
  }

  const surface_mesh& mesh_;
  std::vector<std::uint32_t> walls_;  ///< Not those against tets that stay.
  box_tree tree_;
  /// Where two labels meet.
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<vec3>> meetings_;
};

}  // namespace

std::vector<thin_place> thin_places(const surface_mesh& mesh) {
  return thin_finder(mesh).find();
}

std::optional<thin_remain> thinnest(const surface_mesh& mesh, double size) {
  auto places = thin_places(mesh);
  const auto is_new = [&](std::uint32_t v) { return mesh.vertices[v].origin < 0; };
  // What the part had before is nobody's news.
  std::erase_if(places, [&](const thin_place& place) {
    if (place.gap < rounding_share * size)
      return true;
    return !is_new(place.vertex) && std::ranges::none_of(mesh.faces[place.face].v, is_new);
  });
  const auto found = std::ranges::min_element(places, {}, &thin_place::gap);
  if (found == places.end() || found->gap >= told_share * size)
    return std::nullopt;
  return thin_remain{found->gap, found->foot};
}

std::string thickness_text(const thin_remain& thin) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", 1e3 * thin.thickness);
  return text.data();
}

error too_flat(double quality, const std::optional<thin_remain>& thin) {
  if (thin)
    return {ec::postcondition_failed,
            "only " + thickness_text(*thin) + " mm of the part would be left near " +
              place_text(thin->at) + ", too little for good tets (q = " + number_text(quality) +
              ")",
            "Let the tool go through there, or leave more of the part"};
  return {ec::postcondition_failed,
          "the tets around the tool would be too flat (q = " + number_text(quality) + ")",
          "Move the tool a little: something of it nearly meets an edge of the part"};
}

bool shrink_at(surface_mesh& mesh, const std::vector<thin_place>& places, double edges,
               double least) {
  bool any = false;
  const auto shrink = [&](std::uint32_t v, double size) {
    auto& vertex = mesh.vertices[v];
    if (vertex.fixed || size >= 0.95 * vertex.size)
      return;
    vertex.size = size;
    any = true;
  };
  for (const auto& place : places) {
    const double size = std::max(least, edges * place.gap);
    shrink(place.vertex, size);
    for (const auto w : mesh.faces[place.face].v)
      shrink(w, size + growth * norm(mesh.vertices[w].position - place.foot));
  }
  return any;
}

}  // namespace tedit::ops
