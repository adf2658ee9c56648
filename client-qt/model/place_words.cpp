// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/place_words.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <set>

#include "client-qt/model/probes.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct place_words_phrases {
  Q_DECLARE_TR_FUNCTIONS(places)
};

constexpr double rounding = 1e-9;  // Of the part's size: nearer is on the surface.
constexpr std::size_t most_named = 3;

vec3 unit(const vec3& v) {
  const double length = norm(v);
  return length > 0 ? v / length : vec3{};
}

/// The nearest surfaces to one point while the facets go by.
struct search {
  struct candidate {
    double distance;
    surface_id surface;
    vec3 normal;
  };
  vec3 point;
  double least = INFINITY;
  std::vector<candidate> near = {};  ///< Not farther than when they were met.

  void meet(const std::array<vec3, 3>& corners, double reach, surface_id surface, double slack) {
    if (norm(corners[0] - point) - reach > least + slack)  // No point of it can be as near.
      return;
    const double distance = norm(nearest_on(corners, point) - point);
    if (distance > least + slack)
      return;
    least = std::min(least, distance);
    near.push_back(
      {distance, surface, unit(cross(corners[1] - corners[0], corners[2] - corners[0]))});
  }

  [[nodiscard]] found_place result(double slack) const {
    std::set<surface_id> surfaces;
    vec3 outward;
    for (const auto& one : near)
      if (one.distance <= least + slack) {
        surfaces.insert(one.surface);
        outward += one.normal;
      }
    const double depth = surfaces.empty() || least <= slack ? 0 : least;
    return {{surfaces.begin(), surfaces.end()}, depth, unit(outward)};
  }
};

double size_of(const client::surface_model& on) {
  vec3 low{INFINITY, INFINITY, INFINITY};
  vec3 high = -1 * low;
  on.facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
    for (const auto v : f.v) {
      const vec3& at = *on.positions().find(v);
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
  });
  return norm(high - low);
}

}  // namespace

std::vector<found_place> find_places(const client::surface_model& on,
                                     std::span<const vec3> points) {
  std::vector<found_place> result;
  if (points.empty() || on.total_facets() == 0)
    return std::vector<found_place>(points.size());
  const double slack = rounding * size_of(on);
  std::vector<search> all;
  for (const auto& point : points)
    all.push_back({point});
  on.facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
    std::array<vec3, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = *on.positions().find(f.v[i]);
    const double reach = std::max(norm(corners[1] - corners[0]), norm(corners[2] - corners[0]));
    for (auto& one : all)
      one.meet(corners, reach, f.surface, slack);
  });
  for (const auto& one : all)
    result.push_back(one.result(slack));
  return result;
}

QString words(const found_place& place, const surface_names& names) {
  QStringList all;
  for (const auto id : place.surfaces)
    if (const QString name = names(id); !all.contains(name))
      all << name;
  if (all.isEmpty())
    return {};
  if (place.depth_m > 0)
    return place_words_phrases::tr("inside, %1 from %2")
      .arg(shown(place.depth_m, "m").text(), all.first());
  if (all.size() == 1)
    return all.first();
  if (all.size() > static_cast<qsizetype>(most_named))
    return place_words_phrases::tr("where %1 surfaces meet, %2 among them")
      .arg(all.size())
      .arg(all.first());
  const QString last = all.takeLast();
  return place_words_phrases::tr("where %1 and %2 meet").arg(all.join(", "), last);
}

}  // namespace tedit::desktop
