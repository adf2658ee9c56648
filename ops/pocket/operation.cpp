// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/pocket/pocket.hpp"
#include "ops/shapes/outlines/placed_profile.hpp"

namespace {

using namespace tedit;

class pocket_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "pocket";
    d.name = "Pocket";
    d.summary = "Cuts a round, rectangular, slotted or polygonal pocket into a wall.";
    d.version = "1.3.0";
    d.selection.help = "The wall to cut into, or none where a place is given.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = ops::placed_profile_parameters();
    d.parameters.insert(d.parameters.begin() + 4, {"height",
                                                   "Depth",
                                                   "How deep it goes; 0 goes through all there is.",
                                                   ops::parameter_type::real,
                                                   "m",
                                                   0.0,
                                                   10.0,
                                                   {},
                                                   0.002});
    d.parameters.push_back(ops::at_parameter(
      "Place", "The middle of the profile, on the wall. Empty: the middle of the selected wall."));
    d.parameters.push_back(ops::direction_parameter(
      "direction", "Outward", "The direction that it is cut against. Empty: across the wall."));
    d.parameters.push_back(
      ops::places_parameter("Several at once, all alike: the middle of each profile."));
    d.icon = ops::line_icon(R"(<path d="M3 8 H8 V17 H16 V8 H21"/><path d="M3 8 V20 H21 V8"/>)");
    d.guide =
      "Select the wall and give the place, or take its middle. The floor and the walls of the "
      "pocket are surfaces of their own.";
    d.rank = 28;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::cut_pocket(mesh, picked, values, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("pocket", "1.3.0", pocket_operation)
