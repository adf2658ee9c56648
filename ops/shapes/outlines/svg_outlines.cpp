// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/svg_outlines.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "ops/shapes/outlines/svg_path.hpp"

namespace tedit::ops {

namespace {

constexpr int most_depth = 64;
constexpr std::size_t most_edges = 20'000;

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> result;
  while (true) {
    const auto next = text.find_first_of("+-.0123456789");
    if (next == std::string_view::npos)
      return result;
    text.remove_prefix(text[next] == '+' ? next + 1 : next);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{})
      return result;
    result.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

affine step_of(std::string_view name, const std::vector<double>& v) {
  const auto at = [&](std::size_t i, double otherwise) { return i < v.size() ? v[i] : otherwise; };
  const double angle = at(0, 0) * std::numbers::pi / 180;
  if (name == "matrix" && v.size() == 6)
    return {v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate")
    return {1, 0, 0, 1, at(0, 0), at(1, 0)};
  if (name == "scale")
    return {at(0, 1), 0, 0, at(1, at(0, 1)), 0, 0};
  if (name == "rotate") {
    const affine turn{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
    return affine{1, 0, 0, 1, at(1, 0), at(2, 0)}.of(turn).of({1, 0, 0, 1, -at(1, 0), -at(2, 0)});
  }
  if (name == "skewX")
    return {1, 0, std::tan(angle), 1, 0, 0};
  if (name == "skewY")
    return {1, std::tan(angle), 0, 1, 0, 0};
  return {};
}

affine transform_of(std::string_view text) {
  affine result;
  while (true) {
    const auto open = text.find('(');
    const auto close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return result;
    auto name = text.substr(0, open);
    const auto first = name.find_first_not_of(" \t\r\n,");
    name = first == std::string_view::npos ? std::string_view{} : name.substr(first);
    name = name.substr(0, name.find_last_not_of(" \t\r\n") + 1);
    result = result.of(step_of(name, numbers_in(text.substr(open + 1, close - open - 1))));
    text.remove_prefix(close + 1);
  }
}

double length_of(const pugi::xml_node& node, const char* name) {
  const auto found = numbers_in(node.attribute(name).as_string());
  return found.empty() ? 0 : found.front();
}

/// Whether an element is drawn and filled, where its parent is.
bool is_filled(const pugi::xml_node& node, bool parent) {
  const std::string_view style = node.attribute("style").as_string();
  const auto without_blanks = [&] {
    std::string text(style);
    std::erase(text, ' ');
    return text;
  }();
  if (std::string_view(node.attribute("display").as_string()) == "none" ||
      without_blanks.find("display:none") != std::string::npos)
    return false;
  const std::string_view fill = node.attribute("fill").as_string();
  if (const auto at = without_blanks.find("fill:"); at != std::string::npos)
    return without_blanks.compare(at, 9, "fill:none") != 0;
  return fill.empty() ? parent : fill != "none";
}

std::string number(double value) {
  std::array<char, 32> text{};
  const auto [end, code] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

/// A shape other than a path, as a path.
std::string path_of_ellipse(double cx, double cy, double rx, double ry) {
  const auto arc = [&](double to) {
    return " A " + number(rx) + " " + number(ry) + " 0 0 1 " + number(to) + " " + number(cy);
  };
  return "M " + number(cx - rx) + " " + number(cy) + arc(cx + rx) + arc(cx - rx) + " Z";
}

std::string path_of(const pugi::xml_node& node) {
  const std::string_view kind = node.name();
  const auto length = [&](const char* name) { return length_of(node, name); };
  if (kind == "path")
    return node.attribute("d").as_string();
  if (kind == "circle")
    return path_of_ellipse(length("cx"), length("cy"), length("r"), length("r"));
  if (kind == "ellipse")
    return path_of_ellipse(length("cx"), length("cy"), length("rx"), length("ry"));
  if (kind == "polygon" || kind == "polyline")
    return "M " + std::string(node.attribute("points").as_string()) + " Z";
  if (kind != "rect")
    return {};
  const double w = length("width");
  const double h = length("height");
  const bool round = node.attribute("rx") || node.attribute("ry");
  const double rx = std::min(w / 2, node.attribute("rx") ? length("rx") : length("ry"));
  const double ry = std::min(h / 2, node.attribute("ry") ? length("ry") : length("rx"));
  const auto corner = [&](double dx, double dy) {
    return round ? " a " + number(rx) + " " + number(ry) + " 0 0 1 " + number(dx) + " " + number(dy)
                 : std::string();
  };
  const double x = round ? rx : 0;
  const double y = round ? ry : 0;
  return "M " + number(length("x") + x) + " " + number(length("y")) + " h " + number(w - 2 * x) +
         corner(x, y) + " v " + number(h - 2 * y) + corner(-x, y) + " h " + number(2 * x - w) +
         corner(-x, -y) + " v " + number(2 * y - h) + corner(x, -y) + " Z";
}

void collect(const pugi::xml_node& node, const affine& outer, bool filled, int depth,
             std::vector<curved_outline>& all) {
  if (depth > most_depth)
    return;
  for (const auto& child : node.children()) {
    const std::string_view kind = child.name();
    // What is defined is drawn only where something refers to it.
    if (kind == "defs" || kind == "symbol" || kind == "clipPath" || kind == "mask" ||
        kind == "pattern" || kind == "marker")
      continue;
    const auto here = outer.of(transform_of(child.attribute("transform").as_string()));
    const bool fills = is_filled(child, filled);
    if (const auto path = path_of(child); fills && !path.empty())
      for (auto& outline : svg_path(path)) {
        outline.start = here(outline.start);
        for (auto& piece : outline.pieces)
          piece = {here(piece.first), here(piece.second), here(piece.end), piece.straight};
        all.push_back(std::move(outline));
      }
    collect(child, here, fills, depth + 1, all);
  }
}

point2 on_curve(point2 from, const curve_piece& p, double t) {
  const double u = 1 - t;
  point2 result{};
  for (int k = 0; k < 2; ++k)
    result[k] = u * u * u * from[k] + 3 * u * u * t * p.first[k] + 3 * u * t * t * p.second[k] +
                t * t * t * p.end[k];
  return result;
}

/// In edges of about that length; equal neighbours are one.
std::vector<point2> flattened(const curved_outline& outline, double edge) {
  std::vector<point2> points{outline.start};
  const auto add = [&](point2 p) {
    if (gap_of(points.back(), p) > 1e-3 * edge)
      points.push_back(p);
  };
  point2 from = outline.start;
  for (const auto& piece : outline.pieces) {
    const double length = gap_of(from, piece.first) + gap_of(piece.first, piece.second) +
                          gap_of(piece.second, piece.end);
    const double steps = piece.straight ? 1 : std::ceil(length / edge);
    const int n = static_cast<int>(std::clamp(steps, 1.0, double(most_edges)));
    for (int i = 1; i <= n; ++i)
      add(on_curve(from, piece, double(i) / n));
    from = piece.end;
  }
  while (points.size() > 1 && gap_of(points.back(), points.front()) <= 1e-3 * edge)
    points.pop_back();
  return points;
}

double area_of(const std::vector<point2>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i];
    const auto& q = points[(i + 1) % points.size()];
    sum += p[0] * q[1] - q[0] * p[1];
  }
  return std::abs(sum) / 2;
}

tl::unexpected<error> no_shapes(const attachment& file) {
  return fail(ec::bad_input, file.name + " has no filled shape",
              "Convert texts and strokes to paths, and fill them");
}

/// Around the origin, y upward.
expected<profile> as_profile(const attachment& file, std::vector<curved_outline> all, double size,
                             double edge) {
  point2 low{1e300, 1e300};
  point2 high{-1e300, -1e300};
  const auto add = [&](point2 p) {
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  };
  for (const auto& outline : all) {
    point2 from = outline.start;
    add(from);
    for (const auto& piece : outline.pieces) {
      for (int i = 1; i <= 16; ++i)
        add(on_curve(from, piece, i / 16.0));
      from = piece.end;
    }
  }
  const double longest = std::max(high[0] - low[0], high[1] - low[1]);
  if (!(longest > 0) || !std::isfinite(longest))
    return no_shapes(file);
  const double scale = size / longest;
  const auto place = [&](point2 p) {
    return point2{scale * (p[0] - (low[0] + high[0]) / 2),
                  -scale * (p[1] - (low[1] + high[1]) / 2)};
  };
  profile result;
  result.sides = {"side"};
  std::size_t edges = 0;
  for (auto& outline : all) {
    outline.start = place(outline.start);
    for (auto& piece : outline.pieces)
      piece = {place(piece.first), place(piece.second), place(piece.end), piece.straight};
    auto points = flattened(outline, edge);
    if (points.size() < 3 || area_of(points) < 1e-2 * edge * edge)
      continue;
    edges += points.size();
    if (edges > most_edges)
      return fail(ec::bad_input, file.name + " has too many curves for its size",
                  "Simplify it, or make it smaller");
    outline.pieces.clear();
    result.outlines.push_back({std::move(points), {}});
    result.outlines.back().side.assign(result.outlines.back().points.size(), 0);
  }
  if (result.outlines.empty())
    return no_shapes(file);
  return result;
}

}  // namespace

expected<profile> svg_outlines(const attachment& file, double size, double edge) {
  pugi::xml_document document;
  const auto read = document.load_buffer(file.bytes.data(), file.bytes.size());
  const auto root = document.document_element();
  if (!read || std::string_view(root.name()) != "svg")
    return fail(ec::bad_input, file.name + " is no SVG picture and no DXF drawing",
                "Give a file that ends in .svg or .dxf");
  std::vector<curved_outline> all;
  collect(root, {}, true, 0, all);
  return as_profile(file, std::move(all), size, edge);
}

}  // namespace tedit::ops
