// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/comparison.hpp"

#include "protocol/vector_message.hpp"
#include "tedit/v1/comparison.pb.h"

namespace tedit::protocol {

namespace {

using where_message = v1::VersionsCompared;

// The message's enumeration starts with one for "unspecified".
static_assert(static_cast<int>(presence::only_before) + 1 == where_message::ONLY_BEFORE &&
              static_cast<int>(presence::only_after) + 1 == where_message::ONLY_AFTER &&
              static_cast<int>(presence::both) + 1 == where_message::BOTH);

where_message::Where where_to(presence where) {
  return static_cast<where_message::Where>(static_cast<int>(where) + 1);
}

presence where_from(where_message::Where where) {
  const bool known = where == where_message::ONLY_BEFORE || where == where_message::ONLY_AFTER;
  return known ? static_cast<presence>(static_cast<int>(where) - 1) : presence::both;
}

void size_to(const compared_size& size, v1::ComparedSize* out) {
  out->set_vertices(size.vertices);
  out->set_tets(size.tets);
  out->set_volume_m3(size.volume_m3);
}

compared_size size_from(const v1::ComparedSize& m) {
  return {m.vertices(), m.tets(), m.volume_m3()};
}

void surface_to(const compared_surface& one, v1::ComparedSurface* out) {
  out->set_id(one.id);
  out->set_name(one.name);
  out->set_where(where_to(one.where));
  out->set_changed(one.changed);
  if (one.kin)
    out->set_kin(*one.kin);
  out->set_area_before_m2(one.area_before_m2);
  out->set_area_after_m2(one.area_after_m2);
}

compared_surface surface_from(const v1::ComparedSurface& m) {
  compared_surface result{m.id(), m.name(), where_from(m.where()), m.changed()};
  if (m.has_kin())
    result.kin = m.kin();
  result.area_before_m2 = m.area_before_m2();
  result.area_after_m2 = m.area_after_m2();
  return result;
}

void loads_to(const compared_load_case& one, v1::ComparedLoadCase* out) {
  out->set_name(one.name);
  out->set_where(where_to(one.where));
  if (one.mass_before_kg)
    out->set_mass_before_kg(*one.mass_before_kg);
  if (one.mass_after_kg)
    out->set_mass_after_kg(*one.mass_after_kg);
  out->mutable_differences()->Assign(one.differences.begin(), one.differences.end());
}

compared_load_case loads_from(const v1::ComparedLoadCase& m) {
  compared_load_case result{m.name(), where_from(m.where())};
  if (m.has_mass_before_kg())
    result.mass_before_kg = m.mass_before_kg();
  if (m.has_mass_after_kg())
    result.mass_after_kg = m.mass_after_kg();
  result.differences = {m.differences().begin(), m.differences().end()};
  return result;
}

void change_to(const value_change& change, v1::StressChange* out) {
  out->set_before_pa(change.before);
  out->set_after_pa(change.after);
  write_vector(change.at_m, out->mutable_at_m());
}

value_change change_from(const v1::StressChange& m) {
  return {m.before_pa(), m.after_pa(), read_vector(m.at_m())};
}

void fields_to(const field_comparison& one, v1::FieldComparison* out) {
  out->set_load_case(one.load_case);
  out->set_same(one.same);
  out->set_interpolated(one.interpolated);
  out->set_outside(one.outside);
  if (one.same + one.interpolated > 0) {
    change_to(one.rise, out->mutable_rise());
    change_to(one.fall, out->mutable_fall());
  }
  out->set_max_von_mises_before_pa(one.max_von_mises_before_pa);
  out->set_max_von_mises_after_pa(one.max_von_mises_after_pa);
  if (one.min_safety_before)
    out->set_min_safety_factor_before(*one.min_safety_before);
  if (one.min_safety_after)
    out->set_min_safety_factor_after(*one.min_safety_after);
  out->set_preview(one.preview);
}

field_comparison fields_from(const v1::FieldComparison& m) {
  field_comparison result{m.load_case(), m.same(), m.interpolated(), m.outside()};
  if (m.has_rise())
    result.rise = change_from(m.rise());
  if (m.has_fall())
    result.fall = change_from(m.fall());
  result.max_von_mises_before_pa = m.max_von_mises_before_pa();
  result.max_von_mises_after_pa = m.max_von_mises_after_pa();
  if (m.has_min_safety_factor_before())
    result.min_safety_before = m.min_safety_factor_before();
  if (m.has_min_safety_factor_after())
    result.min_safety_after = m.min_safety_factor_after();
  result.preview = m.preview();
  return result;
}

}  // namespace

void to_message(const version_comparison& all, v1::VersionsCompared* out) {
  out->set_before_id(all.before_id);
  out->set_after_id(all.after_id);
  size_to(all.before, out->mutable_size_before());
  size_to(all.after, out->mutable_size_after());
  out->set_tets_in_common(all.tets_in_common);
  out->set_vertices_in_common(all.vertices_in_common);
  for (const auto& one : all.surfaces)
    surface_to(one, out->add_surfaces());
  auto* deviation = out->mutable_deviation();
  deviation->set_distance_m(all.deviation.distance_m);
  write_vector(all.deviation.at_m, deviation->mutable_at_m());
  deviation->set_of(where_to(all.deviation.of));
  for (const auto& one : all.load_cases)
    loads_to(one, out->add_load_cases());
  for (const auto& one : all.fields)
    fields_to(one, out->add_fields());
  for (const auto& one : all.not_compared) {
    auto* row = out->add_not_compared();
    row->set_load_case(one.load_case);
    row->set_reason(one.reason);
    row->set_remedy(one.remedy);
  }
}

version_comparison from_message(const v1::VersionsCompared& message) {
  version_comparison result{message.before_id(),
                            message.after_id(),
                            size_from(message.size_before()),
                            size_from(message.size_after()),
                            message.tets_in_common(),
                            message.vertices_in_common()};
  for (const auto& one : message.surfaces())
    result.surfaces.push_back(surface_from(one));
  const auto& deviation = message.deviation();
  result.deviation = {deviation.distance_m(), read_vector(deviation.at_m()),
                      where_from(deviation.of())};
  for (const auto& one : message.load_cases())
    result.load_cases.push_back(loads_from(one));
  for (const auto& one : message.fields())
    result.fields.push_back(fields_from(one));
  for (const auto& one : message.not_compared())
    result.not_compared.push_back({one.load_case(), one.reason(), one.remedy()});
  return result;
}

}  // namespace tedit::protocol
