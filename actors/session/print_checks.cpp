// SPDX-License-Identifier: AGPL-3.0-or-later
// What hinders printing a version: looked for on a thread aside.
#include "actors/session/aside.hpp"

namespace tedit::actors {

caf::result<print_checked> session_state::check_print(const print_request& request) {
  const auto* head = graph.head();
  if (!head)
    return to_caf({ec::conflict, "the document has no mesh yet", "Import one first", {}});
  const auto number = request.number.value_or(head->info.number);
  if (number >= graph.nodes().size())
    return to_caf(no_version(number));
  auto promise = self->make_response_promise<print_checked>();
  const cancel_token token;
  add_aside({request.ticket, token,
             [=, this] {
               asides.front().job = new_job(request.ticket, request.client);
               with_mesh(
                 number,
                 [=, this](const version_ptr& mesh) {
                   begin_print_check({{}, number, request.settings, mesh, {}}, token, promise);
                 },
                 [this](const error& e) { refuse_aside(e); });
             },
             [=](const error& e) mutable { promise.deliver(to_caf(e)); }});
  return promise;
}

void session_state::begin_print_check(print_checked wanted, const cancel_token& token,
                                      const caf::typed_response_promise<print_checked>& promise) {
  const execution run{
    token, [job = asides.front().job, to = ear](double fraction, std::string_view stage) {
      caf::anon_send(to, job_progress{job, fraction, std::string(stage)});
    }};
  do_aside<print_checked>(
    promise,
    [=]() -> expected<print_checked> {
      auto found = tedit::check_print(*wanted.mesh, wanted.settings, run);
      if (!found)
        return fail(found.error());
      auto result = wanted;
      result.what = std::make_shared<const print_report>(std::move(*found));
      return result;
    },
    "the check");
}

}  // namespace tedit::actors
