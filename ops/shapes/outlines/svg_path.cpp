// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/outlines/svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace tedit::ops {

namespace {

point2 plus(point2 a, point2 b) {
  return {a[0] + b[0], a[1] + b[1]};
}

point2 between(point2 a, point2 b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

/// Numbers and letters of a path.
class path_words {
public:
  explicit path_words(std::string_view text) : text_(text) {}

  /// The next command's letter, or 0 where a number follows or nothing.
  char command() {
    skip();
    if (text_.empty() || !std::isalpha(static_cast<unsigned char>(text_.front())))
      return 0;
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }

  std::optional<double> number() {
    skip();
    if (text_.starts_with('+'))
      text_.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (code != std::errc{} || !std::isfinite(value))
      return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }

  /// One digit, which no blank need follow.
  std::optional<bool> flag() {
    skip();
    if (text_.empty() || (text_.front() != '0' && text_.front() != '1'))
      return std::nullopt;
    const bool value = text_.front() == '1';
    text_.remove_prefix(1);
    return value;
  }

  [[nodiscard]] bool at_end() {
    skip();
    return text_.empty();
  }

private:
  void skip() {
    const auto next = text_.find_first_not_of(" \t\r\n\f,");
    text_.remove_prefix(next == std::string_view::npos ? text_.size() : next);
  }

  std::string_view text_;
};

class path_reader {
public:
  explicit path_reader(std::string_view text) : words_(text) {}

  std::vector<curved_outline> read() {
    char command = 0;
    while (!words_.at_end()) {
      if (const char next = words_.command(); next != 0)
        command = next;
      else if (command == 0 || command == 'Z' || command == 'z')
        break;
      if (!step(command))
        break;
      // Further pairs after a moveto are lines.
      if (command == 'M')
        command = 'L';
      if (command == 'm')
        command = 'l';
    }
    return std::move(outlines_);
  }

private:
  std::optional<point2> point(bool relative) {
    const auto x = words_.number();
    const auto y = x ? words_.number() : std::nullopt;
    if (!y)
      return std::nullopt;
    return relative ? plus(at_, {*x, *y}) : point2{*x, *y};
  }

  void line(point2 to) {
    outline().pieces.push_back({at_, to, to, true});
    at_ = last_control_ = to;
  }

  void cubic(point2 a, point2 b, point2 to) {
    outline().pieces.push_back({a, b, to, false});
    at_ = to;
  }

  curved_outline& outline() {
    if (outlines_.empty() || closed_) {
      outlines_.push_back({at_, {}});
      closed_ = false;
    }
    return outlines_.back();
  }

  bool step(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    switch (std::toupper(static_cast<unsigned char>(command))) {
      case 'M': {
        const auto to = point(relative);
        if (!to)
          return false;
        at_ = last_control_ = *to;
        outlines_.push_back({at_, {}});
        closed_ = false;
        return true;
      }
      case 'Z':
        if (!outlines_.empty())
          at_ = last_control_ = outlines_.back().start;
        closed_ = true;
        return true;
      case 'L':
        return line_to(point(relative));
      case 'H':
      case 'V':
        return along_axis(relative, std::toupper(static_cast<unsigned char>(command)) == 'V');
      case 'C':
      case 'S':
        return cubic_to(relative, std::toupper(static_cast<unsigned char>(command)) == 'S');
      case 'Q':
      case 'T':
        return quadratic_to(relative, std::toupper(static_cast<unsigned char>(command)) == 'T');
      case 'A':
        return arc_to(relative);
      default:
        return false;
    }
  }

  bool line_to(std::optional<point2> to) {
    if (to)
      line(*to);
    return to.has_value();
  }

  bool along_axis(bool relative, bool vertical) {
    const auto value = words_.number();
    if (!value)
      return false;
    point2 to = at_;
    to[vertical] = relative ? to[vertical] + *value : *value;
    line(to);
    return true;
  }

  /// The last control point mirrored at the end of its curve.
  [[nodiscard]] point2 mirrored() const { return between(last_control_, at_, 2); }

  bool cubic_to(bool relative, bool smooth) {
    const auto a = smooth ? std::optional(mirrored()) : point(relative);
    const auto b = a ? point(relative) : std::nullopt;
    const auto to = b ? point(relative) : std::nullopt;
    if (!to)
      return false;
    cubic(*a, *b, *to);
    last_control_ = *b;
    return true;
  }

  bool quadratic_to(bool relative, bool smooth) {
    const auto c = smooth ? std::optional(mirrored()) : point(relative);
    const auto to = c ? point(relative) : std::nullopt;
    if (!to)
      return false;
    cubic(between(at_, *c, 2.0 / 3), between(*to, *c, 2.0 / 3), *to);
    last_control_ = *c;
    return true;
  }

  bool arc_to(bool relative) {
    const auto rx = words_.number();
    const auto ry = rx ? words_.number() : std::nullopt;
    const auto tilt = ry ? words_.number() : std::nullopt;
    const auto large = tilt ? words_.flag() : std::nullopt;
    const auto sweep = large ? words_.flag() : std::nullopt;
    const auto to = sweep ? point(relative) : std::nullopt;
    if (!to)
      return false;
    arc(std::abs(*rx), std::abs(*ry), *tilt * std::numbers::pi / 180, *large, *sweep, *to);
    return true;
  }

  /// From two points on an ellipse to its centre and angles (F.6.5), then in pieces of at most a
  /// quarter turn.
  void arc(double rx, double ry, double tilt, bool large, bool sweep, point2 to) {
    if (rx == 0 || ry == 0 || at_ == to)
      return line(to);
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    const double dx = (at_[0] - to[0]) / 2;
    const double dy = (at_[1] - to[1]) / 2;
    const double x = c * dx + s * dy;
    const double y = -s * dx + c * dy;
    const double over = x * x / (rx * rx) + y * y / (ry * ry);
    if (over > 1) {
      rx *= std::sqrt(over);
      ry *= std::sqrt(over);
    }
    const double below = rx * rx * y * y + ry * ry * x * x;
    const double f =
      (large == sweep ? -1 : 1) * std::sqrt(std::max(0.0, (rx * rx * ry * ry - below) / below));
    const double cx = f * rx * y / ry;
    const double cy = -f * ry * x / rx;
    const point2 middle = between(at_, to, 0.5);
    const auto on = [&](double angle, double along) {
      // A point of the ellipse and, by `along`, its tangent from there.
      const double u = rx * (std::cos(angle) - along * std::sin(angle)) + cx;
      const double v = ry * (std::sin(angle) + along * std::cos(angle)) + cy;
      return point2{middle[0] + c * u - s * v, middle[1] + s * u + c * v};
    };
    const double first = std::atan2((y - cy) / ry, (x - cx) / rx);
    double turn = std::atan2((-y - cy) / ry, (-x - cx) / rx) - first;
    if (sweep && turn < 0)
      turn += 2 * std::numbers::pi;
    if (!sweep && turn > 0)
      turn -= 2 * std::numbers::pi;
    const int n =
      std::max(1, static_cast<int>(std::ceil(std::abs(turn) / (std::numbers::pi / 2) - 1e-9)));
    const double k = 4.0 / 3 * std::tan(turn / n / 4);
    for (int i = 0; i < n; ++i) {
      const double from = first + turn * i / n;
      const double end = first + turn * (i + 1) / n;
      cubic(on(from, k), on(end, -k), i + 1 < n ? on(end, 0) : to);
    }
    last_control_ = at_;
  }

  path_words words_;
  std::vector<curved_outline> outlines_;
  point2 at_{};
  point2 last_control_{};
  bool closed_ = true;
};

}  // namespace

std::vector<curved_outline> svg_path(std::string_view d) {
  return path_reader(d).read();
}

}  // namespace tedit::ops
