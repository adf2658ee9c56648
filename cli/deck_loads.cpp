// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/deck_loads.hpp"

#include "protocol/convert.hpp"

namespace tedit::cli {

expected<fem::deck_case> load_case_of(const imported_mesh& mesh) {
  if (mesh.loads.empty())
    return fail(ec::not_found, "the file holds no materials, supports or loads",
                "Leave --load-case out, or take a deck: .inp or .bdf");
  if (mesh.loads.load_case.empty())
    return fem::load_case_of_deck(*mesh.version, mesh.loads);
  auto written = protocol::load_case_from_json(mesh.loads.load_case, "the deck's comments");
  if (written)
    return fem::deck_case{std::move(*written), {}};
  // Somebody damaged the comment; the cards say the same with less.
  auto result = fem::load_case_of_deck(*mesh.version, mesh.loads);
  result.remarks.insert(result.remarks.begin(),
                        "the load case that TEdit wrote into the file cannot be read (" +
                          written.error().message + "): its cards are read");
  return result;
}

}  // namespace tedit::cli
