// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/deck_file.hpp"

#include <ostream>
#include <utility>

#include "mesh/io/file.hpp"
#include "mesh/io/inp_sets.hpp"
#include "mesh/io/marked_cards.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

deck_job make_deck_job(const mesh_version& mesh, const fem::problem& problem,
                       const fem::load_case& loads, std::string title) {
  deck_job job{mesh, problem, protocol::load_case_to_json(loads), std::move(title),
               std::vector<std::size_t>(mesh.tet_slots())};
  for (std::size_t e = 0; e < problem.element_count(); ++e)
    job.elements[problem.element_tets[e]] = e + 1;
  return job;
}

expected<fem::calculix_counts> write_calculix_file(const std::filesystem::path& file,
                                                   const deck_job& job,
                                                   fem::calculix_solver solver) {
  fem::calculix_settings settings;
  settings.title = job.title;
  settings.solver = solver;
  settings.sets = [&](std::ostream& out) {
    write_inp_sets(out, job.mesh, [&](tet_id t) { return job.element_of(t); });
  };
  settings.around_cards = [&](std::ostream& out, const std::string& cards) {
    write_marked_cards(out, "** ", cards, job.load_case);
  };
  fem::calculix_counts counts;
  const auto written = write_file(file, [&](std::ostream& out) {
    counts = fem::write_calculix_deck(job.problem, settings, out);
  });
  if (!written)
    return fail(written.error());
  return counts;
}

}  // namespace tedit::cli
