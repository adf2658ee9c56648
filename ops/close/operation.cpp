// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_edges.hpp"

namespace {

using namespace tedit;

class close_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "close";
    d.name = "Fillet inner corners";
    d.summary =
      "Rounds inner corners with a radius: fills what a ball outside the material cannot reach.";
    d.version = "1.0.0";
    d.selection.help =
      "Two or more walls that meet: the concave edges between them; one wall alone: all its "
      "concave edges.";
    d.parameters = ops::round_parameters();
    d.icon =
      ops::line_icon(R"(<path d="M5 4 V19.5 H20.5"/><path d="M5 10 A9.5 9.5 0 0 0 14.5 19.5"/>)");
    d.guide =
      "Use it where two walls meet in a sharp inner corner: the stress there grows with every "
      "finer mesh, in a fillet it does not. Pick the walls on both sides. A fillet needs room: "
      "where a wall is narrower than it, the edit is refused with the largest radius that works.";
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    constexpr double side = 1;  // The ball rolls in the open space.
    return ops::round_edges(mesh, ops::as_set(picked), side, ops::read_round_parameters(values),
                            ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("close", "1.0.0", close_operation)
