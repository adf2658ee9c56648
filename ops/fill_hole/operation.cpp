// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/fill_holes.hpp"

namespace {

using namespace tedit;

class fill_hole final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "fill_hole";
    d.name = "Fill hole";
    d.summary = "Closes holes: through, blind, stepped, in curved walls or closed inside the part.";
    d.version = "1.1.0";
    d.selection.help = "The wall surfaces of one or more holes; bottoms are found by themselves.";
    d.parameters = {
      {"exact",
       "Exactly the selected surfaces",
       "Do not complete the selection by bottoms and inner parts of the hole.",
       ops::parameter_type::boolean,
       "",
       {},
       {},
       {},
       false},
      {"include_entry",
       "Include the entry",
       "Also fill the countersink or counterbore around the hole.",
       ops::parameter_type::boolean,
       "",
       {},
       {},
       {},
       false},
    };
    d.icon = ops::line_icon(
      R"(<circle cx="12" cy="12" r="8.5"/><path d="M7 9.5 L14.5 17 M6.2 13 L11 17.8 M9.5 6.2 L17.8 14.5 M13 5.6 L18.4 11"/>)");
    d.guide =
      "Pick one wall of the hole: what belongs to it is found. A countersink is filled only with "
      "\"Include the entry\". The closed place becomes part of the surface around it where it "
      "continues that one, and is a surface of its own elsewhere.";
    d.rank = 30;
    d.best_for = "hole";
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    completion_settings settings;
    settings.exact = std::get<bool>(values.at("exact"));
    settings.include_entry = std::get<bool>(values.at("include_entry"));
    return ops::fill_holes(mesh, picked.surfaces, settings, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("fill_hole", "1.1.0", fill_hole)
