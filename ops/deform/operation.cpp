// SPDX-License-Identifier: AGPL-3.0-or-later
#include <charconv>

#include "ops/deform/deform.hpp"
#include "ops/tools/placement.hpp"

namespace {

using namespace tedit;

ops::parameter_description length(const std::string& id, const std::string& name,
                                  const std::string& help, double least, double usual) {
  return {id, name, help, ops::parameter_type::real, "m", least, 10.0, {}, usual};
}

/// "12, 15 -3". Errors: `invalid_parameter` naming what is no number.
expected<std::vector<surface_id>> ids_in(const std::string& text) {
  std::vector<surface_id> result;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    surface_id id = 0;
    const auto [next, code] = std::from_chars(at, end, id);
    if (code != std::errc{} || (next != end && *next != ' ' && *next != ','))
      return fail(ec::invalid_parameter, "parameter stay: that is no list of surfaces",
                  "Give their numbers: stay=12,15");
    result.push_back(id);
    at = next;
  }
  return result;
}

class deform_operation final : public ops::operation {
public:
  ops::operation_description describe() const override {
    using enum ops::parameter_type;
    ops::operation_description d;
    d.id = "deform";
    d.name = "Deform";
    d.summary = "Drags a wall, or a patch around a point; what is around it follows smoothly.";
    d.version = "1.0.0";
    d.selection.help = "The walls to drag together, or none where a place is given.";
    d.selection.minimum = 0;
    ops::parameter_description by;
    by.id = "by";
    by.name = "Way";
    by.help = "How far along each axis, instead of a distance along the wall's normal.";
    by.type = vector;
    by.unit = "m";
    by.default_value = std::string();
    d.parameters = {
      length("distance", "Distance", "Along the wall's normal; negative goes into the part.", -10,
             0.001),
      by,
      ops::at_parameter("Place", "Drags only a patch of the wall around this place."),
      length("radius", "Radius", "Of that patch; 0: about two edges of the mesh.", 0, 0),
      length("reach", "Reach",
             "How far around the part follows; 0: the side of a square as large as what is "
             "dragged, or four edges.",
             0, 0),
      {"keep",
       "What stays",
       "Walls within reach that stay as they are, unless they belong to the edge of what is "
       "dragged.",
       choice,
       "",
       {},
       {},
       {"flat_and_round", "round", "nothing"},
       std::string("flat_and_round")},
      {"stay",
       "Surfaces that stay",
       "Numbers of more surfaces that must stay, such as supports: 12, 15.",
       text,
       "",
       {},
       {},
       {},
       std::string()},
      {"keep_volume",
       "Keep the volume",
       "What is within reach gives way until the part has the volume that it had.",
       boolean,
       "",
       {},
       {},
       {},
       false},
    };
    d.icon = ops::line_icon(
      R"(<path d="M3 17 C8 17 8 8 12 8 C16 8 16 17 21 17"/><path d="M12 6 V2 M9.8 4 L12 2 L14.2 4"/>)");
    d.guide =
      "Walls and their loads keep their names and the mesh its tets: only vertices move. Holes and "
      "flat walls that do not touch what is dragged stay as they are. Where a tet would become too "
      "flat, the largest distance that works is told; with a larger reach more is possible.";
    d.rank = 20;
    return d;
  }

  expected<ops::edit_result> apply(const version_ptr& mesh, const ops::selection& picked,
                                   const ops::parameters& values,
                                   ops::context& ctx) const override {
    const auto number = [&](const char* id) { return std::get<double>(values.at(id)); };
    ops::deform_settings settings;
    settings.at = ops::vector_of(values, "at");
    settings.radius = number("radius");
    settings.distance = number("distance");
    settings.by = ops::vector_of(values, "by");
    settings.reach = number("reach");
    const auto& keep = std::get<std::string>(values.at("keep"));
    settings.kept = keep == "nothing" ? ops::kept_walls::none
                    : keep == "round" ? ops::kept_walls::round
                                      : ops::kept_walls::flat_and_round;
    settings.keep_volume = std::get<bool>(values.at("keep_volume"));
    auto stay = ids_in(std::get<std::string>(values.at("stay")));
    if (!stay)
      return fail(stay.error());
    settings.stay = std::move(*stay);
    return ops::deform(mesh, ops::as_set(picked), settings, ctx);
  }
};

}  // namespace

TEDIT_PLUGIN("deform", "1.0.0", deform_operation)
