// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/rib/rib.hpp"
#include "ops/tools/placement.hpp"

namespace {

using namespace tedit;

ops::parameter_description length(const std::string& id, const std::string& name,
                                  const std::string& help, double usual) {
  return {id, name, help, ops::parameter_type::real, "m", 1e-6, 10.0, {}, usual};
}

class rib_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "rib";
    d.name = "Rib";
    d.summary = "Adds a rib between two walls: in their corner, or from one to the other.";
    d.version = "1.0.0";
    d.selection.help = "The two walls.";
    d.selection.minimum = 2;
    d.selection.maximum = 2;
    d.parameters = {
      length("thickness", "Thickness", "Of the rib.", 0.002),
      length("size", "Size",
             "Of its legs along the walls of a corner; between walls that face each other, how "
             "high it is.",
             0.01),
      ops::at_parameter("Place",
                        "A point in the middle of the rib's thickness. Empty: between the walls' "
                        "middles."),
      ops::direction_parameter(
        "direction", "Direction",
        "Along walls that face each other: which way the rib's height goes."),
    };
    d.icon = ops::line_icon(R"(<path d="M5 4 V19 H20"/><path d="M5 8 L16 19"/>)");
    d.guide =
      "Pick two walls of an inner corner, as those of a bracket, for a triangular rib; or two "
      "walls "
      "that face each other for a plate between them. Its sides are surfaces of their own.";
    d.rank = 8;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::add_rib(mesh, ops::as_set(picked), ops::rib_shape_of(values), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("rib", "1.0.0", rib_operation)
