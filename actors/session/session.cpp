// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/session.hpp"

#include <atomic>

#include <caf/event_based_actor.hpp>

#include "actors/errors.hpp"
#include "actors/exits.hpp"
#include "actors/links/open_actors.hpp"
#include "actors/session/numbers.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

using queue_atom = caf::atom_constant<caf::atom("queue")>;

/// From a change's coming until its client hears that it waits; what is quick needs no words.
constexpr std::chrono::milliseconds first_note{400};
constexpr std::chrono::milliseconds later_notes{1000};

/// What jobs are told as their listener: passes on their notes and nothing else.
caf::behavior make_ear(caf::event_based_actor* self, const caf::actor_addr& session) {
  heed_only_own_exits(self);
  open_to_workers(self);
  const auto pass_on = [=](const auto& note) {
    if (const auto to = caf::actor_cast<caf::actor>(session))
      caf::anon_send(to, note);
  };
  return {[=](const job_progress& note) { pass_on(note); },
          [=](const job_frame& frame) { pass_on(frame); },
          [=](const job_preview& preview) { pass_on(preview); }};
}

}  // namespace

session_state::session_state() {
  numbers::open_documents().add(1);
  static_cast<void>(numbers::failed_solves());  // Shown from the first document on.
}

session_state::~session_state() {
  caf::anon_send_exit(ear, caf::exit_reason::user_shutdown);
  cancel_asides();
  stop_cad();
  numbers::open_documents().add(-1);
  numbers::subscriptions().add(-static_cast<double>(subscribers.size()));
}

void session_state::start(session_pointer owner, session_parts with, stored_document stored) {
  self = owner;
  ear = self->spawn(make_ear, caf::actor_cast<caf::actor_addr>(self));
  parts = std::move(with);
  past = change_log(stored.log);
  const auto log = std::move(stored.log);
  tell_makers(log, stored.nodes);
  graph = version_graph(std::move(stored));
  if (const auto* head = graph.head())
    parts.cache->put(*head->mesh);
  begin_meshes();
  if (const auto before = std::exchange(parts.remains, nullptr))
    take_over(*before);
  begin_cad(log);
  look_later();
}

caf::result<session_snapshot> session_state::attach(const attach_request& request) {
  if (ended)
    return to_caf({ec::service_unavailable, "the document is being closed", "Open it again", {}});
  const auto [place, is_new] = subscribers.try_emplace(request.subscriber);
  watched.erase(request.subscriber);
  auto& who = place->second;
  if (is_new) {
    who = {++participants_so_far, request.name, utc_now(), request.only_looks};
    self->monitor(request.subscriber);
    numbers::subscriptions().add(1);
    broadcast(participant_changed{parts.document, who}, {request.subscriber});
  }
  session_snapshot snapshot;
  snapshot.document = parts.document;
  snapshot.participants = participants();
  snapshot.own_participant = who.id;
  if (const auto* head = graph.head()) {
    snapshot.head = head->info;
    snapshot.version = head->mesh;
    snapshot.report = head->report;
    snapshot.load_cases = head->load_cases;
  }
  snapshot.can_undo = graph.can_undo();
  snapshot.can_redo = graph.can_redo();
  return snapshot;
}

void session_state::detach(const caf::actor& subscriber) {
  const auto gone = subscribers.extract(subscriber);
  watched.erase(subscriber);
  if (gone) {
    numbers::subscriptions().add(-1);
    broadcast(participant_changed{parts.document, gone.mapped(), true});
  }
  if (!subscribers.empty())
    return;
  last_preview.reset();
  look_later();
}

std::vector<participant> session_state::participants() const {
  std::vector<participant> result;
  for (const auto& [subscriber, who] : subscribers)
    result.push_back(who);
  std::ranges::sort(result, {}, &participant::id);
  return result;
}

session_history session_state::history(const history_request& request) const {
  session_history result;
  result.document = parts.document;
  for (const auto& node : graph.nodes()) {
    result.versions.push_back(node.info);
    if (request.reports)
      result.reports.push_back(node.report);
  }
  result.head = graph.head() ? graph.head()->info.number : 0;
  return result;
}

caf::result<session_version> session_state::version(const version_request& request) {
  const auto* named = request.id.empty() ? nullptr : graph.find(request.id);
  const auto number = named ? named->info.number : request.number;
  if ((!named && !request.id.empty()) || number >= graph.nodes().size())
    return to_caf(
      {ec::not_found,
       "there is no version " + (request.id.empty() ? std::to_string(request.number) : request.id),
       "The history lists those that there are",
       {}});
  const auto promise = std::make_shared<caf::typed_response_promise<session_version>>(
    self->make_response_promise<session_version>());
  with_mesh(
    number,
    [=, this](const version_ptr& mesh) {
      promise->deliver(session_version{parts.document, number, mesh});
    },
    [=](const error& e) { promise->deliver(to_caf(e)); });
  return *promise;
}

// -- its end -----------------------------------------------------------------------------------

bool session_state::is_unused() const {
  return subscribers.empty() && !running && waiting.empty() && previews.empty() && !active &&
         progress_of.empty() && asides.empty() && copying == 0 && loading == 0 && !ended &&
         !(cad_running && cad_running->storing);
}

void session_state::look_later() {
  if (parts.hub)
    self->delayed_send(self, parts.unused_limit, rest_atom::value, ++looks);
}

void session_state::look(std::uint64_t number) {
  if (number != looks || !subscribers.empty())
    return;
  if (is_unused())
    caf::anon_send(caf::actor_cast<hub_actor>(parts.hub), end_atom::value, session_actor(self));
  look_later();  // Something may come between.
}

/// Who asks the hub for the document meanwhile waits there; who has this session from it already is
/// refused here and asks again.
caf::result<shared_remains> session_state::end() {
  if (!is_unused())
    return to_caf({ec::conflict, "the document is in use", {}, {}});
  ended = true;
  stop_cad();
  const auto promise = std::make_shared<caf::typed_response_promise<shared_remains>>(
    self->make_response_promise<shared_remains>());
  self->request(parts.store, std::chrono::minutes(5), close_atom::value)
    .then(
      [=, this](acknowledged) {
        auto remains = std::make_shared<session_remains>();
        remains->results = std::move(results);
        remains->followed = followed;
        promise->deliver(std::move(remains));
        self->quit();
      },
      [=, this](const caf::error& e) {
        ended = false;
        next_cad();
        promise->deliver(to_caf(from_caf(e, "closing the document")));
      });
  return *promise;
}

// -- the order of commands ---------------------------------------------------------------------

void session_state::enqueue(command c) {
  end_previews({ec::superseded, "the document is being changed", {}, {}});
  c.stage = tracing::begin_part("queue", tracing::of(c.ticket));
  waiting.push_back(std::move(c));
  if (!running)
    next_command();
  else if (waiting.size() == 1)
    look_at_queue_after(first_note);
}

void session_state::look_at_queue_after(std::chrono::milliseconds wait) {
  caf::delayed_anon_send(caf::actor_cast<caf::actor>(self), wait, queue_atom::value, ++queue_looks);
}

void session_state::tell_queue(std::uint64_t number) {
  if (number != queue_looks || waiting.empty())
    return;
  std::size_t before = 1;  // The one that runs.
  for (const auto& c : waiting) {
    if (c.client)
      caf::anon_send(c.client,
                     request_progress{c.ticket, 0,
                                      "waiting for " + std::to_string(before) + " change" +
                                        (before == 1 ? "" : "s") + " of this document before it"});
    ++before;
  }
  look_at_queue_after(later_notes);
}

void session_state::next_command() {
  if (waiting.empty())
    return;
  auto c = std::move(waiting.front());
  waiting.pop_front();
  c.stage.end();
  running = running_command{c.ticket, false, {}};
  c.start();
}

void session_state::finish_command() {
  running.reset();
  store_cad();
  next_command();
}

void session_state::cancel(std::uint64_t ticket) {
  if (running && running->ticket == ticket) {
    running->cancelled = true;
    if (running->cancel_job)
      running->cancel_job();
    return;
  }
  if (previews.contains(ticket))
    return end_preview(ticket, {ec::cancelled, "the preview was cancelled", {}, {}});
  if (leave_solve(ticket) || leave_aside(ticket))
    return;
  const auto found = std::ranges::find(waiting, ticket, &command::ticket);
  if (found == waiting.end())
    return cancel_jobs_of(ticket);
  const auto refuse = std::move(found->refuse);
  waiting.erase(found);
  refuse({ec::cancelled, "the request was cancelled before it began", {}, {}});
}

/// Files and selections wait in no queue of the document; they end in the workers' pool.
void session_state::cancel_jobs_of(std::uint64_t ticket) {
  for (const auto& [job, who] : progress_of)
    if (ticket != 0 && who.first == ticket)
      caf::anon_send(parts.workers.modeling, cancel_atom::value, job);
}

// -- what all commands use -----------------------------------------------------------------------

job_id session_state::new_job(std::uint64_t ticket, const caf::actor& client) {
  // A client that comes back must not take another server's solve for one that it has: numbers
  // begin with the time, in microseconds.
  static std::atomic<std::uint64_t> last{
    static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(
                                 std::chrono::system_clock::now().time_since_epoch())
                                 .count())};
  const job_id job{++last};
  progress_of[job] = {ticket, client};
  return job;
}

order_base session_state::base_order(job_id job) const {
  const auto& [ticket, client] = progress_of.at(job);
  return {caf::actor_cast<caf::actor>(parts.pages), ear, client ? client.id() : 0,
          ticket != 0 ? tracing::of(ticket) : head_trace};
}

void session_state::on_progress(const job_progress& note) {
  const auto found = progress_of.find(note.job);
  if (found == progress_of.end() || !found->second.second)
    return;
  caf::anon_send(found->second.second,
                 request_progress{found->second.first, note.fraction, note.stage});
}

void session_state::commit(store::change change, const std::function<void(double ms)>& done,
                           const std::function<void(const error&)>& failed) {
  if (running)
    running->cancel_job = nullptr;
  const stopwatch clock;
  const auto stage = std::make_shared<tracing::span>(
    tracing::begin_part("commit", running ? tracing::of(running->ticket) : tracing::context{}));
  auto shared = std::make_shared<const store::change>(std::move(change));
  self->request(parts.store, std::chrono::minutes(5), stored_change{shared})
    .then(
      [=](acknowledged) {
        stage->end();
        done(clock.milliseconds());
      },
      [=](const caf::error& e) {
        const auto why = from_caf(e, "storing the document");
        stage->fail(why.message);
        stage->end();
        failed(why);
      });
}

void session_state::pull(const caf::actor& source, const hash_list& ids,
                         const std::function<void(const page_set&)>& done,
                         const std::function<void(const error&)>& failed) {
  self->request(parts.pages, std::chrono::minutes(5), fetch_atom::value, source, ids)
    .then([=](const page_set& pages) { done(pages); },
          [=](const caf::error& e) { failed(from_caf(e, "fetching the result")); });
}

session_actor::behavior_type make_session(session_pointer self, session_parts parts,
                                          stored_document stored) {
  auto& state = self->state;
  state.start(self, std::move(parts), std::move(stored));
  self->set_down_handler([=](caf::down_msg& down) {
    for (const auto& [one, who] : std::map(self->state.subscribers))
      if (one.address() == down.source)
        self->state.detach(one);
  });
  // Notes of workers are no part of the typed interface: they have no answer and may be lost.
  self->set_default_handler(
    [=](caf::scheduled_actor*, caf::message_view& view) -> caf::result<caf::message> {
      auto message = view.move_content_to_message();
      message.apply({[&](const job_progress& note) { self->state.on_progress(note); },
                     [&](const job_frame& frame) { self->state.on_frame(frame); },
                     [&](const job_preview& preview) { self->state.on_preview(preview); },
                     [&](queue_atom, std::uint64_t number) { self->state.tell_queue(number); }});
      return caf::message{};
    });
  heed_only_own_exits(self);
  return {[&state](const attach_request& request) { return state.attach(request); },
          [&state](detach_atom, const caf::actor& subscriber) { state.detach(subscriber); },
          [&state](const import_request& request) { return state.import(request); },
          [&state](const apply_request& request) { return state.edit(request); },
          [&state](const preview_request& request) { return state.preview(request); },
          [&state](const move_request& request) { return state.move(request); },
          [&state](const note_request& request) { return state.note(request); },
          [&state](rename_atom, const std::string& name) { return state.rename(name); },
          [&state](copy_atom, const copy_order& order) { return state.copy_to(order); },
          [&state](delete_atom, const caf::actor& asker) { return state.erase(asker); },
          [&state](status_atom) { return state.status(); },
          [&state](const watch_request& request) { return state.watch(request); },
          [&state](const solve_request& request) { return state.solve(request); },
          [&state](end_solve_atom) { return state.end_solve(); },
          [&state](const export_request& request) { return state.write_file(request); },
          [&state](const select_request& request) { return state.select(request); },
          [&state](const history_request& request) { return state.history(request); },
          [&state](const version_request& request) { return state.version(request); },
          [&state](const comparison_request& request) { return state.compare(request); },
          [&state](const print_request& request) { return state.check_print(request); },
          [&state](cancel_atom, std::uint64_t ticket) { state.cancel(ticket); },
          [&state](end_atom) { return state.end(); },
          [&state](rest_atom, std::uint64_t number) { state.look(number); }};
}

}  // namespace tedit::actors
