// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/carried_field.hpp"

#include <algorithm>

namespace tedit::desktop {

namespace {

/// Of an array with some values a vertex, those of the vertices that are kept; nothing of none.
template <class T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t vertices,
                       const std::vector<std::size_t>& kept) {
  const std::size_t each = vertices == 0 ? 0 : all.size() / vertices;
  std::vector<T> result;
  result.reserve(each * kept.size());
  for (const auto i : kept)
    result.insert(result.end(), all.begin() + static_cast<std::ptrdiff_t>(i * each),
                  all.begin() + static_cast<std::ptrdiff_t>((i + 1) * each));
  return result;
}

}  // namespace

shared_field carried_field(const client::field_event& field, const client::surface_model& before,
                           const client::surface_model& after) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < field.vertices.size(); ++i) {
    const auto* was = before.positions().find(field.vertices[i]);
    const auto* is = after.positions().find(field.vertices[i]);
    if (was && is && *was == *is)
      kept.push_back(i);
  }
  auto result = std::make_shared<client::field_event>();
  result->report = field.report;
  result->report.version_id = after.version_id();
  result->envelope = field.envelope;
  if (result->envelope)
    result->envelope->version_id = after.version_id();
  const auto count = field.vertices.size();
  result->vertices = some_of(field.vertices, count, kept);
  for (const auto& [name, values] : field.values)
    result->values[name] = some_of(values, count, kept);
  for (const auto& [name, cases] : field.worst_cases)
    result->worst_cases[name] = some_of(cases, count, kept);
  return result;
}

}  // namespace tedit::desktop
