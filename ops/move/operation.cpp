// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/move/move.hpp"

namespace {

using namespace tedit;

class move_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "move";
    d.name = "Move hole or boss";
    d.summary = "Moves a hole, pocket, boss or rib by a vector, or makes a copy of it there.";
    d.version = "1.0.0";
    d.selection.help = "A wall of each hole, or a side of each boss.";
    d.parameters = {
      {"by",
       "By",
       "How far it moves, in the axes of the part.",
       ops::parameter_type::vector,
       "m",
       {},
       {},
       {},
       std::string("0, 0, 0")},
      {"copy",
       "Copy",
       "Leave the one that is there, and make another one.",
       ops::parameter_type::boolean,
       "",
       {},
       {},
       {},
       false},
    };
    d.icon = ops::line_icon(
      R"(<circle cx="7" cy="12" r="3.5" stroke-dasharray="2 2"/><circle cx="17" cy="12" r="3.5"/><path d="M9 5 H15 M13 3 L15 5 L13 7"/>)");
    d.guide =
      "Pick one wall: the rest of the hole or boss is found. A hole is closed where it was and cut "
      "where it goes; a through hole goes through there, too. Its walls keep their numbers, and "
      "so their loads and supports. What shares a side with the rest of the part, as a fin that "
      "runs to the part's end, cannot be moved.";
    d.rank = 12;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const vec3 by = ops::vector_of(values, "by").value_or(vec3{});
    return ops::move_features(mesh, ops::as_set(picked), by, std::get<bool>(values.at("copy")),
                              ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("move", "1.0.0", move_operation)
