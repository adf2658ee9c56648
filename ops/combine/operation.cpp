// SPDX-License-Identifier: AGPL-3.0-or-later
#include <numbers>

#include "ops/combine/combine.hpp"

namespace {

using namespace tedit;
using ops::parameter_type;

std::vector<ops::parameter_description> combine_parameters() {
  std::vector<ops::parameter_description> list{
    {"file",
     "File",
     "The shape: STL, OBJ, OFF, PLY or MSH.",
     parameter_type::file,
     "",
     {},
     {},
     {},
     std::string()},
    {"mode",
     "What to do",
     "add: unite both; cut: take it off the part; intersect: keep what both have.",
     parameter_type::choice,
     "",
     {},
     {},
     {"add", "cut", "intersect"},
     std::string("add")},
    {"at",
     "Place",
     "Where the file's origin comes to lie.",
     parameter_type::point,
     "m",
     {},
     {},
     {},
     std::string("0, 0, 0")},
    {"direction",
     "Direction",
     "Where the file's z axis points.",
     parameter_type::direction,
     "",
     {},
     {},
     {},
     std::string("0, 0, 1")},
    {"turn",
     "Turn",
     "About that direction.",
     parameter_type::real,
     "rad",
     -2 * std::numbers::pi,
     2 * std::numbers::pi,
     {},
     0.0},
    {"scale",
     "Scale",
     "How much larger than in the file.",
     parameter_type::real,
     "",
     1e-6,
     1e6,
     {},
     1.0},
    {"unit",
     "Unit",
     "Of the file's numbers: most formats do not say.",
     parameter_type::choice,
     "",
     {},
     {},
     {"mm", "cm", "m", "in"},
     std::string("mm")},
  };
  return list;
}

class combine_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "combine";
    d.name = "Combine with a file";
    d.summary = "Unites the part with the shape in a file, cuts it off, or keeps what both share.";
    d.version = "1.0.0";
    d.selection.help = "Nothing.";
    d.selection.minimum = 0;
    d.selection.maximum = 1;
    d.parameters = combine_parameters();
    d.icon = ops::line_icon(
      R"(<circle cx="9" cy="10" r="5.5"/><rect x="10" y="10" width="10" height="10"/>)");
    d.guide =
      "Takes closed surfaces: STL, OBJ, OFF, PLY, or a Gmsh mesh, of at most 4 MiB. The file's "
      "axes "
      "are those of the part unless a direction is given. Its faces become surfaces of the part, "
      "divided at edges of more than 30 degrees. The file's content is kept with the edit.";
    d.rank = 4;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    auto order = ops::combine_order_of(values);
    if (!order)
      return fail(order.error());
    return ops::combine(mesh, std::move(order->surface), order->settings, ops::as_set(picked), ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("combine", "1.0.0", combine_operation)
