// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boss/boss.hpp"

#include "ops/shapes/outlines/placed_profile.hpp"

namespace tedit::ops {

expected<edit_result> add_boss(const version_ptr& mesh, const selection& picked,
                               const parameters& values, context& ctx) {
  const double height = std::get<double>(values.at("height"));
  return apply_profile(mesh, picked, values,
                       {boolean_mode::add, "boss", 3 * height,
                        [&](const placed_profile& what, double radius) {
                          return boss_span(*mesh, what.where, height, radius);
                        }},
                       ctx);
}

}  // namespace tedit::ops
