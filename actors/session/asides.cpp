// SPDX-License-Identifier: AGPL-3.0-or-later
// What is worked out on a thread aside and changes nothing: comparisons and checks for printing,
// one at a time in a document.
#include <algorithm>

#include "actors/errors.hpp"
#include "actors/session/session.hpp"

namespace tedit::actors {

void session_state::add_aside(aside_run run) {
  asides.push_back(std::move(run));
  if (asides.size() == 1)
    asides.front().begin();
}

void session_state::run_aside(job_task task, const char* what,
                              const std::function<void(const error*)>& done) {
  const bool own = !parts.reader;
  const auto thread = own ? self->spawn<job_thread, caf::linked + caf::detached>() : parts.reader;
  const auto finish = [=, this](const error* failure) {
    if (own) {
      self->unlink_from(thread);  // Its end is not ours.
      caf::anon_send_exit(thread, caf::exit_reason::user_shutdown);
    }
    done(failure);
  };
  self->request(thread, answer_limit, std::move(task))
    .then([=](acknowledged) { finish(nullptr); },
          [=](const caf::error& e) {
            const auto failure = from_caf(e, what);
            finish(&failure);
          });
}

void session_state::refuse_aside(const error& why) {
  asides.front().refuse(why);
  end_aside();
}

void session_state::end_aside() {
  progress_of.erase(asides.front().job);
  asides.pop_front();
  if (!asides.empty())
    asides.front().begin();
}

/// The one that runs is answered once its thread has noticed.
bool session_state::leave_aside(std::uint64_t ticket) {
  const auto found = std::ranges::find_if(
    asides, [&](const auto& one) { return ticket != 0 && one.ticket == ticket; });
  if (found == asides.end())
    return false;
  found->token.cancel();
  if (found == asides.begin())
    return true;
  const auto refuse = std::move(found->refuse);
  asides.erase(found);
  refuse({ec::cancelled, "the request was cancelled before it began", {}, {}});
  return true;
}

void session_state::cancel_asides() {
  for (const auto& one : asides)
    one.token.cancel();
}

}  // namespace tedit::actors
