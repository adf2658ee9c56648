// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/plane_cut/plane_cut.hpp"

namespace {

using namespace tedit;

class plane_cut_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "plane_cut";
    d.name = "Cut by a plane";
    d.summary = "Cuts the part along a plane and keeps one side, or both as bodies of their own.";
    d.version = "1.2.0";
    d.selection.help = "A flat wall to cut along, or none where the plane is given.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = {
      ops::at_parameter("Place", "A point of the plane. Empty: the middle of the selected wall."),
      ops::direction_parameter("normal", "Normal",
                               "Which way the plane looks. Empty: as the wall does."),
      {"offset",
       "Offset",
       "How far the plane is moved against its normal.",
       ops::parameter_type::real,
       "m",
       -10.0,
       10.0,
       {},
       0.0},
      {"keep",
       "Keep",
       "Which side stays: below is what the normal points away from; both: in two.",
       ops::parameter_type::choice,
       "",
       {},
       {},
       {"below", "above", "both"},
       std::string("below")},
      {"plane",
       "Plane",
       "A point of the plane and its normal, or what of the part has them: instead of place and "
       "normal.",
       ops::parameter_type::plane,
       "m",
       {},
       {},
       {},
       std::string()},
    };
    d.icon = ops::line_icon(
      R"(<path d="M4 20 V11 L20 5 V20 Z"/><path d="M2 12 L22 4" stroke-dasharray="2 2.4"/>)");
    d.guide =
      "Select a wall and give an offset to cut a slice off, or give any plane by a point and its "
      "normal, or by a wall or a round edge that lies in it. The cut is a surface of its own.";
    d.rank = 10;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto where = ops::placement_of(*mesh, picked, values, "normal", 0);
    if (!where)
      return fail(where.error());
    const vec3 at = where->at - std::get<double>(values.at("offset")) * where->outward;
    const auto& keep = std::get<std::string>(values.at("keep"));
    const auto side = keep == "below"   ? ops::kept_side::below
                      : keep == "above" ? ops::kept_side::above
                                        : ops::kept_side::both;
    return ops::plane_cut(mesh, at, where->outward, side, ops::as_set(picked), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("plane_cut", "1.2.0", plane_cut_operation)
