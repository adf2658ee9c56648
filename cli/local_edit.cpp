// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/local_edit.hpp"

#include "actors/optimizer/finish.hpp"
#include "base/stopwatch.hpp"
#include "ops/loader/operation_log.hpp"
#include "ops/sdk/most_that_works.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::cli {

namespace {

expected<ops::edit_result> run_operation(const ops::catalogue& plugins, const version_ptr& base,
                                         const edit_request& request, const execution& run,
                                         const operation_place& place) {
  const auto host = ops::make_host_services();
  ops::context ctx;
  ctx.search_s = ops::refusal_search_s;
  ctx.host = host.get();
  ctx.run.cancel = run.cancel;
  if (run.progress)
    ctx.run.progress = [&](double fraction, std::string_view stage) {
      run.report(0.8 * fraction, stage);
    };
  if (place.log)
    ctx.log = ops::operation_log(request.operation, place.log);
  if (place.child)
    return ops::run_operation_in_child(plugins, request.operation, *base, {request.surfaces},
                                       request.parameters, ctx, *place.child);
  return ops::run_operation(plugins, request.operation, *base, {request.surfaces},
                            request.parameters, ctx);
}

}  // namespace

expected<edit_outcome> apply_edit(const ops::catalogue& plugins, const version_ptr& base,
                                  const edit_request& request,
                                  const std::vector<fem::load_case>& load_cases,
                                  const execution& run, const operation_place& place) {
  const stopwatch total;
  stopwatch clock;
  const auto edit = run_operation(plugins, base, request, run, place);
  if (!edit)
    return fail(edit.error());
  const double operation_ms = clock.milliseconds();
  run.report(0.85, "improving and checking");
  edit_claim claim;
  claim.touched = edit->touched;
  claim.volume_change = edit->volume_change;
  claim.quality_floor = edit->quality_floor;
  claim.bodies_added = edit->bodies_added;
  auto finished = actors::finish_candidate(
    base, edit->candidate, claim, {edit->improve, edit->thorough}, load_cases, request.loads, run);
  if (!finished)
    return fail(finished.error());
  edit_outcome outcome{finished->version, std::move(finished->report),
                       std::move(finished->load_cases)};
  outcome.report.operation = request.operation;
  outcome.report.surfaces = request.surfaces;
  outcome.report.surfaces_used = edit->surfaces_used;
  outcome.report.notices = edit->notices;
  outcome.report.figures = edit->figures;
  outcome.report.operation_ms = operation_ms;
  outcome.report.total_ms = total.milliseconds();
  run.report(1, "done");
  return outcome;
}

expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs) {
  ops::parameters result;
  for (const auto& pair : pairs) {
    const auto split = pair.find('=');
    if (split == std::string::npos || split == 0)
      return fail(ec::usage, "\"" + pair + "\" is no parameter", "Write NAME=VALUE");
    result[pair.substr(0, split)] = pair.substr(split + 1);
  }
  return result;
}

}  // namespace tedit::cli
