// SPDX-License-Identifier: AGPL-3.0-or-later
// What plugins of SDK 8 were compiled with. A row that differs here is a plugin refused or broken
// there: raise sdk_major, and put in the rows that the test prints.
#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {
namespace {

#if defined(__x86_64__) && defined(__GLIBCXX__) && !defined(_GLIBCXX_DEBUG)

constexpr std::uint32_t frozen_major = 8;
constexpr layout_fact frozen[] = {
  {"execution", 48, 0xc257467f4f1fc055},
  {"cancel_token", 16, 0x18},
  {"error", 328, 0x2c3e416491325021},
  {"most_that_works", 40, 0x62c19e803b2a5c0d},
  {"rival_change", 168, 0x28840b34fa1b2a29},
  {"ec", 4, 0x25},
  {"mesh_version", 688, 0x5d1e2022d1876bed},
  {"mesh_data", 576, 0x4fc83ca6d6f49989},
  {"manifest", 96, 0xd72d158d2acfc745},
  {"manifest row", 32, 0x7f4e67f76a560ad},
  {"paged_array", 56, 0x8327007b4eb4725},
  {"page", 96, 0x10000},
  {"surface_info", 144, 0x87fabbe98e439a6d},
  {"surface_geometry", 104, 0x565d855a35af3dca},
  {"kind of surface_geometry", 1, 0x6},
  {"spline_surface", 104, 0x7fde3420e8d2e55d},
  {"region_info", 40, 0x2a9a9a7f8a44fc31},
  {"facet_page", 128, 0x6cb3c96d8e46369d},
  {"facet_page part", 24, 0xb758c3e917e1d30d},
  {"boundary_facet", 24, 0x9d5822dadd9bc7d1},
  {"content of a version", 0, 0xe1fd1f5df81ba983},
  {"operation_description", 304, 0x9ac6dc22d23233c9},
  {"selection_description", 48, 0xb2b44354c1c78355},
  {"parameter_description", 264, 0x6f55dca975e6e6e1},
  {"parameter_type", 4, 0xc},
  {"context", 0, 0x80ad611acffdea7d},
  {"edit_result", 192, 0x6201b55312d2f59},
  {"expected<edit_result>", 336, 0x831c807b4ea29ad},
  {"figure", 104, 0x5f15b9f6bc82186d},
  {"thorough_settings", 48, 0x7ae988424bab0f6},
  {"improvement", 4, 0x2},
  {"closed_surface", 48, 0x7d93967f2853a88d},
  {"tet_filling", 48, 0x7d93967f2853a88d},
  {"planar_polygon", 48, 0x7d93967f2853a88d},
  {"planar_filling", 48, 0x7d93967f2853a88d},
  {"services", 0, 0xda3629db1cab812e},
  {"operation", 0, 0x731b0c3d0c677991},
  {"tool_surface", 120, 0xba369c31a7268b25},
  {"boolean_request", 16, 0x2a9ab27f8a4524f9},
  {"boolean_mode", 4, 0x2},
  {"boolean_result", 96, 0x3c7eb4507c08dfd5},
};

std::string text_of(const layout_fact& fact) {
  std::ostringstream out;
  out << "  {\"" << fact.type << "\", " << fact.size << ", 0x" << std::hex << fact.places << "},";
  return out.str();
}

TEST(SdkLayout, IsThatOfItsMajorNumber) {
  ASSERT_EQ(sdk_major, frozen_major) << "the rows are those of another major number";
  std::string all;
  for (const auto& fact : layout_facts())
    all += text_of(fact) + "\n";

  std::size_t found = 0;
  for (const auto& row : frozen)
    for (const auto& fact : layout_facts())
      if (std::string_view(fact.type) == row.type) {
        ++found;
        EXPECT_EQ(text_of(fact), text_of(row)) << "raise sdk_major";
      }

  EXPECT_EQ(found, std::size(frozen)) << "a type went: raise sdk_major. Now:\n" << all;
  EXPECT_EQ(layout_facts().size(), std::size(frozen)) << "what is new, too. Now:\n" << all;
}

#endif

TEST(SdkLayout, NamesEachTypeOnce) {
  std::vector<std::string> types;
  for (const auto& fact : layout_facts())
    types.emplace_back(fact.type);
  std::ranges::sort(types);

  EXPECT_EQ(std::ranges::adjacent_find(types), types.end());
  EXPECT_GE(types.size(), 30u);
}

}  // namespace
}  // namespace tedit::ops
