// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/outline_file.hpp"

#include <algorithm>

#include "base/short_number.hpp"

namespace tedit::ops {

namespace {

// As the parameter "size" of a profile.
constexpr double least_side = 1e-6;  // m
constexpr double most_side = 10;     // m

/// A closed outline's corners: the last one, where it began, is left out.
std::vector<point2> corners_of(const std::vector<plane_curve>& loop, double edge,
                               std::size_t most) {
  std::vector<point2> corners{point_of(loop.front(), 0)};
  for (const auto& curve : loop)
    append_corners(curve, edge, most, corners);
  corners.pop_back();
  return corners;
}

expected<void> check_corners(const dxf_drawing& drawing,
                             const std::vector<std::vector<point2>>& outlines) {
  for (const auto& one : outlines)
    if (one.size() < 3)
      return fail(ec::bad_input,
                  "an outline of the drawing encloses nothing at " + place_text(drawing, one[0]),
                  "Leave it out: put it on a layer that is frozen or off");
  if (const auto met = first_crossing(outlines))
    return fail(ec::bad_input,
                "outlines of the drawing cross or touch at " + place_text(drawing, *met),
                "Draw each outline once, without crossings, a little apart from others");
  return {};
}

}  // namespace

expected<outline_file> outline_file::read(attachment file, double scale) {
  outline_file result;
  result.file_ = std::move(file);
  if (!is_drawing_file(result.file_.bytes))
    return result;
  auto drawing = read_dxf(result.file_);
  if (!drawing)
    return fail(drawing.error());
  auto joined = join_outlines(*drawing);
  if (!joined)
    return fail(joined.error());
  result.drawing_ = std::move(*drawing);
  result.joined_ = std::move(*joined);
  result.scale_ = scale * result.drawing_->metres_per_unit;
  const double side = result.longer_side(0);
  if (!(side >= least_side) || !(side <= most_side))
    return fail(
      ec::invalid_parameter,
      "the drawing is " + short_number(side, 8) + " m long; a profile has 0.000001 to 10 m",
      "Give the scale that its unit lacks: scale=0.001");
  return result;
}

double outline_file::longer_side(double wanted) const {
  return drawing_ ? scale_ * joined_.box.longer_side() : wanted;
}

expected<profile> outline_file::outlines(double size, double edge) const {
  if (!drawing_)
    return svg_outlines(file_, size, edge);
  const double longest = joined_.box.longer_side();
  std::vector<std::vector<point2>> outlines;
  std::size_t left = most_drawn;
  for (const auto& loop : joined_.loops) {
    outlines.push_back(corners_of(loop, edge * longest / size, left));
    if (outlines.back().size() >= left)
      return fail(ec::bad_input, file_.name + " has too many curves for its size",
                  "Simplify it, or make it smaller");
    left -= outlines.back().size();
  }
  if (auto ok = check_corners(*drawing_, outlines); !ok)
    return fail(ok.error());
  const point2 middle = joined_.box.middle();
  profile result;
  for (auto& points : outlines) {
    for (auto& p : points)
      p = {size / longest * (p[0] - middle[0]), size / longest * (p[1] - middle[1])};
    const auto side = static_cast<std::uint32_t>(result.sides.size());
    result.sides.push_back(outlines.size() == 1 ? "side" : "side " + std::to_string(side + 1));
    result.outlines.push_back({std::move(points), {}});
    result.outlines.back().side.assign(result.outlines.back().points.size(), side);
  }
  return result;
}

std::vector<std::string> outline_file::notices() const {
  if (!drawing_)
    return {};
  auto all = drawing_->notices;
  if (joined_.repeated > 0)
    all.push_back(std::to_string(joined_.repeated) +
                  " lines of the drawing are there twice and count once");
  return all;
}

expected<void> check_drawn_edges(const outline_file& file, const profile& shape,
                                 const placement& where) {
  double least = where.size;
  if (file.is_drawing())
    for (const auto& one : shape.outlines)
      least = std::min(least, shortest_edge(one.points));
  return check_fineness(where, least, 0);
}

expected<edit_result> with_notices(expected<edit_result> made,
                                   const std::vector<std::string>& notices) {
  if (made)
    made->notices.insert(made->notices.end(), notices.begin(), notices.end());
  return made;
}

expected<outline_file> outline_file_of(const parameters& values) {
  const auto& text = std::get<std::string>(values.at("file"));
  if (text.empty())
    return fail(ec::invalid_parameter, "the profile is to come from a file, and none was given",
                "Choose one: file=PATH");
  auto file = read_attachment(text);
  if (!file)
    return fail(file.error());
  return outline_file::read(std::move(*file), std::get<double>(values.at("scale")));
}

std::vector<parameter_description> outline_file_parameters(const std::string& help) {
  parameter_description file;
  file.id = "file";
  file.name = "File";
  file.help = help;
  file.type = parameter_type::file;
  file.choices = {"svg", "dxf"};
  file.default_value = std::string();
  return {file,
          {"scale",
           "Scale",
           "Of a DXF, which is as large as it is drawn: 25.4 for one in inches that does not say "
           "so.",
           parameter_type::real,
           "",
           1e-3,
           1e3,
           {},
           1.0}};
}

std::vector<parameter_description> profiles_with_file() {
  auto list = profile_parameters();
  list.front().choices.emplace_back("file");
  list[1].help =
    "The circle's and the polygon's diameter, the longer side of all others but a DXF.";
  for (auto& one : outline_file_parameters(
         "For the profile \"file\": the filled shapes of an SVG or the outlines of a DXF."))
    list.push_back(std::move(one));
  return list;
}

}  // namespace tedit::ops
