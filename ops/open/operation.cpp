// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sdk/round_edges.hpp"

namespace {

using namespace tedit;

class open_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "open";
    d.name = "Round edges";
    d.summary =
      "Rounds outer edges with a radius: takes off what a ball inside the material cannot reach.";
    d.version = "1.0.0";
    d.selection.help =
      "Two or more walls that meet: the convex edges between them; one wall alone: all its convex "
      "edges.";
    d.parameters = {
      {"radius",
       "Radius",
       "Radius of the ball that rolls along both walls.",
       ops::parameter_type::real,
       "m",
       1e-9,
       10.0,
       {},
       0.002},
      {"segments",
       "Segments",
       "Facets over an arc of 90 degrees, at least; where the mesh is finer there are more.",
       ops::parameter_type::integer,
       "",
       2.0,
       12.0,
       {},
       std::int64_t{4}},
    };
    return d;
  }

  expected<ops::edit_result> apply(const mesh_version& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    ops::round_settings settings;
    settings.radius = std::get<double>(values.at("radius"));
    settings.segments = static_cast<int>(std::get<std::int64_t>(values.at("segments")));
    constexpr double side = -1;  // The ball rolls inside the material.
    return ops::round_edges(mesh, ops::as_set(picked), side, settings, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("open", "1.0.0", open_operation)
