// SPDX-License-Identifier: AGPL-3.0-or-later
// CalculiX as a second opinion: reading its results, and oblique supports. All real parts, which
// take minutes, are behind `tedit verify --suite --calculix`.
#include "verification/calculix.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {
namespace {

using ::testing::HasSubstr;

#define TEDIT_NEEDS_CALCULIX() \
  if (find_calculix().empty()) \
  GTEST_SKIP() << "ccx is not installed (Debian package " << calculix_package << ")"

TEST(CalculixTable, HoldsDisplacementsAndForcesOfEachNode) {
  // The third node is no node of the problem: it moves an oblique support.
  std::istringstream dat(
    "\n                        S T E P       1\n\n"
    " displacements (vx,vy,vz) for set NALL and time  0.1000000E+01\n\n"
    "         1  1.500000E-03 -2.000000E+00  0.000000E+00\n"
    "         2 -1.000000E-20  4.000000E-05  5.000000E+10\n"
    "         3  9.000000E+00  9.000000E+00  9.000000E+00\n\n"
    " forces (fx,fy,fz) for set HELD and time  0.1000000E+01\n\n"
    "         2  1.000000E+00  2.000000E+00 -3.000000E+00\n\n"
    " total force (fx,fy,fz) for set HELD and time  0.1000000E+01\n\n"
    "        7.000000E+00  7.000000E+00  7.000000E+00\n");

  const auto table = read_calculix_table(dat, 2);

  ASSERT_TRUE(table.has_value()) << render(table.error());
  EXPECT_EQ(table->displacement, (std::vector<double>{1.5e-3, -2, 0, -1e-20, 4e-5, 5e10}));
  EXPECT_EQ(table->forces, (std::vector<double>{0, 0, 0, 1, 2, -3}));
}

TEST(CalculixTable, AMissingNodeIsNamed) {
  std::istringstream dat(
    " displacements (vx,vy,vz) for set NALL and time  0.1000000E+01\n\n"
    "         1  1.500000E-03 -2.000000E+00  0.000000E+00\n"
    "         2           NaN           NaN           NaN\n");

  const auto table = read_calculix_table(dat, 2);

  ASSERT_FALSE(table.has_value());
  EXPECT_EQ(table.error().code, ec::bad_input);
  EXPECT_THAT(table.error().message, HasSubstr("node 2"));
}

TEST(Calculix, FailsWithARemedy) {
  TEDIT_NEEDS_CALCULIX();
  const auto mesh = *block_mesh({1, 1, 1}, box({1, 1, 1}));
  auto p = *bare_problem(*mesh, with_material(1, 0.3), 1);
  p.constants[0] = {std::nan(""), 1};

  const auto result = solve_with_calculix(find_calculix(), p, {});

  ASSERT_FALSE(result.has_value());
  EXPECT_THAT(result.error().message, HasSubstr("CalculiX"));
  EXPECT_THAT(result.error().remedy, HasSubstr("tedit export"));
}

/// A box turned about an oblique axis, on three oblique rollers that also move: nodes with one, two
/// and three held directions, none of them along an axis.
fem::problem turned_box(int order) {
  const auto turn = [](vec3 v) {
    const vec3 axis = normalized({1, 2, 3});
    return std::cos(0.7) * v + std::sin(0.7) * cross(axis, v) +
           ((1 - std::cos(0.7)) * dot(axis, v)) * axis;
  };
  const auto shake = shaken_box({0.03, 0.02, 0.01});
  const auto mesh = *block_mesh({3, 2, 2}, [&](vec3 p) { return turn(shake(p)); });
  auto loads = with_material(210e9, 0.3, 7850);
  loads.constraints = {{{s_low, t_low, u_low}, fem::roller{}}};
  loads.loads = {{{s_high}, fem::force{{100, 200, 300}}},
                 {{u_high}, fem::pressure{1e6}},
                 {{}, fem::gravity{{0, 0, -1e5}}}};
  auto p = *fem::make_problem(*mesh, loads, order);
  const vec3 moved{1e-7, -2e-7, 3e-7};
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto& s = p.filter[n];
    p.prescribed[3 * n] = moved.x - (s[0] * moved.x + s[1] * moved.y + s[2] * moved.z);
    p.prescribed[3 * n + 1] = moved.y - (s[1] * moved.x + s[3] * moved.y + s[4] * moved.z);
    p.prescribed[3 * n + 2] = moved.z - (s[2] * moved.x + s[4] * moved.y + s[5] * moved.z);
  }
  return p;
}

TEST(Calculix, AgreesOnObliqueSupportsThatMove) {
  TEDIT_NEEDS_CALCULIX();
  for (const int order : {1, 2}) {
    const auto p = turned_box(order);
    const auto device = fem::make_native_backend();
    const auto ours = fem::solve(p, *device, {.tolerance = 1e-11}, {});
    ASSERT_TRUE(ours.has_value()) << render(ours.error());

    const auto theirs = solve_with_calculix(find_calculix(), p, {});

    ASSERT_TRUE(theirs.has_value()) << render(theirs.error());
    vec3 total;
    double force = 0;
    for (std::size_t n = 0; n < p.node_count(); ++n) {
      const vec3 difference =
        node_value(ours->displacement, n) - node_value(theirs->displacement, n);
      EXPECT_LE(norm(difference), 1e-6 * ours->max_displacement_m);
      total += node_value(theirs->reactions, n);
      force += norm(node_value(theirs->reactions, n));
    }
    EXPECT_LE(norm(total - ours->reaction_n), 1e-6 * force);
    EXPECT_LE(norm(total + ours->applied_n), 1e-6 * force);
  }
}

// -- real parts ------------------------------------------------------------------------

struct part_and_order {
  const char* part;
  int order;
};

class PartSideBySide : public ::testing::TestWithParam<part_and_order> {};

TEST_P(PartSideBySide, Agrees) {
  TEDIT_NEEDS_CALCULIX();
  const auto folder = std::filesystem::path(TEDIT_TEST_DATA "/parts") / GetParam().part;
  const auto mesh = import_mesh(folder / (std::string(GetParam().part) + ".coarse.msh"), "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");
  ASSERT_TRUE(mesh.has_value() && loads.has_value());
  const real_part part{GetParam().part, mesh->version, *loads};
  suite_report report;

  const auto ok =
    run_case({side_by_side_case, GetParam().order}, *fem::make_native_backend(), &part, {}, report);

  ASSERT_TRUE(ok.has_value()) << render(ok.error());
  EXPECT_EQ(report.side_by_side.size(), 1u);
  EXPECT_TRUE(report.passed());
  for (const auto& r : report.results)
    EXPECT_TRUE(r.passed) << r.quantity << ": " << r.computed;
}

std::string name_of(const ::testing::TestParamInfo<part_and_order>& test) {
  return test.param.part + ("_order_" + std::to_string(test.param.order));
}

/// The quadratic ones are those that CalculiX does quickest.
INSTANTIATE_TEST_SUITE_P(Some, PartSideBySide,
                         ::testing::Values(part_and_order{"as1_assembly", 1},
                                           part_and_order{"ctc01_plate", 1},
                                           part_and_order{"fork_thin", 1},
                                           part_and_order{"fork_thin", 2},
                                           part_and_order{"inch_block", 2}),
                         name_of);

/// $PATH as long as this lives.
class search_path {
public:
  explicit search_path(const char* path) : before_(std::getenv("PATH")) { setenv("PATH", path, 1); }
  ~search_path() { setenv("PATH", before_.c_str(), 1); }

private:
  std::string before_;
};

TEST(SideBySide, AMissingProgramIsNamedOnceWithItsPackage) {
  const search_path nowhere("/nowhere");
  const real_part part{"box", *block_mesh({1, 1, 1}, box({1, 1, 1})), with_material(1, 0.3)};
  const auto device = fem::make_native_backend();
  suite_report report;

  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(run_case({side_by_side_case, 2}, *device, &part, {}, report).has_value());

  EXPECT_TRUE(report.results.empty());
  ASSERT_EQ(report.left_out.size(), 1u);
  EXPECT_THAT(report.left_out[0].what, HasSubstr("CalculiX (order 2)"));
  EXPECT_THAT(report.left_out[0].why, HasSubstr("apt-get install calculix-ccx"));
}

TEST(SideBySide, APartThatCannotBeSetUpFails) {
  TEDIT_NEEDS_CALCULIX();
  const real_part part{"box", *block_mesh({1, 1, 1}, box({1, 1, 1})), with_material(1, 0.3)};
  suite_report report;

  const auto ok = run_case({side_by_side_case, 1}, *fem::make_native_backend(), &part, {}, report);

  EXPECT_TRUE(ok.has_value());
  EXPECT_FALSE(report.passed()) << "without supports it is no part";
}

TEST(SideBySide, ARefusedPartIsNamed) {
  TEDIT_NEEDS_CALCULIX();
  const std::filesystem::path folder = TEDIT_TEST_DATA "/parts/base_so101";
  const auto mesh = import_mesh(folder / "base_so101.coarse.msh", "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");
  ASSERT_TRUE(mesh.has_value() && loads.has_value());
  const real_part part{"base_so101", mesh->version, *loads};
  suite_report report;

  const auto ok = run_case({side_by_side_case, 1}, *fem::make_native_backend(), &part, {}, report);

  ASSERT_TRUE(ok.has_value());
  ASSERT_EQ(report.left_out.size(), 1u);
  EXPECT_THAT(report.left_out[0].why, HasSubstr("base_so101 is refused"));
  EXPECT_TRUE(report.results.empty());
}

}  // namespace
}  // namespace tedit::verification
