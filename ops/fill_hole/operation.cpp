// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/fill_hole.hpp"

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
    return d;
  }

  expected<ops::edit_result> apply(const mesh_version& mesh, const ops::selection& picked,
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
