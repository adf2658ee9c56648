// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/drill/drill.hpp"

namespace {

using namespace tedit;

ops::parameter_description length(const std::string& id, const std::string& name,
                                  const std::string& help, double least, double usual) {
  return {id, name, help, ops::parameter_type::real, "m", least, 10.0, {}, usual};
}

ops::parameter_description angle(const std::string& id, const std::string& name,
                                 const std::string& help, double least, double usual) {
  return {id, name, help, ops::parameter_type::real, "rad", least, 2.97, {}, usual};
}

class drill_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "drill";
    d.name = "Drill";
    d.summary = "Drills a hole: blind or through, with counterbore, countersink or for a thread.";
    d.version = "1.1.0";
    d.selection.help = "The wall to drill into, or none where a place is given.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = {
      ops::at_parameter(
        "Place", "Where the hole's axis enters the wall. Empty: the middle of the selected wall."),
      ops::direction_parameter("direction", "Axis",
                               "The hole's axis, either way round: it is drilled into the "
                               "material. Empty: across the wall."),
      length("diameter", "Diameter", "Of the hole.", 1e-6, 0.005),
      length("depth", "Depth", "Of its cylinder; 0 goes through all there is.", 0, 0),
      {"thread",
       "For a thread",
       "Takes the core diameter of this metric thread instead.",
       ops::parameter_type::choice,
       "",
       {},
       {},
       ops::threads(),
       std::string("none")},
      angle("tip_angle", "Tip angle", "Of a blind hole's tip; 0 is flat, 118 degrees is usual.", 0,
            0),
      length("counterbore_diameter", "Counterbore", "Its diameter; 0: none.", 0, 0),
      length("counterbore_depth", "Counterbore depth", "From the wall on.", 0, 0),
      length("countersink_diameter", "Countersink", "Its diameter at the wall; 0: none.", 0, 0),
      angle("countersink_angle", "Countersink angle", "Of the whole cone.", 0.17,
            1.5707963267948966),
      ops::places_parameter("Several at once, all alike: where each hole's axis enters a wall."),
    };
    d.icon = ops::line_icon(
      R"(<path d="M4 10 H9 V19 H15 V10 H20"/><path d="M12 3 V14" stroke-dasharray="2 2.4"/>)");
    d.guide =
      "Select the wall and give the place, or take its middle. The hole gets surfaces of its own, "
      "so loads can be put on them. Holes may cut other holes, edges and fillets. "
      "With more places all holes are made, or none.";
    d.rank = 30;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::drill_holes(mesh, picked, values, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("drill", "1.1.0", drill_operation)
