// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/comparisons.hpp"

#include <gtest/gtest.h>

#include "mesh/facet_pages.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::gateway {
namespace {

/// A cube of 2 x 2 x 2 cells, of whose 27 vertices one is inside.
actors::compared cube_with(const std::vector<std::pair<std::string, int>>& arrays) {
  actors::compared made;
  made.document = "cube";
  made.before = 3;
  made.after = 5;
  made.load_case = "pull";
  made.mesh = test::box_mesh({2, 2, 2}, {1, 1, 1});
  auto what = std::make_shared<version_comparison>();
  what->after_id = to_hex(made.mesh->id());
  made.what = what;
  std::vector<field> fields;
  for (const auto& [name, components] : arrays) {
    std::vector<double> values;
    for (std::size_t v = 0; v < made.mesh->vertex_slots(); ++v)
      for (int c = 0; c < components; ++c)
        values.push_back(name == mark_array ? static_cast<double>(v % 3)
                                            : static_cast<double>(v) + .25 * c);
    fields.push_back({name, field_location::vertex, components, paged_array<double>::from(values)});
  }
  made.difference = std::make_shared<const std::vector<field>>(std::move(fields));
  return made;
}

TEST(Comparisons, TheStreamHasTheBoundaryOfTheVersionAfter) {
  const auto made = cube_with({{"difference_mark", 1}, {"displacement_m_difference", 3}});
  const auto result = make_comparison(made, {});

  const auto& message = result.header.versions_compared();
  EXPECT_EQ(message.document(), "cube");
  EXPECT_EQ(message.before(), 3u);
  EXPECT_EQ(message.after(), 5u);
  EXPECT_EQ(message.load_case(), "pull");
  ASSERT_EQ(message.stream().arrays_size(), 3);
  EXPECT_EQ(message.stream().arrays(1).name(), "difference_mark");
  EXPECT_EQ(message.stream().bytes(), 26u * (4 + 1 + 12));
  const auto vertices = boundary_vertices(*made.mesh);
  ASSERT_EQ(vertices.size(), 26u);
  const auto bytes = result.parts.front();
  for (std::size_t i = 0; i < 26; ++i) {
    std::uint32_t slot = 0;
    std::memcpy(&slot, bytes.data() + 4 * i, sizeof(slot));
    EXPECT_EQ(slot, vertices[i]);
    EXPECT_EQ(static_cast<unsigned>(bytes[26 * 4 + i]), slot % 3);
    float z = 0;
    std::memcpy(&z, bytes.data() + 26 * 5 + 12 * i + 8, sizeof(z));
    EXPECT_EQ(z, static_cast<float>(slot) + .5f);
  }
}

TEST(Comparisons, OnlyWhatIsWatchedComesBesideTheUsual) {
  const auto made = cube_with({{"difference_mark", 1},
                               {"von_mises_pa_difference", 1},
                               {"stress_pa_difference", 6},
                               {"safety_factor_difference", 1}});

  EXPECT_EQ(make_comparison(made, {}).stream->arrays_size(), 3);
  const auto more = make_comparison(made, {"stress_pa"});
  ASSERT_EQ(more.stream->arrays_size(), 4);
  EXPECT_EQ(more.stream->arrays(3).name(), "stress_pa_difference");
  EXPECT_EQ(more.stream->arrays(3).components(), 6u);
}

TEST(Comparisons, WithoutADifferenceTheStreamIsEmpty) {
  const auto result = make_comparison(cube_with({}), {"stress_pa"});

  EXPECT_EQ(result.stream->arrays_size(), 0);
  EXPECT_EQ(result.stream->bytes(), 0u);
  EXPECT_EQ(result.header.versions_compared().load_case(), "pull");
}

}  // namespace
}  // namespace tedit::gateway
