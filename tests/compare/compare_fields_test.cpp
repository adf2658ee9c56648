// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/compare_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "compare/point_locator.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/renumbered.hpp"

namespace tedit {
namespace {

using function = std::function<double(vec3)>;

field make_field(const mesh_version& mesh, const std::string& name, const function& f) {
  std::vector<double> values(mesh.vertex_slots());
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_live_vertex(v))
      values[v] = f(mesh.position(v));
  return {name, field_location::vertex, 1, paged_array<double>::from(values)};
}

std::vector<field> stress(const mesh_version& mesh, const function& f) {
  return {make_field(mesh, "von_mises_pa", f)};
}

double linear(vec3 p) {
  return 5 + 3 * p.x - 2 * p.y + 7 * p.z;
}

field_difference compare(const version_ptr& before, const std::vector<field>& was,
                         const version_ptr& after, const std::vector<field>& is) {
  const auto match = match_versions(*before, *after, {});
  return *compare_fields({*before, was}, {*after, is}, *match, {});
}

const field& named(const field_difference& all, const std::string& name) {
  return *find_field(all.fields, name);
}

version_ptr grid_box() {
  return test::box_mesh({4, 4, 4}, {1, 1, 1});
}

TEST(CompareFields, AtTheSameVerticesItIsTheDifferenceOfTheValues) {
  const auto mesh = grid_box();
  const auto is = stress(*mesh, [](vec3 p) { return 2 * linear(p); });

  const auto all = compare(mesh, stress(*mesh, linear), mesh, is);

  EXPECT_EQ(all.figures.same, 125u);
  EXPECT_EQ(all.figures.interpolated + all.figures.outside, 0u);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    EXPECT_EQ(named(all, "von_mises_pa_difference").at(v), linear(mesh->position(v)));
  EXPECT_EQ(all.figures.rise.change(), linear({1, 0, 1}));
  EXPECT_EQ(all.figures.rise.at_m, (vec3{1, 0, 1}));
  EXPECT_EQ(all.figures.fall.change(), linear({0, 1, 0}));
  EXPECT_EQ(all.figures.max_von_mises_before_pa, 15);
  EXPECT_EQ(all.figures.max_von_mises_after_pa, 30);
}

TEST(CompareFields, OtherNumbersChangeNothing) {
  const auto before = grid_box();
  const auto after = test::renumbered(*before);

  const auto all =
    compare(before, stress(*before, linear), after, stress(*after, [](vec3 p) { return p.x; }));

  EXPECT_EQ(all.figures.same, 125u);
  for (vertex_id v = 0; v < after->vertex_slots(); ++v)
    EXPECT_EQ(named(all, "von_mises_pa_difference").at(v),
              after->position(v).x - linear(after->position(v)));
}

TEST(CompareFields, WithinOtherTetsTheValueBeforeIsInterpolated) {
  const auto before = grid_box();
  const auto after = test::split(before, [](tet_id t) { return t % 7 == 0; });
  const auto was = stress(*before, [](vec3 p) { return p.x * p.x; });

  const auto all = compare(before, was, after, stress(*after, linear));

  EXPECT_EQ(all.figures.interpolated, 55u);  // 384 / 7, rounded up.
  EXPECT_EQ(all.figures.outside, 0u);
  for (tet_id t = 0; t < before->tet_slots(); t += 7) {
    const auto c = before->corners(t);
    const vec3 middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    double mean = 0;
    for (const auto& p : c)
      mean += p.x * p.x / 4;
    vertex_id v = 0;
    while (after->position(v) != middle)
      ++v;
    EXPECT_EQ(named(all, "difference_mark").at(v), 1);
    EXPECT_NEAR(named(all, "von_mises_pa_difference").at(v), linear(middle) - mean, 1e-14);
  }
}

TEST(CompareFields, WhatIsOutsideIsMarkedAndHasNoDifference) {
  const auto before = grid_box();
  const auto after = test::move(before, [](vec3 p) { return p.x == 1 ? vec3{1.5, p.y, p.z} : p; });

  const auto all = compare(before, stress(*before, linear), after,
                           stress(*after, [](vec3 p) { return p.x > 1 ? 1e9 : linear(p); }));

  EXPECT_EQ(all.figures.same, 100u);
  EXPECT_EQ(all.figures.outside, 25u);
  EXPECT_EQ(all.figures.rise.change(), 0);  // Not that of the vertices outside.
  EXPECT_EQ(all.figures.max_von_mises_after_pa, 1e9);
  for (vertex_id v = 0; v < after->vertex_slots(); ++v) {
    EXPECT_EQ(named(all, "difference_mark").at(v), after->position(v).x > 1 ? 2 : 0);
    EXPECT_EQ(named(all, "von_mises_pa_difference").at(v), 0);
  }
}

TEST(CompareFields, OutsideByNextToNothingCountsAsOnTheFace) {
  const auto before = grid_box();
  const auto after =  // A hundredth of a tet's height, and a tenth.
    test::move(before, [](vec3 p) {
      return p.x < 1 ? p : p.y < .5 ? vec3{1.0025, p.y, p.z} : vec3{1.025, p.y, p.z};
    });

  const auto all =
    compare(before, stress(*before, linear), after, stress(*after, [](vec3) { return 0.0; }));

  EXPECT_EQ(all.figures.interpolated, 10u);
  EXPECT_EQ(all.figures.outside, 15u);
  for (vertex_id v = 0; v < after->vertex_slots(); ++v) {
    auto face = after->position(v);
    face.x = std::min(face.x, 1.0);
    if (named(all, "difference_mark").at(v) == 1) {
      EXPECT_NEAR(named(all, "von_mises_pa_difference").at(v), -linear(face), .02);
    }
  }
}

/// The slow way: every vertex in every tet.
double value_by_brute_force(const mesh_version& mesh, const field& f, const vec3& p, bool& inside) {
  double best = -still_inside;
  double value = 0;
  inside = false;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    auto weights = barycentric(mesh.corners(t), p);
    const double least = std::ranges::min(*weights);
    if (least <= best)
      continue;
    best = least;
    inside = true;
    put_on_face(*weights);
    value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value += (*weights)[i] * f.at(mesh.tet_at(t).v[i]);
  }
  return value;
}

TEST(CompareFields, OnMeshesOfNoCommonOriginItAgreesWithTheSlowWay) {
  const auto bend = [](vec3 p) {
    return vec3{p.x + .1 * std::sin(3 * p.y), p.y + .05 * p.z * p.z, p.z + .1 * p.x * p.y};
  };
  const auto before = test::box_mesh({5, 4, 3}, {1, 1, 1}, bend);
  const auto after = test::box_mesh({4, 6, 5}, {1, 1, 1.05}, bend);
  const auto was = stress(*before, [](vec3 p) { return std::sin(4 * p.x) + p.y * p.z; });

  const auto all = compare(before, was, after, stress(*after, linear));

  EXPECT_GT(all.figures.interpolated, 80u);
  EXPECT_GT(all.figures.outside, 10u);
  for (vertex_id v = 0; v < after->vertex_slots(); ++v) {
    bool inside = false;
    const double slow = value_by_brute_force(*before, was[0], after->position(v), inside);
    EXPECT_EQ(named(all, "difference_mark").at(v) == 2, !inside) << v;
    if (inside) {
      EXPECT_NEAR(named(all, "von_mises_pa_difference").at(v), linear(after->position(v)) - slow,
                  1e-12);
    }
  }
}

TEST(CompareFields, VectorsAndSafetyFactorsAreTakenAlong) {
  const auto mesh = grid_box();
  auto was = stress(*mesh, linear);
  auto is = stress(*mesh, linear);
  was.push_back({"displacement_m", field_location::vertex, 3,
                 paged_array<double>::from(std::vector<double>(375, 1))});
  is.push_back({"displacement_m", field_location::vertex, 3,
                paged_array<double>::from(std::vector<double>(375, 4))});
  was.push_back(make_field(*mesh, "safety_factor", [](vec3 p) { return p.x == 0 ? 0 : 2 + p.y; }));
  is.push_back(make_field(*mesh, "safety_factor", [](vec3) { return 0.0; }));

  const auto all = compare(mesh, was, mesh, is);

  EXPECT_EQ(named(all, "displacement_m_difference").components, 3);
  EXPECT_EQ(named(all, "displacement_m_difference").at(124, 2), 3);
  EXPECT_EQ(all.figures.min_safety_before, 2);  // 0 is "not known".
  EXPECT_FALSE(all.figures.min_safety_after);
}

TEST(CompareFields, WithoutStressItIsRefused) {
  const auto mesh = grid_box();
  const auto match = match_versions(*mesh, *mesh, {});
  const auto is = stress(*mesh, linear);

  const auto all = compare_fields({*mesh, {}}, {*mesh, is}, *match, {});

  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().code, ec::invalid_argument);
  EXPECT_NE(all.error().message.find("before"), std::string::npos);
}

}  // namespace
}  // namespace tedit
