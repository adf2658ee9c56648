// SPDX-License-Identifier: AGPL-3.0-or-later
// The documents of the server as a whole: which there are, copies, and those that go.
#include <algorithm>
#include <chrono>

#include "actors/node/hub_work.hpp"

namespace tedit::actors {

namespace {

/// While names change, a list is made anew so often; then it is what it is.
constexpr int most_lists = 20;

/// The present name of a document that is there and that nothing else is done with. Errors:
/// `invalid_argument`, `not_found`; `conflict` while it comes, goes or gets another name.
expected<std::string> settled_name(hub_state& state, const std::string& given) {
  if (auto ok = check_document_name(given); !ok)
    return fail(ok.error());
  const auto name =
    state.open.contains(given) || is_busy(state, given) ? given : present_name(state, given);
  const auto here = state.open.find(name);
  if (is_busy(state, name) || (here != state.open.end() && state.renaming.contains(here->second)))
    return fail(ec::conflict,
                "the document " + name + " is being opened, closed, added, copied or renamed",
                "Try again soon");
  if (here == state.open.end() && !has_file(state, name))
    return fail(no_document(name));
  return name;
}

// -- the list ------------------------------------------------------------------------------------

using list_promise = std::shared_ptr<caf::typed_response_promise<document_list>>;

document_row& row_of(document_list& list, const std::string& name) {
  const auto found = std::ranges::lower_bound(list.documents, name, {}, &document_row::name);
  if (found != list.documents.end() && found->name == name)
    return *found;
  document_row row;
  row.name = name;
  return *list.documents.insert(found, std::move(row));
}

/// Adds what the sessions know, and answers when all have said it.
void ask_sessions(hub_pointer self, document_list files, const list_promise& promise) {
  struct gathering {
    document_list list;
    std::size_t missing = 0;
  };
  const auto all = std::make_shared<gathering>();
  all->list = std::move(files);
  all->missing = self->state.open.size();
  const auto count_off = [=] {
    if (--all->missing == 0)
      promise->deliver(std::move(all->list));
  };
  if (self->state.open.empty()) {
    promise->deliver(std::move(all->list));
    return;
  }
  for (const auto& [name, session] : self->state.open) {
    row_of(all->list, name).open = true;
    self->request(session, short_limit, status_atom::value)
      .then(
        [=, name = name](const session_status& status) {
          auto& row = row_of(all->list, name);
          row.clients = status.clients;
          row.versions = status.versions;
          row.head = status.head;
          count_off();
        },
        [=, name = name](const caf::error&) {
          row_of(all->list, name).open = false;  // It has ended meanwhile.
          count_off();
        });
  }
}

/// A name that changed while the disk looked would be there twice, or not at all.
void ask_folder(hub_pointer self, const list_promise& promise, int left) {
  const auto before = self->state.name_changes;
  ask_disk(self, folder_query{self->state.parts.documents})
    .then(
      [=](document_list& files) {
        const auto& state = self->state;
        if (left > 0 && (state.name_changes != before || !state.renaming.empty()))
          return ask_folder(self, promise, left - 1);
        ask_sessions(self, std::move(files), promise);
      },
      [=](const caf::error& e) { promise->deliver(to_caf(from_caf(e, "listing the documents"))); });
}

}  // namespace

caf::result<document_list> list_documents(hub_pointer self) {
  const auto promise = std::make_shared<caf::typed_response_promise<document_list>>(
    self->make_response_promise<document_list>());
  ask_folder(self, promise, most_lists);
  return *promise;
}

// -- copies --------------------------------------------------------------------------------------

/// The new name is held among those that are added. One that nobody has open is held among those
/// that are opened, too: a file must not be opened beside the copying (`document_view`).
caf::result<added_document> copy_document(hub_pointer self, const copy_request& request) {
  auto& state = self->state;
  if (auto ok = check_lasting_name(request.name); !ok)
    return to_caf(ok.error());
  const auto from = settled_name(state, request.document);
  if (!from)
    return to_caf(from.error());
  if (is_taken(state, request.name))
    return to_caf(taken_name(request.name));
  const auto promise = std::make_shared<caf::typed_response_promise<added_document>>(
    self->make_response_promise<added_document>());
  const auto end = [=, from = *from, name = request.name](bool held) {
    self->state.adding.erase(name);
    if (held)
      let_go(self, from);
  };
  const auto receive = [=, name = request.name](bool held) {
    return [=](acknowledged) {
      ++self->state.name_changes;
      forget_former(self->state, name);
      promise->deliver(added_document{name});
      end(held);
    };
  };
  const auto refuse = [=](bool held) {
    return [=](const caf::error& e) {
      promise->deliver(to_caf(from_caf(e, "copying the document")));
      end(held);
    };
  };
  state.adding.insert(request.name);
  if (const auto here = state.open.find(*from); here != state.open.end()) {
    self
      ->request(here->second, std::chrono::minutes(10), copy_atom::value,
                copy_order{request.name, request.stop})
      .then(receive(false), refuse(false));
  } else {
    state.opening[*from];
    ask_disk(self, file_copy{file_of(state, *from), file_of(state, request.name), request.stop})
      .then(receive(true), refuse(true));
  }
  return *promise;
}

// -- documents that go ---------------------------------------------------------------------------

void take_deleted(hub_state& state, const std::string& name) {
  ++state.name_changes;
  std::erase_if(state.former,
                [&](const auto& one) { return one.first == name || one.second == name; });
  state.remains.remove_if([&](const auto& one) { return one.first == name; });
}

/// The name is held among those that are opened: who opens it meanwhile waits, for a new document
/// or for this one if it stays.
caf::result<deleted_document> delete_document(hub_pointer self, const delete_request& request) {
  auto& state = self->state;
  const auto name = settled_name(state, request.document);
  if (!name)
    return to_caf(name.error());
  const auto promise = std::make_shared<caf::typed_response_promise<deleted_document>>(
    self->make_response_promise<deleted_document>());
  const auto receive = [=, name = *name](acknowledged) {
    take_deleted(self->state, name);
    promise->deliver(deleted_document{name});
    let_go(self, name);
  };
  const auto here = state.open.find(*name);
  const bool is_open = here != state.open.end();
  const auto session = is_open ? here->second : session_actor();
  const auto refuse = [=, name = *name](const caf::error& e) {
    promise->deliver(to_caf(from_caf(e, "deleting the document")));
    if (!is_open)
      return let_go(self, name);
    self->state.open.emplace(name, session);
    answer_all(self, name, session);
  };
  if (is_open)
    state.open.erase(here);
  state.opening[*name];
  if (is_open)
    self->request(session, std::chrono::minutes(10), delete_atom::value, request.asker)
      .then(receive, refuse);
  else
    ask_disk(self, deletion{file_of(state, *name)}).then(receive, refuse);
  return *promise;
}

}  // namespace tedit::actors
