// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/simulation/timeline.hpp"

namespace tedit::simulation {

/// What a client does, or what befalls the server.
enum class step_kind {
  import,
  apply,
  preview,
  undo,
  redo,
  go_to,
  set_load_case,
  remove_load_case,
  annotate,
  solve,
  cancel_solve,
  cancel_last,
  export_file,
  history,
  compare,
  check_print,
  reopen_document,
  rename,
  list_documents,
  copy_document,
  delete_document,
  machine_joins,    ///< With a worker of a role; after a restart of the server it does not.
  drop_connection,  ///< The client comes back and asks again for what it does not know.
  read_slowly,
  worker_dies,
  worker_dies_with_job,
  worker_dies_after_answer,
  worker_hangs,
  line_falls_silent,  ///< Of a worker on another machine; one of this machine hangs.
  disk_full,
  disk_slow,
  server_dies,
};

[[nodiscard]] const char* name_of(step_kind kind);

struct scenario_step {
  milliseconds at{0};
  step_kind kind = step_kind::apply;
  std::size_t who = 0;      ///< A client, or a role of workers.
  std::uint32_t value = 0;  ///< Whatever the kind makes of it.
};

/// All that happens, but for the order in which actors handle their messages: that follows from
/// `seed`, too.
struct scenario {
  std::uint64_t seed = 0;
  std::size_t clients = 1;
  std::size_t documents = 1;
  std::vector<scenario_step> steps;  ///< By time.
  bool from_cad = false;  ///< Documents begin with a version that came from CAD, with its model.
};

[[nodiscard]] scenario make_scenario(std::uint64_t seed);

/// A line a step.
[[nodiscard]] std::string describe(const scenario& all);

}  // namespace tedit::simulation
