// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that clients sent, as they are or as parts that are to become one.
#include "actors/node/hub_work.hpp"

namespace tedit::actors {

namespace {

using added_promise = std::shared_ptr<caf::typed_response_promise<added_document>>;

/// The name of a new document. Errors: `conflict` when it is taken and no other is wanted.
expected<std::string> free_name(const hub_state& state, const std::string& wanted,
                                bool or_next_free) {
  if (auto ok = check_lasting_name(wanted); !ok)
    return fail(ok.error());
  if (!is_taken(state, wanted))
    return wanted;
  if (!or_next_free)
    return fail(taken_name(wanted));
  for (int number = 2;; ++number) {
    const auto end = "-" + std::to_string(number);
    const auto name = wanted.substr(0, longest_document_name - end.size()) + end;
    if (!is_taken(state, name))
      return name;
  }
}

/// Ends what is held for the name, which a document has now or does not get.
void refuse(hub_pointer self, const std::string& name, const added_promise& promise,
            const error& why) {
  self->state.adding.erase(name);
  promise->deliver(to_caf(why));
}

/// Makes the bytes the document of a name that is held among those that are added. @param held
/// keeps what was sent on the account of who sent it until then.
void adopt_file(hub_pointer self, const std::vector<page_ptr>& file,
                const std::shared_ptr<const void>& held, const added_document& named,
                const added_promise& promise) {
  ask_disk(self, adoption{file_of(self->state, named.name), file})
    .then(
      [self, held, named, promise](acknowledged) {
        auto& state = self->state;
        state.adding.erase(named.name);
        ++state.name_changes;
        forget_former(state, named.name);
        note_left(self, named.name);  // Nobody has it open yet.
        promise->deliver(named);
      },
      [self, held, named, promise](const caf::error& e) {
        refuse(self, named.name, promise, from_caf(e, "adding the document " + named.name));
      });
}

}  // namespace

caf::result<added_document> add_document(hub_pointer self, const add_request& request) {
  const auto name = free_name(self->state, request.name, request.or_next_free);
  if (!name)
    return to_caf(name.error());
  self->state.adding.insert(*name);
  const auto promise = std::make_shared<caf::typed_response_promise<added_document>>(
    self->make_response_promise<added_document>());
  adopt_file(self, request.file, request.held, {*name, {}}, promise);
  return *promise;
}

/// The name is held meanwhile: nobody waits for a mesh that has no place to go.
caf::result<added_document> add_part(hub_pointer self, const part_request& request) {
  auto& state = self->state;
  if (!state.parts.importer)
    return to_caf({ec::service_unavailable,
                   "this server meshes no CAD files",
                   "Mesh it with \"tedit import PART -o PART.tedit\" and add that document, or set "
                   "work.import_jobs in the server's configuration",
                   {}});
  const auto name = request.name.empty() ? expected<std::string>(make_temporary_name(state))
                                         : free_name(state, request.name, request.or_next_free);
  if (!name)
    return to_caf(name.error());
  state.adding.insert(*name);
  const auto promise = std::make_shared<caf::typed_response_promise<added_document>>(
    self->make_response_promise<added_document>());
  self->request(state.parts.importer, answer_limit, request.part)
    .then(
      [=, name = *name, held = request.part.held](const part_document& made) {
        adopt_file(self, made.file, held, {name, made.warnings}, promise);
      },
      [=, name = *name](const caf::error& e) {
        refuse(self, name, promise, from_caf(e, "importing the part"));
      });
  return *promise;
}

}  // namespace tedit::actors
