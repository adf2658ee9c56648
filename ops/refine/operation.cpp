// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/refine/refine.hpp"
#include "ops/shapes/mesh_pick.hpp"
#include "ops/tools/placement.hpp"

namespace {

using namespace tedit;

class refine_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "refine";
    d.name = "Refine mesh";
    d.summary = "Makes the mesh finer at surfaces or around a point, graded outwards.";
    d.version = "1.0.0";
    d.selection.help =
      "The surfaces at which the mesh is to be finer, or none where a place is given.";
    d.selection.minimum = 0;
    d.parameters = {
      {"size",
       "Size",
       "Edges there become at most so long; 0: half of what they are now.",
       ops::parameter_type::real,
       "m",
       0.0,
       10.0,
       {},
       0.0},
      ops::at_parameter("Place", "Refines around this place instead of at surfaces."),
      ops::pick_radius_parameter(),
    };
    d.icon = ops::line_icon(
      R"(<path d="M3 20 L12 4 L21 20 Z M7.5 12 H16.5 M7.5 12 L12 20 L16.5 12"/><path d="M9.75 16 H14.25 M9.75 16 L12 12 L14.25 16" stroke-width="1.1"/>)");
    d.guide =
      "For more exact stresses where they change fast: fillets, edges of holes, loads on small "
      "surfaces. The part keeps its shape; on round walls the finer mesh is rounder. Loads stay.";
    d.rank = -8;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::refine(mesh, ops::pick_of(picked, values), std::get<double>(values.at("size")),
                       ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("refine", "1.0.0", refine_operation)
