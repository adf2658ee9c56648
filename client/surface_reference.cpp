// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/surface_reference.hpp"

#include <algorithm>
#include <cmath>

#include "base/short_number.hpp"
#include "mesh/distances.hpp"

namespace tedit::client {

namespace {

constexpr double metres_per_mm = 1e-3;
/// As shares of the part's size.
constexpr double usual_reach = 0.01;
constexpr double same_distance = 1e-9;
constexpr std::size_t names_to_tell = 8;

double size_of(const surface_model& part) {
  vec3 least{1e300, 1e300, 1e300};
  vec3 most = -least;
  part.facets().for_each([&](std::uint32_t, const surface_facet& f) {
    for (const auto v : f.v) {
      const vec3 p = *part.positions().find(v);
      least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
  });
  return part.total_facets() > 0 ? norm(most - least) : 0;
}

std::string text_of(double mm) {
  return short_number(mm, 9);
}

std::string text_of(vec3 mm) {
  return "(" + text_of(mm.x) + ", " + text_of(mm.y) + ", " + text_of(mm.z) + ") mm";
}

std::string names_of(const surface_model& part) {
  std::set<std::string> names;
  for (const auto& [id, row] : part.surfaces())
    if (!row.name.empty())
      names.insert(row.name);
  if (names.empty())
    return "This part's surfaces have no names: give a point, at_mm";
  std::string result;
  std::size_t told = 0;
  for (const auto& name : names)
    if (told++ < names_to_tell)
      result += (result.empty() ? "Its surfaces are called " : ", ") + name;
  return result + (names.size() > names_to_tell ? ", ..." : "");
}

/// m: how far each of these surfaces is.
std::map<surface_id, double> distances(const surface_model& part, const std::set<surface_id>& of,
                                       vec3 p) {
  std::map<surface_id, double> result;
  const auto& at = part.positions();
  part.facets().for_each([&](std::uint32_t, const surface_facet& f) {
    if (!of.contains(f.surface))
      return;
    const double off = point_to_triangle(p, *at.find(f.v[0]), *at.find(f.v[1]), *at.find(f.v[2]));
    const auto [row, fresh] = result.emplace(f.surface, off);
    row->second = std::min(row->second, off);
  });
  return result;
}

/// One of the nearest will do where the whole feature is meant.
expected<surface_id> nearest(const surface_model& part, const std::set<surface_id>& of,
                             const surface_reference& one) {
  const vec3 at_mm = *one.at_mm;
  const double size = size_of(part);
  const double reach = one.within_mm > 0 ? metres_per_mm * one.within_mm : usual_reach * size;
  const auto all = distances(part, of, metres_per_mm * at_mm);
  const auto first =
    std::ranges::min_element(all, {}, &std::pair<const surface_id, double>::second);
  if (first->second > reach)
    return fail(ec::surface_not_found,
                "the nearest surface to " + text_of(at_mm) + ", " + std::to_string(first->first) +
                  ", is " + text_of(first->second / metres_per_mm) + " mm away",
                "Give a point on the surface that is meant, or a larger within_mm");
  for (const auto& [id, off] : all)
    if (!one.feature && id != first->first && off <= first->second + same_distance * size)
      return fail(ec::invalid_argument,
                  text_of(at_mm) + " lies between surfaces " + std::to_string(first->first) +
                    " and " + std::to_string(id),
                  "Give a point inside the surface that is meant");
  return first->first;
}

/// Which reference a number stands for; beyond all of them for a surface's own number.
std::uint64_t number_of_reference(surface_id id) {
  return static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(place_of_reference(0));
}

}  // namespace

void surface_references::note(const std::string& label, const surface_model& before,
                              const surface_model& after) {
  if (label.empty())
    return;
  auto& made = made_[label];
  made.clear();
  for (const auto& [id, row] : after.surfaces())
    if (!before.surfaces().contains(id))
      made.insert(id);
}

expected<std::set<surface_id>> surface_references::candidates(const surface_reference& one,
                                                              const surface_model& part) const {
  const auto made = made_.find(one.made_by);
  if (!one.made_by.empty() && made == made_.end())
    return fail(ec::surface_not_found, "no edit so far was labelled \"" + one.made_by + "\"",
                "Give the edit that makes them \"label\": \"" + one.made_by + "\"");
  std::set<surface_id> result;
  for (const auto& [id, row] : part.surfaces())
    if ((one.name.empty() || row.name == one.name) &&
        (one.made_by.empty() || made->second.contains(id)))
      result.insert(id);
  if (!result.empty())
    return result;
  if (one.made_by.empty())
    return fail(ec::surface_not_found, "no surface is called \"" + one.name + "\"", names_of(part));
  return fail(ec::surface_not_found,
              made->second.empty()
                ? "the edit \"" + one.made_by + "\" made no surface of its own"
                : "of what the edit \"" + one.made_by + "\" made no surface " +
                    (one.name.empty() ? "is left" : "is called \"" + one.name + "\""),
              "Give a point instead, at_mm");
}

expected<std::vector<surface_id>> surface_references::find(const surface_reference& one,
                                                           const surface_model& part) const {
  const auto those = candidates(one, part);
  if (!those)
    return fail(those.error());
  if (!one.at_mm)
    return std::vector<surface_id>(those->begin(), those->end());
  return nearest(part, *those, one).map([](surface_id id) { return std::vector<surface_id>{id}; });
}

namespace {

/// The middle of its largest facet: of all places the one that is surely within the surface and
/// furthest from others, also where it is bent.
std::optional<vec3> place_within(surface_id surface, const surface_model& part) {
  std::optional<vec3> place;
  double most = 0;
  part.facets().for_each([&](std::uint32_t, const surface_facet& f) {
    if (f.surface != surface)
      return;
    const vec3 a = *part.positions().find(f.v[0]);
    const vec3 b = *part.positions().find(f.v[1]);
    const vec3 c = *part.positions().find(f.v[2]);
    const double size = norm(cross(b - a, c - a));
    if (place && size <= most)
      return;
    most = size;
    place = (1.0 / 3) * (a + b + c);
  });
  return place;
}

/// As a person would write it: to a ten-thousandth of a millimetre.
double rounded_mm(double metres) {
  constexpr double steps_per_mm = 1e4;
  return std::round(metres / metres_per_mm * steps_per_mm) / steps_per_mm;
}

}  // namespace

std::optional<surface_reference> reference_to(surface_id surface, const surface_model& part,
                                              const std::string& made_by) {
  const auto row = part.surfaces().find(surface);
  const auto place = place_within(surface, part);
  if (row == part.surfaces().end() || !place)
    return std::nullopt;
  surface_reference result;
  result.made_by = made_by;
  const auto same_name = [&](const auto& other) { return other.second.name == row->second.name; };
  if (!row->second.name.empty() && std::ranges::count_if(part.surfaces(), same_name) == 1)
    result.name = row->second.name;
  else
    result.at_mm = vec3{rounded_mm(place->x), rounded_mm(place->y), rounded_mm(place->z)};
  return result;
}

void refer_to_surfaces(
  std::vector<surface_id>& ids, std::vector<surface_reference>& references,
  const std::function<std::optional<surface_reference>(surface_id)>& reference_of) {
  for (auto& id : ids) {
    const auto one = reference_of(id);
    if (!one)
      continue;
    const auto known = std::ranges::find(references, *one);
    id = place_of_reference(static_cast<std::size_t>(known - references.begin()));
    if (known == references.end())
      references.push_back(*one);
  }
}

void refer_to_surfaces(
  fem::load_case& loads, std::vector<surface_reference>& references,
  const std::function<std::optional<surface_reference>(surface_id)>& reference_of) {
  for (auto& one : loads.constraints)
    refer_to_surfaces(one.surfaces, references, reference_of);
  for (auto& one : loads.loads)
    refer_to_surfaces(one.surfaces, references, reference_of);
}

std::string words_of(const surface_reference& one) {
  std::string result = one.feature ? std::string(kind_name(*one.feature)) : std::string();
  const auto add = [&](const std::string& word) { result += (result.empty() ? "" : " ") + word; };
  if (!one.name.empty())
    add(one.name);
  if (!one.made_by.empty())
    add(result.empty() ? "what " + one.made_by + " made" : "of what " + one.made_by + " made");
  if (one.at_mm)
    add("at " + text_of(*one.at_mm));
  return result;
}

std::string words_of(const std::vector<surface_id>& ids,
                     const std::vector<surface_reference>& references) {
  std::string result;
  for (const auto id : ids) {
    const auto k = number_of_reference(id);
    result += (result.empty() ? "" : ", ") +
              (k < references.size() ? words_of(references[k]) : std::to_string(id));
  }
  return result;
}

expected<std::vector<std::vector<surface_id>>> meanings_of(
  const std::vector<surface_reference>& references, const surface_references& known,
  const surface_model& part, const feature_selector& select) {
  std::vector<std::vector<surface_id>> result;
  for (const auto& one : references) {
    auto ids = known.find(one, part);
    if (!ids)
      return fail(ids.error());
    if (one.feature) {
      const auto grown = select({.kind = *one.feature, .surfaces = *ids});
      if (!grown)
        return fail(grown.error());
      for (const auto& feature : *grown)
        ids->insert(ids->end(), feature.surfaces.begin(), feature.surfaces.end());
      std::ranges::sort(*ids);
      ids->erase(std::ranges::unique(*ids).begin(), ids->end());
    }
    result.push_back(std::move(*ids));
  }
  return result;
}

void put_surfaces(std::vector<surface_id>& ids,
                  const std::vector<std::vector<surface_id>>& meanings) {
  if (meanings.empty())
    return;
  std::vector<surface_id> result;
  const auto add = [&](surface_id id) {
    if (std::ranges::find(result, id) == result.end())
      result.push_back(id);
  };
  for (const auto id : ids) {
    const auto k = number_of_reference(id);
    if (k < meanings.size())
      std::ranges::for_each(meanings[k], add);
    else
      add(id);
  }
  ids = std::move(result);
}

void put_surfaces(fem::load_case& loads, const std::vector<std::vector<surface_id>>& meanings) {
  for (auto& one : loads.constraints)
    put_surfaces(one.surfaces, meanings);
  for (auto& one : loads.loads)
    put_surfaces(one.surfaces, meanings);
}

}  // namespace tedit::client
