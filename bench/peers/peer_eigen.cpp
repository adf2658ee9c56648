// SPDX-License-Identifier: AGPL-3.0-or-later
// peer_eigen SYSTEM cg|ldlt: Eigen's conjugate gradients under incomplete Cholesky, to a residual
// of 1e-6, or its simplicial LDL^T factorisation.
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include "bench/peers/peer.hpp"

namespace {

using namespace tedit;
using namespace tedit::bench;

using matrix = Eigen::SparseMatrix<double>;
using vector = Eigen::Map<const Eigen::VectorXd>;

/// By columns, both halves; K' is symmetric, so row i of the file is column i.
expected<matrix> load(system_file& system) {
  const auto size = static_cast<Eigen::Index>(system.unknowns());
  matrix k(size, size);
  k.resizeNonZeros(static_cast<Eigen::Index>(9 * system.header().blocks));
  int next = 0;
  const auto read = system.for_rows([&](std::size_t row, auto columns, auto blocks) {
    for (std::size_t i = 0; i < 3; ++i) {
      k.outerIndexPtr()[3 * row + i] = next;
      for (std::size_t c = 0; c < columns.size(); ++c)
        for (std::size_t j = 0; j < 3; ++j, ++next) {
          k.innerIndexPtr()[next] = static_cast<int>(3 * columns[c] + j);
          k.valuePtr()[next] = blocks[9 * c + 3 * i + j];
        }
    }
  });
  if (!read)
    return fail(read.error());
  k.outerIndexPtr()[size] = next;
  return k;
}

template <class Solver>
peer_solution solve(Solver& solver, const matrix& k, const std::vector<double>& load) {
  peer_solution result;
  const stage_clock setup;
  solver.compute(k);
  result.setup = setup.seconds();
  const stage_clock run;
  const Eigen::VectorXd u = solver.solve(vector(load.data(), k.rows()));
  result.solve = run.seconds();
  result.displacement.assign(u.begin(), u.end());
  return result;
}

expected<peer_solution> solve_iteratively(const matrix& k, const std::vector<double>& load) {
  Eigen::ConjugateGradient<matrix, Eigen::Lower | Eigen::Upper, Eigen::IncompleteCholesky<double>>
    solver;
  solver.setTolerance(1e-6);
  solver.setMaxIterations(20000);
  auto result = solve(solver, k, load);
  if (solver.info() != Eigen::Success)
    return fail(ec::not_converged,
                "Eigen gave up after " + std::to_string(solver.iterations()) + " iterations");
  result.solver = "eigen-cg";
  result.settings = "CG, incomplete Cholesky";
  result.iterations = static_cast<int>(solver.iterations());
  return result;
}

expected<peer_solution> solve_directly(const matrix& k, const std::vector<double>& load) {
  Eigen::SimplicialLDLT<matrix> solver;
  auto result = solve(solver, k, load);
  if (solver.info() != Eigen::Success)
    return fail(ec::internal, "Eigen could not factor the matrix");
  result.solver = "eigen-ldlt";
  result.settings = "simplicial LDL', AMD ordering";
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string way = argc > 2 ? argv[2] : "";
  if (way != "cg" && way != "ldlt")
    return stop({ec::usage, "usage: peer_eigen SYSTEM cg|ldlt", {}, {}});
  auto system = open_argument(argc, argv, "peer_eigen SYSTEM cg|ldlt");
  if (!system)
    return stop(system.error());
  // Eigen numbers entries with 32 bits.
  if (9 * system->header().blocks > 0x7fffffff)
    return stop({ec::out_of_memory, "the matrix has more than 2^31 entries", {}, {}});
  const auto k = load(*system);
  if (!k)
    return stop(k.error());
  const auto solution =
    way == "cg" ? solve_iteratively(*k, system->load()) : solve_directly(*k, system->load());
  return solution ? report(*system, *solution) : stop(solution.error());
}
