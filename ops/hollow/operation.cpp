// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/hollow/hollow.hpp"

namespace {

using namespace tedit;

ops::parameter_description length(const std::string& id, const std::string& name,
                                  const std::string& help, double least, double usual) {
  return {id, name, help, ops::parameter_type::real, "m", least, 100.0, {}, usual};
}

class hollow_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "hollow";
    d.name = "Hollow";
    d.summary = "Makes a shell of the part: walls of one thickness, nothing inside.";
    d.version = "1.1.0";
    d.selection.help = "Walls that are left open, or that get a drain hole; or none.";
    d.selection.minimum = 0;
    d.parameters = {
      length("thickness", "Thickness", "Of the walls that stay.", 1e-6, 2e-3),
      length("drain_diameter", "Drain holes",
             "Through the middle of each picked wall; 0: the picked walls are open.", 0, 0),
      {"drain_points",
       "Places for drains",
       "Where more drain holes go, across the wall that is there.",
       ops::parameter_type::polyline,
       "m",
       1.0,
       100.0,
       {},
       std::string()},
      {"region",
       "Region",
       "Of a part with several regions the one that becomes hollow, by name or number. Empty: the "
       "one of the picked walls.",
       ops::parameter_type::text,
       "",
       {},
       {},
       {},
       std::string()}};
    d.icon = ops::line_icon(
      R"(<path d="M4 6 H20 V19 H4 Z"/><path d="M7.5 9.5 H16.5 V15.5 H7.5 Z" stroke-dasharray="2 2"/>)");
    d.guide =
      "Pick the walls that shall be open, as the underside of a cover; or give a diameter for "
      "drain "
      "holes, which powder or resin runs out of. Without either a closed void is left. What is "
      "thinner than two walls stays full. A thin shell takes many tets: they are about as large "
      "as the wall is thick.";
    d.rank = 3;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto walls = ops::as_set(picked);
    const auto settings = ops::hollow_settings_of(*mesh, walls, values);
    if (!settings)
      return fail(settings.error());
    return ops::hollow(mesh, walls, *settings, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("hollow", "1.1.0", hollow_operation)
