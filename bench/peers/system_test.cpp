// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/peers/system.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Dense>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::bench {
namespace {

namespace fs = std::filesystem;

class SystemFile : public ::testing::Test {
protected:
  SystemFile()
      : path_(fs::temp_directory_path() /
              ("tedit_system_" + std::to_string(getpid()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())) {}
  ~SystemFile() override { fs::remove(path_); }

  fs::path path_;
};

/// The unit tet; E = 2.5 Pa and nu = 0.25 (lambda = mu = 1), node 0 clamped.
fem::problem one_tet() {
  fem::problem p;
  p.corner_count = 4;
  p.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.node_vertices = {0, 1, 2, 3};
  p.element_nodes = {0, 1, 2, 3};
  p.element_tets = {0};
  p.element_materials = {0};
  p.constants = {{1, 1}};
  p.densities = {0};
  p.yield_strengths = {0};
  p.loads.assign(12, 0);
  p.prescribed.assign(12, 0);
  p.filter.assign(4, {1, 0, 0, 1, 0, 1});
  p.filter[0] = {};
  return p;
}

Eigen::MatrixXd dense(system_file& system) {
  const auto size = static_cast<Eigen::Index>(system.unknowns());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  const auto read = system.for_rows([&](std::size_t row, auto columns, auto blocks) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t i = 0; i < 9; ++i)
        k(static_cast<Eigen::Index>(3 * row + i / 3),
          static_cast<Eigen::Index>(3 * columns[c] + i % 3)) = blocks[9 * c + i];
  });
  EXPECT_TRUE(read.has_value());
  return k;
}

TEST_F(SystemFile, OneTetHasTheBlocksOfItsFreeNodes) {
  ASSERT_TRUE(write_system(one_tet(), path_).has_value());
  auto system = system_file::open(path_);
  ASSERT_TRUE(system.has_value());

  const auto k = dense(*system);

  // V = 1/6, grad N_1 = e_x, grad N_2 = e_y: K_11 = V (2 e_x e_x^T + I), K_12 = V (e_x e_y^T + e_y
  // e_x^T).
  ASSERT_EQ(k.rows(), 9);
  Eigen::Matrix3d own = Eigen::Vector3d(3, 1, 1).asDiagonal();
  Eigen::Matrix3d other = Eigen::Matrix3d::Zero();
  other(0, 1) = other(1, 0) = 1;
  EXPECT_TRUE((6 * k.block<3, 3>(0, 0)).isApprox(own, 1e-14));
  EXPECT_TRUE((6 * k.block<3, 3>(0, 3)).isApprox(other, 1e-14));
  EXPECT_EQ(system->header().tets, 1U);
}

TEST_F(SystemFile, HeldDirectionStandsAlone) {
  auto p = one_tet();
  p.filter[1] = {0, 0, 0, 1, 0, 1};
  p.loads[3] = 7;
  p.loads[4] = 5;
  ASSERT_TRUE(write_system(p, path_).has_value());
  auto system = system_file::open(path_);
  ASSERT_TRUE(system.has_value());

  const auto k = dense(*system);

  EXPECT_DOUBLE_EQ(k(0, 0), 5.0 / 18);  // the mean of the diagonal 3/6, 1/6, 1/6
  EXPECT_EQ(k.row(0).tail(8).norm(), 0);
  EXPECT_EQ(k.col(0).tail(8).norm(), 0);
  EXPECT_EQ(system->load()[0], 0);
  EXPECT_EQ(system->load()[1], 5);
}

TEST_F(SystemFile, HasTheSolversSolutionWithQuadraticTetsAndAnObliqueRoller) {
  // The end at x = 2 m is sheared, so that the roller there holds along an oblique normal.
  const auto mesh = test::box_mesh({2, 1, 1}, {2, 1, 1}, [](vec3 x) {
    return vec3{x.x + 0.2 * x.x * x.y, x.y, x.z};
  });
  fem::load_case loads;
  loads.materials = {{"steel", 2e11, 0.3, 0, 0, {}}};
  loads.constraints = {{{1}, fem::fixed{}}, {{2}, fem::roller{}}};
  loads.loads = {{{4}, fem::force{{100, -500, 300}}}};
  const auto p = fem::make_problem(*mesh, loads, 2);
  ASSERT_TRUE(p.has_value());
  fem::solve_settings settings;
  settings.tolerance = 1e-10;
  const auto native = fem::make_native_backend();
  const auto ours = fem::solve(*p, *native, settings, {});
  ASSERT_TRUE(ours.has_value());
  ASSERT_TRUE(write_system(*p, path_).has_value());
  auto system = system_file::open(path_);
  ASSERT_TRUE(system.has_value());

  const Eigen::VectorXd u = dense(*system).llt().solve(Eigen::Map<const Eigen::VectorXd>(
    system->load().data(), static_cast<Eigen::Index>(system->unknowns())));
  const auto check = check_solution(*system, {u.data(), system->unknowns()});

  ASSERT_TRUE(check.has_value());
  EXPECT_LT(check->relative_residual, 1e-12);
  // The solver holds oblique directions to single precision of the displacement.
  EXPECT_NEAR(check->compliance / ours->compliance_j, 1, 1e-7);
  EXPECT_NEAR(check->max_displacement / ours->max_displacement_m, 1, 1e-7);
}

TEST_F(SystemFile, CutShortIsRefused) {
  ASSERT_TRUE(write_system(one_tet(), path_).has_value());
  fs::resize_file(path_, fs::file_size(path_) - 8);

  const auto system = system_file::open(path_);

  ASSERT_FALSE(system.has_value());
  EXPECT_EQ(system.error().code, ec::bad_input);
}

TEST_F(SystemFile, PrescribedDisplacementIsRefused) {
  auto p = one_tet();
  p.prescribed[0] = 0.001;

  EXPECT_EQ(write_system(p, path_).error().code, ec::invalid_argument);
  EXPECT_FALSE(fs::exists(path_));
}

}  // namespace
}  // namespace tedit::bench
