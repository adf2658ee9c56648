// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/coarsen/coarsen.hpp"
#include "ops/shapes/mesh_pick.hpp"
#include "ops/tools/placement.hpp"

namespace {

using namespace tedit;

ops::parameter_description length(const std::string& id, const std::string& name,
                                  const std::string& help) {
  return {id, name, help, ops::parameter_type::real, "m", 0.0, 10.0, {}, 0.0};
}

class coarsen_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "coarsen";
    d.name = "Coarsen mesh";
    d.summary = "Makes the mesh coarser at surfaces or around a point; the part keeps its shape.";
    d.version = "1.0.0";
    d.selection.help =
      "The surfaces at which the mesh is to be coarser, or none where a place is given.";
    d.selection.minimum = 0;
    d.parameters = {
      length("size", "Size", "Shorter edges go; 0: twice what they are now."),
      ops::at_parameter("Place", "Coarsens around this place instead of at surfaces."),
      ops::pick_radius_parameter(),
      length("depth", "Depth", "How far from there vertices may go; 0: three times the size."),
      length("tolerance", "Surface tolerance",
             "How far the boundary may be from where it was; 0: a fiftieth of the size."),
    };
    d.icon = ops::line_icon(
      R"(<path d="M3 20 L12 4 L21 20 Z"/><path d="M7.5 12 H16.5 M7.5 12 L12 20 L16.5 12" stroke-dasharray="2 2.4"/>)");
    d.guide =
      "For quicker solutions: takes tets away where little happens. Edges and corners of the part "
      "stay, flat walls stay exactly. Loads stay.";
    d.rank = -9;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto number = [&](const char* id) { return std::get<double>(values.at(id)); };
    return ops::coarsen(mesh, ops::pick_of(picked, values),
                        {number("size"), number("depth"), number("tolerance")}, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("coarsen", "1.0.0", coarsen_operation)
