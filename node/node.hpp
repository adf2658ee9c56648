// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "actors/node/membership.hpp"
#include "actors/observation.hpp"
#include "fem/problem.hpp"
#include "fem/solve_report.hpp"
#include "mesh/field.hpp"

/// A program of one's own as a node of a TEdit server: docs/integrate.md has both beginnings. What
/// a node may do is by its certificate, which "tedit certs issue --role solver|observer" makes.
///
/// Common errors of what joins: `service_unavailable` when the server is not there, goes away or
/// turns the node away for now: trying again later may help. `invalid_argument`, `io_error`,
/// `bad_input` for what a person must mend first: certificates, roles, names. Nothing when `stop`
/// was set.
namespace tedit::node {

/// A server's port for nodes (`[nodes]` in its configuration).
struct place {
  std::string host;  ///< Name or IP address; the server's certificate must have it.
  std::uint16_t port = 7465;
  std::filesystem::path certificates;  ///< The folder that "tedit certs issue" made.
};

// -- a solver of one's own ---------------------------------------------------------------------

/// Solves K u = f: a problem of linear elasticity on tets, assembled from the mesh and one load
/// case (fem/problem.hpp). @returns the displacement, m, 3 per node of the problem. Called on one
/// thread, one problem after the other; `run.cancel` says when nobody wants the answer any more.
using solve_function =
  std::function<expected<std::vector<double>>(const fem::problem& problem, const execution& run)>;

struct solver_offer {
  /// What clients ask for (`SolveRequest.device`, `--device`): 1 to 63 letters, digits, ".", "-",
  /// "_". Case does not matter.
  std::string device;
  solve_function solve;
};

/// Joins a server and solves what asks for `offer.device`, until the server goes away or `stop` is
/// set; work that has begun is then ended first. Stresses, strains, reactions, error estimate and
/// the true residual are computed from the displacement as for every other solver, so a wrong one
/// shows as a residual that is not small. Returns nothing only when it was stopped.
[[nodiscard]] expected<void> serve_solver(const place& where, const solver_offer& offer,
                                          const cancel_token& stop);

// -- an observer -------------------------------------------------------------------------------

/// A version of a document, as it became the head.
struct version_event {
  std::string document;
  std::uint32_t number = 0;
  std::optional<std::uint32_t> parent;
  std::string cause;      ///< "head" (what it is as the watching begins), "import", "edit", "undo",
                          ///< "redo", "goto".
  std::string operation;  ///< That made the version: "import", or an operation's.
  version_ptr mesh;
  std::shared_ptr<const load_case_list> load_cases;
  std::shared_ptr<const edit_report>
    report;  ///< What an edit did that has just been made; else null.
};

/// A solve that has ended.
struct result_event {
  std::string document;
  version_ptr mesh;
  std::shared_ptr<const solve_outcome> outcome;
  std::vector<field> fields;  ///< Those that clients are sent (fem/quantities.hpp).
};

/// Called on one thread, one after the other, in the order in which things happened. Who is 64
/// events behind is cut off. Empty functions are left out.
struct observer {
  std::function<void(const version_event&)> on_version;
  std::function<void(const result_event&)> on_result;
  std::function<void(const std::string& document, const load_case_list&)> on_load_cases;
  std::function<void(const std::string& before, const std::string& document)> on_name;
  std::function<void(const std::string& document, const std::string& why)> on_end;
};

/// The documents that a server has.
[[nodiscard]] expected<std::vector<std::string>> documents(const place& where,
                                                           const cancel_token& stop = {});

/// Joins a server and hears all of these documents until `stop` is set. Errors: also `not_found`
/// for a document that is not there.
[[nodiscard]] expected<void> observe(const place& where, const std::vector<std::string>& documents,
                                     const observer& told, const cancel_token& stop);

}  // namespace tedit::node
