// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/erode.hpp"

namespace {

using namespace tedit;

class erode_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "erode";
    d.name = "Erode";
    d.summary = "Takes material off below surfaces: a given depth, or layers of tets.";
    d.version = "2.0.0";
    d.selection.help = "The surfaces to take material off; for a fin its sides, tip and fillets.";
    d.parameters = {
      {"depth",
       "Depth",
       "How much material to take off. 0 takes off layers of tets instead.",
       ops::parameter_type::real,
       "m",
       0.0,
       1.0,
       {},
       0.0005},
      {"layers",
       "Layers of tets",
       "How many layers of tets to take off where the depth is 0. A layer is no length.",
       ops::parameter_type::integer,
       "",
       0.0,
       20.0,
       {},
       std::int64_t{0},
       "depth"},
      {"pieces",
       "Pieces",
       "What becomes of a part that falls apart: the cut is refused, the largest piece of each "
       "body is kept, or all pieces stay.",
       ops::parameter_type::choice,
       "",
       {},
       {},
       {"refuse", "keep_largest", "allow"},
       std::string("refuse")},
    };
    d.icon = ops::line_icon(
      R"(<path d="M4 18 H20 V13 H4 Z"/><path d="M4 9 H20" stroke-dasharray="2 2.4"/><path d="M12 4 V11 M9.4 8.6 L12 11 L14.6 8.6"/>)");
    d.guide =
      "Surfaces of any form move by exactly the depth and keep their names, so loads on them stay. "
      "Beside a neighbour that runs on smoothly a step is left: select it, too, to move both. A "
      "cut "
      "that would split the part is refused unless \"Pieces\" allows it.";
    d.rank = 50;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    ops::erode_settings settings;
    settings.layers = static_cast<int>(std::get<std::int64_t>(values.at("layers")));
    settings.depth = std::get<double>(values.at("depth"));
    const auto& pieces = std::get<std::string>(values.at("pieces"));
    settings.pieces = pieces == "allow"          ? piece_policy::allow
                      : pieces == "keep_largest" ? piece_policy::keep_largest
                                                 : piece_policy::refuse;
    return ops::erode(mesh, ops::as_set(picked), settings, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("erode", "2.0.0", erode_operation)
