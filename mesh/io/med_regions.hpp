// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mesh/io/med_content.hpp"
#include "mesh/types.hpp"

namespace tedit {

/// Which regions the families of tets are: a tet is in one region, but a family may be in several
/// groups. Those that have the same groups are a region. What we wrote has its id in the group's
/// name; others take the numbers at the end of their names where these are distinct, else they are
/// counted. A region is called like the smallest of its groups.
class med_regions {
public:
  using find_family = std::function<const med_content::family*(std::int32_t)>;

  /// @param sizes tets of each family.
  med_regions(const find_family& find, const std::map<std::int32_t, std::size_t>& sizes);

  [[nodiscard]] region_id of(std::int32_t family) const;
  [[nodiscard]] const std::vector<region_info>& names() const { return names_; }
  /// What is said of groups that are no region; empty: nothing.
  [[nodiscard]] const std::string& notice() const { return notice_; }

private:
  struct tet_set {
    std::vector<std::string> groups;
    std::vector<std::int32_t> families;
    std::size_t tets = 0;
    std::string name;
    bool has_id = false;
    region_id id = 0;
  };

  void take_own_names();
  void choose_names(const std::map<std::string, std::size_t>& sizes, std::size_t tets);
  void number_others();
  void say_lost(const std::map<std::string, std::size_t>& sizes);

  std::vector<tet_set> parts_;
  std::map<std::int32_t, region_id> region_of_;
  std::vector<region_info> names_;
  std::string notice_;
};

}  // namespace tedit
