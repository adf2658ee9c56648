// SPDX-License-Identifier: AGPL-3.0-or-later
// A plugin that asks for other operations: a round boss with a hole through its middle.
#include "ops/tools/placement.hpp"

namespace {

using namespace tedit;

class eyelet final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "eyelet";
    d.name = "Eyelet";
    d.summary = "Puts a round boss on a flat wall and drills a blind hole into its middle.";
    d.version = "1.0.0";
    d.selection = {"The wall, or none where a place is given.", 0, 1};
    d.parameters = {ops::at_parameter("Place", "The middle. Empty: that of the selected wall."),
                    ops::direction_parameter("direction", "Outward", "Empty: across the wall."),
                    {"asks",
                     "Asks",
                     "For the two operations, for itself, or for one that there is not.",
                     ops::parameter_type::choice,
                     {},
                     0,
                     0,
                     {"others", "itself", "nobody"},
                     std::string("others")}};
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto& asks = std::get<std::string>(values.at("asks"));
    if (asks == "itself")
      return ctx.apply_other("eyelet", mesh, picked, values);
    if (asks == "nobody")
      return ctx.apply_other("eyelit", mesh, picked, {});
    const ops::parameters place{{"at", values.at("at")}, {"direction", values.at("direction")}};
    auto boss = place;
    boss.insert({{"profile", std::string("circle")}, {"size", 0.008}, {"height", 0.005}});
    const auto raised = ctx.apply_other("boss", mesh, picked, boss);
    if (!raised)
      return raised;
    auto hole = place;
    hole.insert({{"diameter", 0.004}, {"depth", 0.012}});
    auto drilled = ctx.apply_other("drill", raised->candidate, {}, hole);
    if (!drilled)
      return drilled;
    return ops::followed_by(*raised, std::move(*drilled));
  }
};

}  // namespace

TEDIT_PLUGIN("composing", "1.0.0", eyelet)
