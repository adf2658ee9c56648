// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/resize_bore/resize_bore.hpp"

namespace {

using namespace tedit;

class resize_bore_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "resize_bore";
    d.name = "Change diameter";
    d.summary = "Gives a round bore or pin another diameter.";
    d.version = "1.0.0";
    d.selection.help = "A wall of each bore or pin; the other half of a wall is found.";
    d.parameters = {
      {"diameter",
       "Diameter",
       "Of the bore or pin afterwards.",
       ops::parameter_type::real,
       "m",
       1e-5,
       100.0,
       {},
       0.01},
    };
    d.icon = ops::line_icon(
      R"(<circle cx="12" cy="12" r="4"/><circle cx="12" cy="12" r="8.5" stroke-dasharray="2 2.4"/><path d="M6 18 L18 6"/>)");
    d.guide =
      "The walls keep their numbers, and so their loads and supports: a bearing seat that becomes "
      "larger carries what it carried. A counterbore or another step of the hole is a wall of its "
      "own. Where the part leaves no room the answer says which diameter can be.";
    d.rank = 14;
    d.best_for = "hole";
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    return ops::resize_bores(mesh, ops::as_set(picked), std::get<double>(values.at("diameter")),
                             ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("resize_bore", "1.0.0", resize_bore_operation)
