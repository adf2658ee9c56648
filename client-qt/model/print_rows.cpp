// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/print_rows.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct print_phrases {
  Q_DECLARE_TR_FUNCTIONS(print_rows)
};

constexpr std::size_t most_names = 3;

QString names_of(const std::vector<surface_id>& surfaces, const surface_namer& name_of) {
  QStringList names;
  for (std::size_t i = 0; i < std::min(surfaces.size(), most_names); ++i)
    names << name_of(surfaces[i]);
  return surfaces.size() > most_names ? print_phrases::tr("%1 and %2 more")
                                          .arg(names.join(", "))
                                          .arg(surfaces.size() - most_names)
                                      : names.join(", ");
}

QString counted(std::size_t items) {
  return count(static_cast<double>(items));
}

QString area_words(double area) {
  return quantity(area, "m2");
}

/// `all`: how many there are, of which `some` were sent.
std::vector<print_row> rows_of(const std::vector<print_place>& some, std::uint64_t all,
                               const QString& worst_unit, const QString& worst_words,
                               const surface_namer& name_of) {
  std::vector<print_row> rows;
  for (std::size_t i = 0; i < std::min(some.size(), most_print_rows); ++i) {
    const auto& place = some[i];
    rows.push_back({names_of(place.surfaces, name_of),
                    worst_words.arg(quantity(place.worst, worst_unit), area_words(place.area)),
                    true, place.at, place.surfaces});
  }
  if (all > rows.size())
    rows.push_back({print_phrases::tr("... and %1 smaller").arg(all - rows.size()), {}});
  return rows;
}

print_row watertight_row(const print_findings& what) {
  return {print_phrases::tr("Watertight"),
          what.watertight() ? print_phrases::tr("yes")
                            : print_phrases::tr("no: %1 open edges").arg(counted(what.open_edges)),
          !what.watertight()};
}

QString size_words(const box& extent) {
  const vec3 size = extent.high - extent.low;
  const auto unit = shown_as("m");
  return QString::fromUtf8("%1 × %2 × %3 %4")
    .arg(number(unit.scale * size.x), number(unit.scale * size.y), number(unit.scale * size.z),
         unit.name);
}

print_row thin_row(const client::print_check& made, const surface_namer& name_of) {
  const auto& what = made.what;
  const QString limit = quantity(made.settings.thinner_than, "m");
  if (what.thin.empty())
    return {print_phrases::tr("Thin walls"), print_phrases::tr("none under %1").arg(limit)};
  return {
    print_phrases::tr("Thin walls"),
    print_phrases::tr("%1 under %2, both sides counted").arg(area_words(what.thin_area), limit),
    true,
    {},
    {},
    rows_of(what.thin, made.thin_places, "m", print_phrases::tr("down to %1, %2"), name_of)};
}

print_row overhang_row(const client::print_check& made, const surface_namer& name_of) {
  const auto& what = made.what;
  const QString limit = quantity(made.settings.lean, "rad");
  if (what.overhangs.empty())
    return {print_phrases::tr("Overhangs"), print_phrases::tr("none beyond %1").arg(limit)};
  return {print_phrases::tr("Overhangs"),
          print_phrases::tr("%1 lean more than %2").arg(area_words(what.overhang_area), limit),
          true,
          {},
          {},
          rows_of(what.overhangs, made.overhanging_places, "rad", print_phrases::tr("up to %1, %2"),
                  name_of)};
}

}  // namespace

std::vector<print_row> print_rows(const client::print_check& made, const surface_namer& name_of) {
  const auto& what = made.what;
  std::vector<print_row> rows{watertight_row(what)};
  const auto add_fault = [&rows](const QString& title, std::size_t items) {
    if (items > 0)
      rows.push_back({title, counted(items), true});
  };
  add_fault(print_phrases::tr("Edges of more than two facets"), what.hinge_edges);
  add_fault(print_phrases::tr("Facets that meet others they should not"), what.crossing_facets);
  add_fault(print_phrases::tr("Closed voids"), what.closed_voids);
  if (made.settings.thinner_than > 0)
    rows.push_back(thin_row(made, name_of));
  rows.push_back(overhang_row(made, name_of));
  rows.push_back({print_phrases::tr("Bodies"), counted(what.bodies)});
  rows.push_back({print_phrases::tr("Volume"), quantity(what.volume, "m3")});
  rows.push_back({print_phrases::tr("Surface area"), area_words(what.area)});
  rows.push_back({print_phrases::tr("Bounding box"), size_words(what.extent)});
  rows.push_back({print_phrases::tr("On the plate"), area_words(what.plate_area)});
  return rows;
}

std::optional<vec3> up_from(const client::surface_model& part,
                            const std::vector<surface_id>& surfaces) {
  std::vector<vec3> areas;
  vec3 sum;
  double least = INFINITY;
  double most = -INFINITY;
  const auto for_each_facet = [&](const auto& visit) {
    part.facets().for_each([&](std::uint32_t, const client::surface_facet& f) {
      if (std::ranges::find(surfaces, f.surface) != surfaces.end())
        visit(std::array{*part.positions().find(f.v[0]), *part.positions().find(f.v[1]),
                         *part.positions().find(f.v[2])});
    });
  };
  for_each_facet([&](const std::array<vec3, 3>& p) {
    areas.push_back(0.5 * cross(p[1] - p[0], p[2] - p[0]));
    sum = sum + areas.back();
  });
  if (norm(sum) == 0)
    return std::nullopt;
  const vec3 outward = sum / norm(sum);
  const bool even = std::ranges::all_of(areas, [&](const vec3& area) {
    return dot(area, outward) >= std::cos(1 * degree) * norm(area);
  });
  for_each_facet([&](const std::array<vec3, 3>& p) {
    for (const auto& corner : p) {
      least = std::min(least, dot(corner, outward));
      most = std::max(most, dot(corner, outward));
    }
  });
  // Two walls of one direction may lie at different heights.
  const bool one_plane = most - least <= std::tan(1 * degree) * std::sqrt(norm(sum));
  return even && one_plane ? std::optional(-outward) : std::nullopt;
}

}  // namespace tedit::desktop
