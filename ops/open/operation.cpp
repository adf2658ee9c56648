// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_edges.hpp"

namespace {

using namespace tedit;

class open_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "open";
    d.name = "Round edges";
    d.summary =
      "Rounds outer edges with a radius: takes off what a ball inside the material cannot reach.";
    d.version = "1.0.0";
    d.selection.help =
      "Two or more walls that meet: the convex edges between them; one wall alone: all its convex "
      "edges.";
    d.parameters = ops::round_parameters();
    d.icon = ops::line_icon(
      R"(<path d="M4 20 V13 A8 8 0 0 1 12 5 H20" /><path d="M4 5 V9 M4 5 H8" stroke-dasharray="2 2"/>)");
    d.guide =
      "Use it on sharp outer edges. Pick the walls on both sides of an edge, or one wall for all "
      "its edges. It takes material off; loads and supports on the walls stay.";
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    constexpr double side = -1;  // The ball rolls inside the material.
    return ops::round_edges(mesh, ops::as_set(picked), side, ops::read_round_parameters(values),
                            ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("open", "1.0.0", open_operation)
