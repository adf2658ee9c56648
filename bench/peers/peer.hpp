// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "bench/peers/system.hpp"

/// What the programs around other solvers share: clocks, and one JSON object as their answer.
namespace tedit::bench {

/// CPU seconds of all threads of this process.
inline double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct stage_seconds {
  double cpu = 0;
  double wall = 0;
};

/// Time since it was made.
class stage_clock {
public:
  [[nodiscard]] stage_seconds seconds() const {
    return {cpu_seconds() - before_, wall_.milliseconds() / 1000};
  }

private:
  stopwatch wall_;
  double before_ = cpu_seconds();
};

/// A solve by another program's library.
struct peer_solution {
  std::string solver;
  std::string settings;  ///< What was chosen of its options, for people.
  int iterations = 0;    ///< 0 for a direct solver.
  stage_seconds setup;   ///< From the matrix in the library's own form to a solver that is ready.
  stage_seconds solve;   ///< One right-hand side.
  std::vector<double> displacement;
};

/// Checks the solution against the file, prints one JSON object and returns the exit status. The
/// peak memory is that of the solve: taken before the check.
inline int report(system_file& system, const peer_solution& s) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto check = check_solution(system, s.displacement);
  if (!check) {
    std::cerr << render(check.error()) << '\n';
    return 1;
  }
  const nlohmann::json result{{"solver", s.solver},
                              {"settings", s.settings},
                              {"tets", system.header().tets},
                              {"element_order", system.header().element_order},
                              {"unknowns", system.unknowns()},
                              {"true_relative_residual", check->relative_residual},
                              {"compliance_j", check->compliance},
                              {"max_displacement_m", check->max_displacement},
                              {"iterations", s.iterations},
                              {"setup_cpu_s", s.setup.cpu},
                              {"solve_cpu_s", s.solve.cpu},
                              {"wall_s", s.setup.wall + s.solve.wall},
                              {"peak_mib", static_cast<double>(usage.ru_maxrss) / 1024}};
  std::cout << result.dump() << '\n';
  return 0;
}

/// The system that a program's first argument names; empty, with a message, when there is none.
inline expected<system_file> open_argument(int argc, char** argv, const std::string& usage) {
  if (argc < 2)
    return fail(ec::usage, "usage: " + usage);
  return system_file::open(argv[1]);
}

inline int stop(const error& e) {
  std::cerr << render(e) << '\n';
  return exit_status(e.code);
}

}  // namespace tedit::bench
