// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cad/editing.hpp"
#include "cad/model.hpp"
#include "cad/program.hpp"
#include "edit/report.hpp"
#include "mesh/version.hpp"

namespace tedit::cad {

/// An edit that is to be made on the CAD model, too.
struct replay_request {
  const cad_model& model;  ///< Of `before`.
  const ops::operation_description& description;
  version_ptr before;
  version_ptr after;
  const edit_request& wanted;
  const edit_report& report;
  program_limits limits{std::chrono::seconds(20), std::uint64_t{2} << 30, std::uint64_t{1} << 28};
};

struct replayed_edit {
  cad_model model;  ///< Where the verdict says "the same": of `after`.
  cad_verdict verdict;
  double ms = 0;
};

/// Makes an edit of a mesh on the CAD model in a process of its own, and compares what came of it
/// with the mesh (cad/editor/judge.hpp). What cannot be made, or is another shape, is no error: the
/// verdict says why. Errors: `io_error`, `service_unavailable`, `cancelled`; `timeout` by a clock
/// that is given beside the time of CPU. Cost: some 100 ms of another process.
[[nodiscard]] expected<replayed_edit> replay_edit(const replay_request& request,
                                                  const execution& run);

}  // namespace tedit::cad
