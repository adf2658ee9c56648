// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/mesher/narrow_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gmsh.h>

#include "mesh/box.hpp"

namespace tedit::cad {

namespace {

/// Of a curve that is not straight.
constexpr int pieces_of_curve = 64;
/// Edges at a strip, in terms of its width, and how fast they grow away from it.
constexpr double size_share = 2;
constexpr double growth = 0.4;
/// Places nearer to each other than this share of their size are one; so many are looked at for one
/// that is kept.
constexpr double apart = 0.5;
constexpr std::size_t most_repeated = 10;

struct segment {
  vec3 a, b;
};

/// A curve as a polygon.
struct curve {
  int tag = 0;
  std::vector<segment> segments;
  box extent;
  std::array<int, 2> ends{-1, -1};  ///< Tags of points; none of a closed one.
};

vec3 point_on(int tag, double parameter) {
  std::vector<double> at;
  gmsh::model::getValue(1, tag, {parameter}, at);
  return {at[0], at[1], at[2]};
}

curve curve_of(int tag) {
  curve result;
  result.tag = tag;
  gmsh::vectorpair ends;
  gmsh::model::getBoundary({{1, tag}}, ends, false, false);
  for (std::size_t i = 0; i < std::min<std::size_t>(ends.size(), 2); ++i)
    result.ends[i] = std::abs(ends[i].second);
  std::string type;
  gmsh::model::getType(1, tag, type);
  std::vector<double> low;
  std::vector<double> high;
  gmsh::model::getParametrizationBounds(1, tag, low, high);
  const int pieces = type == "Line" ? 1 : pieces_of_curve;
  vec3 last = point_on(tag, low[0]);
  for (int i = 1; i <= pieces; ++i) {
    const vec3 next = point_on(tag, low[0] + (high[0] - low[0]) * i / pieces);
    result.extent.add(std::array{last, next});
    if (norm(next - last) > 0)
      result.segments.push_back({last, next});
    last = next;
  }
  return result;
}

bool meet(const curve& one, const curve& other) {
  return std::ranges::any_of(one.ends, [&](int end) {
    return end >= 0 && std::ranges::find(other.ends, end) != other.ends.end();
  });
}

double distance_to(const segment& s, vec3 p) {
  const vec3 along = s.b - s.a;
  const double share = std::clamp(dot(p - s.a, along) / dot(along, along), 0.0, 1.0);
  return norm(s.a + share * along - p);
}

class strip_finder {
public:
  strip_finder(double widest, double thinnest, std::size_t most, narrow_places& found)
      : widest_(widest),
        thinnest_(thinnest),
        most_(most),
        most_looked_at_(most_repeated * most),
        found_(found) {}

  /// False where there are too many.
  bool look_at(int face) {
    gmsh::vectorpair tags;
    gmsh::model::getBoundary({{2, face}}, tags, false, false);
    std::set<int> once;
    for (const auto& [dimension, tag] : tags)
      once.insert(std::abs(tag));
    std::vector<curve> curves;
    double around = 0;
    for (const int tag : once) {
      curves.push_back(curve_of(tag));
      for (const auto& one : curves.back().segments)
        around += norm(one.b - one.a);
    }
    double area = 0;
    gmsh::model::occ::getMass(2, face, area);
    // A face that is a strip all over goes into its neighbours.
    if (2 * area < widest_ * around)
      return true;
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (std::size_t k = i + 1; k < curves.size(); ++k)
        look_between(face, curves[i], curves[k]);
    drop_repeated();
    return found_.all.size() <= most_;
  }

private:
  /// Of places within each other's edges the first one is enough.
  void drop_repeated() {
    std::ranges::sort(found_.all, {}, &narrow_place::size);
    std::vector<narrow_place> left;
    for (const auto& one : found_.all)
      if (std::ranges::none_of(left, [&](const narrow_place& other) {
            return norm(one.at - other.at) < apart * other.size;
          }))
        left.push_back(one);
    found_.all = std::move(left);
  }

  void look_between(int face, const curve& one, const curve& other) {
    if (!one.extent.grown(widest_).meets(other.extent) || meet(one, other))
      return;
    const auto before = found_.all.size();
    for (const auto& a : one.segments) {
      const box around = box_of(std::array{a.a, a.b}).grown(widest_);
      for (const auto& b : other.segments)
        if (around.meets(box_of(std::array{b.a, b.b})) && found_.all.size() <= most_looked_at_)
          look_along(a, b);
    }
    if (found_.all.size() == before)
      return;
    found_.faces.insert(face);
    found_.curves.insert({one.tag, other.tag});
  }

  /// Halves the first one until it is as short as the strip is wide.
  void look_along(const segment& a, const segment& b) {
    const vec3 middle = 0.5 * (a.a + a.b);
    const double half = 0.5 * norm(a.b - a.a);
    const double width = distance_to(b, middle);
    if (width - half > widest_ || found_.all.size() > most_looked_at_)
      return;
    if (half > std::max(width, thinnest_)) {
      look_along({a.a, middle}, b);
      look_along({middle, a.b}, b);
    } else if (width >= thinnest_ && width <= widest_) {
      found_.all.push_back({middle, size_share * width});
    }
  }

  double widest_;
  double thinnest_;
  std::size_t most_;
  std::size_t most_looked_at_;
  narrow_places& found_;
};

}  // namespace

double narrow_places::size_at(vec3 p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& one : all) {
    if (one.size >= least)
      break;
    least = std::min(least, one.size + growth * norm(p - one.at));
  }
  return least;
}

narrow_places find_narrow_places(double widest, double thinnest, std::size_t most) {
  narrow_places found;
  strip_finder finder(widest, thinnest, most, found);
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  for (const auto& [dimension, face] : faces)
    if (!finder.look_at(face))
      return {};
  return found;
}

}  // namespace tedit::cad
