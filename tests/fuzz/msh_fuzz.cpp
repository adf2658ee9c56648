// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "mesh/checks.hpp"
#include "mesh/io/import.hpp"

namespace {

using namespace tedit;

/// A broken promise counts as a crash, so that libFuzzer keeps the input.
void require(bool holds, const char* promise, const std::string& detail = {}) {
  if (holds)
    return;
  std::fprintf(stderr, "msh_fuzz: broken promise: %s %s\n", promise, detail.c_str());
  std::abort();
}

/// What an import lets through (with a warning) and simulation refuses. Anything else that
/// `check_version` finds is a fault of the import.
bool may_pass(ec code) {
  return code == ec::inverted_tet || code == ec::degenerate_tet || code == ec::non_manifold;
}

void check_accepted(const imported_mesh& imported) {
  const auto& mesh = *imported.version;
  require(mesh.tet_count() > 0, "an accepted mesh has tets");
  require(std::isfinite(total_volume(mesh)), "an accepted mesh has a finite volume");
  for (const auto& finding : check_version(mesh).findings)
    require(may_pass(finding.code), finding.rule.c_str(),
            finding.element + " (" + finding.numbers + ")");
  const auto list = manifest::from_bytes(mesh.pages().to_bytes());
  require(list && *list == mesh.pages(), "an accepted mesh's manifest can be read back");
}

void check_refused(const error& failure) {
  require(failure.code == ec::bad_input || failure.code == ec::unsupported_format,
          "a refused file is bad_input or unsupported_format, not", render(failure));
  require(!failure.message.empty(), "a refusal says why");
}

}  // namespace

/// Imports the bytes as a file in millimetres: it must come back, with a sound mesh or a reason.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto result = import_mesh_bytes({reinterpret_cast<const char*>(data), size}, "mm");
  if (result)
    check_accepted(*result);
  else
    check_refused(result.error());
  return 0;
}
