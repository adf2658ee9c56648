// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/thicken/thicken.hpp"

namespace {

using namespace tedit;

class thicken_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "thicken";
    d.name = "Thicken";
    d.summary = "Puts material of a given thickness on flat and round surfaces.";
    d.version = "1.0.0";
    d.selection.help =
      "The flat, cylindrical and conical surfaces to put material on; both halves of a bore.";
    d.parameters = {{"depth",
                     "Thickness",
                     "How much material to put on.",
                     ops::parameter_type::real,
                     "m",
                     1e-9,
                     1.0,
                     {},
                     0.001}};
    return d;
  }

  expected<ops::edit_result> apply(const mesh_version& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::thicken(mesh, ops::as_set(picked), std::get<double>(values.at("depth")), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("thicken", "1.0.0", thicken_operation)
