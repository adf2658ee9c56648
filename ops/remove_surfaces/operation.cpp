// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/remove_protrusion.hpp"

namespace {

using namespace tedit;

class remove_surfaces final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "remove_surfaces";
    d.name = "Remove boss, rib or fin";
    d.summary = "Takes off what stands on the part and continues the surface under it.";
    d.version = "1.0.0";
    d.selection.help =
      "A surface of the boss, rib or fin; its other sides are found by themselves.";
    d.parameters = {
      {"exact",
       "Exactly the selected surfaces",
       "Do not complete the selection by the other sides, the top and the fillets.",
       ops::parameter_type::boolean,
       "",
       {},
       {},
       {},
       false},
    };
    d.icon = ops::line_icon(
      R"(<path d="M3.5 18.5 H20.5 M8 18.5 V9 H16 V18.5"/><path d="M9.2 4 L14.8 7.5 M14.8 4 L9.2 7.5"/>)");
    d.guide =
      "Pick any one side: the other sides, the top and the fillets that belong to it are found, "
      "and the surface under it runs on. Loads and supports on what is taken off go with it, "
      "unless the form says otherwise.";
    d.rank = 20;
    d.best_for = "protrusion";
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::remove_protrusion(mesh, picked.surfaces, std::get<bool>(values.at("exact")), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("remove_surfaces", "1.0.0", remove_surfaces)
