// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/hub.hpp"

#include <chrono>

#include "actors/exits.hpp"
#include "actors/node/hub_work.hpp"
#include "actors/session/session.hpp"
#include "actors/store/former_names.hpp"
#include "actors/store/store.hpp"

namespace tedit::actors {

namespace {

/// Documents that nobody has open and of which something is kept.
constexpr std::size_t most_remains = 1000;

/// Former names that are remembered, of all documents together.
constexpr std::size_t most_former = 1000;

void refuse_all(hub_pointer self, const std::string& name, const error& e) {
  auto promises = std::move(self->state.opening[name]);
  self->state.opening.erase(name);
  for (auto& promise : promises)
    promise.deliver(to_caf(e));
}

/// What the session before left of a document; null when there is nothing.
shared_remains take_remains(hub_state& state, const std::string& name) {
  const auto found =
    std::ranges::find(state.remains, name, &std::pair<std::string, shared_remains>::first);
  if (found == state.remains.end())
    return nullptr;
  auto result = std::move(found->second);
  state.remains.erase(found);
  return result;
}

void keep_remains(hub_state& state, const std::string& name, shared_remains left) {
  if (left->results.empty() && !left->followed)
    return;
  state.remains.emplace_front(name, std::move(left));
  if (state.remains.size() > most_remains)
    state.remains.pop_back();
}

void start_opening(hub_pointer self, const std::string& name) {
  const auto store =
    self->spawn<caf::linked>(make_store, file_of(self->state, name), self->state.disks);
  self->request(store, std::chrono::minutes(10), load_atom::value)
    .then(
      [=](const stored_document& stored) {
        const auto& with = self->state.parts;
        session_parts parts{name,
                            store,
                            with.pages,
                            with.cache,
                            with.workers,
                            with.device,
                            caf::actor_cast<caf::actor>(self),
                            with.unused_limit,
                            with.results,
                            with.versions,
                            take_remains(self->state, name),
                            with.reader,
                            with.cad};
        const auto session = self->spawn<caf::linked>(make_session, std::move(parts), stored);
        self->state.open.emplace(name, session);
        answer_all(self, name, session);
      },
      [=](const caf::error& e) {
        caf::anon_send(store, close_atom::value);
        refuse_all(self, name, from_caf(e, "opening the document " + name));
      });
}

void open_for(hub_pointer self, const std::string& name, hub_state::promise promise) {
  auto& state = self->state;
  if (const auto found = state.open.find(name); found != state.open.end()) {
    promise.deliver(opened_document{name, caf::actor_cast<caf::actor>(found->second)});
    return;
  }
  const bool first = !state.opening.contains(name);
  state.opening[name].push_back(std::move(promise));
  if (first)
    start_opening(self, name);
}

/// @param begin also a document that is not there yet.
caf::result<opened_document> open(hub_pointer self, const std::string& given, bool begin) {
  auto& state = self->state;
  std::string name = given;
  if (name.empty() && !begin)
    return to_caf({ec::invalid_argument,
                   "a document that is there already has a name",
                   "Name one of those that the list of documents has",
                   {}});
  if (name.empty())
    name = make_temporary_name(state);
  if (auto ok = check_document_name(name); !ok)
    return to_caf(ok.error());
  if (state.adding.contains(name))
    return to_caf({ec::conflict, "the document " + name + " is being added", "Try again soon", {}});
  if (!state.open.contains(name) && !state.opening.contains(name)) {
    name = present_name(state, name);
    if (!given.empty() && is_temporary(name) && !has_file(state, name))
      return to_caf(ended_document(name));
    if (!begin && !is_taken(state, name))
      return to_caf(no_document(name));
  }
  auto promise = self->make_response_promise<opened_document>();
  open_for(self, name, promise);
  return promise;
}

// -- documents that nobody has open --------------------------------------------------------------

/// Those who ask for the document meanwhile wait, and get it anew.
void end_session(hub_pointer self, const session_actor& session) {
  auto& state = self->state;
  const auto found =
    std::ranges::find(state.open, session, &std::pair<const std::string, session_actor>::second);
  if (found == state.open.end() || state.renaming.contains(session))
    return;
  const auto name = found->first;
  state.open.erase(found);
  state.opening[name];
  self->request(session, std::chrono::minutes(10), end_atom::value)
    .then(
      [=](const shared_remains& left) {
        keep_remains(self->state, name, left);
        let_go(self, name);
        note_left(self, name);
      },
      [=](const caf::error&) {
        self->state.open.emplace(name, session);
        answer_all(self, name, session);
      });
}

// -- other names ---------------------------------------------------------------------------------

void take_renamed(hub_pointer self, const session_actor& session, const document_renamed& renamed) {
  auto& state = self->state;
  state.renaming.erase(session);
  ++state.name_changes;
  state.open.erase(renamed.before);
  state.open.emplace(renamed.document, session);
  forget_former(state, renamed.document);
  for (auto& [before, now] : state.former)
    if (now == renamed.before)
      now = renamed.document;
  state.former.emplace_back(renamed.before, renamed.document);
  if (state.former.size() > most_former)
    state.former.pop_front();
  answer_all(self, renamed.document, session);
}

/// Those who asked for the name meanwhile get what they would have got without it.
void leave_name(hub_pointer self, const session_actor& session, const std::string& name) {
  auto& state = self->state;
  state.renaming.erase(session);
  auto promises = std::move(state.opening[name]);
  state.opening.erase(name);
  for (auto& promise : promises)
    open_for(self, present_name(state, name), std::move(promise));
}

/// Whether there is anything to do: nothing when it is asked for again.
expected<bool> check_rename(const hub_state& state, const session_actor& session,
                            const std::string& name) {
  if (auto ok = check_lasting_name(name); !ok)
    return fail(ok.error());
  if (const auto here = state.open.find(name); here != state.open.end() && here->second == session)
    return false;
  if (state.renaming.contains(session))
    return fail(ec::conflict, "the document is being renamed", "Try again soon");
  if (is_taken(state, name))
    return fail(taken_name(name));
  return true;
}

/// The name is held among those that are being opened: nobody else gets it, and who opens it waits
/// for the document.
caf::result<acknowledged> rename(hub_pointer self, const rename_request& request) {
  auto& state = self->state;
  const auto session = caf::actor_cast<session_actor>(request.session);
  const auto end = [=, close = request.close] {
    if (close)
      end_session(self, session);
  };
  if (const auto wanted = check_rename(state, session, request.name); !wanted || !*wanted) {
    end();
    return wanted ? caf::result<acknowledged>(acknowledged{}) : to_caf(wanted.error());
  }
  state.renaming.insert(session);
  state.opening[request.name];
  auto promise = std::make_shared<caf::typed_response_promise<acknowledged>>(
    self->make_response_promise<acknowledged>());
  self->request(session, std::chrono::minutes(10), rename_atom::value, request.name)
    .then(
      [=](const document_renamed& renamed) {
        take_renamed(self, session, renamed);
        promise->deliver(acknowledged{});
        end();
      },
      [=, name = request.name](const caf::error& e) {
        leave_name(self, session, name);
        promise->deliver(to_caf(from_caf(e, "renaming the document")));
        end();
      });
  return *promise;
}

/// Asks one worker after the other and answers when all have.
caf::result<server_status> status(hub_pointer self) {
  struct gathering {
    server_status result;
    std::size_t missing = worker_roles.size();
    caf::typed_response_promise<server_status> promise;
  };
  auto all = std::make_shared<gathering>();
  all->promise = self->make_response_promise<server_status>();
  all->result.documents = static_cast<std::uint32_t>(self->state.open.size());
  all->result.workers.resize(worker_roles.size());
  const auto& parts = self->state.parts;
  const auto pages = parts.cache->usage();
  all->result.memory = {{"documents", pages.known, 0},
                        {"recent pages", pages.recent, pages.budget},
                        {"versions", parts.versions->used(), parts.versions->budget()},
                        {"results", parts.results->used(), parts.results->budget()}};
  self->state.parts.workers.for_each([=](worker_role role, const auto& worker) {
    const auto receive = [=](const worker_status& one) {
      all->result.workers[static_cast<std::size_t>(role)] = one;
      if (--all->missing == 0)
        all->promise.deliver(all->result);
    };
    self->request(worker, std::chrono::seconds(2), status_atom::value)
      .then(receive, [=](const caf::error& e) {
        receive({name_of(role), "degraded", 0, 0, 0, from_caf(e, name_of(role)).message});
      });
  });
  return all->promise;
}

caf::result<shared_catalogue> catalogue(hub_pointer self) {
  auto promise = std::make_shared<caf::typed_response_promise<shared_catalogue>>(
    self->make_response_promise<shared_catalogue>());
  self->request(self->state.parts.workers.modeling, std::chrono::seconds(30), catalog_atom::value)
    .then([=](const shared_catalogue& all) { promise->deliver(all); },
          [=](const caf::error& e) {
            promise->deliver(to_caf(from_caf(e, "listing the operations")));
          });
  return *promise;
}

}  // namespace

// -- what library.cpp needs, too -----------------------------------------------------------------

std::filesystem::path file_of(const hub_state& state, const std::string& name) {
  return state.parts.documents / (name + ".tedit");
}

bool has_file(const hub_state& state, const std::string& name) {
  std::error_code code;
  return std::filesystem::exists(std::filesystem::symlink_status(file_of(state, name), code));
}

void forget_former(hub_state& state, const std::string& name) {
  std::erase_if(state.former, [&](const auto& one) { return one.first == name; });
}

std::string present_name(hub_state& state, const std::string& name) {
  if (has_file(state, name))
    forget_former(state, name);
  const auto found =
    std::ranges::find_if(state.former, [&](const auto& one) { return one.first == name; });
  return found == state.former.end() ? name : found->second;
}

bool is_taken(const hub_state& state, const std::string& name) {
  return state.open.contains(name) || state.opening.contains(name) || state.adding.contains(name) ||
         has_file(state, name);
}

error no_document(const std::string& name) {
  return {ec::not_found,
          "there is no document " + name,
          "The list of documents says which there are",
          {}};
}

error taken_name(const std::string& name) {
  return {
    ec::conflict, "there is a document " + name + " already", "Give this one another name", {}};
}

void answer_all(hub_pointer self, const std::string& name, const session_actor& session) {
  auto promises = std::move(self->state.opening[name]);
  self->state.opening.erase(name);
  for (auto& promise : promises)
    promise.deliver(opened_document{name, caf::actor_cast<caf::actor>(session)});
}

void let_go(hub_pointer self, const std::string& name) {
  if (self->state.opening[name].empty())
    self->state.opening.erase(name);
  else
    start_opening(self, name);
}

hub_actor::behavior_type make_hub(hub_actor::stateful_pointer<hub_state> self, hub_parts parts) {
  heed_only_own_exits(self);
  self->state.parts = std::move(parts);
  const auto& disks = self->state.parts.disks;
  self->state.disks = disks ? *disks : disk_set::spawn(self);
  for (auto& one : store::read_former_names(self->state.parts.documents))
    self->state.former.push_back(std::move(one));
  expect_ends(self);
  return {[=](const std::string& name) { return open(self, name, true); },
          [=](existing_atom, const std::string& name) { return open(self, name, false); },
          [=](const add_request& request) { return add_document(self, request); },
          [=](const part_request& request) { return add_part(self, request); },
          [=](const rename_request& request) { return rename(self, request); },
          [=](const copy_request& request) { return copy_document(self, request); },
          [=](const delete_request& request) { return delete_document(self, request); },
          [=](list_atom) { return list_documents(self); },
          [=](end_atom, const session_actor& session) { end_session(self, session); },
          [=](rest_atom, const std::string& name, std::uint64_t number) {
            end_temporary(self, name, number);
          },
          [=](status_atom) { return status(self); },
          [=](catalog_atom) { return catalogue(self); }};
}

}  // namespace tedit::actors
