// SPDX-License-Identifier: AGPL-3.0-or-later
// Which hole of a part may be closed? Closes each of them on a running server, solves, says what
// became of the largest stress, and takes it back: the edits of a design study in one session.
//
//   hole_study SERVER TOKEN_FILE MESH LOAD_CASE [LEAST_MM MOST_MM]
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "client/client.hpp"
#include "protocol/convert.hpp"

namespace {

/// Ends the program with the reason, the remedy included, unless there is a value.
template <class T>
T value_of(tedit::expected<T> result) {
  if (!result) {
    std::cerr << tedit::render(result.error()) << '\n';
    std::exit(1);
  }
  if constexpr (!std::is_void_v<T>)
    return std::move(*result);
}

std::string first_line(const std::string& path) {
  std::string line;
  std::ifstream file(path);
  if (!std::getline(file, line)) {
    std::cerr << "cannot read the token in " << path << '\n';
    std::exit(1);
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5 && argc != 7) {
    std::cerr << "usage: hole_study SERVER TOKEN_FILE MESH LOAD_CASE [LEAST_MM MOST_MM]\n";
    return 2;
  }
  tedit::client::connect_options to;
  to.url = argv[1];
  to.token = first_line(argv[2]);
  to.client_name = "hole_study 1.0";
  const auto server = value_of(tedit::client::client::connect(to, {}));
  const tedit::execution run;  // Here one could hear of progress, and cancel.

  value_of(server->open("", false, false));
  value_of(server->import_file(argv[3], "mm", run));
  value_of(server->set_load_case(value_of(tedit::protocol::load_case_from_file(argv[4]))));
  const auto before = value_of(server->solve({}, run));
  std::cout << "as it is: " << before.max_von_mises_pa / 1e6 << " MPa, "
            << before.max_displacement_m * 1e3 << " mm\n";

  tedit::selection_query holes;
  holes.kind = tedit::feature_kind::holes;
  if (argc == 7) {
    holes.min_diameter = std::atof(argv[5]) / 1e3;
    holes.max_diameter = std::atof(argv[6]) / 1e3;
  }
  for (const auto& hole : value_of(server->select(holes, run))) {
    std::cout << "hole of " << hole.diameter * 1e3 << " mm: ";
    // Without the policy the edit would drop the loads and supports of a wall that goes.
    const auto made = server->edit("fill_hole", hole.surfaces, {}, run, {},
                                   {tedit::fem::load_policy::refuse, false});
    if (!made) {  // The part is as it was.
      std::cout << tedit::render(made.error()) << '\n';
      continue;
    }
    const auto after = value_of(server->solve({}, run));
    std::cout << after.max_von_mises_pa / 1e6 << " MPa, " << after.max_displacement_m * 1e3
              << " mm, solved in " << after.total_ms << " ms\n";
    value_of(server->undo());
  }
}
