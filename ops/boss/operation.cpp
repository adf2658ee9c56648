// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boss/boss.hpp"
#include "ops/shapes/outlines/placed_profile.hpp"

namespace {

using namespace tedit;

class boss_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "boss";
    d.name = "Boss";
    d.summary = "Adds a round, rectangular, slotted or polygonal boss to a wall.";
    d.version = "1.3.0";
    d.selection.help = "The wall to put it on, or none where a place is given.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = ops::placed_profile_parameters();
    d.parameters.insert(d.parameters.begin() + 4, {"height",
                                                   "Height",
                                                   "How far it stands out over the place.",
                                                   ops::parameter_type::real,
                                                   "m",
                                                   1e-6,
                                                   10.0,
                                                   {},
                                                   0.005});
    d.parameters.push_back(ops::at_parameter(
      "Place", "The middle of the profile, on the wall. Empty: the middle of the selected wall."));
    d.parameters.push_back(ops::direction_parameter(
      "direction", "Outward", "The direction that it grows in. Empty: across the wall."));
    d.parameters.push_back(
      ops::places_parameter("Several at once, all alike: the middle of each profile."));
    d.icon = ops::line_icon(R"(<path d="M3 20 V14 H8 V6 H16 V14 H21 V20 Z"/>)");
    d.guide =
      "Select the wall and give the place, or take its middle. On curved walls the boss goes down "
      "to the wall all around. Its top and sides are surfaces of their own.";
    d.rank = 29;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::add_boss(mesh, picked, values, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("boss", "1.3.0", boss_operation)
