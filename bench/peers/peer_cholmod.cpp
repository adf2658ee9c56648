// SPDX-License-Identifier: AGPL-3.0-or-later
// peer_cholmod SYSTEM: CHOLMOD's supernodal factorisation in METIS' ordering, and one solve.
#include <algorithm>

#include <cholmod.h>

#include "bench/peers/peer.hpp"

namespace {

using namespace tedit;
using namespace tedit::bench;

/// The upper half by columns; K' is symmetric, so row i of the file is column i.
expected<cholmod_sparse*> load(system_file& system, cholmod_common& common) {
  const auto& first = system.row_first();
  const std::size_t size = system.unknowns();
  // Half of the entries beside the diagonal blocks, and six of the nine in these.
  const std::size_t entries = 9 * (first.back() - system.nodes()) / 2 + 6 * system.nodes();
  auto* k = cholmod_l_allocate_sparse(size, size, entries, 1, 1, 1, CHOLMOD_REAL, &common);
  if (!k)
    return fail(ec::out_of_memory, "no room for the matrix");
  auto* begin = static_cast<SuiteSparse_long*>(k->p);
  auto* row_of = static_cast<SuiteSparse_long*>(k->i);
  auto* value = static_cast<double*>(k->x);
  std::size_t next = 0;
  const auto read = system.for_rows([&](std::size_t row, auto columns, auto blocks) {
    for (std::size_t i = 0; i < 3; ++i) {
      begin[3 * row + i] = static_cast<SuiteSparse_long>(next);
      for (std::size_t c = 0; c < columns.size(); ++c)
        for (std::size_t j = 0; j < 3 && 3 * columns[c] + j <= 3 * row + i; ++j, ++next) {
          row_of[next] = static_cast<SuiteSparse_long>(3 * columns[c] + j);
          value[next] = blocks[9 * c + 3 * i + j];
        }
    }
  });
  if (!read)
    return fail(read.error());
  begin[size] = static_cast<SuiteSparse_long>(next);
  return k;
}

expected<peer_solution> solve(cholmod_sparse* k, std::vector<double> load, cholmod_common& common) {
  peer_solution result;
  result.solver = "cholmod";
  result.settings = "supernodal LL', METIS ordering";
  const stage_clock setup;
  auto* factor = cholmod_l_analyze(k, &common);
  if (!factor || !cholmod_l_factorize(k, factor, &common) || common.status != CHOLMOD_OK)
    return fail(ec::out_of_memory,
                "CHOLMOD could not factor: status " + std::to_string(common.status));
  result.setup = setup.seconds();
  cholmod_dense f{};
  f.nrow = f.nzmax = f.d = load.size();
  f.ncol = 1;
  f.x = load.data();
  f.xtype = CHOLMOD_REAL;
  f.dtype = CHOLMOD_DOUBLE;
  const stage_clock run;
  auto* u = cholmod_l_solve(CHOLMOD_A, factor, &f, &common);
  result.solve = run.seconds();
  if (!u)
    return fail(ec::out_of_memory, "no room for the solution");
  const auto* values = static_cast<const double*>(u->x);
  result.displacement.assign(values, values + load.size());
  cholmod_l_free_dense(&u, &common);
  cholmod_l_free_factor(&factor, &common);
  return result;
}

int run(system_file& system, cholmod_common& common) {
  auto k = load(system, common);
  if (!k)
    return stop(k.error());
  const auto solution = solve(*k, system.load(), common);
  cholmod_l_free_sparse(&*k, &common);
  return solution ? report(system, *solution) : stop(solution.error());
}

}  // namespace

int main(int argc, char** argv) {
  auto system = open_argument(argc, argv, "peer_cholmod SYSTEM");
  if (!system)
    return stop(system.error());
  cholmod_common common;
  cholmod_l_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  const int status = run(*system, common);
  cholmod_l_finish(&common);
  return status;
}
