// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pocket/pocket.hpp"

#include "base/number_range.hpp"
#include "ops/shapes/outlines/placed_profile.hpp"

namespace tedit::ops {

expected<edit_result> cut_pocket(const version_ptr& mesh, const selection& picked,
                                 const parameters& values, context& ctx) {
  const double depth = std::get<double>(values.at("height"));
  return apply_profile(mesh, picked, values,
                       {boolean_mode::cut, "pocket", largest_number,
                        [&](const placed_profile& what, double radius) {
                          return pocket_span(*mesh, what.where, depth, radius);
                        }},
                       ctx);
}

}  // namespace tedit::ops
