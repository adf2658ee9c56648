// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/compare.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "client-qt/model/field_values.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

struct compare_phrases {
  Q_DECLARE_TR_FUNCTIONS(compare)
};

QString figure(const QString& words, const std::optional<double>& value,
               const std::optional<double>& before, const QString& unit) {
  if (!value)
    return {};
  QString text = "   " + words.arg(unit == "kg" ? mass(*value) : quantity(*value, unit));
  if (before)
    if (const QString by = change(*before, *value); !by.isEmpty())
      text += " (" + by + ")";
  return text;
}

/// m^2 that each vertex slot stands for: a third of the facets around it.
std::unordered_map<std::uint32_t, float> areas_of(const client::surface_model& surface) {
  std::unordered_map<std::uint32_t, float> result;
  surface.facets().for_each([&](std::uint32_t, const client::surface_facet& facet) {
    const vec3 a = *surface.positions().find(facet.v[0]);
    const vec3 n =
      cross(*surface.positions().find(facet.v[1]) - a, *surface.positions().find(facet.v[2]) - a);
    for (const auto slot : facet.v)
      result[slot] += static_cast<float>(norm(n) / 6);
  });
  return result;
}

}  // namespace

shown_field difference_field(shown_field wanted) {
  if (!is_of_result(wanted))
    return shown_field::von_mises;
  const auto& quantity = quantity_of(wanted);
  if (quantity.part == fem::shown_part::component)
    return wanted;
  const auto first = [&](const fem::shown_quantity& one) {
    return one.array == quantity.array && one.part == fem::shown_part::component && one.index == 0;
  };
  return {
    static_cast<int>(std::ranges::find_if(fem::shown_quantities, first) - fem::shown_quantities)};
}

shared_field difference(const version_record& before, const shared_field& before_field,
                        const version_record& after, const shared_field& after_field,
                        shown_field wanted) {
  auto result = std::make_shared<client::field_event>();
  result->report = after_field->report;
  result->envelope = after_field->envelope;
  const auto& as = quantity_of(difference_field(wanted));
  const auto* form = fem::find_array(as.array);
  auto& values = result->values[as.array];
  if (!is_of_result(wanted))
    wanted = shown_field::von_mises;
  const value_reader value_before(before_field->values, wanted);
  const value_reader value_after(after_field->values, wanted);
  const auto& slots_before = before_field->vertices;
  std::size_t k = 0;  // Both lists ascend.
  for (std::size_t i = 0; i < after_field->vertices.size(); ++i) {
    const auto slot = after_field->vertices[i];
    const auto* there = before.surface->positions().find(slot);
    const auto* here = after.surface->positions().find(slot);
    while (k < slots_before.size() && slots_before[k] < slot)
      ++k;
    const bool both = k < slots_before.size() && slots_before[k] == slot;
    const float was = both ? value_before(k) : NAN;
    const float is = value_after(i);
    if (!there || !here || !(*there == *here) || !std::isfinite(was) || !std::isfinite(is))
      continue;
    result->vertices.push_back(slot);
    values.resize(values.size() + static_cast<std::size_t>(form->components));
    const bool none = form->needs_yield && is == was;  // 0 means "not known" there.
    values[values.size() - static_cast<std::size_t>(form->components - as.index)] =
      none ? 1e-30F : is - was;
  }
  return result;
}

shared_field difference(const client::comparison& made, shown_field wanted) {
  if (!is_of_result(wanted))
    wanted = shown_field::von_mises;
  const auto& as = quantity_of(wanted);
  const auto* form = fem::find_array(as.array);
  const auto& all = made.differences.of(as.array);
  if (as.part != fem::shown_part::component || form->needs_yield || all.empty())
    return nullptr;
  auto result = std::make_shared<client::field_event>();
  result->report.version_id = made.what.after_id;
  result->report.load_case = made.load_case;
  auto& values = result->values[as.array];
  const auto components = static_cast<std::size_t>(form->components);
  for (std::size_t i = 0; i < made.vertices.size(); ++i) {
    if (made.marks[i] == difference_mark::outside)
      continue;
    result->vertices.push_back(made.vertices[i]);
    const auto row = all.begin() + static_cast<std::ptrdiff_t>(i * components);
    values.insert(values.end(), row, row + static_cast<std::ptrdiff_t>(components));
  }
  return result;
}

shared_field field_of(const version_record& version, const std::string& load_case) {
  for (const auto& field : version.fields)
    if (field->envelope ? load_case.empty() : field->report.load_case == load_case)
      return field;
  return load_case.empty() && version.fields.size() == 1 ? version.fields.front() : nullptr;
}

QString not_held(const version_record& version, const std::string& load_case, shown_field wanted) {
  if (!version.surface)
    return compare_phrases::tr(
             "The surface of version %1 was not seen since the document was opened.")
      .arg(version.info.number);
  const auto field = field_of(version, load_case);
  if (!field)
    return compare_phrases::tr("Version %1 has no field of this load case here yet.")
      .arg(version.info.number);
  if (!has(*field, wanted))
    return compare_phrases::tr("Version %1 was seen without this quantity: %2.")
      .arg(version.info.number)
      .arg(field_title(wanted));
  return {};
}

legend common_legend(legend by, const compared& a, const compared& b) {
  if (by.mode != range_mode::automatic && by.mode != range_mode::full)
    return by;
  std::vector<float> values;
  std::vector<float> areas;
  for (const auto& one : {a, b}) {
    const auto of = areas_of(one.surface);
    const value_reader value(one.field.values, by.field);
    for (std::size_t i = 0; i < one.field.vertices.size(); ++i) {
      const auto at = of.find(one.field.vertices[i]);
      values.push_back(value(i));
      areas.push_back(at == of.end() ? 0 : at->second);
    }
  }
  by.fit(values, areas);
  by.mode = range_mode::manual;
  return by;
}

version_figures figures_of(const version_record& version) {
  version_figures result;
  if (!version.outcome)
    return result;
  for (const auto& one : version.outcome->cases)
    result.stress = std::max(result.stress.value_or(0), one.max_von_mises_pa);
  result.mass = version.outcome->cases.front().mass_kg;
  return result;
}

QString title_of(const version_record& version, const version_record* before) {
  const auto now = figures_of(version);
  const auto was = before ? figures_of(*before) : version_figures{};
  return QString("v%1").arg(version.info.number) +
         figure(compare_phrases::tr("max %1"), now.stress, was.stress, "Pa") +
         figure(compare_phrases::tr("mass %1"), now.mass, was.mass, "kg");
}

}  // namespace tedit::desktop
