// SPDX-License-Identifier: AGPL-3.0-or-later
// What makes no new version: load cases, names and notes of one, the document's own name, its copy
// and its end.
#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "actors/errors.hpp"
#include "actors/session/session.hpp"
#include "actors/store/store.hpp"
#include "protocol/convert.hpp"
#include "protocol/forms.hpp"

namespace tedit::actors {

namespace {

/// "anna, ben and 3 more": as many as a line has room for.
std::string names_of(const std::vector<participant>& several) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(several.size(), most); ++i)
    text += (i ? ", " : "") + (several[i].name.empty() ? "one without a name" : several[i].name);
  if (several.size() > most)
    text += " and " + std::to_string(several.size() - most) + " more";
  return text;
}

constexpr std::size_t longest_name = 80;
constexpr std::size_t longest_note = 4000;

/// Load cases of a version together, as JSON: they travel with every message about a new head.
constexpr std::size_t most_load_case_bytes = std::size_t{4} << 20;

/// Characters of a UTF-8 text: bytes that go on from another do not count.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
    std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool has_control(const std::string& text, bool lines) {
  return std::ranges::any_of(text, [&](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20 && !(lines && (c == '\n' || c == '\t'))) || code == 0x7F;
  });
}

/// Errors: `invalid_argument`.
expected<void> check_words(const annotate_version& request) {
  if (characters(request.name) > longest_name || has_control(request.name, false))
    return fail(ec::invalid_argument,
                "a version's name has at most " + std::to_string(longest_name) +
                  " characters and is one line",
                "Put the rest into the note");
  if (characters(request.note) > longest_note || has_control(request.note, true))
    return fail(
      ec::invalid_argument,
      "a version's note has at most " + std::to_string(longest_note) + " printable characters",
      "Shorten it");
  return {};
}

/// What the disk gets, and what is done when it is durable.
struct quiet_change {
  store::change change;
  std::function<void()> done;
};

// For each kind of change: how it stands in the log, and what it is; the latter when its turn has
// come.

// -- load cases --------------------------------------------------------------------------------

/// The head gets these load cases instead of its own. Errors: `conflict`.
expected<quiet_change> change_load_cases(session_state& state, load_case_list load_cases) {
  const auto number = state.graph.head()->info.number;
  auto stored = stored_form(load_cases);
  if (stored.size() > most_load_case_bytes)
    return fail(ec::conflict,
                "the load cases of a version may have " + std::to_string(most_load_case_bytes) +
                  " bytes together (as JSON), not " + std::to_string(stored.size()),
                "Remove load cases that are not needed");
  quiet_change result;
  result.change.load_cases.emplace_back(number, std::move(stored));
  result.done = [=, &state,
                 shared = std::make_shared<const load_case_list>(std::move(load_cases))] {
    state.graph.set_load_cases(number, shared);
    state.last_preview.reset();
    state.broadcast(
      load_cases_changed{state.parts.document, to_hex(state.graph.head()->info.id), shared});
  };
  return result;
}

asked_change in_log(const set_load_case& wanted) {
  const nlohmann::json how{{"load_case", protocol::load_case_to_json(wanted.load_case)}};
  return {"load_case", how.dump()};
}

expected<quiet_change> prepare(session_state& state, const set_load_case& wanted) {
  const auto* head = state.graph.head();
  if (!head)
    return fail(empty_document());
  const auto& given = wanted.load_case;
  auto load_cases = *head->load_cases;
  const auto same = std::ranges::find(load_cases, given.name, &fem::load_case::name);
  if (same == load_cases.end())
    load_cases.push_back(given);
  else
    *same = given;
  auto change = change_load_cases(state, std::move(load_cases));
  if (change)
    change->done = [=, &state, then = std::move(change->done)] {
      then();
      state.restart_solve_of(given);
    };
  return change;
}

asked_change in_log(const remove_load_case& wanted) {
  return {"remove_load_case", nlohmann::json{{"load_case", wanted.load_case}}.dump()};
}

/// The last one may go, too: the head is then as it was after its import.
expected<quiet_change> prepare(session_state& state, const remove_load_case& wanted) {
  const auto* head = state.graph.head();
  if (!head)
    return fail(empty_document());
  auto load_cases = *head->load_cases;
  const auto found = std::ranges::find(load_cases, wanted.load_case, &fem::load_case::name);
  if (found == load_cases.end())
    return fail(ec::not_found, "there is no load case \"" + wanted.load_case + "\"",
                "Name one that the head has");
  load_cases.erase(found);
  auto change = change_load_cases(state, std::move(load_cases));
  if (change)
    change->done = [=, &state, then = std::move(change->done)] {
      state.forget_solve_of(wanted.load_case);
      then();
    };
  return change;
}

// -- names and notes ---------------------------------------------------------------------------

asked_change in_log(const annotate_version& wanted) {
  const nlohmann::json how{{"number", wanted.number}, {"name", wanted.name}, {"note", wanted.note}};
  return {"annotate", how.dump()};
}

expected<quiet_change> prepare(session_state& state, const annotate_version& wanted) {
  if (auto ok = check_words(wanted); !ok)
    return fail(ok.error());
  if (wanted.number >= state.graph.nodes().size())
    return fail(ec::not_found, "there is no version " + std::to_string(wanted.number),
                "Ask for the history to see which there are");
  quiet_change result;
  result.change.annotations.push_back({wanted.number, wanted.name, wanted.note});
  result.done = [=, &state] {
    state.graph.annotate(wanted.number, wanted.name, wanted.note);
    state.broadcast(
      version_annotated{state.parts.document, state.graph.nodes()[wanted.number].info});
  };
  return result;
}

}  // namespace

caf::result<acknowledged> session_state::note(const note_request& request) {
  const auto promise = std::make_shared<caf::typed_response_promise<acknowledged>>(
    self->make_response_promise<acknowledged>());
  const auto refuse = [=](const error& e) { promise->deliver(to_caf(e)); };
  const auto end = [=, this](const error& e) {
    refuse(e);
    finish_command();
  };
  const auto asked = std::visit([](const auto& wanted) { return in_log(wanted); }, request.wanted);
  const auto begin = [=, this] {
    const auto found = judge(request.terms, asked);
    if (found.refusal)
      promise->deliver(*found.refusal);
    else if (found.made)
      promise->deliver(acknowledged{});
    if (found.refusal || found.made)
      return finish_command();
    auto prepared =
      std::visit([this](const auto& wanted) { return prepare(*this, wanted); }, request.wanted);
    if (!prepared)
      return end(prepared.error());
    const auto made = begin_change(request.terms, asked);
    prepared->change.what = made.what;
    prepared->change.details = made.to_details(asked.how);
    commit(
      std::move(prepared->change),
      [=, this, done = std::move(prepared->done)](double) {
        past.add(made);
        done();
        promise->deliver(acknowledged{});
        finish_command();
      },
      end);
  };
  enqueue({request.ticket, request.client, begin, refuse});
  return *promise;
}

// -- solves of load cases that change ------------------------------------------------------------

/// A field of the old loads would lie; the solve begins anew with the new ones, as after an edit.
void session_state::restart_solve_of(const fem::load_case& changed) {
  if (!active || !std::ranges::count(active->names, changed.name) ||
      std::ranges::count(active->key.load_cases, changed))
    return;
  end_active_solve(ec::superseded, "the load case \"" + changed.name + "\" was changed",
                   solve_phase::superseded);
  follow_head();
}

/// A field of loads that are gone must not come; nor must the next head ask for them.
void session_state::forget_solve_of(const std::string& load_case) {
  if (followed && std::erase(followed->load_cases, load_case) > 0 && followed->load_cases.empty())
    followed.reset();
  if (active && std::ranges::count(active->names, load_case))
    end_active_solve(ec::cancelled, "the load case \"" + load_case + "\" was removed",
                     solve_phase::cancelled);
}

// -- the document as a whole -------------------------------------------------------------------

/// Beside the queue: the disk sees to it that no commit is under way, and an edit of minutes need
/// not hold it up.
caf::result<document_renamed> session_state::rename(const std::string& wanted) {
  const auto promise = std::make_shared<caf::typed_response_promise<document_renamed>>(
    self->make_response_promise<document_renamed>());
  self->request(parts.store, std::chrono::minutes(5), rename_atom::value, wanted)
    .then(
      [=, this](acknowledged) {
        const document_renamed renamed{std::exchange(parts.document, wanted), wanted};
        for (auto& one : results)
          one.event.document = wanted;
        broadcast(renamed);
        promise->deliver(renamed);
      },
      [=](const caf::error& e) { promise->deliver(to_caf(from_caf(e, "renaming the document"))); });
  return *promise;
}

/// Beside the queue as well: the copy has what was acknowledged before it was asked for.
caf::result<acknowledged> session_state::copy_to(const copy_order& order) {
  const auto promise = std::make_shared<caf::typed_response_promise<acknowledged>>(
    self->make_response_promise<acknowledged>());
  ++copying;
  self->request(parts.store, std::chrono::minutes(10), copy_atom::value, order)
    .then(
      [=, this](acknowledged) {
        --copying;
        promise->deliver(acknowledged{});
      },
      [=, this](const caf::error& e) {
        --copying;
        promise->deliver(to_caf(from_caf(e, "copying the document")));
      });
  return *promise;
}

/// Nobody who was promised an answer may be left without it: only a solve that goes by itself is
/// ended, whatever else is done with the document keeps it.
caf::result<acknowledged> session_state::erase(const caf::actor& asker) {
  std::vector<participant> others;
  for (const auto& [subscriber, who] : subscribers)
    if (subscriber != asker && !who.only_looks)
      others.push_back(who);
  if (!others.empty())
    return to_caf({ec::conflict,
                   "the document " + parts.document + " is open in other clients (" +
                     std::to_string(others.size()) + ": " + names_of(others) + ")",
                   "Have it closed there, then try again",
                   {}});
  if (running || !waiting.empty() || !previews.empty() || !asides.empty() || copying > 0 || ended ||
      (active && !active->waiting.empty()) || progress_of.size() > (active ? 1U : 0U))
    return to_caf({ec::conflict,
                   "the document " + parts.document + " is being worked with",
                   "Wait until that is done or cancel it, then try again",
                   {}});
  end_active_solve(ec::cancelled, "the document is being deleted", solve_phase::cancelled);
  ended = true;
  stop_cad();
  const auto promise = std::make_shared<caf::typed_response_promise<acknowledged>>(
    self->make_response_promise<acknowledged>());
  self->request(parts.store, std::chrono::minutes(5), delete_atom::value)
    .then(
      [=, this](acknowledged) {
        caf::anon_send(parts.store, close_atom::value);
        promise->deliver(acknowledged{});
        self->quit();
      },
      [=, this](const caf::error& e) {
        ended = false;
        next_cad();
        promise->deliver(to_caf(from_caf(e, "deleting the document")));
      });
  return *promise;
}

session_status session_state::status() const {
  const auto work =
    std::ranges::count_if(subscribers, [](const auto& row) { return !row.second.only_looks; });
  session_status result{static_cast<std::size_t>(work), graph.nodes().size(), {}};
  if (const auto* head = graph.head())
    result.head = head->info.number;
  return result;
}

}  // namespace tedit::actors
