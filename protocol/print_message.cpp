// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/print_message.hpp"

#include <algorithm>

#include "base/number_range.hpp"
#include "protocol/vector_message.hpp"
#include "tedit/v1/print.pb.h"

namespace tedit::protocol {

namespace {

constexpr double quarter_turn = 90 * degree;

void place_to(const print_place& place, v1::PrintPlace* out) {
  out->mutable_surfaces()->Assign(place.surfaces.begin(), place.surfaces.end());
  out->set_facets(place.facets);
  out->set_area_m2(place.area);
  out->set_worst(place.worst);
  write_vector(place.at, out->mutable_at_m());
}

print_place place_from(const v1::PrintPlace& m) {
  return {{m.surfaces().begin(), m.surfaces().end()},
          m.facets(),
          m.area_m2(),
          m.worst(),
          read_vector(m.at_m())};
}

template <class Rows>
std::vector<print_place> places_from(const Rows& rows) {
  std::vector<print_place> places;
  for (const auto& row : rows)
    places.push_back(place_from(row));
  return places;
}

expected<void> check_direction(const vec3& direction) {
  const std::pair<const char*, double> all[] = {
    {"x", direction.x}, {"y", direction.y}, {"z", direction.z}};
  for (const auto& [name, value] : all)
    if (auto ok =
          check_number(value, {-1e6, 1e6, {}}, std::string("check_print.direction.") + name);
        !ok)
      return ok;
  if (direction.x == 0 && direction.y == 0 && direction.z == 0)
    return fail(ec::invalid_argument, "the build direction has no length",
                "Take three numbers that are not all zero, as 0,0,1");
  return {};
}

}  // namespace

expected<print_settings> read_print_settings(const v1::CheckPrint& request) {
  print_settings settings;
  if (request.has_direction())
    settings.up = read_vector(request.direction());
  settings.thinner_than = request.thinner_than_m();
  if (request.has_overhang_rad())
    settings.lean = request.overhang_rad();
  if (settings.thinner_than != 0)
    if (auto ok =
          check_number(settings.thinner_than, {1e-9, 1e3, "m"}, "check_print.thinner_than_m");
        !ok)
      return fail(ok.error());
  if (auto ok = check_number(settings.lean, {0, quarter_turn, "rad"}, "check_print.overhang_rad");
      !ok)
    return fail(ok.error());
  if (auto ok = check_direction(settings.up); !ok)
    return fail(ok.error());
  return settings;
}

void write_print_settings(const print_settings& settings, v1::CheckPrint* out) {
  out->set_thinner_than_m(settings.thinner_than);
  out->set_overhang_rad(settings.lean);
  write_vector(settings.up, out->mutable_direction());
}

void to_message(const print_settings& settings, const print_findings& found,
                v1::PrintChecked* out) {
  out->set_thinner_than_m(settings.thinner_than);
  out->set_overhang_rad(settings.lean);
  write_vector(settings.up, out->mutable_direction());
  out->set_volume_m3(found.volume);
  out->set_area_m2(found.area);
  write_vector(found.extent.low, out->mutable_low_m());
  write_vector(found.extent.high, out->mutable_high_m());
  out->set_bodies(found.bodies);
  out->set_closed_voids(found.closed_voids);
  out->set_open_edges(found.open_edges);
  out->set_hinge_edges(found.hinge_edges);
  out->set_crossing_facets(found.crossing_facets);
  out->set_thin_places(found.thin.size());
  for (std::size_t i = 0; i < std::min(found.thin.size(), most_print_places); ++i)
    place_to(found.thin[i], out->add_thin());
  out->set_thin_area_m2(found.thin_area);
  out->set_overhanging_places(found.overhangs.size());
  for (std::size_t i = 0; i < std::min(found.overhangs.size(), most_print_places); ++i)
    place_to(found.overhangs[i], out->add_overhangs());
  out->set_overhang_area_m2(found.overhang_area);
  out->set_plate_area_m2(found.plate_area);
}

print_settings settings_from(const v1::PrintChecked& message) {
  return {read_vector(message.direction()), message.thinner_than_m(), message.overhang_rad()};
}

print_findings findings_from(const v1::PrintChecked& message) {
  print_findings found;
  found.volume = message.volume_m3();
  found.area = message.area_m2();
  found.extent = {read_vector(message.low_m()), read_vector(message.high_m())};
  found.bodies = message.bodies();
  found.closed_voids = message.closed_voids();
  found.open_edges = message.open_edges();
  found.hinge_edges = message.hinge_edges();
  found.crossing_facets = message.crossing_facets();
  found.thin = places_from(message.thin());
  found.thin_area = message.thin_area_m2();
  found.overhangs = places_from(message.overhangs());
  found.overhang_area = message.overhang_area_m2();
  found.plate_area = message.plate_area_m2();
  return found;
}

}  // namespace tedit::protocol
