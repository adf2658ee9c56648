// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/combine/combine.hpp"

#include <cstring>
#include <numbers>

#include <gmock/gmock.h>

#include "ops/tools/files/surface_file.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A box from the origin to these corners in the file's unit.
struct file_box {
  std::vector<vec3> points;
  std::vector<std::array<int, 3>> triangles;

  explicit file_box(vec3 size) {
    for (int i = 0; i < 8; ++i)
      points.push_back({(i & 1) * size.x, (i >> 1 & 1) * size.y, (i >> 2 & 1) * size.z});
    triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  }

  [[nodiscard]] attachment as_text() const {
    std::string text = "solid box\n";
    for (const auto& t : triangles) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int v : t)
        text += "vertex " + std::to_string(points[v].x) + " " + std::to_string(points[v].y) + " " +
                std::to_string(points[v].z) + "\n";
      text += "endloop\nendfacet\n";
    }
    return {"box.stl", text + "endsolid box\n"};
  }

  [[nodiscard]] attachment as_binary() const {
    std::string bytes(80, ' ');
    const auto put = [&](const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    put(static_cast<std::uint32_t>(triangles.size()));
    for (const auto& t : triangles) {
      for (int i = 0; i < 3; ++i)
        put(0.0F);
      for (const int v : t)
        for (const double x : {points[v].x, points[v].y, points[v].z})
          put(static_cast<float>(x));
      put(std::uint16_t{0});
    }
    return {"BOX.STL", bytes};
  }

  [[nodiscard]] attachment as_obj() const {
    std::string text;
    for (const auto& p : points)
      text +=
        "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (const auto& t : triangles)
      text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
              std::to_string(t[2] + 1) + "\n";
    return {"box.obj", text};
  }
};

class Combine : public test::tool_edits {
protected:
  expected<edit_result> combined(const attachment& file, const combine_settings& settings) {
    auto surface = read_surface(file);
    if (!surface)
      return fail(surface.error());
    return combine(block_, std::move(*surface), settings, {}, ctx_);
  }

  version_ptr block_ = test::box_mesh({6, 6, 6}, {0.1, 0.1, 0.1});
  const file_box box_{{40, 30, 20}};  // mm
};

TEST_F(Combine, ABoxHasSixFacesInEachFormat) {
  for (const auto& file : {box_.as_text(), box_.as_binary(), box_.as_obj()}) {
    const auto surface = read_surface(file);
    ASSERT_TRUE(surface) << file.name << ": " << render(surface.error());
    EXPECT_EQ(surface->points.size(), 8u) << file.name;
    EXPECT_EQ(surface->triangles.size(), 12u) << file.name;
    EXPECT_EQ(surface->names.size(), 6u) << file.name;
  }
}

TEST_F(Combine, WhatIsCutIsTheFilesVolumeInItsUnit) {
  const auto result =
    combined(box_.as_binary(), {.mode = boolean_mode::cut, .at = {0.03, 0.03, 0.09}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, -0.04 * 0.03 * 0.01, 1e-12);
}

TEST_F(Combine, FacesThatAreLargeBesideTheTetsAreDivided) {
  const auto fine = test::box_mesh({16, 16, 16}, {0.1, 0.1, 0.1});
  auto surface = read_surface(box_.as_text());
  ASSERT_TRUE(surface);

  const auto result = combine(fine, std::move(*surface),
                              {.mode = boolean_mode::cut, .at = {0.031, 0.033, 0.087}}, {}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(fine, *result);
  EXPECT_NEAR(result->volume_change, -0.04 * 0.03 * 0.013, 1e-11);
}

TEST_F(Combine, WhatIsAddedStandsOutOfThePart) {
  const auto result =
    combined(box_.as_text(),
             {.mode = boolean_mode::add, .unit = 0.01, .scale = 0.1, .at = {0.03, 0.03, 0.09}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, 0.04 * 0.03 * 0.01, 1e-12);
}

TEST_F(Combine, WhatBothShareStays) {
  const auto result =
    combined(box_.as_text(), {.mode = boolean_mode::keep, .unit = 0.002, .at = {0.05, 0.05, 0.05}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(total_volume(*result->candidate), 0.05 * 0.05 * 0.04, 1e-12);
}

TEST_F(Combine, TheFilesZAxisPointsWhereItIsToldTo) {
  // 20 mm high along x now, 40 mm along -z, from the middle of the right side.
  const auto result = combined(
    box_.as_text(), {.mode = boolean_mode::add, .at = {0.09, 0.03, 0.07}, .direction = {1, 0, 0}});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(block_, *result);
  EXPECT_NEAR(result->volume_change, 0.01 * 0.03 * 0.04, 1e-12);
}

TEST_F(Combine, ASurfaceThatLooksInwardIsTurned) {
  auto inward = box_;
  for (auto& t : inward.triangles)
    std::swap(t[1], t[2]);

  const auto result =
    combined(inward.as_text(), {.mode = boolean_mode::cut, .at = {0.03, 0.03, 0.09}});

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_NEAR(result->volume_change, -0.04 * 0.03 * 0.01, 1e-12);
}

TEST_F(Combine, WhatIsWrongWithAFileIsSaid) {
  auto open = box_;
  open.triangles.pop_back();
  const auto text = [](const std::string& name, const std::string& bytes) {
    return read_surface({name, bytes}).error().message;
  };

  EXPECT_THAT(read_surface(open.as_text()).error().message,
              HasSubstr("3 edges have not one triangle on each side"));
  EXPECT_THAT(text("part.step", "ISO-10303-21;"), HasSubstr("of no kind that can be combined"));
  EXPECT_THAT(text("a.stl", ""), HasSubstr("cannot be read"));
  EXPECT_THAT(text("a.obj", "hello"), HasSubstr("cannot be read"));
  EXPECT_THAT(text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n"), HasSubstr("cannot be read"));
  EXPECT_THAT(text("a.msh", "$MeshFormat"), Not(IsEmpty()));
}

TEST_F(Combine, ATruncatedFileIsRefusedAtEveryLength) {
  for (const auto& file : {box_.as_text(), box_.as_binary(), box_.as_obj()})
    for (std::size_t length = 0; length + 16 < file.bytes.size(); length += 7)
      EXPECT_FALSE(read_surface({file.name, file.bytes.substr(0, length)}))
        << file.name << " of " << length << " bytes";
}

TEST_F(Combine, BesideThePartBothSizesAreTold) {
  const auto result = combined(box_.as_text(), {.unit = 1, .at = {100, 0, 0}});

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("40000 x 30000 x 20000 mm, the part 100 x 100"));
}

}  // namespace
}  // namespace tedit::ops
