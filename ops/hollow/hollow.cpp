// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/hollow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/number_range.hpp"
#include "base/short_number.hpp"
#include "mesh/checks.hpp"
#include "ops/hollow/shell_field.hpp"
#include "ops/hollow/untangle.hpp"
#include "ops/tools/placement.hpp"
#include "ops/tools/tools.hpp"

namespace tedit::ops {

namespace {

/// How far the void reaches out of an open wall, as a share of the thickness.
constexpr double overlap_share = 0.4;

/// The inside's triangles measure what the part's do, but for very thin or thick walls: as shares
/// of the thickness, and of the part's mean edge. More cells than that make more triangles than
/// anybody waits for.
constexpr double finest_cell = 0.6;
constexpr double coarsest_cell = 1.5;
constexpr double edge_share = 0.7;
constexpr double most_cells = 60'000;
/// How many cells of unit size a surface of unit area runs through.
constexpr double cells_an_area = 1.5;
/// Smaller voids stay full: in cells.
constexpr double least_cells = 8;

/// Where a surface came out that is not clean, the grid is put elsewhere: as shares of a cell that
/// no plane of a part is likely to meet twice.
constexpr std::array<vec3, 4> grids{vec3{0.1317, 0.2719, 0.4133}, vec3{0.5773, 0.7071, 0.8391},
                                    vec3{0.3819, 0.6537, 0.1931}, vec3{0.8147, 0.0437, 0.6121}};

using corner_triples = std::vector<std::array<std::uint32_t, 3>>;

/// All pieces of a surface that hang together and have at least that volume (m^3), as one tool.
struct void_tool {
  tool_surface tool;
  std::size_t pieces = 0;
};

void_tool large_pieces(const closed_surface& all, double least) {
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
  std::map<std::uint32_t, corner_triples> pieces;
  for (const auto& t : all.triangles)
    pieces[find(t[0])].push_back(t);
  void_tool result;
  result.tool.names = {"inside"};
  std::vector<std::uint32_t> place(all.points.size(), no_id);
  for (auto& [of, piece] : pieces) {
    if (enclosed_volume(all.points, piece) < least)
      continue;
    ++result.pieces;
    for (auto t : piece) {
      for (auto& v : t) {
        if (place[v] == no_id) {
          place[v] = static_cast<std::uint32_t>(result.tool.points.size());
          result.tool.points.push_back(all.points[v]);
        }
        v = place[v];
      }
      result.tool.triangles.push_back(t);
      result.tool.faces.push_back(0);
    }
  }
  return result;
}

class hollower {
public:
  hollower(const version_ptr& mesh, const std::vector<surface_id>& picked,
           const hollow_settings& settings, context& ctx)
      : mesh_(mesh),
        picked_(picked),
        settings_(settings),
        ctx_(ctx),
        now_(mesh),
        walls_(walls_of(*mesh, settings.region)) {}

  expected<edit_result> run() {
    if (auto ok = cut_inside(); !ok)
      return fail(ok.error());
    if (settings_.drain_diameter > 0)
      for (const auto wall : picked_)
        if (auto ok = drain_wall(wall); !ok)
          return fail(ok.error());
    for (std::size_t i = 0; i < settings_.drains.size(); ++i)
      if (auto ok = drain_place(settings_.drains[i]); !ok)
        return fail(at_drain(ok.error(), i));
    return result();
  }

private:
  [[nodiscard]] std::vector<surface_id> open_walls() const {
    return settings_.drain_diameter > 0 ? std::vector<surface_id>{} : picked_;
  }

  /// The edge of the grid's cells, m. Errors: `invalid_parameter` where there would be too many.
  expected<double> cell() const {
    const double t = settings_.thickness;
    const double edge = edge_share * local_size(*mesh_, walls_.extent);
    const double size = std::clamp(edge, finest_cell * t, coarsest_cell * t);
    const double least = std::sqrt(cells_an_area * walls_.area / most_cells);
    if (size >= least)
      return size;
    const double thickness = least / (edge >= least ? coarsest_cell : finest_cell);
    return fail(
      ec::invalid_parameter,
      "walls of " + number_text(1e3 * t) +
        " mm are too thin for a part of this size: they would take too many tets",
      "Take a thickness of at least " + number_text(std::ceil(1e4 * thickness) / 10) + " mm");
  }

  expected<void> cut_inside() {
    const auto size = cell();
    if (!size)
      return fail(size.error());
    const shell_field field(*mesh_, walls_, open_walls(), settings_.thickness,
                            overlap_share * settings_.thickness);
    std::optional<error> last;
    for (const auto& shift : grids) {
      const auto inside = inside_of(field, *size, shift);
      last = inside ? cut(*inside) : inside.error();
      if (!last || (last->code != ec::mesher_failed && last->code != ec::postcondition_failed))
        break;
    }
    return last ? expected<void>(fail(*last)) : expected<void>();
  }

  expected<void_tool> inside_of(const shell_field& field, double size, const vec3& shift) {
    isosurface_settings grid;
    grid.extent = walls_.extent.grown(settings_.thickness);
    grid.cell = size;
    grid.shift = shift;
    ctx_.run.report(0.05, "looking for the inside");
    auto contour = isosurface([&](vec3 p) { return field.at(p); }, grid, ctx_.run.part(0.05, 0.3));
    if (!contour)
      return fail(contour.error());
    if (!untangle(*contour))
      return fail(ec::mesher_failed, "the inside's surface passes through itself",
                  "Take another thickness");
    auto inside = large_pieces(contour->surface, least_cells * size * size * size);
    if (inside.pieces == 0)
      return fail(ec::invalid_argument,
                  "nothing of the part is thicker than twice " +
                    number_text(1e3 * settings_.thickness) + " mm",
                  "Take a smaller thickness");
    return inside;
  }

  std::optional<error> cut(const void_tool& inside) {
    const double size = local_size(*mesh_, inside.tool);
    auto made = ctx_.host->boolean(mesh_, inside.tool, {boolean_mode::cut, deviation_share * size},
                                   ctx_.run.part(0.3, 0.9));
    if (!made)
      return made.error();
    now_ = made->candidate;
    change_ = made->volume_change;
    deviation_ = made->deviation;
    voids_ = inside.pieces;
    return std::nullopt;
  }

  expected<void> drain_wall(surface_id wall) {
    const auto middle = middle_of(*mesh_, wall);
    if (!middle)
      return fail(middle.error());
    return drain(*middle, "the middle of surface " + std::to_string(wall));
  }

  /// The place may lie a little off its wall.
  expected<void> drain_place(vec3 place) {
    const auto on = wall_near(*mesh_, place, settings_.thickness / 2);
    if (!on)
      return fail(on.error());
    return drain(*on, "the place");
  }

  [[nodiscard]] error at_drain(error e, std::size_t i) const {
    const auto mm = [](double metres) { return short_number(1e3 * metres, 8); };
    const vec3 p = settings_.drains[i];
    e.message = "drain " + std::to_string(i + 1) + " (" + mm(p.x) + ", " + mm(p.y) + ", " +
                mm(p.z) + " mm): " + e.message;
    return e;
  }

  /// `what`: the place in words.
  expected<void> drain(const wall_middle& at, const std::string& what) {
    const auto* middle = &at;
    const double r = settings_.drain_diameter / 2;
    const auto hits =
      ray_hits(*now_, middle->point - 1e-6 * settings_.thickness * middle->normal, -middle->normal);
    const bool through = hits.size() > 1 && hits.front().leaves;
    const double depth = through ? hits.front().distance + 0.5 * settings_.thickness : 0;
    if (!through || hits.front().distance > 3 * settings_.thickness)
      return fail(ec::invalid_argument, "behind " + what + " lies no hollow",
                  "Take another wall or place for the drain");
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
  region_walls walls_;
  double change_ = 0;
  double deviation_ = 0;
  std::size_t voids_ = 0;
};

}  // namespace

expected<hollow_settings> hollow_settings_of(const mesh_version& mesh,
                                             const std::vector<surface_id>& picked,
                                             const parameters& values) {
  hollow_settings settings;
  settings.thickness = std::get<double>(values.at("thickness"));
  settings.drain_diameter = std::get<double>(values.at("drain_diameter"));
  settings.drains = points_of(values, "drain_points");
  if (!settings.drains.empty() && settings.drain_diameter == 0)
    return fail(ec::invalid_parameter, "places for drain holes are given, and no diameter",
                "Give it: drain_diameter_mm=4");
  const auto region = region_meant(mesh, std::get<std::string>(values.at("region")), picked);
  if (!region)
    return fail(region.error());
  settings.region = *region;
  return settings;
}

expected<edit_result> hollow(const version_ptr& mesh, const std::vector<surface_id>& picked,
                             const hollow_settings& settings, context& ctx) {
  return hollower(mesh, picked, settings, ctx).run();
}

}  // namespace tedit::ops
