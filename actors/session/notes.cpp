// SPDX-License-Identifier: AGPL-3.0-or-later
// What makes no new version: load cases, names and notes of one, the document's own name.
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

/// Errors: `conflict`.
expected<void> check_size(const load_case_list& load_cases) {
  const auto bytes = protocol::to_json(load_cases).size();
  if (bytes <= most_load_case_bytes)
    return {};
  return fail(ec::conflict,
              "the load cases of a version may have " + std::to_string(most_load_case_bytes) +
                " bytes together (as JSON), not " + std::to_string(bytes),
              "Remove load cases that are not needed");
}

/// Errors: `invalid_argument`.
expected<void> check_words(const annotate_request& request) {
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

}  // namespace

caf::result<acknowledged> session_state::carry_out(
  const change_terms& terms, asked_change request,
  std::function<expected<quiet_change>()> prepare) {
  const auto promise = std::make_shared<caf::typed_response_promise<acknowledged>>(
    self->make_response_promise<acknowledged>());
  const auto refuse = [=](const error& e) { promise->deliver(to_caf(e)); };
  const auto end = [=, this](const error& e) {
    refuse(e);
    finish_command();
  };
  const auto begin = [=, this, prepare = std::move(prepare)] {
    const auto found = judge(terms, request);
    if (found.refusal)
      promise->deliver(*found.refusal);
    else if (found.made)
      promise->deliver(acknowledged{});
    if (found.refusal || found.made)
      return finish_command();
    auto prepared = prepare();
    if (!prepared)
      return end(prepared.error());
    const auto made = begin_change(terms, request);
    prepared->change.what = made.what;
    prepared->change.details = made.to_details(request.how);
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
  enqueue({0, begin, refuse});
  return *promise;
}

// -- load cases --------------------------------------------------------------------------------

session_state::quiet_change session_state::change_load_cases(load_case_list load_cases) {
  const auto number = graph.head()->info.number;
  quiet_change result;
  result.change.load_cases.emplace_back(number, stored_form(load_cases));
  result.done = [=, this, shared = std::make_shared<const load_case_list>(std::move(load_cases))] {
    graph.set_load_cases(number, shared);
    last_preview.reset();
    broadcast(load_cases_changed{parts.document, to_hex(graph.head()->info.id), shared});
  };
  return result;
}

caf::result<acknowledged> session_state::set_load_case(const load_case_request& request) {
  const auto& given = request.load_case;
  const nlohmann::json how{{"load_case", protocol::load_case_to_json(given)}};
  return carry_out(request.terms, {"load_case", how.dump()}, [=, this]() -> expected<quiet_change> {
    const auto* head = graph.head();
    if (!head)
      return fail(empty_document());
    auto load_cases = *head->load_cases;
    const auto same = std::ranges::find(load_cases, given.name, &fem::load_case::name);
    if (same == load_cases.end())
      load_cases.push_back(given);
    else
      *same = given;
    if (auto ok = check_size(load_cases); !ok)
      return fail(ok.error());
    auto change = change_load_cases(std::move(load_cases));
    change.done = [=, this, then = std::move(change.done)] {
      then();
      restart_solve_of(given);
    };
    return change;
  });
}

/// The last one may go, too: the head is then as it was after its import.
caf::result<acknowledged> session_state::remove_load_case(const remove_case_request& request) {
  const asked_change asked{"remove_load_case",
                           nlohmann::json{{"load_case", request.load_case}}.dump()};
  return carry_out(request.terms, asked, [=, this]() -> expected<quiet_change> {
    const auto* head = graph.head();
    if (!head)
      return fail(empty_document());
    auto load_cases = *head->load_cases;
    const auto found = std::ranges::find(load_cases, request.load_case, &fem::load_case::name);
    if (found == load_cases.end())
      return fail(ec::not_found, "there is no load case \"" + request.load_case + "\"",
                  "Name one that the head has");
    load_cases.erase(found);
    auto change = change_load_cases(std::move(load_cases));
    change.done = [=, this, then = std::move(change.done)] {
      forget_solve_of(request.load_case);
      then();
    };
    return change;
  });
}

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

// -- names and notes ---------------------------------------------------------------------------

caf::result<acknowledged> session_state::annotate(const annotate_request& request) {
  const nlohmann::json how{
    {"number", request.number}, {"name", request.name}, {"note", request.note}};
  const asked_change asked{"annotate", how.dump()};
  return carry_out(request.terms, asked, [=, this]() -> expected<quiet_change> {
    if (auto ok = check_words(request); !ok)
      return fail(ok.error());
    if (request.number >= graph.nodes().size())
      return fail(ec::not_found, "there is no version " + std::to_string(request.number),
                  "Ask for the history to see which there are");
    quiet_change result;
    result.change.annotations.push_back({request.number, request.name, request.note});
    result.done = [=, this] {
      graph.annotate(request.number, request.name, request.note);
      broadcast(version_annotated{parts.document, graph.nodes()[request.number].info});
    };
    return result;
  });
}

/// Beside the queue: the disk sees to it that no commit is under way, and an edit of minutes need
/// not hold it up.
caf::result<document_renamed> session_state::rename(const std::string& wanted) {
  const auto promise = std::make_shared<caf::typed_response_promise<document_renamed>>(
    self->make_response_promise<document_renamed>());
  self->request(parts.store, std::chrono::minutes(5), rename_atom::value, wanted)
    .then(
      [=, this](acknowledged) {
        const document_renamed renamed{std::exchange(parts.document, wanted), wanted};
        broadcast(renamed);
        promise->deliver(renamed);
      },
      [=](const caf::error& e) { promise->deliver(to_caf(from_caf(e, "renaming the document"))); });
  return *promise;
}

}  // namespace tedit::actors
