// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/remove_surfaces/remove_surfaces.hpp"

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
    return d;
  }

  expected<ops::edit_result> apply(const mesh_version& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::remove_surfaces(mesh, picked.surfaces, std::get<bool>(values.at("exact")), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("remove_surfaces", "1.0.0", remove_surfaces)
