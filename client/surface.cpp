// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/surface.hpp"

#include <algorithm>

namespace tedit::client {

namespace {

expected<void> check_size(const char* name, std::size_t have, std::size_t items,
                          std::size_t components) {
  if (have == items * components)
    return {};
  return fail(ec::protocol_error, "a surface update has " + std::to_string(have) + " values in \"" +
                                    name + "\" for " + std::to_string(items) + " items of " +
                                    std::to_string(components));
}

expected<void> check_slots(const char* name, const std::vector<std::uint32_t>& slots) {
  const auto largest = std::max_element(slots.begin(), slots.end());
  if (largest == slots.end() || *largest < max_slots)
    return {};
  return fail(ec::protocol_error, "a surface update lists slot " + std::to_string(*largest) +
                                    " in \"" + name + "\", which no mesh can have");
}

expected<void> check_arrays(const surface_update& update) {
  if (auto ok = check_size("positions", update.positions.size(), update.vertices.size(), 3); !ok)
    return ok;
  if (auto ok = check_size("facet_vertices", update.facet_vertices.size(), update.facets.size(), 3);
      !ok)
    return ok;
  if (auto ok = check_size("facet_surfaces", update.facet_surfaces.size(), update.facets.size(), 1);
      !ok)
    return ok;
  if (auto ok = check_slots("vertices", update.vertices); !ok)
    return ok;
  return check_slots("facets", update.facets);
}

}  // namespace

expected<void> surface_model::apply(const surface_update& update) {
  if (update.version_id.empty())
    return fail(ec::protocol_error, "a surface update names no version");
  if (!update.base_version_id.empty() && update.base_version_id != version_id_)
    return fail(ec::protocol_error,
                "a surface update builds on version " + update.base_version_id +
                  ", but this client holds " +
                  (version_id_.empty() ? std::string("none") : version_id_),
                "Open the document again to get the whole surface.");
  if (auto ok = check_arrays(update); !ok)
    return ok;
  surface_model next = update.base_version_id.empty() ? surface_model{} : *this;
  next.take(update);
  if (auto ok = next.check_references(update); !ok)
    return ok;
  *this = std::move(next);
  return {};
}

void surface_model::take(const surface_update& update) {
  version_id_ = update.version_id;
  for (const auto id : update.removed)
    surfaces_.erase(id);
  for (const auto& row : update.surfaces)
    surfaces_[row.id] = row;

  slot_table<vec3>::editor vertices(positions_);
  for (std::size_t i = 0; i < update.vertices.size(); ++i)
    vertices.set(update.vertices[i], {update.positions[3 * i], update.positions[3 * i + 1],
                                      update.positions[3 * i + 2]});

  slot_table<surface_facet>::editor facets(facets_);
  for (const auto slot : update.removed_facets)
    facets.erase(slot);
  for (std::size_t i = 0; i < update.facets.size(); ++i) {
    const auto* v = &update.facet_vertices[3 * i];
    facets.set(update.facets[i], {{v[0], v[1], v[2]}, update.facet_surfaces[i]});
  }
}

expected<void> surface_model::check_references(const surface_update& update) const {
  for (std::size_t i = 0; i < update.facet_vertices.size(); ++i)
    if (!positions_.find(update.facet_vertices[i]))
      return fail(ec::protocol_error, "facet " + std::to_string(update.facets[i / 3]) +
                                        " of a surface update names vertex " +
                                        std::to_string(update.facet_vertices[i]) +
                                        ", which this client was never sent");
  return {};
}

double surface_model::area(surface_id surface) const {
  double doubled = 0;
  facets_.for_each([&](std::uint32_t, const surface_facet& facet) {
    if (facet.surface != surface)
      return;
    const vec3 a = *positions_.find(facet.v[0]);
    doubled += norm(cross(*positions_.find(facet.v[1]) - a, *positions_.find(facet.v[2]) - a));
  });
  return doubled / 2;
}

}  // namespace tedit::client
