// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/handle_pose.hpp"

#include "client-qt/model/circle_fit.hpp"
#include "client-qt/model/wall_spot.hpp"

namespace tedit::desktop {

namespace {

using kind = handle::kind;

tool_frame frame_at(const vec3& at, const vec3& outward, const std::optional<vec3>& along,
                    bool is_up) {
  tool_frame f;
  f.at = at;
  f.z = normalized(outward);
  const auto [x, y] = across(f.z);
  f.x = x;
  f.y = y;
  if (!along)
    return f;
  const vec3 flat = normalized(*along - dot(*along, f.z) * f.z);
  if (norm(flat) < 0.5)
    return f;
  f.x = is_up ? cross(flat, f.z) : flat;
  f.y = cross(f.z, f.x);
  return f;
}

/// What is moved or changed as a whole stands at its axis, if it is round.
std::optional<round_wall> round_feature(const handle_plan& plan,
                                        const std::vector<surface_id>& picked,
                                        const client::surface_model& part) {
  const bool of_feature = !plan.takes_wall && (plan.find(kind::ring) || plan.find(kind::way));
  return of_feature ? round_wall_of(part, picked) : std::nullopt;
}

}  // namespace

double number_in(const ops::parameters& values, const std::string& id) {
  const auto found = values.find(id);
  const auto* number = found == values.end() ? nullptr : std::get_if<double>(&found->second);
  return number ? *number : 0;
}

std::string text_in(const ops::parameters& values, const std::string& id) {
  const auto found = values.find(id);
  const auto* words = found == values.end() ? nullptr : std::get_if<std::string>(&found->second);
  return words ? *words : std::string();
}

std::optional<vec3> vector_in(const ops::parameters& values, const std::string& id) {
  if (text_in(values, id).empty())
    return std::nullopt;
  const auto found = ops::vector_of(values, id);
  return found && is_finite(*found) ? found : std::nullopt;
}

half_extents profile_extents(const ops::parameters& values) {
  const auto profile = text_in(values, "profile");
  const double size = number_in(values, "size");
  const double width = number_in(values, "width");
  if (profile == "rectangle")
    return {size / 2, (width > 0 ? width : size) / 2};
  if (profile == "slot")
    return {size / 2, (width > 0 ? width : size / 2) / 2};
  return {size / 2, size / 2};
}

std::optional<handle_pose> pose_of(const handle_plan& plan, const ops::parameters& values,
                                   const std::vector<surface_id>& picked,
                                   const client::surface_model& part,
                                   const std::array<double, 6>& bounds) {
  if (!plan.plane.empty() && !text_in(values, plan.plane).empty())
    return std::nullopt;
  const auto round = round_feature(plan, picked, part);
  auto of_picks = round ? std::optional(wall_spot{round->middle, round->axis}) : std::nullopt;
  if (!round && !picked.empty())
    of_picks = middle_of(part, picked.front());
  const auto* place = plan.find(kind::place);
  const auto given = place ? vector_in(values, place->parameter) : std::nullopt;
  std::optional<wall_spot> spot = of_picks;
  if (given) {
    const auto normal =
      outward_at(part, *given, plan.takes_wall ? picked : std::vector<surface_id>{});
    spot = normal ? std::optional(wall_spot{*given, *normal}) : std::nullopt;
  }
  if (!spot)
    return std::nullopt;
  handle_pose pose;
  pose.bounds = bounds;
  pose.wall_normal = spot->normal;
  pose.feature = of_picks ? of_picks->at : spot->at;
  if (round) {
    pose.axis = round->axis;
    pose.half_length = round->half_length;
  }
  vec3 outward = spot->normal;
  if (const auto* axis = plan.find(kind::direction))
    if (const auto direction = vector_in(values, axis->parameter)) {
      outward = normalized(*direction);
      if (axis->either_way && dot(outward, spot->normal) < 0)
        outward = -outward;
    }
  const auto* turn = plan.find(kind::turn);
  pose.frame = frame_at(spot->at, outward, turn ? vector_in(values, turn->parameter) : std::nullopt,
                        turn && turn->parameter == "up");
  return pose;
}

}  // namespace tedit::desktop
