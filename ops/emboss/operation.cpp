// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/emboss/emboss.hpp"

namespace {

using namespace tedit;

class emboss_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    using enum ops::parameter_type;
    ops::operation_description d;
    d.id = "emboss";
    d.name = "Emboss text or logo";
    d.summary = "Raises a line of text or a logo from a wall, or sinks it in.";
    d.version = "1.2.0";
    d.selection.help = "The wall to write on, or none where a place is given.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = {
      {"text", "Text", "One line.", text, "", {}, {}, {}, std::string("TEdit")},
      {"size",
       "Letter height",
       "Of capitals; of a logo its longer side, but for a DXF.",
       real,
       "m",
       1e-5,
       1.0,
       {},
       0.005},
      {"height",
       "Height",
       "How far it stands out of the wall; negative is sunk.",
       real,
       "m",
       -1.0,
       1.0,
       {},
       0.0005},
      {"font",
       "Font",
       "Of the letters.",
       choice,
       "",
       {},
       {},
       {"sans", "bold", "serif", "mono"},
       std::string("sans")},
      ops::at_parameter(
        "Place", "The middle of the text, on the wall. Empty: the middle of the selected wall."),
      ops::direction_parameter("up", "Up",
                               "Which way the letters stand. Empty: by the part's "
                               "axes."),
      ops::direction_parameter("direction", "Outward",
                               "The direction that the text looks in. Empty: across the wall."),
      {"wrap",
       "Around round walls",
       "Letters on a selected round wall follow it; else they stand straight on it.",
       boolean,
       "",
       {},
       {},
       {},
       true},
    };
    for (auto& one : ops::outline_file_parameters(
           "A logo instead of the text: the filled shapes of an SVG or the outlines of a DXF."))
      d.parameters.push_back(std::move(one));
    d.icon =
      ops::line_icon(R"(<path d="M4 19 L10 5 L16 19 M6.2 14 H13.8"/><path d="M18 19 H21"/>)");
    d.guide =
      "For names and numbers on flat walls. Letters that are small beside the part's tets make "
      "many small ones: a raised height of about a tenth of the letters does well.";
    d.rank = 20;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto order = ops::emboss_order_of(*mesh, picked, values);
    if (!order)
      return fail(order.error());
    return ops::emboss(mesh, order->where, order->what, ops::as_set(picked), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("emboss", "1.2.0", emboss_operation)
