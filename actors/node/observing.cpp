// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/observing.hpp"

#include <map>

#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"
#include "fem/quantities.hpp"

namespace tedit::actors {

namespace {

/// Documents of one observer: each stays open.
constexpr std::size_t most_watched = 64;

/// For an observer to name what it watches, once its certificate was seen.
constexpr std::chrono::seconds time_to_watch{30};

/// For an observer to take an event.
constexpr std::chrono::seconds time_to_answer{60};

struct observing_state {
  observing_parts parts;
  caf::actor_addr observer;  ///< Once it was named; the connection has no other.
  std::map<std::string, session_actor> watched;
  std::size_t beginning = 0;  ///< Of which it is not known yet whether they can be watched.
  std::size_t unanswered = 0;

  static inline const char* name = "observing";
};

using observing_pointer = observation_actor::stateful_pointer<observing_state>;

void cut_off(observing_pointer self, const std::string& why) {
  const auto& parts = self->state.parts;
  logging::warn("{} is cut off: {}", parts.line->name(), why);
  parts.line->cut();
  self->quit();
}

/// `held` keeps the pages of the event until it was taken.
template <class Event>
void tell(observing_pointer self, Event event, std::shared_ptr<const void> held) {
  auto& state = self->state;
  const auto to = caf::actor_cast<observer_actor>(state.observer);
  if (!to)
    return;
  if (++state.unanswered > most_unanswered)
    return cut_off(self, "it does not keep up with what it watches");
  self->request(to, time_to_answer, std::move(event))
    .then([=, keep = std::move(held)](bool) { --self->state.unanswered; },
          [=](const caf::error&) { cut_off(self, "it does not answer"); });
}

void tell_head(observing_pointer self, const head_moved& moved) {
  if (!moved.version)
    return;
  observed_version event;
  event.document = moved.document;
  event.number = moved.head.number;
  if (moved.head.parent)
    event.parent = *moved.head.parent;
  event.cause = moved.cause;
  event.operation = moved.head.operation;
  event.version = make_ref(moved.version);
  event.load_cases = wire_value(moved.load_cases);
  event.has_report = moved.report != nullptr;
  if (moved.report)
    event.report = wire_value(moved.report);
  event.source = self->state.parts.pages;
  tell(self, std::move(event), moved.version);
}

/// Those of solves that still run are for who looks on, not for who counts on them.
void tell_result(observing_pointer self, const solved& result) {
  if (!result.outcome || !result.fields || result.outcome->cases.front().interim)
    return;
  observed_result event;
  event.document = result.document;
  event.version = make_ref(result.version);
  event.outcome = wire_value(result.outcome);
  for (const auto& one : *result.fields)
    event.fields.push_back(make_ref(one));
  event.source = self->state.parts.pages;
  tell(self, std::move(event), result.fields);
}

void end_watching(observing_pointer self, const caf::actor_addr& session) {
  auto& watched = self->state.watched;
  const auto found =
    std::ranges::find_if(watched, [&](const auto& one) { return one.second.address() == session; });
  if (found == watched.end())
    return;
  const auto document = found->first;
  watched.erase(found);
  tell(self, observed_end{document, "the document was deleted, or the server is stopping"},
       nullptr);
}

void take_new_name(observing_pointer self, const document_renamed& renamed) {
  auto& watched = self->state.watched;
  auto session = watched.extract(renamed.before);
  if (session.empty())
    return;
  session.key() = renamed.document;
  watched.insert(std::move(session));
  tell(self, observed_name{renamed.before, renamed.document}, nullptr);
}

using watch_promise = std::shared_ptr<caf::typed_response_promise<std::string>>;

void refuse_watch(observing_pointer self, const watch_promise& promise, const error& why) {
  --self->state.beginning;
  promise->deliver(to_caf(why));
}

/// What the document is now, as if it had just become that.
void tell_present(observing_pointer self, const session_actor& session,
                  const session_snapshot& now) {
  if (!now.head)
    return;
  tell_head(self, {now.document, *now.head, now.version, "head", nullptr, now.load_cases});
  watch_request all{caf::actor_cast<caf::actor>(self),
                    {}};  // Which of them it reads, it says to nobody.
  for (const auto& array : fem::result_arrays)
    if (array.sent == fem::array_sent::on_request)
      all.arrays.emplace(array.name);
  self->request(session, std::chrono::minutes(1), std::move(all))
    .then(
      [=](const held_result& held) {
        if (held.result)
          tell_result(self, *held.result);
      },
      [](const caf::error&) {});
}

void attach_to(observing_pointer self, const opened_document& opened,
               const watch_promise& promise) {
  const auto session = caf::actor_cast<session_actor>(opened.session);
  attach_request request{caf::actor_cast<caf::actor>(self)};
  request.only_looks = true;
  request.name = self->state.parts.line->name();
  self->request(session, std::chrono::minutes(1), request)
    .then(
      [=](const session_snapshot& now) {
        self->monitor(session);
        --self->state.beginning;
        self->state.watched.insert_or_assign(now.document, session);
        promise->deliver(now.document);
        tell_present(self, session, now);
      },
      [=](const caf::error& e) { refuse_watch(self, promise, from_caf(e, "watching")); });
}

/// Only documents that are there: opening another one would make it.
void open_to_watch(observing_pointer self, const std::string& document,
                   const watch_promise& promise) {
  const auto refuse = [=](const caf::error& e) {
    refuse_watch(self, promise, from_caf(e, "watching " + document));
  };
  self->request(self->state.parts.hub, std::chrono::minutes(10), existing_atom::value, document)
    .then([=](const opened_document& opened) { attach_to(self, opened, promise); }, refuse);
}

caf::result<std::string> watch(observing_pointer self, const std::string& document,
                               const caf::actor& observer) {
  auto& state = self->state;
  const auto asker = self->current_sender();
  if (!observer || !asker || asker->node() != observer.node() ||
      (state.observer && state.observer != observer.address()))
    return to_caf({ec::invalid_argument,
                   "it named an observer that is not its own, or a second one",
                   "Name one actor of the node that asks, each time the same",
                   {}});
  if (state.watched.size() + state.beginning >= most_watched)
    return to_caf({ec::invalid_argument,
                   "one connection watches " + std::to_string(most_watched) + " documents at most",
                   "Watch others over a second connection",
                   {}});
  if (!state.observer) {
    state.observer = observer.address();
    self->monitor(observer);
  }
  const auto promise = std::make_shared<caf::typed_response_promise<std::string>>(
    self->make_response_promise<std::string>());
  ++state.beginning;
  open_to_watch(self, document, promise);
  return *promise;
}

caf::result<std::vector<std::string>> names(observing_pointer self) {
  auto promise = std::make_shared<caf::typed_response_promise<std::vector<std::string>>>(
    self->make_response_promise<std::vector<std::string>>());
  self->request(self->state.parts.hub, std::chrono::minutes(1), list_atom::value)
    .then(
      [=](const document_list& all) {
        std::vector<std::string> result;
        for (const auto& row : all.documents)
          result.push_back(row.name);
        promise->deliver(std::move(result));
      },
      [=](const caf::error& e) { promise->deliver(to_caf(from_caf(e, "listing documents"))); });
  return *promise;
}

node_answer no_worker_but_observer(const std::string& name) {
  return {false, false, "the certificate of " + name + " is one of an observer, not of a worker",
          "Issue it another certificate with \"tedit certs issue --role solver\""};
}

observation_actor::behavior_type observing(observing_pointer self, observing_parts parts) {
  self->state.parts = std::move(parts);
  heed_only_own_exits(self);
  self->set_down_handler([=](const caf::down_msg& down) {
    if (down.source == self->state.observer)
      self->quit();
    else
      end_watching(self, down.source);
  });
  // What sessions tell their subscribers is no part of what a node may send: of that only what was
  // made in this process is heeded.
  self->set_default_handler(
    [=](caf::scheduled_actor*, caf::message_view& view) -> caf::result<caf::message> {
      const auto& from = self->current_sender();
      auto message = view.move_content_to_message();
      if (from && from->node() != self->node()) {
        if (message.match_elements<node_enlistment>())
          return caf::make_message(no_worker_but_observer(self->state.parts.name));
        return caf::sec::unexpected_message;
      }
      message.apply(
        {[&](const head_moved& moved) { tell_head(self, moved); },
         [&](const solved& result) { tell_result(self, result); },
         [&](const load_cases_changed& now) {
           tell(self, observed_load_cases{now.document, wire_value(now.load_cases)}, nullptr);
         },
         [&](const document_renamed& renamed) { take_new_name(self, renamed); },
         [&](rest_atom) {
           if (self->state.watched.empty())
             cut_off(self, "it watches nothing");
         }});
      return caf::message{};
    });
  caf::delayed_anon_send(caf::actor_cast<caf::actor>(self), time_to_watch, rest_atom::value);
  return {[=](names_atom) { return names(self); },
          [=](watch_atom, const std::string& document, const caf::actor& observer) {
            return watch(self, document, observer);
          }};
}

}  // namespace

observation_actor make_observing(caf::actor_system& system, observing_parts parts) {
  return system.spawn(observing, std::move(parts));
}

}  // namespace tedit::actors
