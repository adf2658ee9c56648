// SPDX-License-Identifier: AGPL-3.0-or-later
// peer_petsc SYSTEM [PETSc options]: conjugate gradients under GAMG with the six rigid-body modes,
// to a residual of 1e-6. Options come after ours, so that each can be replaced.
#include <algorithm>
#include <cstring>

#include <petscksp.h>

#include "bench/peers/peer.hpp"

namespace {

using namespace tedit;
using namespace tedit::bench;

/// The best of those that were tried on the meshes of the comparison: bench/README.md.
constexpr const char* our_options =
  "-ksp_type cg -ksp_norm_type unpreconditioned -ksp_rtol 1e-6 -ksp_max_it 20000 -pc_type gamg";

struct equations {
  Mat k = nullptr;
  Vec f = nullptr;
  Vec u = nullptr;
};

Vec make_vector(const std::vector<double>& values) {
  Vec v = nullptr;
  VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(values.size()), &v);
  VecSetBlockSize(v, 3);
  double* to = nullptr;
  VecGetArray(v, &to);
  std::ranges::copy(values, to);
  VecRestoreArray(v, &to);
  return v;
}

/// Scalar rows with blocks of three: PETSc multiplies and smooths them three rows at a time.
expected<equations> load(system_file& system) {
  equations e;
  std::vector<PetscInt> lengths;
  const auto& first = system.row_first();
  for (std::size_t n = 0; n < system.nodes(); ++n)
    lengths.insert(lengths.end(), 3, static_cast<PetscInt>(3 * (first[n + 1] - first[n])));
  const auto size = static_cast<PetscInt>(system.unknowns());
  MatCreateSeqAIJ(PETSC_COMM_SELF, size, size, 0, lengths.data(), &e.k);
  MatSetBlockSize(e.k, 3);
  std::vector<PetscInt> nodes;
  std::vector<double> rows;
  const auto read = system.for_rows([&](std::size_t row, auto columns, auto blocks) {
    nodes.assign(columns.begin(), columns.end());
    const std::size_t width = 3 * columns.size();
    rows.resize(3 * width);
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::size_t i = 0; i < 9; ++i)
        rows[i / 3 * width + 3 * k + i % 3] = blocks[9 * k + i];
    const auto at = static_cast<PetscInt>(row);
    MatSetValuesBlocked(e.k, 1, &at, static_cast<PetscInt>(nodes.size()), nodes.data(), rows.data(),
                        INSERT_VALUES);
  });
  if (!read)
    return fail(read.error());
  MatAssemblyBegin(e.k, MAT_FINAL_ASSEMBLY);
  MatAssemblyEnd(e.k, MAT_FINAL_ASSEMBLY);
  MatSetOption(e.k, MAT_SPD, PETSC_TRUE);
  MatNullSpace rigid = nullptr;
  Vec positions = make_vector(system.positions());
  MatNullSpaceCreateRigidBody(positions, &rigid);
  MatSetNearNullSpace(e.k, rigid);
  MatNullSpaceDestroy(&rigid);
  VecDestroy(&positions);
  e.f = make_vector(system.load());
  VecDuplicate(e.f, &e.u);
  return e;
}

expected<peer_solution> solve(const equations& e, std::size_t unknowns) {
  peer_solution result;
  result.solver = "petsc";
  result.settings = "CG, GAMG with rigid-body modes";
  KSP solver = nullptr;
  KSPCreate(PETSC_COMM_SELF, &solver);
  KSPSetOperators(solver, e.k, e.k);
  KSPSetFromOptions(solver);
  const stage_clock setup;
  KSPSetUp(solver);
  KSPSetUpOnBlocks(solver);
  result.setup = setup.seconds();
  const stage_clock run;
  KSPSolve(solver, e.f, e.u);
  result.solve = run.seconds();
  KSPConvergedReason reason{};
  KSPGetConvergedReason(solver, &reason);
  PetscInt iterations = 0;
  KSPGetIterationNumber(solver, &iterations);
  result.iterations = static_cast<int>(iterations);
  if (reason <= 0)
    return fail(ec::not_converged, "PETSc gave up after " + std::to_string(iterations) +
                                     " iterations, reason " + std::to_string(reason));
  const double* u = nullptr;
  VecGetArrayRead(e.u, &u);
  result.displacement.assign(u, u + unknowns);
  VecRestoreArrayRead(e.u, &u);
  return result;
}

int run(int argc, char** argv) {
  auto system = open_argument(argc, argv, "peer_petsc SYSTEM [PETSc options]");
  if (!system)
    return stop(system.error());
  const auto equations = load(*system);
  if (!equations)
    return stop(equations.error());
  const auto solution = solve(*equations, system->unknowns());
  return solution ? report(*system, *solution) : stop(solution.error());
}

}  // namespace

int main(int argc, char** argv) {
  // Ours first: what stands on the command line is put in again and counts.
  if (PetscInitialize(nullptr, nullptr, nullptr, nullptr))
    return 1;
  PetscOptionsInsertString(nullptr, our_options);
  for (int i = 2; i < argc; ++i) {
    const bool has_value = i + 1 < argc && argv[i + 1][0] != '-';
    PetscOptionsSetValue(nullptr, argv[i], has_value ? argv[i + 1] : nullptr);
    i += has_value ? 1 : 0;
  }
  const int status = run(argc, argv);
  PetscFinalize();
  return status;
}
