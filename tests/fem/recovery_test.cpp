// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/recovery.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "fem/element.hpp"
#include "fem/error_estimate.hpp"
#include "fem/fields.hpp"
#include "fem/quantities.hpp"
#include "tests/fem/quadrature.hpp"

namespace tedit::fem {
namespace {

using test::box_mesh;
using test::simple_case;

solution recovered(const problem& p, std::vector<double> displacement) {
  solution out;
  out.element_order = p.element_order;
  out.displacement = std::move(displacement);
  EXPECT_TRUE(recover(p, element_operator(p), out).has_value());
  return out;
}

solution solution_of(const problem& p) {
  auto s = recovered(p, test::solve_directly(p));
  s.converged = true;
  return s;
}

problem regular_box_problem(int order, std::array<int, 3> cells, vec3 size,
                            const load_case& loads) {
  auto p = make_problem(*box_mesh(cells, size), loads, order);
  EXPECT_TRUE(p.has_value()) << (p ? "" : render(p.error()));
  return p.value_or(problem{});
}

/// Pulled along x and held by rollers on three sides: uniform stress.
load_case tension() {
  auto loads = simple_case(200e9, 0.3);
  loads.materials[0].yield_strength_pa = 3e6;
  loads.constraints = {{{1}, roller{}}, {{3}, roller{}}, {{5}, roller{}}};
  loads.loads = {{{2}, traction{{1e6, 0, 0}}}};
  return loads;
}

class Recovery : public ::testing::TestWithParam<int> {};

TEST_P(Recovery, UniformTensionIsExactEverywhere) {
  const auto p = regular_box_problem(GetParam(), {3, 2, 2}, {3, 1, 1}, tension());

  const auto s = solution_of(p);

  EXPECT_EQ(s.preview(), GetParam() == 1);
  ASSERT_EQ(s.nodal_stress.size(), 6 * p.corner_count);
  for (std::size_t n = 0; n < p.corner_count; ++n) {
    EXPECT_NEAR(s.nodal_stress[6 * n], 1e6, 1e-3);
    EXPECT_NEAR(s.von_mises[n], 1e6, 1e-3);
    EXPECT_NEAR(s.principal_stress[3 * n], 1e6, 1e-3);
    EXPECT_NEAR(s.principal_stress[3 * n + 2], 0, 0.1);  // One of two equal ones: 1e-7.
    EXPECT_NEAR(s.nodal_strain[6 * n], 5e-6, 1e-14);
    EXPECT_NEAR(s.nodal_strain[6 * n + 1], -1.5e-6, 1e-14);
    EXPECT_NEAR(s.safety_factor[n], 3, 1e-8);
  }
  EXPECT_NEAR(s.max_von_mises_pa, 1e6, 1e-3);
  EXPECT_NEAR(s.min_safety_factor, 3, 1e-8);
  EXPECT_NEAR(s.mass_kg, 3000, 1e-9);
  EXPECT_TRUE(s.mass_known);
  EXPECT_NEAR(s.strain_energy_j, 0.5 * s.compliance_j, 1e-9 * s.compliance_j);
  EXPECT_NEAR(s.strain_energy_j, 0.5 * 1e6 * 5e-6 * 3, 1e-9);
  EXPECT_LT(s.relative_error, 1e-9);
  EXPECT_TRUE(s.singular_places.empty());
}

TEST_P(Recovery, EachRollerGetsTheReactionAlongItsNormal) {
  const auto p = regular_box_problem(GetParam(), {3, 2, 2}, {3, 1, 1}, tension());

  const auto s = solution_of(p);

  ASSERT_EQ(s.surface_reactions.size(), 3u);
  EXPECT_EQ(s.surface_reactions[0].surface, 1);
  EXPECT_NEAR(norm(s.surface_reactions[0].force_n - vec3{-1e6, 0, 0}), 0, 1e-3);
  EXPECT_NEAR(norm(s.surface_reactions[1].force_n), 0, 1e-3);
  EXPECT_NEAR(norm(s.surface_reactions[2].force_n), 0, 1e-3);
}

TEST_P(Recovery, ReactionsOfSurfacesThatShareNodesAddUp) {
  auto loads = simple_case(200e9, 0.3);
  loads.constraints = {
    {{1}, fixed{}}, {{1, 3}, prescribed_displacement{{}, 0.0, 0.0}}, {{6}, roller{}}};
  loads.loads = {{{2}, force{{10, -20, 30}}}, {{}, gravity{{1, 2, 3}}}};
  const auto p = regular_box_problem(GetParam(), {3, 2, 2}, {2, 1, 1}, loads);

  const auto s = solution_of(p);

  vec3 sum;
  for (const auto& part : s.surface_reactions) {
    sum += part.force_n;
    EXPECT_GT(norm(part.force_n), 1);
  }
  ASSERT_EQ(s.surface_reactions.size(), 3u);
  EXPECT_NEAR(norm(sum - s.reaction_n), 0, 1e-9 * norm(s.reaction_n));
  EXPECT_NEAR(norm(s.reaction_n + s.applied_n), 0, 1e-8 * norm(s.applied_n));
}

TEST_P(Recovery, StressIsNotAveragedAcrossMaterials) {
  auto p = regular_box_problem(GetParam(), {2, 2, 2}, {1, 1, 1}, simple_case(1e6, 0));
  // Stretched side by side: the stress jumps where the materials meet, and that is no error.
  p.constants = {{0, 0.5e6}, {0, 1.5e6}};
  p.densities = {1000, 0};
  p.yield_strengths = {0, 1e4};
  const std::size_t per = p.nodes_per_element;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    vec3 centre;
    for (int a = 0; a < 4; ++a)
      centre += 0.25 * p.nodes[p.element_nodes[per * e + a]];
    p.element_materials[e] = centre.z > 0.5;
  }

  const auto s = recovered(p, test::at_nodes(p, [](vec3 x) { return vec3{1e-3 * x.x, 0, 0}; }));

  EXPECT_LT(s.relative_error, 1e-9);
  EXPECT_FALSE(s.mass_known);
  EXPECT_EQ(s.mass_kg, 0);
  EXPECT_NEAR(s.max_von_mises_pa, 3000, 1e-6);
  EXPECT_NEAR(s.min_safety_factor, 1e4 / 3000, 1e-9);
  for (std::size_t n = 0; n < p.corner_count; ++n) {
    const double z = p.nodes[n].z;
    EXPECT_NEAR(s.nodal_strain[6 * n], 1e-3, 1e-12);
    EXPECT_EQ(s.safety_factor[n] == 0, z < 0.4);
    if (std::abs(z - 0.5) < 1e-9) {
      EXPECT_GT(s.nodal_stress[6 * n], 1001);
      EXPECT_LT(s.nodal_stress[6 * n], 2999);
      if (GetParam() == 2) {
        EXPECT_NEAR(s.von_mises[n], 3000, 1e-6);
      }
    }
  }
}

load_case tip_loaded() {
  auto loads = simple_case(210e3, 0.3);
  loads.loads = {{{2}, traction{{0, 0, 1000}}}};
  return loads;
}

TEST_P(Recovery, TheErrorEstimateFallsWithTheMeshSize) {
  const int n = GetParam() == 1 ? 2 : 1;
  const vec3 size{4, 1, 1};
  const auto coarse =
    solution_of(regular_box_problem(GetParam(), {4 * n, n, n}, size, tip_loaded()));
  const auto fine =
    solution_of(regular_box_problem(GetParam(), {8 * n, 2 * n, 2 * n}, size, tip_loaded()));

  EXPECT_GT(coarse.relative_error, 0.01);
  EXPECT_LT(fine.relative_error, 0.8 * coarse.relative_error);
}

INSTANTIATE_TEST_SUITE_P(Orders, Recovery, ::testing::Values(1, 2));

TEST(QuadraticRecovery, ABentBeamIsNotTooStiff) {
  const auto p = regular_box_problem(2, {20, 2, 2}, {10, 1, 1}, tip_loaded());

  const auto s = solution_of(p);

  EXPECT_NEAR(s.max_displacement_m, 19.193, 0.01 * 19.193);  // Timoshenko
  EXPECT_NEAR(s.strain_energy_j, 0.5 * s.compliance_j, 1e-8 * s.compliance_j);
  EXPECT_NEAR(norm(s.reaction_n + s.applied_n), 0, 1e-7 * norm(s.applied_n));
}

TEST(QuadraticRecovery, TheRimOfAClampIsCalledSingular) {
  const auto p = regular_box_problem(2, {8, 4, 4}, {2, 1, 1}, tip_loaded());

  const auto s = solution_of(p);

  ASSERT_FALSE(s.singular_places.empty());
  EXPECT_NEAR(s.singular_places.front().von_mises_pa, s.max_von_mises_pa, 1e-9);
  for (const auto& place : s.singular_places) {
    EXPECT_EQ(place.kind, singularity::clamp_rim);
    EXPECT_EQ(place.at.x, 0);
  }
}

TEST(QuadraticRecovery, AReentrantEdgeIsCalledSingular) {
  auto p = regular_box_problem(2, {8, 8, 2}, {2, 2, 0.5}, simple_case(200e9, 0.3));
  // Without one quarter it is an L; the field has the root of the distance to the inner edge.
  problem left = p;
  left.element_nodes.clear();
  left.element_tets.clear();
  left.element_materials.clear();
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    vec3 centre;
    for (int a = 0; a < 4; ++a)
      centre += 0.25 * p.nodes[p.element_nodes[10 * e + a]];
    if (centre.x > 1 && centre.y > 1)
      continue;
    const auto nodes = std::span(p.element_nodes).subspan(10 * e, 10);
    left.element_nodes.insert(left.element_nodes.end(), nodes.begin(), nodes.end());
    left.element_tets.push_back(p.element_tets[e]);
    left.element_materials.push_back(0);
  }

  const auto s = recovered(left, test::at_nodes(left, [](vec3 x) {
                             return vec3{std::sqrt(std::hypot(x.x - 1, x.y - 1)), 0, 0};
                           }));

  ASSERT_FALSE(s.singular_places.empty());
  for (const auto& place : s.singular_places) {
    EXPECT_EQ(place.kind, singularity::reentrant_edge);
    EXPECT_NEAR(std::hypot(place.at.x - 1, place.at.y - 1), 0, 1e-12);
  }
}

TEST(QuadraticRecovery, FieldsHoldTheCornerNodesOnly) {
  const auto mesh = box_mesh({2, 2, 2}, {3, 1, 1});
  const auto p = *make_problem(*mesh, tension(), 2);

  const auto fields = make_fields(*mesh, p, solution_of(p));

  const auto* stress = find_field(fields, "principal_stress_pa");
  const auto* safety = find_field(fields, "safety_factor");
  ASSERT_NE(stress, nullptr);
  ASSERT_NE(safety, nullptr);
  ASSERT_NE(find_field(fields, "element_error_sqrt_j"), nullptr);
  const auto* strain = find_field(fields, "strain");
  ASSERT_NE(strain, nullptr);
  EXPECT_EQ(stress->values.size(), mesh->vertex_slots());
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v) {
    EXPECT_NEAR(stress->at(v), 1e6, 1e-3);
    EXPECT_NEAR(strain->at(v, 0), 5e-6, 1e-14);
    EXPECT_NEAR(strain->at(v, 1), -1.5e-6, 1e-14);
  }
}

TEST(Fields, ThatAreShownAreThoseThatSomebodyIsSent) {
  const auto mesh = box_mesh({2, 2, 2}, {3, 1, 1});
  const auto p = *make_problem(*mesh, tension(), 2);
  const auto solution = solution_of(p);
  std::set<std::string> shown;
  for (const auto& one : make_fields(*mesh, p, solution, field_range::shown))
    shown.insert(one.name);

  EXPECT_EQ(shown, (std::set<std::string>{"displacement_m", "von_mises_pa", "stress_pa",
                                          "safety_factor", "relative_error", "largest_strain"}));
  for (const auto& one : make_fields(*mesh, p, solution))
    EXPECT_EQ(is_shown(one), shown.contains(one.name)) << one.name;
  field of_case = make_fields(*mesh, p, solution).front();
  for (const auto& [name, is] : {std::pair("stress_pa (a (b))", true),
                                 {"strain (a)", false},
                                 {"envelope_von_mises", true}}) {
    of_case.name = name;
    EXPECT_EQ(is_shown(of_case), is) << name;
  }
}

TEST(Fields, AreThoseOfTheTableOfTheirFormAndPlace) {
  const auto mesh = box_mesh({2, 2, 2}, {3, 1, 1});
  const auto p = *make_problem(*mesh, tension(), 2);

  const auto fields = make_fields(*mesh, p, solution_of(p));

  EXPECT_EQ(fields.size(), std::size(result_arrays));
  for (const auto& array : result_arrays) {
    const auto* found = find_field(fields, array.name);
    ASSERT_NE(found, nullptr) << array.name;
    EXPECT_EQ(found->components, array.components) << array.name;
    EXPECT_EQ(found->location == field_location::tet, array.place == array_place::tets);
  }
  for (const auto& shown : shown_quantities) {
    const auto* array = find_array(shown.array);
    ASSERT_NE(array, nullptr) << shown.id;
    EXPECT_NE(array->sent, array_sent::in_files) << shown.id;
    EXPECT_LT(shown.index, array->components) << shown.id;
    // Differences of what is made of several components are shown as the first of them.
    EXPECT_TRUE(std::ranges::any_of(shown_quantities,
                                    [&](const auto& one) {
                                      return one.array == shown.array &&
                                             one.part == shown_part::component && one.index == 0;
                                    }))
      << shown.id;
  }
}

TEST(LargestStrain, OfABarInTensionIsStressOverYoungsModulus) {
  const auto mesh = box_mesh({3, 2, 2}, {3, 1, 1});
  const auto p = *make_problem(*mesh, tension(), 2);

  const auto fields = make_fields(*mesh, p, solution_of(p));

  const auto* strain = find_field(fields, "largest_strain");
  ASSERT_NE(strain, nullptr);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    EXPECT_NEAR(strain->at(v), 1e6 / 200e9, 1e-14);  // Across it is -0.3 times that.
}

TEST(LargestStrain, IsHalfOfTheEngineeringShear) {
  const auto mesh = box_mesh({2, 2, 2}, {1, 1, 1});
  const auto p = *make_problem(*mesh, tension(), 1);
  std::vector<double> sheared(p.dofs());
  for (std::size_t n = 0; n < p.node_count(); ++n)
    sheared[3 * n] = 1e-3 * p.nodes[n].y;  // gamma_xy = 1e-3: principal +-5e-4.

  const auto fields = make_fields(*mesh, p, recovered(p, sheared));

  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    EXPECT_NEAR(find_field(fields, "largest_strain")->at(v), 5e-4, 1e-12);
}

TEST(NodalError, AddsUpToTheErrorOfThePart) {
  const auto mesh = box_mesh({3, 2, 2}, {3, 1, 1});
  auto loads = tension();
  loads.loads = {{{2}, traction{{0, 0, -1e5}}}};  // Bending, which linear tets miss.
  loads.constraints = {{{1}, fixed{}}};
  const auto p = *make_problem(*mesh, loads, 1);
  const auto s = solution_of(p);

  ASSERT_GT(s.relative_error, 0.1);
  double sum = 0;
  double volume = 0;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const double v = gradients_of(p, e).volume;
    volume += v;
    for (int k = 0; k < 4; ++k) {
      const double at = s.nodal_error[p.element_nodes[4 * e + k]];
      sum += v / 4 * at * at;
    }
  }
  EXPECT_NEAR(std::sqrt(sum / volume), s.relative_error, 1e-12);
}

TEST(PrincipalValues, AreSorted) {
  const std::array<double, 6> shear{0, 0, 7, 3, 0, 0};

  const auto s = principal_values(shear.data());

  EXPECT_NEAR(s[0], 7, 1e-12);
  EXPECT_NEAR(s[1], 3, 1e-12);
  EXPECT_NEAR(s[2], -3, 1e-12);
}

}  // namespace
}  // namespace tedit::fem
