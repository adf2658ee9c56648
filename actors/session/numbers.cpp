// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/numbers.hpp"

namespace tedit::actors::numbers {

metrics::gauge& open_documents() {
  static auto& one = metrics::level_of("tedit_documents_open", "Documents that are open.");
  return one;
}

metrics::gauge& subscriptions() {
  static auto& one =
    metrics::level_of("tedit_subscriptions", "Clients that have a document open, for each.");
  return one;
}

metrics::counter& heads_moved(const std::string& kind) {
  return metrics::count_of("tedit_heads_moved_total",
                           "Changes that moved a document's head, by kind.", {{"kind", kind}});
}

metrics::counter& carried_over(bool done) {
  return metrics::count_of("tedit_edits_carried_over_total",
                           "Edits that were asked for an older head, by what became of them.",
                           {{"outcome", done ? "done" : "collided"}});
}

metrics::counter& solves() {
  static auto& one = metrics::count_of("tedit_solves_total", "Solves that were done.");
  return one;
}

metrics::counter& failed_solves() {
  static auto& one =
    metrics::count_of("tedit_solve_failures_total", "Solves that came to no result.");
  return one;
}

}  // namespace tedit::actors::numbers
