// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/plot.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::verification {

namespace {

constexpr double plot_width = 300;
constexpr double plot_height = 290;
constexpr double top = 46;

template <class... Values>
std::string text_with(const char* format, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof(buffer), format, values...);
  return buffer;
}

struct style {
  const char* colour;
  const char* name;
};

style style_of(int order) {
  return order == 1 ? style{"#b5452c", "linear tets (T4)"}
                    : style{"#1d5c8f", "quadratic tets (T10)"};
}

struct plot_point {
  double size = 0;
  double error = 0;
};

struct curve {
  int order = 1;
  std::vector<plot_point> points;  ///< By descending size.
};

/// A logarithmic axis over whole ticks: from low (at pixel `at_low`) to high (at `at_high`).
struct log_axis {
  double low = 0.1;
  double high = 1;
  double at_low = 0;
  double at_high = 1;

  [[nodiscard]] double operator()(double value) const {
    return at_low + (at_high - at_low) * std::log(value / low) / std::log(high / low);
  }
};

/// One diagram: frame, ticks, curves and slope triangles.
class panel {
public:
  panel(double left, std::string title, std::vector<curve> curves)
      : left_(left), title_(std::move(title)), curves_(std::move(curves)) {
    double least_size = 1e300;
    double most_size = 0;
    double least_error = 1e300;
    double most_error = 0;
    for (const auto& c : curves_)
      for (const auto& p : c.points) {
        least_size = std::min(least_size, p.size);
        most_size = std::max(most_size, p.size);
        least_error = std::min(least_error, p.error);
        most_error = std::max(most_error, p.error);
      }
    x_ = {least_size / 1.35, most_size * 1.35, left, left + plot_width};
    // Whole decades, with room for the triangle below the lowest curve.
    y_ = {std::pow(10, std::floor(std::log10(least_error / 2.5))),
          std::pow(10, std::ceil(std::log10(most_error))), top + plot_height, top};
  }

  [[nodiscard]] std::string draw(int slope_above_order) const {
    std::string svg = x_ticks() + y_ticks() + frame();
    for (const auto& c : curves_)
      svg += draw_curve(c) + draw_slope(c, c.order + slope_above_order);
    return svg;
  }

private:
  [[nodiscard]] std::string frame() const {
    return text_with(
             "<text x=\"%.1f\" y=\"%.1f\" class=\"title\" text-anchor=\"middle\">%s</text>\n",
             left_ + plot_width / 2, top - 14, title_.c_str()) +
           text_with(
             "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" "
             "stroke=\"#444\"/>\n",
             left_, top, plot_width, plot_height) +
           text_with(
             "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">edge length of a cell of "
             "six tets</text>\n",
             left_ + plot_width / 2, top + plot_height + 40);
  }

  [[nodiscard]] static std::string line(double x1, double y1, double x2, double y2,
                                        const char* colour) {
    return text_with("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1,
                     y1, x2, y2, colour);
  }

  /// Ticks at 1, 2 and 5 times powers of ten.
  [[nodiscard]] std::string x_ticks() const {
    std::string svg;
    const double bottom = top + plot_height;
    for (double decade = std::pow(10, std::floor(std::log10(x_.low))); decade <= x_.high;
         decade *= 10)
      for (const double digit : {1, 2, 5}) {
        const double value = digit * decade;
        if (value < x_.low || value > x_.high)
          continue;
        svg += line(x_(value), top, x_(value), bottom, "#e4e4e4") +
               line(x_(value), bottom, x_(value), bottom + 5, "#444") +
               text_with("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%g</text>\n",
                         x_(value), bottom + 19, value);
      }
    return svg;
  }

  /// Labels at powers of ten, short ticks between.
  [[nodiscard]] std::string y_ticks() const {
    std::string svg;
    const int first = static_cast<int>(std::lround(std::log10(y_.low)));
    const int last = static_cast<int>(std::lround(std::log10(y_.high)));
    for (int power = first; power <= last; ++power) {
      const double y = y_(std::pow(10, power));
      svg += line(left_, y, left_ + plot_width, y, "#d0d0d0") +
             line(left_ - 5, y, left_, y, "#444") +
             text_with(
               "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">10<tspan dy=\"-5\" "
               "font-size=\"9\">%d</tspan></text>\n",
               left_ - 8, y + 5, power);
      for (int digit = 2; digit < 10 && power < last; ++digit) {
        const double between = y_(digit * std::pow(10, power));
        svg += line(left_ - 3, between, left_, between, "#888");
      }
    }
    return svg;
  }

  [[nodiscard]] std::string draw_curve(const curve& c) const {
    const auto colour = style_of(c.order).colour;
    std::string path;
    std::string marks;
    for (const auto& p : c.points) {
      path += text_with("%.1f,%.1f ", x_(p.size), y_(p.error));
      marks += text_with("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", x_(p.size),
                         y_(p.error), colour);
    }
    return text_with("<polyline fill=\"none\" stroke-width=\"2\" stroke=\"%s\" points=\"", colour) +
           path + "\"/>\n" + marks;
  }

  /// A right triangle under the finest segment whose long side rises by h^slope.
  [[nodiscard]] std::string draw_slope(const curve& c, int slope) const {
    if (c.points.size() < 2)
      return {};
    const auto& fine = c.points.back();
    const auto& coarse = c.points[c.points.size() - 2];
    const double reach = std::pow(coarse.size / fine.size, 0.55);
    const double x1 = fine.size * std::pow(coarse.size / fine.size, 0.3);
    const double rate = std::log(coarse.error / fine.error) / std::log(coarse.size / fine.size);
    const double y1 = 0.6 * fine.error * std::pow(x1 / fine.size, rate);
    const double left = x_(x1);
    const double right = x_(x1 * reach);
    const double low = y_(y1);
    const double high = y_(y1 * std::pow(reach, slope));
    const auto colour = style_of(c.order).colour;
    return text_with(
             "<path d=\"M%.1f %.1f H%.1f V%.1f Z\" fill=\"%s\" fill-opacity=\"0.12\" "
             "stroke=\"%s\"/>\n",
             left, low, right, high, colour, colour) +
           text_with("<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\">%d</text>\n", right + 5,
                     (low + high) / 2 + 4, colour, slope) +
           text_with("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" fill=\"%s\">1</text>\n",
                     (left + right) / 2, low + 14, colour);
  }

  double left_;
  std::string title_;
  std::vector<curve> curves_;
  log_axis x_;
  log_axis y_;
};

std::vector<curve> curves_of(std::span<const convergence_row> rows, bool energy) {
  std::vector<curve> curves;
  for (const int order : {1, 2}) {
    curve c{order, {}};
    for (const auto& row : rows)
      if (row.element_order == order)
        c.points.push_back({row.size, energy ? row.energy_error : row.l2_error});
    if (!c.points.empty())
      curves.push_back(std::move(c));
  }
  return curves;
}

std::string legend(const std::vector<curve>& curves) {
  std::string svg;
  double x = 210;
  for (const auto& c : curves) {
    const auto [colour, name] = style_of(c.order);
    const double y = top + plot_height + 72;
    svg += text_with(
             "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
             "stroke-width=\"2\"/><circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n",
             x, y, x + 30, y, colour, x + 15, y, colour) +
           text_with("<text x=\"%.1f\" y=\"%.1f\">%s</text>\n", x + 38, y + 4, name);
    x += 190;
  }
  return svg;
}

}  // namespace

std::string convergence_svg(std::span<const convergence_row> rows) {
  constexpr double width = 780;
  constexpr double height = top + plot_height + 92;
  std::string svg = text_with(
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f "
    "%.0f\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12\">\n",
    width, height, width, height);
  svg +=
    "<style>.title { font-size: 14px; font-weight: bold }</style>\n"
    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  const auto l2 = curves_of(rows, false);
  if (!l2.empty()) {
    svg += panel(70, "relative L2 error of the displacement", l2).draw(1);
    svg += panel(450, "relative energy error", curves_of(rows, true)).draw(0);
    svg += legend(l2);
  }
  return svg + "</svg>\n";
}

}  // namespace tedit::verification
