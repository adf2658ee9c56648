// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/refine/refine.hpp"

#include <cmath>

#include "mesh/adapt/split_edges.hpp"
#include "mesh/adapt/wall_places.hpp"
#include "mesh/pieces.hpp"
#include "ops/shapes/mesh_pick.hpp"

namespace tedit::ops {

namespace {

/// Worst radius ratio that is promised, unless it was worse.
constexpr double floor_quality = 0.1;
/// Of the size: how far vertices of flat walls may go where thin facets are mended.
constexpr double mend_share = 1e-6;

/// Two digits of a size that is told may be so much less than the size.
constexpr double rounded_up = 1.06;

std::string count_text(double count) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g million", count / 1e6);
  return text;
}

/// Errors: `invalid_parameter` with the size that would do.
expected<void> check_count(const mesh_version& mesh, const split_settings& settings) {
  const double expected_tets = tets_after_split(mesh, settings);
  const auto most = static_cast<double>(settings.most_tets);
  if (expected_tets <= most)
    return {};
  double high = std::max(settings.size, mean_size(mesh, settings.pick));
  for (int i = 0; i < 60 && tets_after_split(mesh, {settings.pick, high, 0}) > most; ++i)
    high *= 2;
  double low = std::max(settings.size, 1e-6 * high);
  for (int i = 0; i < 10; ++i) {
    const double middle = std::sqrt(low * high);
    (tets_after_split(mesh, {settings.pick, middle, 0}) > most ? low : high) = middle;
  }
  char text[96];
  std::snprintf(text, sizeof(text), "Take a size of %.2g mm or more, or pick less",
                1e3 * rounded_up * high);
  return fail(ec::invalid_parameter,
              "about " + count_text(expected_tets) + " tets would come out; at most " +
                count_text(most) + " are made",
              text);
}

void tell(std::size_t vertices, std::size_t off_walls, double size, edit_result& result) {
  result.figures.push_back({"new_vertices", static_cast<double>(vertices), "", "new vertices"});
  result.figures.push_back({"size_mm", 1e3 * size, "mm", "longest edge at what was picked"});
  if (off_walls > 0)
    result.notices.push_back(std::to_string(off_walls) +
                             " new vertices lie beside their round wall: on it, tets would turn");
}

}  // namespace

expected<edit_result> refine(const version_ptr& mesh, const mesh_pick& pick, double size,
                             context& ctx) {
  if (auto ok = check_pick(*mesh, pick); !ok)
    return fail(ok.error());
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  split_settings settings{pick, size > 0 ? size : mean_size(*mesh, pick) / 2};
  if (auto ok = check_count(*mesh, settings); !ok)
    return fail(ok.error());
  ctx.run.report(0.1, "splitting edges");
  adapt_mesh work(*mesh);
  const auto made = split_edges(*mesh, work, settings, ctx.run);
  if (!made)
    return fail(made.error());
  if (made->vertices == 0)
    return fail(ec::invalid_parameter, "no edge there is longer than " + size_text(settings.size),
                "Take a smaller size");
  ctx.run.report(0.8, "putting the new tets in");
  mesh_builder builder(mesh);
  if (auto written = work.write(builder); !written)
    return fail(written.error().code, written.error().message,
                "Improve the mesh first: improve_mesh");
  if (auto mended = mend_split(builder, mend_share * settings.size, ctx.run); !mended)
    return fail(mended.error());
  edit_result result;
  result.touched = builder.touched();
  result.candidate = builder.freeze();
  result.volume_change = boundary_volume_change(*mesh, *result.candidate);
  result.surfaces_used = pick.surfaces;
  result.quality_floor = floor_quality;
  tell(made->vertices, count_off_walls(*mesh, *result.candidate, result.touched), settings.size,
       result);
  ctx.run.report(1, "refined");
  return result;
}

}  // namespace tedit::ops
