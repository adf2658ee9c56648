// SPDX-License-Identifier: AGPL-3.0-or-later
#include "decks/deck_file.hpp"

#include <ostream>
#include <utility>

#include "fem/nastran_deck.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/bdf_sets.hpp"
#include "mesh/io/inp_sets.hpp"
#include "mesh/io/marked_cards.hpp"
#include "protocol/convert.hpp"

namespace tedit::decks {

deck_job make_deck_job(const mesh_version& mesh, const fem::problem& problem,
                       const fem::load_case& loads, std::string title) {
  deck_job job{mesh, problem, protocol::load_case_to_json(loads), std::move(title),
               std::vector<std::size_t>(mesh.tet_slots())};
  for (std::size_t e = 0; e < problem.element_count(); ++e)
    job.elements[problem.element_tets[e]] = e + 1;
  return job;
}

expected<deck_counts> write_calculix(const file_target& to, const deck_job& job,
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
  const auto written = to.write(
    [&](std::ostream& out) { counts = fem::write_calculix_deck(job.problem, settings, out); });
  if (!written)
    return fail(written.error());
  return deck_counts{counts.held_nodes, counts.boundaries, counts.equations, counts.loads};
}

expected<deck_counts> write_nastran(const file_target& to, const deck_job& job) {
  std::vector<std::size_t> node_of(job.mesh.vertex_slots());
  for (std::size_t n = 0; n < job.problem.corner_count; ++n)
    if (job.problem.node_vertices[n] != no_id)
      node_of[job.problem.node_vertices[n]] = n + 1;
  fem::nastran_settings settings;
  settings.title = job.title;
  settings.property = [&](tet_id t) { return bdf_property(job.mesh, job.mesh.region_of(t)); };
  settings.head = [&](std::ostream& out) { write_bdf_names(out, job.mesh, "m"); };
  settings.sets = [&](std::ostream& out) {
    write_bdf_surfaces(
      out, job.mesh, [&](tet_id t) { return job.element_of(t); },
      [&](vertex_id v) { return node_of[v]; });
  };
  settings.around_cards = [&](std::ostream& out, const std::string& cards) {
    write_marked_cards(out, "$ ", cards, job.load_case);
  };
  expected<fem::nastran_counts> counts;
  const auto written = to.write(
    [&](std::ostream& out) { counts = fem::write_nastran_deck(job.problem, settings, out); });
  if (!written)
    return fail(written.error());
  if (!counts)
    return fail(counts.error());
  return deck_counts{counts->held_nodes, counts->components, counts->equations, counts->loads};
}

expected<void> write_deck(std::string_view format, const file_target& to, const mesh_version& mesh,
                          const fem::load_case& loads, const std::string& title) {
  const bool calculix = format == formats::inp::about.name;
  if (!calculix && format != formats::bdf::about.name)
    return fail(ec::invalid_argument,
                "a file of the format " + std::string(format) + " holds no load case",
                "Ask for inp (CalculiX, Abaqus) or bdf (Nastran), or name no load case");
  constexpr int quadratic = 2;
  const auto problem = fem::make_problem(mesh, loads, quadratic);
  if (!problem)
    return fail(problem.error());
  const auto job = make_deck_job(mesh, *problem, loads, title);
  const auto counts =
    calculix ? write_calculix(to, job, fem::calculix_solver::spooles) : write_nastran(to, job);
  if (!counts)
    return fail(counts.error());
  return {};
}

}  // namespace tedit::decks
