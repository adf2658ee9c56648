// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/med_regions.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "mesh/io/group_names.hpp"
#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

/// Of names in one sentence; a hostile file has as many as it likes.
constexpr std::size_t most_groups_told = 12;

std::optional<region_id> as_region_id(std::int64_t number) {
  if (number < std::numeric_limits<region_id>::min() ||
      number > std::numeric_limits<region_id>::max())
    return std::nullopt;
  return static_cast<region_id>(number);
}

/// Of the groups those that divide the part, where there are any: one of all its tets does not.
std::vector<std::string> dividing(const std::vector<std::string>& groups,
                                  const std::map<std::string, std::size_t>& sizes,
                                  std::size_t tets) {
  std::vector<std::string> result;
  for (const auto& group : groups)
    if (sizes.at(group) < tets)
      result.push_back(group);
  return result.empty() ? groups : result;
}

std::string joined_groups(const std::vector<std::string>& groups) {
  std::string text;
  for (const auto& group : groups)
    text += (text.empty() ? "" : " + ") + group;
  return text;
}

}  // namespace

med_regions::med_regions(const find_family& find,
                         const std::map<std::int32_t, std::size_t>& sizes) {
  std::map<std::vector<std::string>, std::size_t> place_of;
  std::map<std::string, std::size_t> group_sizes;
  std::size_t tets = 0;
  // Families of cells are numbered downwards.
  for (auto one = sizes.rbegin(); one != sizes.rend(); ++one) {
    const auto* family = find(one->first);
    auto groups = family ? family->groups : std::vector<std::string>{};
    if (family && groups.empty())
      groups = {family->name};
    std::ranges::sort(groups);
    groups.erase(std::ranges::unique(groups).begin(), groups.end());
    const auto [found, fresh] = place_of.try_emplace(groups, parts_.size());
    if (fresh)
      parts_.push_back({groups, {}, 0, {}, false, 0});
    auto& part = parts_[found->second];
    part.families.push_back(one->first);
    part.tets += one->second;
    tets += one->second;
    for (const auto& group : groups)
      group_sizes[group] += one->second;
  }
  take_own_names();
  choose_names(group_sizes, tets);
  number_others();
  say_lost(group_sizes);
  for (const auto& part : parts_) {
    names_.push_back({part.id, part.name});
    for (const auto family : part.families)
      region_of_[family] = part.id;
  }
}

void med_regions::take_own_names() {
  for (auto& part : parts_) {
    std::map<std::size_t, std::string> pieces;  // Of a long name.
    for (const auto& group : part.groups) {
      const auto own = own_group(group, "region");
      const auto id = own ? as_region_id(own->id) : std::nullopt;
      if (!id || (part.has_id && *id != part.id))
        continue;
      part.has_id = true;
      part.id = *id;
      pieces[own->part] = own->name;
    }
    for (const auto& [place, text] : pieces)
      part.name += text;
  }
}

void med_regions::choose_names(const std::map<std::string, std::size_t>& sizes, std::size_t tets) {
  std::set<std::string> taken;
  for (auto& part : parts_) {
    if (part.has_id || part.groups.empty())
      continue;
    const auto names = dividing(part.groups, sizes, tets);
    part.name = *std::ranges::min_element(
      names, {}, [&](const std::string& group) { return sizes.at(group); });
    if (!taken.insert(part.name).second)
      part.name = joined_groups(names);
  }
}

void med_regions::number_others() {
  std::set<region_id> taken;
  for (const auto& part : parts_)
    if (part.has_id)
      taken.insert(part.id);
  const auto own = taken;
  std::vector<region_id> numbers;
  for (const auto& part : parts_) {
    const auto number = part.has_id ? std::nullopt : number_at_end(part.name);
    if (number && taken.insert(static_cast<region_id>(*number)).second)
      numbers.push_back(static_cast<region_id>(*number));
  }
  const bool all = std::ranges::count(parts_, false, &tet_set::has_id) ==
                   static_cast<std::ptrdiff_t>(numbers.size());
  region_id next = 0;
  std::size_t place = 0;
  for (auto& part : parts_) {
    if (part.has_id)
      continue;
    do
      ++next;
    while (own.contains(next));
    part.id = all ? numbers[place++] : next;
  }
}

/// A group is kept where it names a region that has all of its tets.
void med_regions::say_lost(const std::map<std::string, std::size_t>& sizes) {
  std::set<std::string> kept;
  for (const auto& part : parts_)
    for (const auto& group : part.groups)
      if (own_group(group, "region") || (group == part.name && sizes.at(group) == part.tets))
        kept.insert(group);
  std::size_t lost = 0;
  for (const auto& [group, size] : sizes) {
    if (kept.contains(group))
      continue;
    if (++lost <= most_groups_told)
      notice_ += (notice_.empty() ? "\"" : ", \"") + shown(group) + "\"";
  }
  if (lost > most_groups_told)
    notice_ += ", and " + std::to_string(lost - most_groups_told) + " more";
  if (lost > 0)
    notice_ = "a tet has one region: groups of tets that overlap others are not kept: " + notice_;
}

region_id med_regions::of(std::int32_t family) const {
  return region_of_.at(family);
}

}  // namespace tedit
