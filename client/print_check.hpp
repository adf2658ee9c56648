// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/print/print_checks.hpp"

namespace tedit::client {

/// What hinders printing a version (message `tedit.v1.PrintChecked`).
struct print_check {
  std::uint32_t version = 0;  ///< Its number.
  std::string version_id;
  print_settings settings;        ///< As asked for.
  print_findings what;            ///< Of the places at most the largest 1000 of each kind.
  std::uint64_t thin_places = 0;  ///< How many there are.
  std::uint64_t overhanging_places = 0;
  std::vector<std::uint32_t> facets;  ///< Slots of those that are marked, ascending.
  std::vector<print_mark> marks;      ///< Of each.
};

}  // namespace tedit::client
