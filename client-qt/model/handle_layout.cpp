// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/handle_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

using kind = handle::kind;

// Pixels.
constexpr double beyond = 22;       // A knob stands beyond the end of its arrow,
constexpr double least_reach = 30;  // and never on the place.
constexpr double between_rings = 22;
constexpr std::array<double, 3> stalks{74, 54, 36};  // The longest whose end is in sight.
constexpr double turn_radius = 58;
constexpr double least_arrow = 0.15;  // Of its length that can be seen, else it points upward.

/// Lays the handles of one form, each beside those before it.
class layout {
public:
  layout(const handle_plan& plan, const ops::parameters& values, const handle_pose& pose,
         const lens& by)
      : plan_(plan), values_(values), frame_(pose.frame), feature_(pose.feature), by_(by) {
    if (pose.axis) {  // At the end of a bore that can be seen.
      const double nearer = dot(*pose.axis, cross(by.right, by.up)) < 0 ? -1 : 1;
      const vec3 to_end = nearer * pose.half_length * *pose.axis;
      feature_ += to_end;
      if (!plan.find(kind::place))
        frame_.at += to_end;
    }
    pixel_ = by.metres_per_pixel(frame_.at);
  }

  [[nodiscard]] std::vector<laid_handle> all() {
    for (const auto& one : plan_.all)
      if (one.what != kind::place && one.what != kind::direction && one.what != kind::turn)
        add(one);
    for (const auto what : {kind::direction, kind::turn, kind::place})
      if (const auto* one = plan_.find(what))
        add(*one);
    return std::move(laid_);
  }

private:
  void add(const handle& one) {
    switch (one.what) {
      case kind::place:
        return laid_.push_back({&one, by_.to_screen(frame_.at), {}, frame_.at});
      case kind::length:
        return add_length(one);
      case kind::ring:
        return add_ring(one, one.half * number_in(values_, one.parameter));
      case kind::span:
        return add_span(one);
      case kind::direction:
        return add_direction(one);
      case kind::turn:
        return add_turn(one);
      case kind::way:
        return add_way(one);
    }
  }

  /// From a place on the screen `pixels` further along a way of space; upward where it looks at the
  /// viewer.
  [[nodiscard]] QPointF further(const vec3& from, const vec3& along, double pixels) const {
    const QPointF a = by_.to_screen(from);
    const QPointF way = by_.to_screen(from + 100 * pixel_ * along) - a;
    const double seen = std::hypot(way.x(), way.y());
    return seen < 100 * least_arrow ? a - QPointF(0, pixels) : a + way * (pixels / seen);
  }

  void add_length(const handle& one) {
    const double value = number_in(values_, one.parameter);
    if (value == 0 && !one.first)
      return;
    const vec3 along = one.inward ? -frame_.z : frame_.z;
    const vec3 end = frame_.at + value * along;
    const QPointF knob = further(end, value < 0 ? -along : along, beyond);
    laid_.push_back({&one, knob, {by_.to_screen(frame_.at), knob}, frame_.at, along, 0, value});
    const double outward = (one.inward ? -value : value) / pixel_;
    above_ = std::max(above_, outward + (outward > 0 || !one.inward ? beyond : 0));
  }

  /// Each further ring has its knob at another side.
  [[nodiscard]] vec3 side() const {
    const vec3 flat = by_.right - dot(by_.right, frame_.z) * frame_.z;
    const vec3 right = norm(flat) > 0.1 ? normalized(flat) : frame_.x;
    const vec3 up = cross(frame_.z, right);
    return std::array{right, -right, up, -up}[rings_ % 4];
  }

  void add_ring(const handle& one, double radius) {
    if (radius == 0 && !one.first)
      return;
    const vec3 along = side();
    const double reach = std::max(radius / pixel_, least_reach + between_rings * rings_);
    ++rings_;
    laid_handle laid{&one, further(frame_.at, along, reach), {}, frame_.at, along};
    laid.value = number_in(values_, one.parameter);
    if (radius / pixel_ >= reach)
      laid.knob = by_.to_screen(frame_.at + radius * along);
    laid.line = circle(frame_, radius);
    laid_.push_back(std::move(laid));
  }

  [[nodiscard]] std::vector<QPointF> circle(const tool_frame& f, double radius) const {
    constexpr int steps = 64;
    std::vector<QPointF> result;
    for (int i = 0; radius > 0 && i <= steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      result.push_back(
        by_.to_screen(f.point(radius * std::cos(angle), radius * std::sin(angle), 0)));
    }
    return result;
  }

  void add_span(const handle& one) {
    const auto profile = text_in(values_, "profile");
    const auto half = profile_extents(values_);
    const bool is_round = profile == "circle" || profile == "polygon";
    if (is_round && !one.across)
      return add_ring(one, half.along);
    if (is_round || profile == "file" || profile == "points")
      return;
    const double metres = one.across ? half.across : half.along;
    const vec3 along = one.across ? frame_.y : frame_.x;
    const double reach = std::max(metres / pixel_, least_reach);
    const QPointF knob = metres / pixel_ >= reach ? by_.to_screen(frame_.at + metres * along)
                                                  : further(frame_.at, along, reach);
    laid_.push_back(
      {&one, knob, {by_.to_screen(frame_.at), knob}, frame_.at, along, 0, metres / one.half});
    if (!one.across)
      beside_ = reach;
  }

  void add_direction(const handle& one) {
    laid_handle laid{&one, {}, {}, frame_.at, frame_.z};
    for (const double stalk : stalks) {
      laid.radius = (above_ + stalk) * pixel_;
      laid.knob = by_.to_screen(laid.root + laid.radius * laid.along);
      if (by_.shows(laid.knob))
        break;
    }
    laid.line = {by_.to_screen(laid.root), laid.knob};
    laid_.push_back(std::move(laid));
  }

  void add_turn(const handle& one) {
    laid_handle laid{&one, {}, {}, frame_.at};
    laid.along = one.parameter == "up" ? frame_.y : frame_.x;
    laid.radius = std::max(turn_radius, beside_ + least_reach) * pixel_;
    laid.knob = by_.to_screen(laid.root + laid.radius * laid.along);
    laid.line = {by_.to_screen(laid.root), laid.knob};
    laid_.push_back(std::move(laid));
  }

  void add_way(const handle& one) {
    const vec3 way = vector_in(values_, one.parameter).value_or(vec3{});
    if (way == vec3{} && !one.first)
      return;
    laid_handle laid{&one, {}, {}, feature_};
    laid.along = way;
    const QPointF root = by_.to_screen(laid.root);
    const QPointF end = by_.to_screen(laid.root + way);
    // One that goes nowhere yet stands aside of what it moves.
    laid.knob = pixels_between(root, end) < least_reach ? end + QPointF(least_reach, 0) : end;
    laid.line = {root, laid.knob};
    laid_.push_back(std::move(laid));
  }

  const handle_plan& plan_;
  const ops::parameters& values_;
  tool_frame frame_;
  vec3 feature_;
  const lens& by_;
  double pixel_ = 0;
  double above_ = 0;   // What stands on the outward axis, pixels,
  double beside_ = 0;  // and along the profile.
  int rings_ = 0;
  std::vector<laid_handle> laid_;
};

}  // namespace

std::vector<laid_handle> lay_out(const handle_plan& plan, const ops::parameters& values,
                                 const handle_pose& pose, const lens& by) {
  return layout(plan, values, pose, by).all();
}

const laid_handle* handle_at(const std::vector<laid_handle>& all, QPointF pointer) {
  const laid_handle* best = nullptr;
  double least = handle_reach;
  for (const auto& one : all)
    if (const double far = pixels_between(one.knob, pointer);
        far <= least && (!best || far < least)) {
      least = far;
      best = &one;
    }
  return best;
}

namespace {

QString vector_words(const vec3& v, const QString& unit) {
  const auto shown = shown_as(unit);
  QStringList numbers;
  for (const double x : {v.x, v.y, v.z})
    numbers << number(shown.scale * x);
  return side_by_side(numbers) + (shown.name.isEmpty() ? QString() : " " + shown.name);
}

}  // namespace

QString words_of(const laid_handle& one, const ops::parameters& values) {
  const auto& what = *one.of;
  if (what.what == kind::place)
    return what.name + " " + vector_words(one.root, what.unit);
  if (what.what == kind::direction || what.what == kind::turn)
    return what.name + " " + vector_words(one.along, {});
  if (what.what == kind::way)
    return what.name + " " + vector_words(one.along, what.unit);
  return what.name + " " + quantity(number_in(values, what.parameter), what.unit);
}

}  // namespace tedit::desktop
