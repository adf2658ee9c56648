// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/combine/combine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/number_range.hpp"
#include "base/units.hpp"
#include "ops/tools/files/surface_file.hpp"
#include "ops/tools/placement.hpp"

namespace tedit::ops {

namespace {

/// The file's axes where they come to lie: unturned where its z axis stays.
frame frame_of(const combine_settings& s) {
  const vec3 z = normalized(s.direction);
  // Across the shortest way from the z axis to z.
  const vec3 axis = cross({0, 0, 1}, z);
  frame f{s.at, {1, 0, 0}, {0, 1, 0}, z};
  if (const double sine = norm(axis); sine > 1e-12) {
    const vec3 a = axis / sine;
    const auto turned = [&](vec3 v) {
      return z.z * v + sine * cross(a, v) + (1 - z.z) * dot(a, v) * a;
    };
    f.x = turned({1, 0, 0});
    f.y = turned({0, 1, 0});
  } else if (z.z < 0) {
    f.y = {0, -1, 0};
  }
  const vec3 x = std::cos(s.turn) * f.x + std::sin(s.turn) * f.y;
  f.y = cross(z, x);
  f.x = x;
  return f;
}

/// "12 x 30 x 5 mm".
std::string size_text(const box& b) {
  const vec3 d = 1e3 * (b.high - b.low);
  return number_text(d.x) + " x " + number_text(d.y) + " x " + number_text(d.z) + " mm";
}

/// Files have triangles as large as a flat face: tets would have to be as long.
class edge_divider {
public:
  edge_divider(tool_surface& surface, double longest) : surface_(surface), longest_(longest) {}

  /// Halves all longer edges, with both triangles at each; is any left, or are there too many?
  bool divide(std::size_t most_triangles) {
    while (surface_.triangles.size() <= most_triangles) {
      middles_.clear();
      for (const auto& t : surface_.triangles)
        for (int k = 0; k < 3; ++k)
          mark(t[k], t[(k + 1) % 3]);
      if (middles_.empty())
        return true;
      split();
    }
    return false;
  }

private:
  using corners = std::array<std::uint32_t, 3>;

  static std::pair<std::uint32_t, std::uint32_t> key(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
  }

  void mark(std::uint32_t a, std::uint32_t b) {
    const vec3 p = surface_.points[a];
    const vec3 q = surface_.points[b];
    if (a < b && norm(q - p) > longest_) {
      middles_[key(a, b)] = static_cast<std::uint32_t>(surface_.points.size());
      surface_.points.push_back(0.5 * (p + q));
    }
  }

  void split() {
    std::vector<corners> triangles;
    std::vector<std::uint32_t> faces;
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const auto before = triangles.size();
      split(surface_.triangles[i], triangles);
      faces.insert(faces.end(), triangles.size() - before, surface_.faces[i]);
    }
    surface_.triangles = std::move(triangles);
    surface_.faces = std::move(faces);
  }

  /// At one of its middles after the other.
  void split(const corners& t, std::vector<corners>& into) const {
    for (int k = 0; k < 3; ++k) {
      const auto a = t[k];
      const auto b = t[(k + 1) % 3];
      const auto c = t[(k + 2) % 3];
      const auto found = middles_.find(key(a, b));
      if (found == middles_.end() || !is_longest(t, k))
        continue;
      split({a, found->second, c}, into);
      split({found->second, b, c}, into);
      return;
    }
    into.push_back(t);
  }

  /// Of the edges that have a middle.
  [[nodiscard]] bool is_longest(const corners& t, int k) const {
    const auto length = [&](int e) {
      const auto a = t[e];
      const auto b = t[(e + 1) % 3];
      return middles_.contains(key(a, b)) ? norm(surface_.points[b] - surface_.points[a]) : 0;
    };
    return length(k) >= length((k + 1) % 3) && length(k) >= length((k + 2) % 3);
  }

  tool_surface& surface_;
  double longest_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

/// Edges of the file's surface, in those of the part there.
constexpr double longest_share = 1.5;
constexpr std::size_t most_divided = 400'000;

}  // namespace

expected<combine_order> combine_order_of(const parameters& values) {
  const auto& text = std::get<std::string>(values.at("file"));
  if (text.empty())
    return fail(ec::invalid_parameter, "no file was given", "Choose one: file=PATH");
  const auto file = read_attachment(text);
  if (!file)
    return fail(file.error());
  auto surface = read_surface(*file);
  if (!surface)
    return fail(surface.error());
  const auto unit = metres_per_unit(std::get<std::string>(values.at("unit")));
  if (!unit)
    return fail(unit.error());
  combine_settings settings;
  const auto& mode = std::get<std::string>(values.at("mode"));
  settings.mode = mode == "add"   ? boolean_mode::add
                  : mode == "cut" ? boolean_mode::cut
                                  : boolean_mode::keep;
  settings.unit = *unit;
  settings.scale = std::get<double>(values.at("scale"));
  settings.at = vector_of(values, "at").value_or(vec3{});
  settings.direction = vector_of(values, "direction").value_or(vec3{0, 0, 1});
  settings.turn = std::get<double>(values.at("turn"));
  return combine_order{std::move(*surface), settings};
}

std::vector<vec3> placed_points(const tool_surface& surface, const combine_settings& settings) {
  const auto place = frame_of(settings);
  const double scale = settings.unit * settings.scale;
  std::vector<vec3> points;
  points.reserve(surface.points.size());
  for (const auto& p : surface.points)
    points.push_back(place.at(scale * p.x, scale * p.y, scale * p.z));
  return points;
}

expected<edit_result> combine(const version_ptr& mesh, tool_surface surface,
                              const combine_settings& settings,
                              const std::vector<surface_id>& picked, context& ctx) {
  surface.points = placed_points(surface, settings);
  box extent;
  for (const auto& p : surface.points)
    extent.add(p);
  if (const auto part = extent_of(*mesh); !extent.meets(part))
    return fail(ec::empty_selection,
                "the file's surface lies beside the part: it measures " + size_text(extent) +
                  ", the part " + size_text(part),
                "Check its unit, its scale and its place");
  const double size = local_size(*mesh, surface);
  if (!edge_divider(surface, longest_share * size).divide(most_divided))
    return fail(ec::invalid_parameter,
                "the file's surface is so large that it would take more than 400,000 triangles "
                "like those of the part",
                "Check its unit and its scale");
  return apply_tool(mesh, surface, settings.mode, size, picked, ctx);
}

}  // namespace tedit::ops
