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
    d.icon = ops::line_icon(
      R"(<path d="M4 19 H20 V14 H4 Z"/><path d="M4 9 H20" stroke-dasharray="2 2.4"/><path d="M12 11.4 V4.6 M9.4 7 L12 4.6 L14.6 7"/>)");
    d.guide =
      "The surfaces keep their names, so loads and supports on them stay. Pick both halves of a "
      "bore together. Where something is in the way, the edit is refused with the greatest "
      "thickness that works.";
    d.rank = 40;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::thicken(mesh, ops::as_set(picked), std::get<double>(values.at("depth")), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("thicken", "1.0.0", thicken_operation)
