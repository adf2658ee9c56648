// SPDX-License-Identifier: AGPL-3.0-or-later
#include <numbers>

#include "ops/pattern/pattern.hpp"

namespace {

using namespace tedit;
using ops::parameter_type;

ops::parameter_description vector_parameter(const std::string& id, const std::string& name,
                                            const std::string& help) {
  return {id, name, help, parameter_type::vector, "m", {}, {}, {}, std::string("0, 0, 0")};
}

std::vector<ops::parameter_description> pattern_parameters() {
  std::vector<ops::parameter_description> list{
    {"kind",
     "Kind",
     "In rows, around an axis, or mirrored in a plane.",
     parameter_type::choice,
     "",
     {},
     {},
     {"rows", "ring", "mirror"},
     std::string("rows")},
    {"count",
     "Count",
     "How many there are in a row or around the axis in the end, the one that is there included.",
     parameter_type::integer,
     "",
     2.0,
     1000.0,
     {},
     std::int64_t{2}},
    vector_parameter("step", "Step", "Rows: the way from one to the next."),
    {"rows",
     "Rows",
     "How many such rows.",
     parameter_type::integer,
     "",
     1.0,
     1000.0,
     {},
     std::int64_t{1}},
    vector_parameter("row_step", "Step of rows", "The way from one row to the next."),
    {"at",
     "Place",
     "A point of the axis or of the mirror's plane.",
     parameter_type::point,
     "m",
     {},
     {},
     {},
     std::string("0, 0, 0")},
    {"direction",
     "Direction",
     "Of the axis, or across the mirror's plane.",
     parameter_type::direction,
     "",
     {},
     {},
     {},
     std::string("0, 0, 1")},
    {"angle",
     "Angle",
     "Ring: from the first to the last; a whole turn is shared out evenly.",
     parameter_type::real,
     "rad",
     -2 * std::numbers::pi,
     2 * std::numbers::pi,
     {},
     2 * std::numbers::pi},
    {"axis",
     "Axis",
     "Ring: a point of the axis and its direction, or what of the part has them: instead of place "
     "and direction.",
     parameter_type::axis,
     "m",
     {},
     {},
     {},
     std::string()},
    {"plane",
     "Plane",
     "Mirror: a point of the plane and its normal, or what of the part has them: instead of place "
     "and direction.",
     parameter_type::plane,
     "m",
     {},
     {},
     {},
     std::string()},
    {"distances",
     "Distances",
     "Rows: how far each copy is from the one that is there, the way that the step goes: instead "
     "of the count.",
     parameter_type::list,
     "m",
     -10.0,
     10.0,
     {},
     std::string()},
    {"angles",
     "Angles",
     "Ring: where each copy is, from the one that is there on: instead of count and angle.",
     parameter_type::list,
     "rad",
     -2 * std::numbers::pi,
     2 * std::numbers::pi,
     {},
     std::string()},
  };
  return list;
}

class pattern_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "pattern";
    d.name = "Pattern";
    d.summary = "Repeats a hole, pocket, boss or rib in rows, around an axis, or mirrored.";
    d.version = "1.1.0";
    d.selection.help = "A wall of each hole, or a side of each boss.";
    d.parameters = pattern_parameters();
    d.icon = ops::line_icon(
      R"(<circle cx="6" cy="7" r="2.6"/><circle cx="17" cy="7" r="2.6"/><circle cx="6" cy="17" r="2.6"/><circle cx="17" cy="17" r="2.6"/>)");
    d.guide =
      "Pick one wall: the rest of the hole or boss is found. The one that is there counts: a count "
      "of 4 adds three. Where they are not evenly apart, give distances or angles: one for each "
      "copy. "
      "The axis of a ring may be a round wall's, a mirror's plane a flat wall's. A through hole "
      "goes through everywhere. Where one of the copies cannot be, "
      "none is made, and the answer names it.";
    d.rank = 9;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto motions = ops::pattern_motions(values);
    if (!motions)
      return fail(motions.error());
    return ops::repeat_features(mesh, ops::as_set(picked), *motions, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("pattern", "1.1.0", pattern_operation)
