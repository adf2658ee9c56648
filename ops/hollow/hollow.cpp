// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/hollow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/number_range.hpp"
#include "mesh/checks.hpp"
#include "ops/hollow/shell_field.hpp"
#include "ops/tools/placement.hpp"
#include "ops/tools/tools.hpp"

namespace tedit::ops {

namespace {

/// Cells of the grid a wall thickness; and how far the void reaches out of an open wall, both as
/// shares of the thickness.
constexpr double cell_share = 0.6;
constexpr double overlap_share = 0.4;

/// Where a surface came out that is not clean, the grid is put elsewhere: as shares of a cell that
/// no plane of a part is likely to meet twice.
constexpr std::array<vec3, 4> grids{vec3{0.1317, 0.2719, 0.4133}, vec3{0.5773, 0.7071, 0.8391},
                                    vec3{0.3819, 0.6537, 0.1931}, vec3{0.8147, 0.0437, 0.6121}};

double volume_of(const closed_surface& s) {
  double sum = 0;
  const vec3 o = s.points.front();
  for (const auto& t : s.triangles)
    sum += dot(s.points[t[0]] - o, cross(s.points[t[1]] - o, s.points[t[2]] - o));
  return sum / 6;
}

/// The pieces of a surface that hang together, of at least that volume (m^3).
std::vector<closed_surface> large_pieces(const closed_surface& all, double least) {
  std::vector<std::uint32_t> root(all.points.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::uint32_t p) {
    while (root[p] != p)
      p = root[p] = root[root[p]];
    return p;
  };
  for (const auto& t : all.triangles)
    for (int k = 1; k < 3; ++k)
      root[find(t[k])] = find(t[0]);
  std::map<std::uint32_t, closed_surface> pieces;
  std::vector<std::uint32_t> place(all.points.size(), no_id);
  for (const auto& t : all.triangles) {
    auto& piece = pieces[find(t[0])];
    auto& to = piece.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      if (place[t[k]] == no_id) {
        place[t[k]] = static_cast<std::uint32_t>(piece.points.size());
        piece.points.push_back(all.points[t[k]]);
      }
      to[k] = place[t[k]];
    }
  }
  std::vector<closed_surface> result;
  for (auto& [of, piece] : pieces)
    if (volume_of(piece) >= least)
      result.push_back(std::move(piece));
  return result;
}

tool_surface as_tool(closed_surface surface) {
  tool_surface tool;
  tool.points = std::move(surface.points);
  tool.triangles = std::move(surface.triangles);
  tool.faces.assign(tool.triangles.size(), 0);
  tool.names = {"inside"};
  return tool;
}

class hollower {
public:
  hollower(const version_ptr& mesh, const std::vector<surface_id>& picked,
           const hollow_settings& settings, context& ctx)
      : mesh_(mesh), picked_(picked), settings_(settings), ctx_(ctx), now_(mesh) {}

  expected<edit_result> run() {
    if (auto ok = cut_inside(); !ok)
      return fail(ok.error());
    if (settings_.drain_diameter > 0)
      for (const auto wall : picked_)
        if (auto ok = drain(wall); !ok)
          return fail(ok.error());
    return result();
  }

private:
  [[nodiscard]] std::vector<surface_id> open_walls() const {
    return settings_.drain_diameter > 0 ? std::vector<surface_id>{} : picked_;
  }

  expected<void> cut_inside() {
    const shell_field field(*mesh_, open_walls(), settings_.thickness,
                            overlap_share * settings_.thickness);
    std::optional<error> last;
    for (const auto& shift : grids) {
      const auto surface = inside_of(field, shift);
      if (!surface)
        return fail(surface.error());
      last = cut_pieces(*surface);
      if (!last || last->code == ec::cancelled)
        break;
    }
    return last ? expected<void>(fail(*last)) : expected<void>();
  }

  expected<std::vector<closed_surface>> inside_of(const shell_field& field, const vec3& shift) {
    const double cell = cell_share * settings_.thickness;
    isosurface_settings grid;
    grid.extent = extent_of(*mesh_).grown(settings_.thickness);
    grid.cell = cell;
    grid.shift = shift;
    ctx_.run.report(0.05, "looking for the inside");
    const auto surface =
      isosurface([&](vec3 p) { return field.at(p); }, grid, ctx_.run.part(0.05, 0.3));
    if (!surface)
      return fail(surface.error());
    auto pieces = surface->triangles.empty() ? std::vector<closed_surface>{}
                                             : large_pieces(*surface, 8 * cell * cell * cell);
    if (pieces.empty())
      return fail(ec::invalid_argument,
                  "nothing of the part is thicker than twice " +
                    number_text(1e3 * settings_.thickness) + " mm",
                  "Take a smaller thickness");
    return pieces;
  }

  /// All or none of them.
  std::optional<error> cut_pieces(const std::vector<closed_surface>& pieces) {
    auto next = mesh_;
    double change = 0;
    double deviation = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto tool = as_tool(pieces[i]);
      const double size = local_size(*mesh_, tool);
      const auto share = [&](std::size_t n) {
        return 0.3 + 0.6 * double(n) / double(pieces.size());
      };
      const auto made = ctx_.host->boolean(next, tool, {boolean_mode::cut, deviation_share * size},
                                           ctx_.run.part(share(i), share(i + 1)));
      if (!made)
        return made.error();
      next = made->candidate;
      change += made->volume_change;
      deviation = std::max(deviation, made->deviation);
    }
    now_ = next;
    change_ = change;
    deviation_ = deviation;
    voids_ = pieces.size();
    return std::nullopt;
  }

  expected<void> drain(surface_id wall) {
    const auto middle = middle_of(*mesh_, wall);
    if (!middle)
      return fail(middle.error());
    const double r = settings_.drain_diameter / 2;
    const auto hits =
      ray_hits(*now_, middle->point - 1e-6 * settings_.thickness * middle->normal, -middle->normal);
    const bool through = hits.size() > 1 && hits.front().leaves;
    const double depth = through ? hits.front().distance + 0.5 * settings_.thickness : 0;
    if (!through || hits.front().distance > 3 * settings_.thickness)
      return fail(ec::invalid_argument,
                  "behind the middle of surface " + std::to_string(wall) + " lies no hollow",
                  "Pick another wall for the drain");
    box near;
    near.add(middle->point);
    const double size = std::min(local_size(*mesh_, near.grown(r)), 0.4 * r);
    const double above =
      clearance(*now_, middle->point, middle->normal, r) + 0.5 * settings_.thickness;
    const auto tool = revolve(
      make_frame(middle->point, middle->normal),
      {{0, above, ""}, {r, above, "top"}, {r, -depth, "drain"}, {0, -depth, "end"}}, 24, size);
    const auto made = ctx_.host->boolean(now_, tool, {boolean_mode::cut, deviation_share * size},
                                         ctx_.run.part(0.9, 1));
    if (!made)
      return fail(made.error());
    now_ = made->candidate;
    change_ += made->volume_change;
    deviation_ = std::max(deviation_, made->deviation);
    return {};
  }

  expected<edit_result> result() const {
    edit_result done;
    done.candidate = now_;
    done.touched = changed_tets(*mesh_, *now_);
    done.volume_change = change_;
    done.improve = improvement::none;  // The booleans have done it.
    done.quality_floor = lowest_boolean_quality;
    done.surfaces_used = picked_;
    const auto before = boundary_components(*mesh_);
    const auto after = boundary_components(*now_);
    if (after > before) {
      const auto closed = after - before;
      if (closed > voids_)
        return fail(ec::invalid_argument, "the part would fall into pieces",
                    "Take a larger thickness, or open other walls");
      done.bodies_added = closed;
      done.notices.push_back((closed == 1 ? std::string("a closed void is")
                                          : std::to_string(closed) + " closed voids are") +
                             " left inside; pick walls for drains, or walls to leave open");
    }
    done.figures = {{"hollow_mm3", -1e9 * change_, "mm3", "taken out"},
                    {"voids", static_cast<double>(voids_), "", "hollow spaces"},
                    {"deviation_mm", 1e3 * deviation_, "mm", "furthest off what was asked for"}};
    return done;
  }

  const version_ptr& mesh_;
  const std::vector<surface_id>& picked_;
  const hollow_settings& settings_;
  context& ctx_;
  version_ptr now_;
  double change_ = 0;
  double deviation_ = 0;
  std::size_t voids_ = 0;
};

}  // namespace

expected<edit_result> hollow(const version_ptr& mesh, const std::vector<surface_id>& picked,
                             const hollow_settings& settings, context& ctx) {
  return hollower(mesh, picked, settings, ctx).run();
}

}  // namespace tedit::ops
