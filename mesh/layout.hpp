// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

#include "base/execution.hpp"
#include "mesh/facet_pages.hpp"

namespace tedit {

/// A type that crosses the border between host and plugin, as who was compiled has it. Both have
/// mesh code of their own, which works on what the other's made: see ops/sdk/operation.hpp. Inline
/// throughout, so that it tells of the headers, compiler and options of whoever calls it.
struct layout_fact {
  const char* type;
  std::uint64_t size;    ///< Bytes; 0 for what grows with minor releases.
  std::uint64_t places;  ///< Of members or virtual functions, and their sizes or types: a hash.
};

}  // namespace tedit

/// A type with another layout, or a member more, needs a line here and a new `ops::sdk_major`:
/// tests/ops/sdk_layout_test.cpp tells when. Members are named by structured bindings where that is
/// possible: what was forgotten does not compile.
namespace tedit::layout {

/// FNV-1a.
class hash {
public:
  void add(std::uint64_t value) { value_ = (value_ ^ value) * 0x100000001b3; }
  void add(std::string_view text) {
    for (const char c : text)
      add(static_cast<unsigned char>(c));
  }
  [[nodiscard]] std::uint64_t get() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Members of an object, in any order that stays.
template <class T, class... Members>
layout_fact of(const char* type, const T& whole, const Members&... members) {
  hash places;
  const auto place = [&](const void* part) {
    return static_cast<const char*>(part) - reinterpret_cast<const char*>(std::addressof(whole));
  };
  (..., (places.add(static_cast<std::uint64_t>(place(std::addressof(members)))),
         places.add(sizeof(Members))));  // NOLINT(bugprone-sizeof-expression): a pointer, too.
  return {type, sizeof(T), places.get()};
}

/// Virtual functions, by what a pointer to one holds (its place in the table) and by its type.
template <class... Functions>
layout_fact table(const char* type, Functions... functions) {
  hash places;
  const auto add = [&](const auto& function) {
    std::array<std::uint64_t, sizeof(function) / sizeof(std::uint64_t)> words{};
    std::memcpy(words.data(), &function, sizeof(function));
    for (const auto word : words)
      places.add(word);
    places.add(std::string_view(typeid(function).name()));
  };
  (..., add(functions));
  return {type, 0, places.get()};
}

/// The last of an enumeration: more may only follow.
template <class Enum>
layout_fact last(const char* type, Enum value) {
  return {type, sizeof(Enum), static_cast<std::uint64_t>(value)};
}

/// A version of one surface and one region, no tets.
inline version_ptr small_version() {
  mesh_data data;
  data.surfaces = {{1, "a", {surface_geometry::kind::sphere, {1, 2, 3}, {}, 4}}};
  data.regions = {{2, "b"}};
  return mesh_version::create(std::move(data));
}

inline void add_mesh(std::vector<layout_fact>& facts) {
  const auto version = small_version();
  const auto& m = *version;
  const auto& d = m.data();
  facts.push_back(of("mesh_version", m, m.data(), m.pages(), m.id()));
  facts.push_back(of("mesh_data", d, d.positions, d.vertex_tet, d.tets, d.tet_regions, d.neighbours,
                     d.facets, d.interfaces, d.surfaces, d.regions, d.vertices, d.live_tets,
                     d.live_facets, d.free_vertex, d.free_tet, d.free_facet, d.vertex_order,
                     d.tet_order));
  const auto& [arrays, surfaces, regions, counts] = m.pages();
  facts.push_back(of("manifest", m.pages(), arrays, surfaces, regions, counts));
  facts.push_back(of("manifest row", arrays[0], arrays[0].size, arrays[0].pages));
  facts.push_back(of("paged_array", d.positions, d.positions.pages()));
  facts.push_back({"page", sizeof(page), max_page_bytes});
  const auto& [surface, surface_name, geometry] = d.surfaces[0];
  facts.push_back(of("surface_info", d.surfaces[0], surface, surface_name, geometry));
  const auto& [type, point, axis, radius, slope, tube, tolerance, spline] = geometry;
  facts.push_back(
    of("surface_geometry", geometry, type, point, axis, radius, slope, tube, tolerance, spline));
  facts.push_back(last("kind of surface_geometry", surface_geometry::kind::spline));
  const spline_surface free_form;
  const auto& [degree, knots, poles, weights] = free_form;
  facts.push_back(of("spline_surface", free_form, degree, knots, poles, weights));
  const auto& [region, region_name] = d.regions[0];
  facts.push_back(of("region_info", d.regions[0], region, region_name));
  const facet_page kept;
  facts.push_back(of("facet_page", kept, kept.parts, kept.extent, kept.extents, kept.positions));
  const facet_page::part part;
  facts.push_back(of("facet_page part", part, part.surface, part.size.facets, part.size.area_m2));
  const boundary_facet facet;
  facts.push_back(of("boundary_facet", facet, facet.v, facet.tet, facet.surface));
  // Both sides hash what versions are made of: the same content has the same id.
  facts.push_back({"content of a version", 0, m.id().low});
}

inline void add_base(std::vector<layout_fact>& facts) {
  const execution run;
  const auto& [cancel, progress] = run;
  facts.push_back(of("execution", run, cancel, progress));
  facts.push_back({"cancel_token", sizeof(cancel_token), cancel_token::state_size});
  const error e;
  const auto& [code, message, remedy, where, most, rival] = e;
  facts.push_back(of("error", e, code, message, remedy, where, most, rival));
  const most_that_works found;
  facts.push_back(of("most_that_works", found, found.parameter, found.value));
  const rival_change other;
  const auto& [id, number, client, cause, operation_id, made_at] = other;
  facts.push_back(of("rival_change", other, id, number, client, cause, operation_id, made_at));
  facts.push_back(last("ec", ec::internal));
}

}  // namespace tedit::layout
