// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/selection_message.hpp"

#include "protocol/vector_message.hpp"
#include "tedit/v1/session.pb.h"

namespace tedit::protocol {

namespace {

// The message's numbers are those of the enumeration, one later.
v1::SelectSurfaces::Kind kind_to(feature_kind kind) {
  return static_cast<v1::SelectSurfaces::Kind>(static_cast<int>(kind) + 1);
}
static_assert(static_cast<int>(feature_kind::hole) + 1 == v1::SelectSurfaces::HOLE);
static_assert(static_cast<int>(feature_kind::protrusion) + 1 == v1::SelectSurfaces::PROTRUSION);
static_assert(static_cast<int>(feature_kind::holes) + 1 == v1::SelectSurfaces::HOLES);
static_assert(static_cast<int>(feature_kind::smooth) + 1 == v1::SelectSurfaces::SMOOTH);
static_assert(static_cast<int>(feature_kind::neighbours) + 1 == v1::SelectSurfaces::NEIGHBOURS);

}  // namespace

expected<selection_query> from_message(const v1::SelectSurfaces& message) {
  if (message.kind() < v1::SelectSurfaces::HOLE || message.kind() > v1::SelectSurfaces::NEIGHBOURS)
    return fail(ec::invalid_argument, "there is no such kind of selection",
                "Take HOLE, PROTRUSION, HOLES, SMOOTH or NEIGHBOURS");
  selection_query query;
  query.kind = static_cast<feature_kind>(static_cast<int>(message.kind()) - 1);
  query.surfaces.assign(message.surfaces().begin(), message.surfaces().end());
  if (message.has_angle_rad())
    query.angle = message.angle_rad();
  if (message.has_min_diameter_m())
    query.min_diameter = message.min_diameter_m();
  if (message.has_max_diameter_m())
    query.max_diameter = message.max_diameter_m();
  return query;
}

void to_message(const selection_query& query, v1::SelectSurfaces* out) {
  out->set_kind(kind_to(query.kind));
  out->mutable_surfaces()->Assign(query.surfaces.begin(), query.surfaces.end());
  out->set_angle_rad(query.angle);
  out->set_min_diameter_m(query.min_diameter);
  out->set_max_diameter_m(query.max_diameter);
}

std::vector<found_feature> from_message(const v1::SurfacesSelected& message) {
  std::vector<found_feature> features;
  for (const auto& row : message.features()) {
    found_feature found;
    found.kind = row.kind() == v1::SelectSurfaces::HOLE         ? feature_kind::hole
                 : row.kind() == v1::SelectSurfaces::PROTRUSION ? feature_kind::protrusion
                                                                : feature_kind::smooth;
    found.surfaces.assign(row.surfaces().begin(), row.surfaces().end());
    found.diameter = row.diameter_m();
    found.centre = read_vector(row.centre_m());
    found.axis = read_vector(row.axis());
    features.push_back(std::move(found));
  }
  return features;
}

void to_message(const std::vector<found_feature>& features, v1::SurfacesSelected* out) {
  for (const auto& found : features) {
    auto* row = out->add_features();
    row->set_kind(kind_to(found.kind));
    row->mutable_surfaces()->Assign(found.surfaces.begin(), found.surfaces.end());
    row->set_diameter_m(found.diameter);
    write_vector(found.centre, row->mutable_centre_m());
    write_vector(found.axis, row->mutable_axis());
  }
}

}  // namespace tedit::protocol
