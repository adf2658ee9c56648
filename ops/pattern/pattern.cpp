// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pattern/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ops/shapes/features/place_copies.hpp"

namespace tedit::ops {

namespace {

/// More copies than this are a mistake in typing.
constexpr int most_copies = 1000;

expected<void> check_count(int copies) {
  if (copies < 1)
    return fail(ec::invalid_parameter, "a pattern of one is what is there already",
                "Give a count of 2 or more");
  if (copies > most_copies)
    return fail(ec::invalid_parameter,
                std::to_string(copies) + " copies are more than the 1000 that one edit makes",
                "Give a smaller count");
  return {};
}

/// Each is another place, none the one of what is there. After `whole` it is the same place again.
expected<void> check_different(std::vector<double> places, double whole) {
  constexpr double nearest = 1e-9;  // m or rad: less than any mesh has.
  places.push_back(0);
  for (auto& one : places)
    one -= whole * std::floor(one / whole + nearest);
  std::ranges::sort(places);
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] - places[i - 1] < nearest)
      return fail(ec::invalid_parameter, "two copies would lie in the same place",
                  "Give each distance or angle once, and none for the one that is there");
  return {};
}

}  // namespace

expected<std::vector<motion>> uneven_motions(const uneven_pattern& rows) {
  const auto count = static_cast<int>(rows.distances.size() + 1) * rows.rows - 1;
  if (auto ok = check_count(count); !ok)
    return fail(ok.error());
  if (auto ok = check_different(rows.distances, 1e6); !ok)
    return fail(ok.error());
  if (norm(rows.step) == 0 || (rows.rows > 1 && norm(rows.row_step) == 0))
    return fail(ec::invalid_parameter, "which way the distances go is not given",
                "Give the step, whose length then means nothing: step=1,0,0");
  std::vector<motion> result;
  const vec3 unit = normalized(rows.step);
  for (int row = 0; row < rows.rows; ++row) {
    if (row > 0)
      result.push_back(shift_by(row * rows.row_step));
    for (const double far : rows.distances)
      result.push_back(shift_by(far * unit + row * rows.row_step));
  }
  return result;
}

expected<std::vector<motion>> angle_motions(vec3 point, vec3 axis,
                                            const std::vector<double>& angles) {
  if (auto ok = check_count(static_cast<int>(angles.size())); !ok)
    return fail(ok.error());
  if (auto ok = check_different(angles, 2 * std::numbers::pi); !ok)
    return fail(ok.error());
  std::vector<motion> result;
  for (const double angle : angles)
    result.push_back(turn_around(point, axis, angle));
  return result;
}

expected<std::vector<motion>> grid_motions(const grid_pattern& grid) {
  if (auto ok = check_count(grid.count * grid.rows - 1); !ok)
    return fail(ok.error());
  if ((grid.count > 1 && norm(grid.step) == 0) || (grid.rows > 1 && norm(grid.row_step) == 0))
    return fail(ec::invalid_parameter, "the copies would lie in the same place",
                "Give the way from one to the next: step_mm=20,0,0");
  std::vector<motion> result;
  for (int row = 0; row < grid.rows; ++row)
    for (int i = 0; i < grid.count; ++i)
      if (row + i > 0)
        result.push_back(shift_by(i * grid.step + row * grid.row_step));
  return result;
}

expected<std::vector<motion>> ring_motions(vec3 point, vec3 axis, int count, double angle) {
  if (auto ok = check_count(count - 1); !ok)
    return fail(ok.error());
  constexpr double whole = 2 * std::numbers::pi;
  const bool all_around = std::abs(angle) > whole * (1 - 1e-6);
  if (angle == 0)
    return fail(ec::invalid_parameter, "the copies would lie in the same place",
                "Give the angle from the first to the last");
  const double step = all_around ? std::copysign(whole, angle) / count : angle / (count - 1);
  std::vector<motion> result;
  for (int i = 1; i < count; ++i)
    result.push_back(turn_around(point, axis, i * step));
  return result;
}

expected<std::vector<motion>> pattern_motions(const parameters& values) {
  const auto number = [&](const char* id) {
    return static_cast<int>(std::get<std::int64_t>(values.at(id)));
  };
  const auto vector = [&](const char* id) { return vector_of(values, id).value_or(vec3{}); };
  const auto& kind = std::get<std::string>(values.at("kind"));
  const auto distances = numbers_of(values, "distances");
  if (kind == "rows" && !distances.empty())
    return uneven_motions({distances, vector("step"), number("rows"), vector("row_step")});
  if (kind == "rows")
    return grid_motions({number("count"), vector("step"), number("rows"), vector("row_step")});
  const axis_value given{vector("at"), normalized(vector("direction"))};
  const auto about = axis_of(values, kind == "ring" ? "axis" : "plane").value_or(given);
  if (kind == "mirror")
    return std::vector{mirror_in(about.point, about.direction)};
  const auto angles = numbers_of(values, "angles");
  if (!angles.empty())
    return angle_motions(about.point, about.direction, angles);
  return ring_motions(about.point, about.direction, number("count"),
                      std::get<double>(values.at("angle")));
}

expected<edit_result> repeat_features(const version_ptr& mesh,
                                      const std::vector<surface_id>& picked,
                                      const std::vector<motion>& motions, context& ctx) {
  const auto features = pick_features(*mesh, picked, ctx);
  if (!features)
    return fail(features.error());
  return place_copies({mesh, mesh}, *features, motions, ctx);
}

}  // namespace tedit::ops
