// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/simulation/cad.hpp"

#include <map>

#include <caf/event_based_actor.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/cad/cad_rows.hpp"
#include "actors/errors.hpp"
#include "actors/session/change_log.hpp"
#include "actors/store/loading.hpp"
#include "actors/store/store.hpp"
#include "tests/simulation/workers.hpp"

namespace tedit::simulation {

namespace {

struct made_up_editor_state {
  std::map<job_id, std::pair<hash128, caf::typed_response_promise<cad_outcome>>> running;
  static inline const char* name = "made_up_cad_editor";
};
using made_up_editor = caf::stateful_actor<made_up_editor_state>;

store::cad_row made_up_model() {
  return row_with({std::make_shared<const std::string>("made up"), {}}, 0);
}

cad_outcome made_up_outcome(const hash128& version) {
  auto row = is_made(version) ? made_up_model() : row_without_model("no way was right");
  return {std::make_shared<const store::cad_row>(std::move(row))};
}

void answer(made_up_editor* self, timeline& time, job_id job) {
  const auto found = self->state.running.find(job);
  if (found == self->state.running.end())
    return;
  auto [version, promise] = std::move(found->second);
  self->state.running.erase(found);
  if (time.random.one_in(40))
    promise.deliver(to_caf({ec::io_error, "the disk is full", "Make room", {}}));
  else
    promise.deliver(made_up_outcome(version));
}

caf::behavior make_editor(made_up_editor* self, timeline* time) {
  return {[=](job_id job, const cad_order& order) -> caf::result<cad_outcome> {
            if (order.model->shape != "made up")
              return to_caf({ec::internal, "the model is of no version before", {}, {}});
            auto promise = self->make_response_promise<cad_outcome>();
            self->state.running.emplace(job, std::pair(order.after->id(), promise));
            self->delayed_send(self, milliseconds(time->random.below(3000)), tick_atom::value, job);
            return promise;
          },
          [=](cancel_atom, job_id job) {
            const auto found = self->state.running.find(job);
            if (found == self->state.running.end())
              return;
            auto promise = std::move(found->second.second);
            self->state.running.erase(found);
            promise.deliver(to_caf({ec::cancelled, "it was cancelled", {}, {}}));
          },
          [=](tick_atom, job_id job) { answer(self, *time, job); }};
}

}  // namespace

bool is_made(const hash128& version) {
  return version.low % 5 != 0;
}

caf::actor spawn_cad_editor(caf::actor_system& system, timeline& time) {
  return system.spawn(make_editor, &time);
}

expected<void> make_cad_document(const std::filesystem::path& file) {
  auto document = store::document::open(file);
  if (!document)
    return fail(document.error());
  graph_node node;
  node.info.operation = "import";
  describe_mesh(node, imported_part(1));
  auto change = change_of(node, nullptr);
  past_change made;
  made.time = utc_now();
  made.version = 0;
  change.what = "import";
  change.details = made.to_details("{}");
  change.cad.push_back(made_up_model());
  return (*document)->commit(change);
}

}  // namespace tedit::simulation
