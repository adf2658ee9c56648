// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sweep/sweep_along.hpp"

namespace {

using namespace tedit;

class sweep_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "sweep";
    d.name = "Sweep";
    d.summary = "Carries a profile along a path: cuts a groove or a channel, or adds a bead.";
    d.version = "1.0.0";
    d.selection.help = "The wall that the profile's height stands on, or none.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = parameters();
    d.icon = ops::line_icon(R"(<path d="M4 18 C10 18 8 8 19 7"/><circle cx="4" cy="18" r="2.2"/>)");
    d.guide =
      "Give the path by its points, or pick an edge of the part to go along. The profile's middle "
      "stays on the path, its corners are mitred; a path that ends where it began is closed. Walls "
      "and ends are surfaces of their own.";
    d.rank = 7;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::sweep_along(mesh, picked, values, ctx);
  }

private:
  static std::vector<ops::parameter_description> parameters() {
    using ops::parameter_type;
    return {
      {"path",
       "Path",
       "Points in the order in which the profile comes by, or an edge of the part.",
       parameter_type::polyline,
       "m",
       2.0,
       1000.0,
       {},
       std::string()},
      {"profile",
       "Profile",
       "What is carried along the path.",
       parameter_type::choice,
       "",
       {},
       {},
       {"circle", "rectangle"},
       std::string("circle")},
      {"size",
       "Size",
       "The circle's diameter, the rectangle's width.",
       parameter_type::real,
       "m",
       1e-6,
       10.0,
       {},
       0.002},
      {"height",
       "Height",
       "Of a rectangle, out of the wall; 0: as its width.",
       parameter_type::real,
       "m",
       0.0,
       10.0,
       {},
       0.0},
      {"mode",
       "Mode",
       "Whether it is cut from the part or added to it.",
       parameter_type::choice,
       "",
       {},
       {},
       {"cut", "add"},
       std::string("cut")},
    };
  }
};

}  // namespace

TEDIT_PLUGIN("sweep", "1.0.0", sweep_operation)
