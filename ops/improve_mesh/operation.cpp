// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/improve_mesh/improve_mesh.hpp"

namespace {

using namespace tedit;

class improve_mesh final : public ops::operation {
public:
  ops::operation_description describe() const override {
    using enum ops::parameter_type;
    ops::operation_description d;
    d.id = "improve_mesh";
    d.name = "Improve mesh";
    d.summary = "Gives the tets a better shape: the worst first, then all of them.";
    d.version = "1.0.0";
    d.selection.help = "Surfaces whose surroundings are improved; none: the whole mesh.";
    d.selection.minimum = 0;
    const thorough_settings defaults;
    d.parameters = {
      {"surface_tolerance",
       "Surface tolerance",
       "How far the boundary may move, to mend tets on thin boundary triangles. 0 keeps it as it "
       "is.",
       real,
       "m",
       0.0,
       1.0,
       {},
       0.0},
      {"harmonic",
       "Smooth the whole mesh",
       "Also lower the harmonic energy, which evens out all tets; without, only bad ones change.",
       boolean,
       "",
       {},
       {},
       {},
       true},
      {"target",
       "Target quality",
       "Tets with a radius ratio (3 r_in / R_circ) below this are lifted, worst first.",
       real,
       "",
       0.0,
       1.0,
       {},
       defaults.target},
    };
    d.icon = ops::line_icon(
      R"(<path d="M4 18.5 L12 5 L20 18.5 Z M12 5 V18.5 M8 11.8 L12 18.5 L16 11.8"/>)");
    d.guide =
      "Edits improve what they touch by themselves: use this for a mesh that came with bad tets. "
      "Without a selection all of it is improved, which takes some seconds. The part keeps its "
      "shape, unless a tolerance is given.";
    d.rank = -10;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    thorough_settings settings;
    settings.tolerance.absolute = std::get<double>(values.at("surface_tolerance"));
    settings.harmonic = std::get<bool>(values.at("harmonic"));
    settings.target = std::get<double>(values.at("target"));
    settings.insert_below = std::min(settings.insert_below, settings.target);
    return ops::improve_mesh(mesh, picked, settings, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("improve_mesh", "1.0.0", improve_mesh)
